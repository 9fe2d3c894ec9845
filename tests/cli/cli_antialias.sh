# SPDX-License-Identifier: MIT
#
# Antialiased edges on the command line: the same pictures from a compiled scene, from any tree and from sorted polygons;
# the figure of their error; the firmware's configuration; and what is refused.
. tests/tap.sh

rooms() { # [OPTION...]: hashes of eight frames
    awk 'n++ % 8 == 0' sim/scenes/rooms.cam >"$work/few.cam"
    "$BUILD/limner" render sim/scenes/rooms.obj --camera "$work/few.cam" --size 96x72 "$@"
}

differs_from_aliased() {
    rooms --antialias --write-hashes "$work/smooth" && rooms --write-hashes "$work/aliased" &&
        [ "$(sort "$work/smooth" "$work/aliased" | uniq -d | wc -l)" -eq 0 ]
}

same_by() { # OPTION...
    rooms --antialias "$@" --write-hashes "$work/other" && cmp "$work/smooth" "$work/other"
}

compiled_knows_it() {
    "$BUILD/limner" compile sim/scenes/rooms.obj --size 96x72 --antialias -o "$work/rooms" >/dev/null &&
        "$BUILD/limner" render "$work/rooms.lim" --camera "$work/few.cam" --size 96x72 --antialias --stats \
            --check "$work/smooth" >"$work/said" && grep -q 'LIM_HAS_ANTIALIAS 1' "$work/rooms.h" &&
        awk '$1 == "frame" { for (i = 1; i <= NF; i++) column[$i] = i }
            $1 == "mean" { print; found = 1; many = $column["bands"] > 0.5 }
            END { exit many || !found }' "$work/said"
}

others_do_not() {
    "$BUILD/limner" compile sim/scenes/rooms.obj --size 96x72 -o "$work/plain" >/dev/null &&
        grep -q 'LIM_HAS_ANTIALIAS 0' "$work/plain.h"
}

a_solid_is_drawn_from_its_tree() { # by its own method it could not be
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --antialias -o "$work/solid" >/dev/null &&
        grep -qE 'LIM_HAS_(NEAREST|SCANLINE) 1' "$work/solid.h" && grep -q 'LIM_HAS_CONVEX 0' "$work/solid.h"
}

error_is_printed() {
    rooms --antialias --compare >"$work/said" && tail -n 1 "$work/said" &&
        awk '/^edges against 256 rays/ { found = 1; for (i = 1; i < NF; i++) if ($(i + 1) == "%") exit !($i > 5 && $i <= 25) }
            END { exit !found }' "$work/said"
}

refused() { # REASON COMMAND OPTION...
    reason=$1 command=$2
    shift 2
    ! "$BUILD/limner" "$command" sim/scenes/icosahedron.obj --antialias "$@" >"$work/out" 2>"$work/said" &&
        [ "$(wc -l <"$work/said")" -eq 1 ] && grep -qE -e "^limner: ([^ ]*: )?--antialias $reason" "$work/said"
}

tap_check "edges are not what they are without" differs_from_aliased
for method in clusters newell portals; do
    tap_check "$method paints the same" same_by --method $method
done
tap_check "into plain memory, the same" same_by --panel memory
tap_check "a compiled scene has the memory for it" compiled_knows_it
tap_check "and others have nothing of it" others_do_not
tap_check "a convex solid is drawn from its tree" a_solid_is_drawn_from_its_tree
tap_check "the error at edges is printed, and a quarter at most" error_is_printed
tap_check "the painter has none" refused '--method painter: ' render --method painter
tap_check "nor has a firmware that paints back to front" refused '--method painter: ' compile --method painter --report
tap_check "nor what is drawn as one convex solid" refused '--method convex: ' render --method convex
tap_check "nor a wireframe" refused '--wireframe: ' render --wireframe
tap_done
