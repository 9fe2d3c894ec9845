# SPDX-License-Identifier: MIT
#
# Textures from the command line: what the report says of pictures that are resized or not to be read, frames of the
# textured demo by every order, the scene as a file, and how far texels are from the model's own.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
demo=$(cd "$BUILD/scenes/textured" && pwd)
models=$(pwd)/tests/models
cp "$models"/quarters.* "$work"
cp -R "$demo" "$work/demo"
cd "$work" || exit 1
printf '0.5 0.5 1.4 0.5 0.5 0\n' >front.cam

hashes() { # FILE MODEL-OR-SCENE CAMERA OPTION...
    hashes_to=$1 hashes_of=$2 hashes_camera=$3
    shift 3
    timeout 120 "$limner" render "$hashes_of" --camera "$hashes_camera" --write-hashes "$hashes_to" "$@" 2>said
}

# Four squares of one colour each are the same picture.
quarters_are_where_they_belong() { # SUFFIX
    hashes flat.hashes flat.obj front.cam --unlit --size 64x64 &&
        hashes "$1.hashes" quarters."$1" front.cam --unlit --size 64x64 || return 1; cat said flat.hashes "$1.hashes"; cmp flat.hashes "$1.hashes"
}

flat_quarters() {
    printf 'newmtl %s\nKd %s\n' red '1 0 0' green '0 1 0' blue '0 0 1' white '1 1 1' >flat.mtl
    cat <<'OBJ'
mtllib flat.mtl
v 0 0 0
v 0.5 0 0
v 1 0 0
v 0 0.5 0
v 0.5 0.5 0
v 1 0.5 0
v 0 1 0
v 0.5 1 0
v 1 1 0
usemtl red
f 4 5 8 7
usemtl green
f 5 6 9 8
usemtl blue
f 1 2 5 4
usemtl white
f 2 3 6 5
OBJ
}

same_frames() { # FILE FILE
    diff "$1" "$2" && [ "$(cut -d ' ' -f 2 "$1" | sort -u | wc -l)" -gt 40 ]
}

orders_agree() { # PRECISION
    hashes near demo/textured.obj demo/textured.cam --precision "$1" --size 120x90 &&
        hashes far demo/textured.obj demo/textured.cam --precision "$1" --size 120x90 --method painter && same_frames near far
}

file_agrees() {
    "$limner" compile demo/textured.obj -o scene --report >report && hashes model demo/textured.obj demo/textured.cam &&
        hashes file scene.lim demo/textured.cam && same_frames model file
}

notes() { # PATTERN MODEL OPTION...: the report and the renderer say the same, and both go on
    pattern=$1 model=$2
    shift 2
    "$limner" compile "$model" "$@" --report >report || return 1
    grep 'note: ' report
    hashes none "$model" front.cam "$@" && cat said && grep -q "note: $pattern" report && grep -q "^limner: note: $pattern" said
}

is_flat() { # MODEL OPTION...: of one colour
    "$limner" render "$@" --camera front.cam --size 8x8 --fov 40 -o 'flat%d.png' 2>/dev/null &&
        "$limner" compile "$@" -o bare >/dev/null && grep -q 'LIM_HAS_TEXTURE 0' bare.h
}

# Red, and green that is half transparent.
half_clear() {
    echo iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEklEQVR42mP4z8DwHwgbGGAMAEBXBvtWfMWmAAAAAElFTkSuQmCC | base64 -d
}

# Red and a hole, blue and white.
holes() {
    echo iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4z8DwHwhB4D8YAAA/0gj40XhpOAAAAABJRU5ErkJggg== | base64 -d >holes.png
    echo iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAAAAABX3VL4AAAADklEQVR42mP4z8Dw/z8AB/4C/krRhL8AAAAASUVORK5CYII= | base64 -d >white.png # as a mask alone
}

yellow() {
    printf 'newmtl yellow\nKd 1 1 0\n'
}

# A wall just behind all of it, and a little more.
wall_behind() {
    printf 'v -1 -1 -0.01\nv 2 -1 -0.01\nv 2 2 -0.01\nv -1 2 -0.01\nusemtl yellow\nf -4 -3 -2 -1\n'
}

