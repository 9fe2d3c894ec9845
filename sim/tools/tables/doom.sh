# SPDX-License-Identifier: MIT
#
# Doom's own renderer and ours on the same walks through the same maps: instructions of a frame on this computer, of 320x200 pixels, 90 degrees
# wide. Both without what the C library's functions take. The picture of README is drawn beside it.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work, pictures
. sim/targets/targets.sh
. sim/tools/bench_host.sh
: "${WARNINGS:=-Wall}"
wads=/usr/share/games/doom

# Doom's pixels are square in its arithmetic: 160 of them are as wide as far.
fov_deg=64.0107601

# R_RenderPlayerView(), of WAD MAP; lines "STAGE MEAN WORST", the frame is `frame`.
count_doom() {
    rm -f "$work"/callgrind.*
    valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" --compress-strings=no --compress-pos=no --toggle-collect=view \
        --dump-after=view "$work/doom_view" "$wads/$1" "$2" "$work/walk.cam" >"$work/said" 2>&1 || { cat "$work/said" >&2; return 1; }
    awk -v own='/chocolate-doom[^/]*/src/' -f sim/tools/bench_host.awk "$work"/callgrind.[0-9]*
}

# lim_frame(), of WAD MAP, from CAMERAS.
count_ours() {
    rm -rf "$work/scene" && mkdir "$work/scene"
    "$BUILD/limner" compile "$wads/$1:$2" --size 320x200 --path "$3" -o "$work/scene/model" >/dev/null 2>&1
    bench_host_count "$work/scene" "$3" 320x200 "$fov_deg"
}

# Of a frame: "mean / worst", and the mean.
frame() { awk '$1 == "frame" { printf "%.0f / %.0f", $2 / 1000, $3 / 1000 }' "$1"; }
mean() { awk '$1 == "frame" { print $2 }' "$1"; }

# The mean of these files.
part() { # COUNTED PATTERN
    awk -v pattern="$2" '$1 ~ pattern { sum += $2 } END { printf "%.0f", sum / 1000 }' "$1"
}

row() { # WAD MAP
    "$BUILD/limner" walk "$wads/$1:$2" -o "$work/walk.cam" >/dev/null
    awk '!/^#/ { $5 -= 0.3639702; print }' "$work/walk.cam" >"$work/down.cam"
    count_doom "$1" "$2" >"$work/doom.counted"
    count_ours "$1" "$2" "$work/walk.cam" >"$work/ours.counted"
    count_ours "$1" "$2" "$work/down.cam" >"$work/down.counted"
    times=$(echo "$(mean "$work/ours.counted") $(mean "$work/doom.counted")" | awk '{ printf "%.2f", $1 / $2 }')
    echo "| $1:$2 | $(frame "$work/doom.counted") | $(part "$work/doom.counted" '^r_(draw|plane)$')" \
        "| $(frame "$work/ours.counted") | $(part "$work/ours.counted" '^(tex|paint$)') | $times | $(frame "$work/down.counted") |"
}

# Every fourth frame of the first 192 of E1M1's walk.
draw() {
    awk '!/^#/ && n < 192 && n++ % 4 == 0' sim/scenes/freedoom1-E1M1.cam >"$work/few.cam"
    "$BUILD/limner" render "$wads/freedoom1.wad:E1M1" --camera "$work/few.cam" --size 160x100 --fov "$fov_deg" --fps 8 \
        --gif "$pictures/level.gif" >/dev/null 2>&1
}

sh sim/tools/doom.sh "$work/doom_view"
echo '| thousand instructions, x86-64, mean / worst | R_RenderPlayerView | of it floors, columns | Limner | of it painting | times | looking 20 degrees down |'
echo '|---|---|---|---|---|---|---|'
row freedoom1.wad E1M1
row freedoom1.wad E2M1
row freedoom2.wad MAP01
[ -z "$pictures" ] || draw
