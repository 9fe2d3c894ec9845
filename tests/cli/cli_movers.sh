# SPDX-License-Identifier: MIT
#
# Animated models, from the command line: what moves is as right as what stands still, in both orders of drawing, also in
# a crowd; whether it moves and how it is lit can be chosen; it becomes C that compiles; what is no rigid motion is refused by name,
# by the true reason and with what helps; what is not drawn as the file has it is told in a line a kind.
. tests/tap.sh

model=sim/scenes/movers.gltf

movers() { # [OPTION...]: eight frames, compared with the reference
    awk '!/^#/ && n++ % 6 == 0' sim/scenes/movers.cam >"$work/few.cam"
    "$BUILD/limner" render $model --camera "$work/few.cam" --fps 2 "$@" >"$work/said" || return 1
    cat "$work/said"
}

says() { # PATTERN
    cat "$work/said"
    grep -qE "$1" "$work/said"
}

wrong_at_most() { # PERCENT [OPTION...]
    most=$1
    shift
    movers --compare "$@" && awk -v most="$most" '/^compared/ { wrong = $8; holes = $NF }
        END { exit !(wrong != "" && wrong + 0 <= most && holes == 0) }' "$work/said"
}

orders_agree() {
    movers --method nearest --write-hashes "$work/near" && movers --method scanline --check "$work/near"
}

differ() { # OPTION...
    movers --write-hashes "$work/one" && movers "$@" --write-hashes "$work/other" && ! cmp "$work/one" "$work/other"
}

is_what_compile_is_given() { # without movers the scene is one like any other
    movers --movers off --write-hashes "$work/still" && "$BUILD/limner" compile $model --movers off -o "$work/still" >/dev/null &&
        "$BUILD/limner" render "$work/still.lim" --camera "$work/few.cam" --check "$work/still" &&
        ! ls "$work"/still_object* && grep -q 'LIM_HAS_MOVERS 0' "$work/still.h"
}

compiles() {
    "$BUILD/limner" compile $model -o "$work/moving" >/dev/null && says_nothing_of_light &&
        ls "$work"/moving_object5.c "$work/moving_movers.c" &&
        for file in "$work"/moving*.c; do
            # shellcheck disable=SC2086 # flags are words
            ${CC:-cc} -std=c11 ${WARNINGS:?} -Ifirmware -I"$work" -DLIM_CONFIG='"moving.h"' -c -o "$work/object.o" "$file" || return 1
        done
}

says_nothing_of_light() {
    grep -q 'LIM_HAS_MOVERS 1' "$work/moving.h" && grep -q 'LIM_HAS_LIGHT 0' "$work/moving.h" && ! grep MOVING_LIGHT "$work/moving.h"
}

lit_says_so() {
    "$BUILD/limner" compile $model --mover-light turning -o "$work/lit" >/dev/null && grep -q 'LIM_HAS_LIGHT 1' "$work/lit.h" &&
        grep -q 'LIT_LIGHT {true, ' "$work/lit.h"
}

changed() { # SED-EXPRESSION: a copy of the model
    sed "$1" $model >"$work/changed.gltf" && ! cmp -s $model "$work/changed.gltf"
}

refused() { # REASON MODEL OPTION...
    reason=$1
    shift
    "$BUILD/limner" render "$@" -o "$work/%d.png" >/dev/null 2>"$work/said" && return 1
    says "$reason" && [ ! -e "$work/0.png" ] && [ "$(wc -l <"$work/said")" -eq 1 ]
}

refused_changed() { # REASON SED-EXPRESSION
    changed "$2" && refused "$1" "$work/changed.gltf"
}

noticed() { # an empty node takes the place of the block
    changed 's/{"mesh": 12, "name": "block"/{"name": "block"/' &&
        "$BUILD/limner" render "$work/changed.gltf" --camera "$work/few.cam" --stats 2>"$work/said" >/dev/null &&
        says "changed.gltf: node 'block' is animated, but has no mesh, nor anything below it: nothing moves, and cameras stay where they are$"
}

noticed_without_keys() {
    changed '/"componentType": 5126, "count": 9, "type": "SCALAR"/s/"count": 9/"count": 0/' &&
        "$BUILD/limner" compile "$work/changed.gltf" -o "$work/four" 2>"$work/said" >/dev/null &&
        says "changed.gltf: node 'ball' stands still: its animation has no keys$" && grep -q 'FOUR_MOVERS 4' "$work/four.h"
}