# Holes of its picture show the wall as holes in a model do: MODEL OPTION...
holes_show_what_is_behind() {
    model=$1
    shift
    for method in nearest painter scanline; do
        hashes flat.hashes around.obj front.cam --unlit --size 64x64 --method $method "$@" &&
            hashes holes.hashes "$model" front.cam --unlit --size 64x64 --method $method "$@" || return 1
        cat said flat.hashes holes.hashes
        ! grep 'its transparency' said && cmp flat.hashes holes.hashes || return 1
    done
    "$limner" compile "$model" -o holes --report >report && grep -q 'LIM_HAS_MASKED 1' holes.h &&
        hashes file.hashes holes.lim front.cam --size 64x64 && hashes model.hashes "$model" front.cam --size 64x64 || return 1
    cat said file.hashes model.hashes
    cmp file.hashes model.hashes
}

is_a_pane() { # MODEL: without textures, or with lines alone, nothing is linked for holes
    "$limner" compile "$1" --no-textures -o pane --report >report && grep -q 'LIM_HAS_MASKED 0' pane.h
}

says_nothing() { # MODEL: of transparency; but it has its texture
    "$limner" compile "$1" -o bare --report >report || return 1
    ! grep 'its transparency' report && grep -q 'LIM_HAS_TEXTURE 1' bare.h
}

# All four materials show one picture: one blends, two are masks and one, with two of six faces, is opaque.
alpha_modes_with() { # PICTURE
    sed -e 's/"pbrMetallicRoughness": {/&"baseColorTexture": {"index": 0},/' \
        -e "s/^ \"materials\"/ \"textures\": [{\"source\": 0}], \"images\": [{\"uri\": \"$1\"}],&/" "$models/alpha_modes.gltf"
}

texels_are_near() { # PRECISION MOST
    timeout 120 "$limner" measure demo/textured.obj --camera demo/textured.cam --no-cost --precision "$1" >table || return 1
    mean=$(awk -F '|' '/texel error mean/ { getline; getline; print $3; exit }' table)
    whole=$(awk -F '|' '/texel error mean/ { getline; getline; print $5; exit }' table)
    echo "$1: $mean texels of the level shown, $whole of the whole picture"
    awk -v mean="$mean" -v whole="$whole" -v most="$2" 'BEGIN { exit !(mean > 0 && mean <= most && whole <= most) }'
}

texel_column() { # NAME: of each profile, draft to exact
    awk -F , -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } { printf "%s ", $at[name] } END { print "" }' texels/measure.csv
}

# The finer a profile, the nearer; a picture of fast and finer shows no texel that is not next to the true one.
profiles_get_nearer() {
    timeout 300 "$limner" measure demo/textured.obj --camera demo/textured.cam --no-cost -o texels >said 2>&1 || { cat said; return 1; }
    texel_column texel_rms && texel_column texel_far_percent && texel_column texel_level_percent && texel_column texel_straight_percent
    texel_column texel_rms | awk '{ exit !(NF == 4 && $1 < 0.5 && $2 < 0.1 && $3 < 0.03 && $4 < 0.01 && $1 > $2 && $2 > $3 && $3 > $4 && $4 > 0) }' &&
        texel_column texel_far_percent | awk '{ exit !(NF == 4 && $1 > 0 && $1 < 1 && $2 + $3 + $4 == 0) }' &&
        texel_column texel_level_percent | awk '{ exit !(NF == 4 && $1 < 12 && $2 < 12 && $3 < 12 && $4 < 12 && $1 >= $4) }' &&
        texel_column texel_straight_percent | awk '{ exit !(NF == 4 && $1 > 5 && $1 < 95 && $2 > 5 && $2 < 95) }'
}

meshes_are_measured_too() {
    timeout 300 "$limner" measure demo/textured.obj --camera demo/textured.cam --no-cost --method mesh-depth --precision fast -o texels >said 2>&1 || { cat said; return 1; }
    texel_column texel_rms && texel_column texel_far_percent && texel_column texel_straight_percent
    texel_column texel_rms | awk '{ exit !(NF == 1 && $1 > 0 && $1 < 0.2) }' && texel_column texel_far_percent | awk '{ exit !($1 < 0.5) }' &&
        [ "$(texel_column texel_straight_percent)" = ' ' ] && grep -q '^| fast | - | - | - |' texels/measure.md
}

# Columns are there, and empty.
plain_models_have_none() {
    "$limner" measure flat.obj --camera front.cam --size 32x32 --no-cost --precision fast -o texels >said 2>&1 || { cat said; return 1; }
    tail -n 1 texels/measure.csv && [ "$(texel_column texel_rms)$(texel_column texel_far_percent)" = '  ' ] && ! grep -q 'texel error' texels/measure.md &&
        awk -F , '{ fields[NF]++ } END { for (n in fields) kinds++; exit kinds != 1 }' texels/measure.csv
}

