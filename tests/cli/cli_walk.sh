# SPDX-License-Identifier: MIT
#
# `limner walk`: cameras that render takes, the same each time, as far apart as asked; and what it refuses.
. tests/tap.sh

rooms=sim/scenes/rooms.obj
walk() { "$BUILD/limner" walk "$@"; }

lines() { grep -vc '^#' "$1"; } # FILE

walks() {
    walk $rooms --frames 40 -o "$work/a.cam" >"$work/said" && walk $rooms -o "$work/b.cam" --frames=40 >/dev/null &&
        cmp "$work/a.cam" "$work/b.cam" && [ "$(lines "$work/a.cam")" -eq 40 ] &&
        grep -Eqx "$rooms: 40 frames, [0-9]+ m; of [0-9]+ places half a metre apart that can be reached [0-9]+ are seen, [0-9]+ %" "$work/said"
}

is_rendered() {
    "$BUILD/limner" render $rooms --camera "$work/a.cam" --size 32x24 --write-hashes "$work/hashes" &&
        [ "$(wc -l <"$work/hashes")" -eq 40 ]
}

# The longest way on the level from one eye to the next.
longest() { # FILE
    awk '!/^#/ { if (n++) { d = sqrt(($1 - x) ^ 2 + ($3 - z) ^ 2); if (d > most) most = d } x = $1; z = $3 }
        END { printf "%.3f\n", most }' "$1"
}

strides_are_as_asked() {
    walk $rooms --frames 60 --stride 0.1 -o "$work/short.cam" && walk $rooms --frames 60 --stride 0.4 -o "$work/long.cam" &&
        [ "$(longest "$work/short.cam")" = 0.100 ] && [ "$(longest "$work/long.cam")" = 0.400 ]
}

begins_there() {
    first=$(awk '!/^#/ { print; exit }' "$work/a.cam")
    # shellcheck disable=SC2086 # words
    set -- $first
    walk $rooms --frames 2 --from "$1,$2,$3" --heading 90 --eye 1.6 -o "$work/there.cam" >/dev/null &&
        awk -v x="$1" -v z="$3" '!/^#/ && !n++ { dx = $1 - x; dz = $3 - z; exit !(dx * dx + dz * dz < 1e-4 && $4 - $1 < -0.999) }' "$work/there.cam"
}

compiled_scenes_do() {
    "$BUILD/limner" compile $rooms --tree bsp -o "$work/rooms" >/dev/null && walk "$work/rooms.lim" --frames 5 -o "$work/lim.cam" &&
        [ "$(lines "$work/lim.cam")" -eq 5 ]
}

refused() { # TEXT ARGUMENT...
    text=$1
    shift
    rm -f "$work/no.cam"
    ! walk "$@" >"$work/said" 2>"$work/err" && [ ! -e "$work/no.cam" ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
        grep -qF "limner: $text" "$work/err" || { cat "$work/err"; return 1; }
}

tap_check "rooms are walked through, twice the same" walks
tap_check "render takes the cameras" is_rendered
tap_check "strides are as long as asked" strides_are_as_asked
tap_check "it begins where it should" begins_there
tap_check "a compiled scene does as well" compiled_scenes_do
tap_check "no model is refused" refused "walk: needs a model" -o "$work/no.cam"
tap_check "no file is" refused "walk: -o FILE.cam says where to" $rooms
tap_check "two models are" refused "walk: one model at a time" $rooms $rooms -o "$work/no.cam"
tap_check "an unknown option is" refused "--fast: no such option here" $rooms --fast -o "$work/no.cam"
tap_check "no frames are" refused "--frames" $rooms --frames 0 -o "$work/no.cam"
tap_check "half a place is" refused "--from 1,2: must be the eye's X,Y,Z in metres" $rooms --from 1,2 -o "$work/no.cam"
tap_check "a place without ground is" refused "--from 500,2,3: there is no ground below" $rooms --from 500,2,3 -o "$work/no.cam"
tap_check "a solid in the air is" refused "sim/scenes/teapot.obj: there is no ground in its free space" sim/scenes/teapot.obj -o "$work/no.cam"
tap_check "a heading of nobody is" refused "--heading 3: belongs to --from" $rooms --heading 3 -o "$work/no.cam"
tap_check "an eye above the head is" refused "--eye 2: must be below the walker's height" $rooms --eye 2 -o "$work/no.cam"
tap_check "a giant is" refused "a walker of 500 m is too large" $rooms --height 500 --radius 200 -o "$work/no.cam"
tap_check "a dwarf is" refused "a walker of 0.01 m is too small" $rooms --height 0.01 --eye 0.005 --step 0.001 --radius 0.001 -o "$work/no.cam"
tap_check "a model that is not there is" refused "$work/none.obj" "$work/none.obj" -o "$work/no.cam"
tap_check "the model is not written over" refused "$rooms" $rooms -o $rooms
tap_done
