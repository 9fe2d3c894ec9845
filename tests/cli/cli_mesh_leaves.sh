# SPDX-License-Identifier: MIT
#
# Mesh leaves, from the command line: dense things in rooms are found, whatever their places; what the report, the header
# and the file say fits together; nobody gets them who did not ask, and nothing errs more than is promised.
. tests/tap.sh

limner=$BUILD/limner

says() { # PATTERN
    cat "$work/said"
    grep -qE -- "$1" "$work/said"
}

refused() { # REASON COMMAND...
    reason=$1
    shift
    "$limner" "$@" >/dev/null 2>"$work/said" && return 1
    [ "$(wc -l <"$work/said")" -eq 1 ] && says "$reason"
}

furnish() { # NAME SEED THINGS HOW
    awk -v seed="$2" -v things="$3" -v how="$4" -v dense=14 -v mtl="$work/$1.mtl" -f tests/furnished.awk >"$work/$1.obj"
}

report() { # MODEL OPTION...
    model=$1
    shift
    "$limner" compile "$work/$model.obj" --portals off "$@" --report >"$work/said" 2>&1
}

count() { # WHAT: the number behind it in the report; none: 0
    awk -v what="$1" 'index($0, what) { sub(".*" what " *", ""); print $1; seen = 1; exit } END { if (!seen) print 0 }' "$work/said"
}

for how in apart touching inside sheets planes; do
    furnish $how 7 5 $how
done

# All of them ------------------------------------------------------------------------------------------

has_leaves() { # MODEL OPTION...
    report "$@" --mesh-leaves all || return 1
    says '^    mesh leaves, by distance +[1-9]' && says '^  mesh leaves, not exact: [1-9][0-9]* dense part'
}
for how in apart touching inside sheets planes; do
    tap_check "dense things are leaves: $how" has_leaves $how --method nearest
done
for tree in bsp clusters axis octree; do
    tap_check "in a tree of kind $tree" has_leaves touching --tree $tree
done
tap_check "by scan lines" has_leaves apart --method scanline
tap_check "by the painter" has_leaves apart --method painter

is_less() { # MODEL WHAT PART: with leaves less than a part of what it is without
    report "$1" --method nearest --mesh-leaves none && before=$(count "$2") &&
        report "$1" --method nearest --mesh-leaves all && after=$(count "$2") || return 1
    echo "# $2: $before, with leaves $after"
    [ "$after" -lt $((before / $3)) ]
}
tap_check "what planes go through is split less" is_less planes splits 4
tap_check "a room with leaves takes less flash" is_less apart 'in all' 2

# Nothing is exact about it, and what stands apart is right all the same.
wrong() { # MODEL MOST OPTION...
    model=$1 most=$2
    shift 2
    "$limner" render "$work/$model.obj" --camera random:3:8 --size 160x120 --compare "$@" >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    awk -v most="$most" '/^compared/ { print; seen = 1; sub(/.*wrong /, ""); is_wrong = $1 + 0 > most } END { exit !seen || is_wrong }' "$work/said"
}
for how in apart touching inside sheets; do
    tap_check "pictures are right: $how" wrong $how 0.5 --mesh-leaves all
done

same_orders() {
    set -- "$work/apart.obj" --camera random:3:6 --size 80x60 --mesh-leaves all
    "$limner" render "$@" --method nearest --write-hashes "$work/hashes" >/dev/null 2>&1 &&
        "$limner" render "$@" --method scanline --check "$work/hashes" >/dev/null 2>&1
}
tap_check "nearest first and scan lines show the same" same_orders

# Nobody who did not ask ------------------------------------------------------------------------------

has_none() { # MODEL OPTION...
    report "$@" || return 1
    ! grep -q 'mesh leaves, by distance' "$work/said"
}
tap_check "none are none" has_none touching --mesh-leaves none
tap_check "a method that is named has none by itself" has_none touching --method nearest
tap_check "nor a tree that is named" has_none touching --tree bsp
tap_check "profile exact promises its order" has_none touching --precision exact --mesh-leaves all
tap_check "wireframe has none" has_none touching --wireframe --mesh-leaves all
tap_check "a framebuffer has none" has_none touching --framebuffer --mesh-leaves all
tap_check "a set has none" has_none touching --tree none --mesh-leaves all
tap_check "a mesh has none" has_none touching --method mesh --mesh-leaves all

draws_as_before() {
    set -- "$work/touching.obj" --frames 2 --size 64x48
    "$limner" render "$@" --mesh-leaves none --write-hashes "$work/hashes" >/dev/null 2>&1 &&
        "$limner" render "$@" --check "$work/hashes" >/dev/null 2>&1
}
tap_check "render has none by itself" draws_as_before

# The choice -------------------------------------------------------------------------------------------

chooses() { # what is taken is as right as promised, and cheaper; what is not says why
    report "$1" || return 1
    line=$(grep '^  mesh leaves, not exact' "$work/said") || { cat "$work/said"; return 1; }
    echo "# $line"
    case $line in
    *"none, after"*) ! says 'mesh leaves, by distance' ;;
    *) echo "$line" | awk '{
            match($0, /[0-9]+ instead of [0-9]+ instructions/); split(substr($0, RSTART), cost, " ")
            match($0, /[0-9.]+ % of pixels wrong, at most [0-9.]+/); split(substr($0, RSTART), share, " ")
            exit !(cost[1] + 0 <= cost[4] + 0 && RSTART && share[1] + 0 <= share[8] + 0) }' ;;
    esac
}
for how in apart touching inside sheets planes; do
    tap_check "the choice says why: $how" chooses $how