flat_quarters >flat.obj
tap_check 'an OBJ names its picture' quarters_are_where_they_belong obj
tap_check 'a GLB holds it' quarters_are_where_they_belong glb
for precision in draft fast fine exact; do
    tap_check "$precision: both orders paint the textured demo alike" orders_agree $precision
done
tap_check 'a .lim file shows what the model shows' file_agrees
tap_check 'fast: texels are within a quarter' texels_are_near fast 0.25
tap_check 'fine: within a 12th' texels_are_near fine 0.083
tap_check 'exact: within a 40th' texels_are_near exact 0.025
tap_check 'the finer a profile, the nearer its texels' profiles_get_nearer
tap_check 'of meshes, too, it is known which texels are painted' meshes_are_measured_too
tap_check 'models without textures have no such figures' plain_models_have_none
tap_check 'the demo is what it was' "$limner" render demo/textured.obj --camera demo/textured.cam --size 120x90 --check "$OLDPWD/tests/textured.hashes"

tap_check 'what is resized is noted' notes 'texture bricks.png: 120x90 pixels, resized to 128x64' demo/textured.obj
sed 's/quarters.png/none.png/' quarters.mtl >none.mtl
sed 's/quarters.mtl/none.mtl/' quarters.obj >none.obj
refuses_texture() { # REASON
    for command in compile render 'measure --no-cost'; do
        "$limner" $command none.obj -o never 2>said && return 1
        cat said
        grep -qx "limner: none.obj: texture none.png: $1.*; --no-textures does without" said || return 1
        ! ls never* 2>/dev/null || return 1
    done
}
tap_check 'a missing picture is an error' refuses_texture 'there is no such file'
tap_check 'unless textures are not wanted' notes 'texture none.png: there is no such file; faces of a flat colour instead: 1' none.obj --no-textures
tap_check 'then there is a flat face, without a texture in the firmware' is_flat none.obj --no-textures
head -c 40 quarters.png >none.png
tap_check 'so is a damaged one' refuses_texture 'damaged'
: >none.png
tap_check 'and an empty one' refuses_texture 'the file is empty'
tap_check 'of one that can be read there is a flat face, too' is_flat quarters.obj --no-textures
half_clear >clear.png
sed 's/quarters.png/clear.png/' quarters.mtl >clear.mtl
sed 's/quarters.mtl/clear.mtl/' quarters.obj >clear.obj
tap_check 'transparency that is not drawn is noted' notes 'texture clear.png: its transparency is not drawn; faces that it belongs to: 1; a cut-out is, as of alphaMode MASK$' clear.obj
compile_tells() { # without --report, too
    "$limner" compile clear.obj -o clear >short 2>said && cat said && grep -q '^limner: note: texture clear.png: its transparency is not drawn' said
}
tap_check 'by compile as well' compile_tells
tap_check 'where nothing is transparent nothing is said' says_nothing quarters.obj
(cat quarters.mtl && echo 'map_d mask.png') >masked.mtl
sed 's/quarters.mtl/masked.mtl/' quarters.obj >masked.obj
tap_check 'so is that of a mask' notes 'texture mask.png: its transparency is not drawn; faces that it belongs to: 1; a cut-out is, as of alphaMode MASK$' masked.obj
alpha_modes_with clear.png >modes.gltf
tap_check 'and in glTF that of what is not OPAQUE, but for a mask of which texels are clear' notes 'texture clear.png: its transparency is not drawn; faces that it belongs to: 3; a cut-out is, as of alphaMode MASK$' modes.gltf
holes_are_as_they_were() { # METHOD
    timeout 120 "$limner" render "$models/holes.obj" --camera "$models/holes.cam" --sky heaven --size 96x72 --method "$1" --check "$models/holes.hashes"
}
for method in nearest painter; do
    tap_check "$method: bars before a sky are what they were" holes_are_as_they_were $method
