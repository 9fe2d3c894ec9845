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
    "$limner" compile demo/textured.obj -o scene >report && hashes model demo/textured.obj demo/textured.cam &&
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

says_nothing() { # MODEL: of transparency; but it has its texture
    "$limner" compile "$1" -o bare >report || return 1
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
tap_check 'unless textures are not wanted' notes 'texture none.png: left out; faces of a flat colour instead: 1' none.obj --no-textures
tap_check 'then there is a flat face, without a texture in the firmware' is_flat none.obj --no-textures
head -c 40 quarters.png >none.png
tap_check 'so is a damaged one' refuses_texture 'damaged'
: >none.png
tap_check 'and an empty one' refuses_texture 'the file is empty'
tap_check 'one that could be read is left out, too' is_flat quarters.obj --no-textures
half_clear >clear.png
sed 's/quarters.png/clear.png/' quarters.mtl >clear.mtl
sed 's/quarters.mtl/clear.mtl/' quarters.obj >clear.obj
tap_check 'transparency that is not drawn is noted' notes 'texture clear.png: its transparency is not drawn; faces that it belongs to: 1$' clear.obj
tap_check 'where nothing is transparent nothing is said' says_nothing quarters.obj
(cat quarters.mtl && echo 'map_d mask.png') >masked.mtl
sed 's/quarters.mtl/masked.mtl/' quarters.obj >masked.obj
tap_check 'so is that of a mask' notes 'texture mask.png: its transparency is not drawn; faces that it belongs to: 1$' masked.obj
alpha_modes_with clear.png >modes.gltf
tap_check 'and in glTF that of what is not OPAQUE' notes 'texture clear.png: its transparency is not drawn; faces that it belongs to: 4$' modes.gltf
sed 's/^vt 1 0/vt 1e20 0/' quarters.obj >far.obj
tap_check 'coordinates out of all range leave a flat face' is_flat far.obj
grep -v '^vt' quarters.obj | sed 's,/[0-9],,g' >bare.obj
tap_check 'so do none at all' is_flat bare.obj
"$limner" compile bare.obj --report >report
tap_check 'which the report counts' grep -q 'no texture coordinates *1$' report
tap_done
