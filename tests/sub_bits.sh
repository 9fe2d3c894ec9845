# SPDX-License-Identifier: MIT
#
# Profiles with other sub-pixel bits than their own, which `limner measure` compiles when it is asked for them: more bits
# are more accurate, no hole, no wrong side; emulated processors draw the same; and what unit tests promise of profiles holds.
. tests/tap.sh

# Lines "NAME WRONG HOLES SIDES" of the table of accuracy.
figures() {
    awk -F ' *[|] *' '/^\| (draft|fast|fine|exact)/ && !seen[$2]++ { print $2, $4, $7, $10 + 0 }' "$work/table"
}

has_rows() { # NAME...
    [ "$(figures | cut -d ' ' -f 1)" = "$(printf '%s\n' "$@")" ]
}

is_less_wrong() { # NAME THAN
    figures | awk -v name="$1" -v than="$2" '{ wrong[$1] = $2 } END { exit !(wrong[name] < wrong[than]) }'
}

nothing_is_broken() { figures | awk '$1 ~ /_/ && ($3 || $4) { print; bad = 1 } END { exit bad || !NR }'; }

measured() { # SCENE
    "$BUILD/limner" measure "sim/scenes/$1.obj" --camera "sim/scenes/$1.cam" --no-cost --sub-bits >"$work/table"
}

for scene in rooms teapot; do
    tap_check "$scene: measured" measured $scene
    tap_check "$scene: a row for each" has_rows draft fast fine exact fast_4 fast_5 fast_8 fine_6
    for pair in 'fast_5 fast_4' 'fast fast_5' 'fine fine_6' 'fast_4 draft'; do
        tap_check "$scene: ${pair% *} is less wrong than ${pair#* }" is_less_wrong "${pair% *}" "${pair#* }"
    done
    tap_check "$scene: no hole, no wrong side" nothing_is_broken
done

# Counting ends with an error where a processor's frames are not this program's.
head -n 2 sim/scenes/teapot.cam >"$work/few.cam"
processors_draw_the_same() {
    "$BUILD/limner" measure sim/scenes/teapot.obj --camera "$work/few.cam" --size 64x48 --sub-bits --precision fast >"$work/said" &&
        [ "$(grep -c '^| fine_6 .* | [0-9][0-9]* | [0-9]* ([0-9]*) |' "$work/said")" -eq 4 ]
}
tap_check "each processor draws the same with other bits" processors_draw_the_same

for name in convex scanline target_errors; do
    tap_check "test_$name, with other bits" env SUB_BITS=yes "$BUILD/tests/test_$name"
done
tap_done