done
is_taken() { report inside && says '^  mesh leaves, not exact: [1-9]' && says '^    mesh leaves, by distance'; }
tap_check "a ring round a ball pays" is_taken
furnish mixed 12 7 planes
errs() { report mixed --splitter fewest && says '^  mesh leaves, not exact: none, after' && says 'of pixels wrong, at most'; }
tap_check "what goes through each other errs too much" errs

# Files ------------------------------------------------------------------------------------------------

writes() {
    "$limner" compile "$work/apart.obj" --portals off --method nearest --mesh-leaves all -o "$work/leafy" --report >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    grep -q '^#define LIM_HAS_MESH_LEAVES 1$' "$work/leafy.h" && grep -q '^#define LIM_HAS_LEAVES 1$' "$work/leafy.h" &&
        grep -qE 'SCENE_MEM_B.*\+ LIM_MESH_LEAF_MEM_B\([1-9][0-9]*, [1-9][0-9]*\)' "$work/leafy.h" &&
        grep -q 'approximate order' "$work/leafy.h" &&
        grep -qE '\.leaf_vertices = [1-9][0-9]*, \.leaf_polygons = [1-9]' "$work/leafy.c"
}
tap_check "the header asks for mesh leaves and their memory" writes
writes_none() {
    "$limner" compile "$work/apart.obj" --portals off --method nearest -o "$work/plain" --report >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    grep -q '^#define LIM_HAS_MESH_LEAVES 0$' "$work/plain.h" && ! grep -q 'LIM_MESH_LEAF_MEM_B' "$work/plain.h" &&
        ! grep -q 'approximate order' "$work/plain.h" && grep -q '\.leaf_vertices = 0, \.leaf_polygons = 0' "$work/plain.c"
}
tap_check "one without asks for nothing" writes_none
compiles() {
    for scene in leafy plain; do
        "${CC:-gcc}" -std=c11 $WARNINGS -Ifirmware -I"$work" -DLIM_CONFIG="\"$scene.h\"" -c -o "$work/$scene.o" "$work/$scene.c" || return 1
    done
}
tap_check "both are C" compiles
reads() {
    "$limner" render "$work/leafy.lim" --method nearest --frames 3 --size 80x60 --write-hashes "$work/hashes" >/dev/null 2>&1 &&
        "$limner" render "$work/apart.obj" --method nearest --mesh-leaves all --frames 3 --size 80x60 --check "$work/hashes" >/dev/null 2>&1
}
tap_check "the file shows what the model shows" reads
sorted_refused() { ! "$limner" render "$work/leafy.lim" --method "$1" --frames 1 -o "$work/x.png" >"$work/said" 2>&1; }
tap_check "methods that sort do not draw the file" sorted_refused depth

# What moves -------------------------------------------------------------------------------------------

moves() {
    "$limner" compile sim/scenes/movers.gltf --mesh-leaves all -o "$work/movers" --report >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    says "^  mesh leaf of 'ball', not exact: 1 dense part of 128 polygons" &&
        grep -qE 'MOVERS_LIMITS \{5, [0-9]+, [1-9][0-9]*, [1-9][0-9]*\}' "$work/movers.h" &&
        grep -qE 'MOVERS_MEM_B \(LIM_MOVERS_MEM_B\(.*\) \+ LIM_MESH_LEAF_MEM_B\([1-9][0-9]*, [1-9][0-9]*\)\)' "$work/movers.h" &&
        grep -q "'ball', by distance: an approximate order" "$work/movers.h"
}
tap_check "a dense object is one leaf" moves
moves_as_before() {
    "$limner" compile sim/scenes/movers.gltf --mesh-leaves none -o "$work/movers" --report >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    ! grep -q 'mesh leaf' "$work/said" && grep -qE 'MOVERS_LIMITS \{5, [0-9]+, 0, 0\}' "$work/movers.h"
}
tap_check "or none" moves_as_before

# The option -------------------------------------------------------------------------------------------

tap_check "another word is refused" refused '^limner: --mesh-leaves some: no such choice; there are auto, none and all$' \
    compile "$work/apart.obj" --mesh-leaves some --report
for command in measure worst report render; do
    tap_check "by $command, too" refused 'mesh-leaves some: no such choice' $command "$work/apart.obj" --mesh-leaves some
done
is_idle() { "$limner" render "$work/leafy.lim" --mesh-leaves all --frames 1 --size 32x32 -o "$work/x.png" 2>&1 | grep -q 'mesh-leaves.*compiled already'; }
tap_check "a compiled scene has its leaves" is_idle
tap_check "the help tells" sh -c "\"$limner\" help compile all | grep -q -- '--mesh-leaves WHICH'"
tap_check "bash completes it" sh -c "\"$limner\" help --bash-completion | grep -q -- \"--mesh-leaves) words='auto none all\""

tap_done