done
holes
(flat_quarters | sed '/^usemtl green/,/^f/d' && wall_behind) >around.obj
yellow >>flat.mtl
(sed 's/quarters.png/holes.png/' quarters.mtl && yellow) >holes.mtl
(sed 's/quarters.mtl/holes.mtl/' quarters.obj && wall_behind) >holes.obj
tap_check 'clear texels of an OBJ are holes' holes_show_what_is_behind holes.obj
tap_check 'in every profile' holes_show_what_is_behind holes.obj --precision exact
(cat quarters.mtl && echo 'map_d white.png' && yellow) >by_mask.mtl
(sed 's/quarters.mtl/by_mask.mtl/' quarters.obj && wall_behind) >by_mask.obj
tap_check 'so are the black ones of its mask' holes_show_what_is_behind by_mask.obj
cat >holes.gltf <<'GLTF'
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0},
                           {"attributes": {"POSITION": 3}, "indices": 2, "material": 1}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "alphaMode": "MASK", "alphaCutoff": 0.4},
              {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 0, 1]}}],
"textures": [{"source": 0}], "images": [{"uri": "holes.png"}],
"buffers": [{"byteLength": 140, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAIA/AACAPwAAgD8AAAAAAAAAAAAAAAAAAAEAAgAAAAIAAwAAAIC/AACAvwrXI7wAAABAAACAvwrXI7wAAABAAAAAQArXI7wAAIC/AAAAQArXI7w="}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                {"buffer": 0, "byteOffset": 80, "byteLength": 12}, {"buffer": 0, "byteOffset": 92, "byteLength": 48}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
              {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
              {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
              {"bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, -0.01], "max": [2, 2, -0.01]}]}
GLTF
tap_check 'so are those of a glTF whose alphaMode is MASK' holes_show_what_is_behind holes.gltf
sed 's/"MASK"/"BLEND"/' holes.gltf >blend.gltf
tap_check 'BLEND is not drawn, and noted' notes 'texture holes.png: its transparency is not drawn; faces that it belongs to: 2; a cut-out is, as of alphaMode MASK$' blend.gltf
sed 's/"MASK"/"OPAQUE"/' holes.gltf >opaque.gltf
tap_check 'OPAQUE has no holes' says_nothing opaque.gltf
tap_check 'a mesh draws none, and says so' sh -c "! '$limner' compile holes.obj --method mesh -o never 2>said && grep 'transparent faces are not drawn' said"
tap_check 'without textures no holes are linked' is_a_pane holes.obj
sky_is_drawn() { # of a square's picture where it stands, and endlessly far away: the same from two places, but for its edges
    printf '0 0 1 0 0 -1\n0.4 0.2 1 0.4 0.2 -1\n' >two.cam
    sed -e 's/^v 0 0 0/v -9 -9 0/;s/^v 1 0 0/v 9 -9 0/;s/^v 1 1 0/v 9 9 0/;s/^v 0 1 0/v -9 9 0/' quarters.obj >wide.obj
    hashes sky.hashes wide.obj two.cam --sky quarters --size 64x64 &&
        hashes wall.hashes wide.obj two.cam --size 64x64 || return 1
    cat sky.hashes wall.hashes
    [ "$(cut -d ' ' -f 2 sky.hashes | sort -u | wc -l)" = 1 ] && [ "$(cut -d ' ' -f 2 wall.hashes | sort -u | wc -l)" = 2 ] &&
        "$limner" compile wide.obj --sky=quarters -o sky --report >report && grep -q 'LIM_HAS_SKY 1' sky.h &&
        hashes file.hashes sky.lim two.cam --size 64x64 && cmp sky.hashes file.hashes &&
        "$limner" compile wide.obj -o sky --report >report && grep -q 'LIM_HAS_SKY 0' sky.h
}
tap_check 'faces of the material that --sky names are a sky' sky_is_drawn
tap_check 'a sky that no material is, is told' sh -c "'$limner' compile quarters.obj --sky heaven -o none 2>&1 | grep 'quarters.obj: --sky: no material of that name has a picture'"
tap_check 'a mesh draws none, and says so' sh -c "! '$limner' compile wide.obj --sky quarters --method mesh -o never 2>said && grep 'no sky is drawn' said"
sed 's/^vt 1 0/vt 1e20 0/' quarters.obj >far.obj
tap_check 'coordinates out of all range leave a flat face' is_flat far.obj
grep -v '^vt' quarters.obj | sed 's,/[0-9],,g' >bare.obj
tap_check 'so do none at all' is_flat bare.obj
"$limner" compile bare.obj --report >report
tap_check 'which the report counts' grep -q 'no texture coordinates *1$' report
tap_done
