# SPDX-License-Identifier: MIT
#
# `--path`: what a scene is compiled for are the cameras of its program. Method and pools are theirs, and what is wrong
# with a file is said before anything is written.
. tests/tap.sh

compiled() { # NAME MODEL OPTION...: $work/NAME.c and its like, and $work/said
    name=$1
    shift
    "$BUILD/limner" compile "$@" -o "$work/$name" --report >"$work/said" 2>"$work/notes"
}

says() { # PATTERN
    grep -qE "$1" "$work/said"
}

memory_b() {
    sed -n 's/^ *working memory, bytes *//p' "$work/said"
}

from_anywhere_by_lines() {
    compiled anywhere sim/scenes/teapot.obj && says '^RAM at 240x240 pixels, by scan lines' && ! says ': chosen for these'
}

from_its_orbit_by_depth() {
    compiled orbit sim/scenes/teapot.obj --path sim/scenes/teapot.cam &&
        says '^ *cameras +64 of sim/scenes/teapot.cam: chosen for these' && says '^ *by depth .*: taken$' &&
        says '^RAM at 240x240 pixels, as a mesh, by depth'
}

# The same instructions are no reason to take a mesh, if it takes as much memory.
smaller_where_alike() {
    awk '/by the tree/ { tree = $4 } /by depth .*taken/ { mesh = $3 } /the tree took/ { flash_b = $4; mem_b = $9 }
        /^  in all/ && !own_b { own_b = $3 } /working memory, bytes/ { own_mem_b = $4 }
        END { exit !(mesh <= tree && (mesh <= 0.95 * tree || (own_b <= 0.95 * flash_b && own_mem_b <= 0.95 * mem_b))) }' "$work/said"
}

# A look at one wall takes less than a walk, and a walk through rooms no second one.
pools_are_the_path_s() {
    echo '-3.7 1.5 1.6 -3.7 1.5 -0.4' >"$work/one.cam"
    compiled anywhere sim/scenes/rooms.obj && anywhere_b=$(memory_b) &&
        compiled one sim/scenes/rooms.obj --path "$work/one.cam" && one_b=$(memory_b) &&
        echo "# one view $one_b bytes, any $anywhere_b" && [ "$one_b" -lt "$anywhere_b" ]
}

no_second_walk() {
    compiled walk sim/scenes/rooms.obj --path sim/scenes/rooms-walk.cam &&
        "$BUILD/limner" render "$work/walk.lim" --camera sim/scenes/rooms-walk.cam --stats >"$work/stats" &&
        awk '$1 == "frame" { for (i = 1; i <= NF; i++) column[$i] = i }
            $1 ~ /^[0-9]+$/ { frames++; if ($column["bands"] > 0) bands++ }
            END { exit !(frames > 30 && !bands) }' "$work/stats"
}

# Any other view is the same picture.
other_views_are_drawn() {
    "$BUILD/limner" render "$work/one.lim" --camera random:5:8 --write-hashes "$work/few" >/dev/null &&
        "$BUILD/limner" render "$work/anywhere.lim" --camera random:5:8 --write-hashes "$work/many" >/dev/null &&
        cmp "$work/few" "$work/many"
}

what_moves_has_times() {
    sed 's/$/ @0.5/; /^#/d' sim/scenes/movers.cam >"$work/times.cam"
    compiled moving sim/scenes/movers.gltf --path "$work/times.cam" && says 'cameras +48 of .*times.cam: chosen'
}

a_map_has_cameras() {
    map=/usr/share/games/doom/freedoom2.wad:MAP01
    compiled map "$map" --no-textures --path "$map" && says "cameras +[1-9][0-9]+ of $map: chosen for these"
}

measured_as_compiled() {
    "$BUILD/limner" measure sim/scenes/teapot.obj --camera sim/scenes/teapot.cam --path sim/scenes/teapot.cam --precision fast \
        --no-cost -o "$work/measured" >"$work/said" && says 'by depth'
}

refused() { # PATTERN FILE
    ! "$BUILD/limner" compile sim/scenes/teapot.obj --path "$2" -o "$work/refused" --report >"$work/said" 2>"$work/notes" &&
        grep -qE "$1" "$work/notes" && [ "$(wc -l <"$work/notes")" -eq 1 ] && [ ! -e "$work/refused.c" ] && [ ! -e "$work/refused.lim" ]
}

refuses_missing_files() { refused '^limner: .*/none.cam: No such file' "$work/none.cam"; }

refuses_broken_lines() {
    printf '0 0 5 0 0 0\n0 0 five 0 0 0\n' >"$work/broken.cam"
    refused '^limner: .*/broken.cam:2: ' "$work/broken.cam"
}

refuses_random_ones() { refused '^limner: --path random:1: ' random:1; }

refuses_far_eyes() {
    printf '0 0 5 0 0 0\n1e9 0 0 0 0 0\n' >"$work/far.cam"
    refused '/far.cam:2: the eye is too far' "$work/far.cam"
}

tap_check 'cameras anywhere: the teapot is drawn by scan lines' from_anywhere_by_lines
tap_check 'from its orbit it is a mesh by depth' from_its_orbit_by_depth
tap_check '... which takes no more instructions than the tree, and less of all else' smaller_where_alike
tap_check 'pools are no larger than the path takes' pools_are_the_path_s
tap_check 'no frame of a path takes a second walk' no_second_walk
tap_check 'all other views are drawn, too' other_views_are_drawn
tap_check 'cameras may have times' what_moves_has_times
tap_check 'they may be the players and things of a map' a_map_has_cameras
tap_check 'measure compiles in the same way' measured_as_compiled
tap_check 'a missing file is refused' refuses_missing_files
tap_check 'a line that is no camera is refused' refuses_broken_lines
tap_check 'cameras at random are refused, which no program has' refuses_random_ones
tap_check 'an eye out of range is refused, with its line' refuses_far_eyes
tap_done
