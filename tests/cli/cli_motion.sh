# SPDX-License-Identifier: MIT
#
# What animations may say, from the command line: drawn by the reference's own reading of the file, told in a line, or
# refused by the true reason with what helps; and --movers off draws all of it. Where things are at a time is
# tests/unit/sim/test_node_motion.c's and tests/brought/kind_motion.py's.
. tests/tap.sh

python3 tests/cli/motion_files.py "$work"

render() { # MODEL [OPTION...]
    model=$work/$1.gltf
    shift
    "$BUILD/limner" render "$model" --frames 8 --size 120x120 "$@" >"$work/said" 2>&1
}

says() { # PATTERN
    cat "$work/said"
    grep -qE "$1" "$work/said"
}

is_near() { # MODEL [OPTION...]
    render "$@" --compare && cat "$work/said" &&
        awk '/^compared/ { wrong = $8; holes = $NF } END { exit !(wrong != "" && wrong + 0 <= 0.05 && holes == 0) }' "$work/said"
}

is_right() { # MODEL [OPTION...]: and nothing is said
    is_near "$@" && ! grep -q 'note:' "$work/said"
}

refuses() { # MODEL PATTERN
    ! render "$1" -o "$work/%d.png" && says "^limner: .*/$1.gltf: $2" && [ ! -e "$work/0.png" ] && [ "$(wc -l <"$work/said")" -eq 1 ]
}

notes_alone() { # MODEL PATTERN...: these lines and no other notes
    name=$1
    shift
    render "$name" || return 1
    for pattern in "$@"; do
        says "^limner: note: .*/$name.gltf: $pattern" || return 1
    done
    [ "$(grep -c 'note:' "$work/said")" -eq $# ]
}

off_draws() { # all of it, and one line says what stands still
    for file in "$work"/*.gltf; do
        name=$(basename "$file" .gltf)
        render "$name" --movers off --compare && says 'gltf: what is animated stands still where the file has it$' &&
            [ "$(grep -c 'note:' "$work/said")" -eq 1 ] || return 1
    done
}

compile_notes() {
    "$BUILD/limner" compile "$work/crowd_bars.gltf" -o "$work/crowd" >/dev/null 2>"$work/said" && says "$crowd"
}

has_holes() { # MODEL [OPTION...]
    render "$@" --compare && awk '/^compared/ { holes = $NF } END { exit !(holes > 0) }' "$work/said"
}

tree_helps() {
    has_holes crowd_boxes && ! has_holes crowd_boxes --tree clusters && says 'holes 0$' && ! grep -q 'in a crowd' "$work/said"
}

crowd='objects that move pass through each other in a crowd: in [0-9.e+]+ % of sampled views .* --tree clusters helps$'
tap_check "a scale that keys keep is drawn" is_right kept
tap_check "jumps are" is_right jumps
tap_check "a mirrored node is" is_right mirrored
tap_check "what an uneven scale above does not shear is" is_right slides
tap_check "what leaves the scene is, and it is not left out" is_right away
tap_check "a scale that changes is refused, with both" refuses grows \
    "node 'box': its animation changes its scale, from 1 1 1 to 2 1 1; --movers off draws it where the file has it, or apply"
tap_check "what an uneven scale above shears is refused" refuses shears \
    "node 'box': the uneven scale of a node above shears it as it turns; apply that scale .*, or --movers off$"
tap_check "times that go back are refused" refuses backwards \
    "animation 1: its times do not ascend from 0, or a key is no number; --movers off draws all where the file has it$"
tap_check "what moves too far is refused" refuses too_far \
    "node 'box': it moves too far for coordinates of 16 bits; --coordinates 32, a ground in the scene or --movers off helps$"
tap_check "and drawn as is said" is_near too_far --coordinates 32
tap_check "whatever is animated stands still with --movers off" off_draws
tap_check "bones, bare nodes and weights have a line a kind" notes_alone skin \
    "3 nodes, 'joint 0' the first, are animated and move skins: these are drawn at rest$" \
    "2 nodes, 'lamp' the first, are animated, but have no mesh, nor anything below them: nothing moves$" \
    "1 animation of morph targets' weights is not run: drawn with the weights that the file has at rest$"
tap_check "nodes of several animations have one" notes_alone twice \
    "2 nodes, 'box 0' the first, are moved by several animations: the first one counts$"
tap_check "a crowd of bars through a point is noted" notes_alone crowd_bars "$crowd"
tap_check "a crowd of boxes is" notes_alone crowd_boxes "$crowd"
tap_check "compile notes it too" compile_notes
tap_check "the tree that the note names draws it" tree_helps
tap_check "a few that meet are not noted" is_right few_meet
tap_check "many that do not meet are not" is_right many_apart
tap_done
