# SPDX-License-Identifier: MIT
#
# `limner compare` counts the instructions of every method on an emulated processor; what each builds draws what the
# host draws.
. tests/tap.sh

compare() { # SCENE: one small frame into $work/SCENE
    head -n 1 "sim/scenes/$1.cam" >"$work/one.cam"
    "$BUILD/limner" compare "sim/scenes/$1.obj" --camera "$work/one.cam" --size 97x61 --core m4 -o "$work/$1"
}

column() { # NAME [SCENE]: of every row that draws it
    awk -F , -v name="$1" '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR > 1 && $column["frames"] != "" { print $column["method"], $column[name] }' "$work/${2:-knot}/compare.csv"
}

counts() { # SCENE
    compare "$1" || return 1
    for name in m4_instructions m4_worst_instructions m4_ram_b m4_flash_b; do
        column $name "$1"
        column $name "$1" | awk '!($2 > 0) { bad = 1 } END { exit bad || NR < 8 }' || return 1
    done
}

# The painter wants a whole frame of lines, 97 pixels in 196 bytes each.
counts_lines() {
    column lines_b
    [ "$(column lines_b | awk '$1 == "painter" { print $2 }')" -eq $((196 * 61)) ] &&
        [ "$(column lines_b | awk '$1 == "bsp" { print $2 }')" -eq 196 ]
}

# Without a tree Newell has to compare: more instructions, more RAM, and less of a scene.
newell_pays_with_time() {
    column m4_instructions | awk '{ of[$1] = $2 } END { exit !(of["newell"] > of["bsp"] && of["depth"] < of["newell"]) }' &&
        column m4_ram_b | awk '{ of[$1] = $2 } END { exit !(of["newell"] > of["bsp"]) }' &&
        column scene_b | awk '{ of[$1] = $2 } END { exit !(of["newell"] < of["bsp"]) }'
}

tap_check "every method is counted" counts knot
tap_check "so it is where polygons are transparent" counts glass
tap_check "lines that the target lends are counted as RAM" counts_lines
tap_check "the figures are those of different methods" newell_pays_with_time
tap_done