# The ball turns by a second animation too, or only by that one.
second='s/^\( *{"input": 40, "output": 42}\]}\)\],/\1, {"channels": [{"sampler": 0, "target": {"node": 9, "path": "rotation"}}],\n'
second_same="$second"'"samplers": [{"input": 28, "output": 30}]}],/'
second_other="$second"'"samplers": [{"input": 31, "output": 33}]}],/'

same_pictures() { # as the model that is not changed; errors to $work/said
    movers --write-hashes "$work/whole" && "$BUILD/limner" render "$work/changed.gltf" --camera "$work/few.cam" --fps 2 \
        --check "$work/whole" 2>"$work/said"
}

joined() {
    changed "$second_same; /\"sampler\": 1, /d" && same_pictures && [ ! -s "$work/said" ]
}

first_counts() {
    changed "$second_other" && same_pictures &&
        says "changed.gltf: node 'ball' is moved by several animations: the first that moves it is drawn, or that named after it; a file with one helps: of Blender's FBX without All Actions and NLA Strips$"
}

still_is_not() { # no objects, and nothing said of them
    "$BUILD/limner" compile --report $model --movers off >"$work/said" && ! says '^objects'
}

# One line an object and one for all: polygons, nodes, keys, bytes.
is_reported() {
    "$BUILD/limner" compile $model -o "$work/told" --report >"$work/said" && says '^objects that move  *polygons  *nodes  *keys  *bytes$' &&
        says "^  note: $work/told.lim holds what stands still alone" && awk '/^objects that move/ { inside = 1; next }
        inside && /^  working memory/ { working = $4; exit }
        inside && /^  in all/ { for (i = 1; i <= 4; i++) all[i] = $(i + 2); next }
        inside { rows++; names = names $1 " "; for (i = 1; i <= 4; i++) { sum[i] += $(i + 1); few = few || $(i + 1) < 1 } }
        END { for (i = 1; i <= 4; i++) wrong = wrong || sum[i] != all[i]
            exit !(rows == 5 && names == "ball bar post block crystal " && !few && !wrong && all[3] == 29 && working > 0) }' "$work/said"
}

textured_says_so() { # the ball shows a picture
    cp tests/models/quarters.png "$work/" && changed 's/{"name": "9", "pbrMetallicRoughness": {/&"baseColorTexture": {"index": 0}, /
        s/"attributes": {"POSITION": 18}/"attributes": {"POSITION": 18, "TEXCOORD_0": 43}/
        s/^  "animations": /  "textures": [{"source": 0}], "images": [{"uri": "quarters.png"}],\n&/
        s/^\( *{"bufferView": 42,.*}\)\],/\1, {"bufferView": 18, "componentType": 5126, "count": 384, "type": "VEC2"}],/' || return 1
    for command in "compile --report" "render --stats"; do
        # shellcheck disable=SC2086 # two words
        "$BUILD/limner" $command "$work/changed.gltf" --mover-light turning >"$work/said" 2>&1 &&
            says "note: object 'ball': textures are not drawn on what moves$" && [ "$(grep -c note: "$work/said")" -eq 1 ] || return 1
    done
}

# The ball's texture is the scene's, in whose file it is; the same pixels in firmware (measure compares hashes).
textured_shows_it() {
    "$BUILD/limner" compile "$work/changed.gltf" -o "$work/textured" --report >"$work/said" 2>&1 && ! grep -q 'note: object' "$work/said" &&
        grep -q '^const LIM_FLASH uint8_t textured_texels' "$work/textured.c" && grep -q 'textures = textured_textures' "$work"/textured_object1.c &&
        ! grep -q '_texels\[' "$work"/textured_object1.c &&
        "$BUILD/limner" measure "$work/changed.gltf" --size 64x64 --camera random:1:2 --precision fast --core m4 -o "$work/measured" >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
}

view() { # DUMP [OPTION...]: without a display, one frame
    dump=$1
    shift
    env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11 LIMNER_DUMP="$work/$dump" "$BUILD/limner" view $model \
        --camera "$work/few.cam" "$@" >/dev/null 2>"$work/said" </dev/null
}

view_begins() {
    view view.png && mkdir "$work/frames" && "$BUILD/limner" render $model --camera "$work/few.cam" -o "$work/frames/%d.png" &&
        cmp "$work/view.png" "$work/frames/0.png"
}

view_goes_on() {
    LIMNER_UNSEEN=1 SDL_VIDEODRIVER=dummy LIMNER_DUMP="$work/later.png" timeout --preserve-status -s INT 6 "$BUILD/limner" view $model \
        --camera "$work/few.cam" </dev/null && [ -s "$work/later.png" ] && [ -s "$work/view.png" ] && ! cmp -s "$work/later.png" "$work/view.png"
}

