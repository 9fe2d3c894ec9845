# SPDX-License-Identifier: MIT
#
# Portals from the command line: left out where they do not pay, kept where they do, forced, refused; a
# scene without has nothing of them.
. tests/tap.sh

limner=$BUILD/limner
rooms=sim/scenes/rooms.obj

says() { # PATTERN COMMAND...
    pattern=$1
    shift
    "$@" >"$work/out" 2>&1
    grep -qE -e "$pattern" "$work/out"
}
fails_with() { # PATTERN COMMAND...
    pattern=$1
    shift
    "$@" >"$work/out" 2>&1 && return 1
    [ "$(wc -l <"$work/out")" -eq 1 ] && grep -qE -e "$pattern" "$work/out"
}

tap_check "nearest first, the rooms go without, and the report says why" \
    says '^portals: at best they would spare [0-9.]+ % of the instructions; they pay from 10 % on$' \
    "$limner" compile $rooms -o "$work/without" --report
tap_check "by the painter they pay" says '^portals +kept$' "$limner" compile $rooms --method painter -o "$work/painter" --report
tap_check "they can be had all the same" says '^portals +kept$' "$limner" compile $rooms --portals on -o "$work/with" --report
# What the best of all would spare is no less than what they spare.
is_a_bound() {
    "$limner" compile $rooms -o "$work/with" --portals on --report | tee -a "$work/out" | grep '^  polygons reached, with ' || return 1
    awk '/^portals: at best/ { best = $7 } /^  instructions, with / { spared = $4 }
        END { print best, spared; exit !(best >= spared && spared > 0) }' "$work/without.report" "$work/out"
}
"$limner" compile $rooms -o "$work/without" --report >"$work/without.report"
tap_check "at best they would spare no less than they do" is_a_bound
# Where nearly all is seen from nearly everywhere, the largest rooms tell so.
hides_little() {
    "$limner" compile sim/scenes/glass.obj -o "$work/glass" --report >"$work/glass.report" &&
        grep '^portals: they would hide less than 3 % of the polygons$' "$work/glass.report" &&
        "$limner" compile sim/scenes/glass.obj --portals on -o "$work/glass" --report >"$work/glass.report" &&
        awk '/^  polygons in the scene / { all = $5 } /polygons a visible set shows/ { shown = $6 }
            END { print shown, all; exit !(all > 0 && shown >= 0.97 * all) }' "$work/glass.report"
}
tap_check "what hides hardly anything is told early" hides_little
tap_check "or not be looked for" "$limner" compile $rooms --portals off -o "$work/off"
tap_check "which is the same scene as when they are left out" cmp "$work/off.lim" "$work/without.lim"

nothing_of_them() {
    grep -q '^#define LIM_HAS_PORTALS 0$' "$work/without.h" && ! grep -qE 'PORTALS_MEM' "$work/without.h" &&
        ! grep -qE 'place|pvs' "$work/without.c"
}
all_of_them() {
    grep -q '^#define LIM_HAS_PORTALS 1$' "$work/with.h" && grep -q 'LIM_PORTALS_MEM_B' "$work/with.h" &&
        grep -q 'lim_place with_places' "$work/with.c" && grep -q 'uint8_t with_pvs' "$work/with.c"
}
tap_check "a scene without has nothing of them in C" nothing_of_them
tap_check "a scene with them has both arrays" all_of_them

object() { # NAME FLAG...: the renderer's code for the scene
    name=$1
    shift
    gcc -std=c11 -O2 -Wall -Wextra -Wundef -Werror -Ifirmware -I"$work" "-DLIM_CONFIG=\"$name.h\"" "$@" -c firmware/view/walk.c \
        -o "$work/walk.o" && gcc -std=c11 -Ifirmware -I"$work" "-DLIM_CONFIG=\"$name.h\"" "$@" -c firmware/view/portals.c -o "$work/portals.o" &&
        gcc -std=c11 -Wall -Wextra -Werror -Ifirmware -I"$work" "-DLIM_CONFIG=\"$name.h\"" "$@" -c "$work/$name.c" -o "$work/scene.o"
}
no_symbol() { object "$@" && [ -z "$(nm "$work/portals.o")" ]; }
has_symbol() { object "$@" && nm "$work/portals.o" | grep -q ' T lim_portals_unpack$'; }
tap_check "no symbol is linked for a scene without" no_symbol without
tap_check "a scene with them links the look-up" has_symbol with
tap_check "a build may leave them out of a scene that has them" no_symbol with -DLIM_HAS_PORTALS=0

pictures() { # FILE ARGUMENT...
    file=$1
    shift
    "$limner" render "$@" --camera sim/scenes/rooms.cam --size 120x90 --write-hashes "$work/$file"
}
same_pictures() {
    pictures plain $rooms && pictures forced $rooms --method portals && pictures file "$work/with.lim" &&
        cmp "$work/plain" "$work/forced" && cmp "$work/plain" "$work/file"
}
tap_check "the pictures are the same" same_pictures
tap_check "a compiled scene with them is drawn by --method portals" pictures again "$work/with.lim" --method portals
tap_check "one without is refused" \
    fails_with '^limner: .*/without.lim: --method portals needs a scene compiled with --portals on$' \
    "$limner" render "$work/without.lim" --method portals --stats
tap_check "a convex solid is refused" fails_with 'portals: one convex solid has no cells to look from$' \
    "$limner" compile sim/scenes/icosahedron.obj --portals on -o "$work/solid"
tap_check "a mesh from outside is refused" fails_with 'portals: its portals lead too far to be followed$' \
    "$limner" compile sim/scenes/teapot.obj --portals on -o "$work/teapot"
tap_check "clusters are refused" fails_with 'portals: they lead between cells of a BSP tree; this has none$' \
    "$limner" compile $rooms --tree clusters --portals on -o "$work/clusters"
nothing_written() { ! ls "$work"/solid* "$work"/teapot* "$work"/clusters* 2>/dev/null; }
tap_check "and nothing is written" nothing_written
tap_check "an unknown word is refused" fails_with '^limner: --portals maybe: there are on, off and auto$' \
    "$limner" compile $rooms --portals maybe --report
tap_done