view_stands_still() {
    view depth.png --method depth && says 'movers.gltf: objects stand still; methods nearest, scanline and bsp move them$'
}

is_what_the_generator_writes() {
    # shellcheck disable=SC2086 # flags are words
    ${CC:-cc} -std=c11 -O2 ${WARNINGS:?} -o "$work/generate" sim/scenes/movers/generate_movers.c -lm && mkdir "$work/made" &&
        "$work/generate" "$work/made" && cmp "$work/made/movers.gltf" $model && cmp "$work/made/movers.cam" sim/scenes/movers.cam
}

tap_check "the model is what its generator writes" is_what_the_generator_writes
tap_check "as right as what stands still" wrong_at_most 0.02
tap_check "in profile fine too" wrong_at_most 0.008 --precision fine
tap_check "nearest first and by scan lines are the same pictures" orders_agree
tap_check "light that turns is another one" differ --mover-light turning
tap_check "time is frames by frames a second" differ --fps 3
tap_check "what is off stands still" differ --movers off
tap_check "and is a part of the scene" is_what_compile_is_given
tap_check "objects and motions are written as C, which compiles" compiles
tap_check "what each object takes is reported, and what all do" is_reported
tap_check "without movers there is nothing to report" still_is_not
tap_check "a light is written where it is asked for" lit_says_so
# What is predicted is measured with other random cameras, half of them near what stands still or moves.
predicted() { # [OPTION...]
    "$BUILD/limner" compile $model --report "$@" >"$work/said" || return 1
    awk '/wrong pixels, predicted/ { print $4 }' "$work/said"
}
predicted_is_measured() { # PROFILE
    expected=$(predicted --precision "$1") || return 1
    for kind in random near; do
        "$BUILD/limner" measure $model --no-cost --precision "$1" --camera $kind:5:24 >"$work/$kind" || return 1
    done
    awk -F ' *[|] *' -v profile="$1" -v predicted="$expected" '$2 == profile { measured += $4 / 2 }
        END { print predicted, measured; exit !(measured > 0 && predicted <= 2 * measured && measured <= 2 * predicted) }' \
        "$work/random" "$work/near"
}
tap_check "what is predicted of movers is measured, draft" predicted_is_measured draft
tap_check "and fast" predicted_is_measured fast

# All that stands still becomes larger, and the grid coarser.
around() { changed "s/{\"mesh\": \([0-8]\)},/{\"mesh\": \1, \"scale\": [$1, $1, $1]},/"; }
small_is_refused() { around 1000 && refused "node 'bar': face 193 [(]0\.3 m[)], .* of 12 faces would vanish or move too far" "$work/changed.gltf"; }
cut_is_refused() { refused "node 'bar': .* smaller than the distance within which nothing is drawn" "$work/changed.gltf" --precision exact; }
exact_is_chosen() {
    "$BUILD/limner" compile "$work/changed.gltf" --report --near 0.5 --max-error 1 --size 32x32 >"$work/said" &&
        says '^exact .* chosen$' && says "^draft, .*: refused: node 'bar': face"
}
dropped_is_said() { # all of one object cannot be
    around 700 && "$BUILD/limner" compile "$work/changed.gltf" --report --drop-small --near 0.3 >"$work/said" &&
        says "object 'bar': --drop-small left out [0-9]* of 12 faces, too small for the grid"
}
tap_check "a mover too small for the grid of a wide scene is refused by name" small_is_refused
tap_check "and one that its near plane would cut away" cut_is_refused
tap_check "each precision is judged by itself" exact_is_chosen
tap_check "what is left out of an object is said" dropped_is_said
tap_check "an animation that scales is refused" refused_changed \
    "node 'ball': its animation changes its scale, from -3 1.2 0.1 to [-0-9. ]*, and what moves keeps its size; --movers off draws it where the file has it$" '/"sampler": 0,/s/translation/scale/'
tap_check "a sheared mover is refused" refused_changed \
    "node 'bar': its own transform shears it, and its animation cannot; apply the transform .*, or --movers off$" \
    's/"name": "bar", "translation": [[][^]]*[]]/"name": "bar", "matrix": [1,0,0,0, 0.5,1,0,0, 0,0,1,0, 0,0,0,1]/'
below() { # the post moves with the bar, which moves too
    changed 's/"name": "bar",/"name": "bar", "children": [11],/; s/"scenes": [[]{"nodes": [[].*/"scenes": [{"nodes": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13]}],/'
}
namesake() { changed 's/"name": "post"/"name": "ball"/'; }
all_move() { changed 's/"scenes": [[]{"nodes": [[].*/"scenes": [{"nodes": [9, 10, 11, 12, 13]}],/'; }
changed_is_right() { # CHANGE PERCENT: by the reference's own reading
    "$1" && "$BUILD/limner" render "$work/changed.gltf" --frames 16 --compare >"$work/said" 2>&1 || return 1
    cat "$work/said"
    awk -v most="$2" '/^compared/ { wrong = $8; holes = $NF } END { exit !(wrong != "" && wrong + 0 <= most && holes == 0) }' "$work/said"
}
same_as_unchanged() { namesake && same_pictures; }
all_move_silently() { ! grep -q 'note:' "$work/said"; }
tap_check "a mover below another goes with it" changed_is_right below 0.02
tap_check "movers of one name are two" same_as_unchanged
tap_check "where nothing stands still all is drawn" changed_is_right all_move 0.02
tap_check "and nothing is said of it" all_move_silently
tap_check "places of one animation and turns of another are one motion" joined
tap_check "of two animations of one kind the first counts, and a line says so" first_counts
tap_check "an animation without keys stands still, and a line says so" noticed_without_keys
tap_check "an animated node without a mesh moves nothing, and a line says so" noticed
tap_check "a textured mover has one colour where it is lit in each frame, and a line says so" textured_says_so
tap_check "else it shows its texture, which is the scene's" textured_shows_it
no_firmware() { ! "$BUILD/limner" compile $model --method newell -o "$work/sorted" >/dev/null 2>"$work/said" && [ ! -e "$work/sorted.h" ] &&
    grep -q '^limner: --method newell: it moves no objects' "$work/said"; }
tap_check "nor is firmware made for it" no_firmware
for method in newell painter; do
    tap_check "--method $method moves nothing" refused \
        "^limner: .*--method $method: it moves no objects; nearest and scanline do, with any tree\$" $model --method $method
done
for mode in x clipped centre; do
    tap_check "--movers $mode is refused" refused "^limner: --movers $mode: no such way; there are on and off\$" $model --movers $mode
done
tap_check "an unknown light is refused" refused '^limner: --mover-light x: no such light; there are baked and turning$' \
    $model --mover-light x
tap_check "view begins as render does" view_begins
if ldd "$BUILD/limner" | grep -q libSDL2; then
    tap_check "and moves what moves" view_goes_on
else
    tap_skip "and moves what moves" "built without SDL2"
fi
tap_check "view by a method that moves nothing says so" view_stands_still
for fps in 0 -1 x 1e9; do
    tap_check "--fps $fps is refused" refused '^limner: --fps ' $model --fps $fps
done
# What animations may say, of files that are made here; where things are at a time is tests/unit/readers/test_node_motion.c's
# and tests/brought/kind_motion.py's.
python3 tests/models/animated.py "$work"

render() { # MODEL [OPTION...]
    model=$work/$1.gltf
    shift
    "$BUILD/limner" render "$model" --frames 8 --size 120x120 "$@" >"$work/said" 2>&1 || return 1
    sed -i '/faces are covered/d' "$work/said" # by others in their plane: not of motion
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

tap_check "a scale that keys keep is drawn" is_right kept
tap_check "jumps are" is_right jumps
tap_check "a mirrored node is" is_right mirrored
tap_check "what an uneven scale above does not shear is" is_right slides
tap_check "what leaves the scene is, and it is not left out" is_right away
tap_check "a scale that changes is refused, with both" refuses grows \
    "node 'box': its animation changes its scale, from 1 1 1 to 2 1 1, and what moves keeps its size; --movers off draws it where the file has it$"
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
    "2 nodes, 'lamp' the first, are animated, but have no mesh, nor anything below them: nothing moves, and cameras stay where they are$" \
    "1 animation of morph targets' weights is not run: drawn with the weights that the file has at rest$"
tap_check "nodes of several animations have one" notes_alone twice \
    "2 nodes, 'box 0' the first, are moved by several animations: the first that moves each is drawn, or that named after it; a file with one helps: of Blender's FBX without All Actions and NLA Strips$"
tap_check "a crowd of bars through a point is drawn" is_right crowd_bars
tap_check "a crowd of boxes is" is_right crowd_boxes
tap_check "in a tree of clusters, too" is_right crowd_boxes --tree clusters
tap_check "a few that meet are" is_right few_meet
tap_check "many that do not meet are" is_right many_apart
tap_done
