# SPDX-License-Identifier: MIT
#
# Palette atlases, one picture for a pack of models: faces of one colour are flat by themselves, --textures flat gives
# each face the mean of what it shows, so do --no-textures and a budget that no size keeps; a hint tells of it.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
atlas=$(pwd)/tests/rigs/atlas.py
cd "$work" || exit 1
python3 "$atlas" plain plain 1024 && python3 "$atlas" shaded shaded 512 || exit 1
echo '2 1.8 2.5 0 0.5 0' >front.cam

compiled() { # NAME MODEL OPTION...
    name=$1 of=$2
    shift 2
    timeout 120 "$limner" compile "$of" -o "$name" --report "$@" >"$name.report" 2>"$name.said" || { cat "$name.said" && return 1; }
}

flash_b() { # NAME
    awk '/^  in all/ { print $3; exit }' "$1.report"
}

instructions() { # NAME
    awk '/^  instructions a frame/ { print $4 }' "$1.report"
}

has_no_texture() { # NAME
    grep 'LIM_HAS_TEXTURE' "$1.h" && grep -q 'LIM_HAS_TEXTURE 0' "$1.h"
}

same_frames() { # MODEL MODEL OPTION...: of the first one, with the options, and of the second
    first=$1 second=$2
    shift 2
    "$limner" render "$first" --camera front.cam --size 160x160 --write-hashes a "$@" 2>said &&
        "$limner" render "$second" --camera front.cam --size 160x160 --write-hashes b 2>>said || { cat said; return 1; }
    cat said a b && cmp a b
}

palettes_are_flat() {
    compiled plain plain.obj && cat plain.said && has_no_texture plain && [ ! -s plain.said ] &&
        grep 'note: faces that show one colour of their texture, and have that: 180$' plain.report && [ "$(flash_b plain)" -lt 8500 ]
}

spares_what_it_says() {
    compiled shaded shaded.obj && compiled flat shaded.obj --textures flat || return 1
    echo "$(flash_b shaded) bytes and $(instructions shaded) instructions, $(flash_b flat) and $(instructions flat)"
    has_no_texture flat && [ "$(flash_b flat)" -lt 8500 ] && [ "$(instructions shaded)" -gt $((4 * $(instructions flat))) ] &&
        grep 'note: faces that have the mean colour of their texture' flat.report | grep ': 180$'
}

textures_b() { # NAME
    awk '/^    of these textures/ { print $4 }' "$1.report"
}

hints() {
    cat shaded.said
    [ "$(wc -l <shaded.said)" -eq 1 ] && [ ! -s flat.said ] &&
        grep -q "^limner: note: shaded.obj: textures take $(textures_b shaded) of the scene's $(flash_b shaded) bytes of flash: --textures flat spares these $(textures_b shaded)," shaded.said
}

# A quarter of the atlas and less is shown: 8 swatches across, and 5 down.
is_cropped() {
    grep 'note: texture' shaded.report && grep -q 'note: texture shaded.png: 256x256 of its 512x512 pixels, faces show no others' shaded.report &&
        [ "$(textures_b shaded)" -lt 90000 ] && [ "$(textures_b shaded)" -gt 87380 ] # 65,536 and a third of it
}

same_scene() { # NAME NAME
    cmp "$1.lim" "$2.lim"
}

budget_ends_in_colours() {
    compiled never shaded.obj --texture-budget 0 && grep 'note: textures for 0.0 KB' never.report && has_no_texture never && [ "$(flash_b never)" -eq "$(flash_b flat)" ] &&
        [ ! -s never.said ] && grep -q 'note: texture shaded.png: shown as the mean colour of each face, off by [0-9.]* of 255' never.report
}

refuses() { # TEXT OPTION...
    text=$1
    shift
    ! "$limner" compile shaded.obj -o no "$@" 2>said && cat said && [ "$(wc -l <said)" -eq 1 ] && grep -q "$text" said && ! ls no.* 2>/dev/null
}

# The material's colour is red.
without_picture() { # PICTURE
    sed "s|map_Kd.*|map_Kd $1|; s/Kd 1 1 1/Kd 1 0 0/" shaded.mtl >red.mtl && sed 's/shaded.mtl/red.mtl/' shaded.obj >red.obj &&
        sed '/map_Kd/d' red.mtl >all_red.mtl && sed 's/shaded.mtl/all_red.mtl/; s|/[0-9]*||g; /^vt/d' shaded.obj >all_red.obj &&
        ! "$limner" compile red.obj -o no --textures flat 2>said && cat said && same_frames red.obj all_red.obj --no-textures
}

tap_check 'palettes of plain colours are flat by themselves' palettes_are_flat
tap_check 'and drawn as their twin in materials is' same_frames plain.obj plain_flat.obj
tap_check '--textures flat takes a twelfth of the flash and a quarter of the instructions' spares_what_it_says
tap_check 'each face has the mean of what it shows' same_frames shaded.obj shaded_flat.obj --textures flat
tap_check 'a hint tells of it, where textures are over half, and what it spares' hints
tap_check 'the atlas is cropped to what is shown' is_cropped
tap_check '--no-textures does the same' eval 'compiled none shaded.obj --no-textures && same_scene none flat'
tap_check '--textures drawn is the default' eval 'compiled drawn shaded.obj --textures drawn && same_scene drawn shaded'
tap_check 'a budget that no size keeps ends in colours of faces' budget_ends_in_colours
tap_check 'who gives a budget gets no hint' eval 'compiled roomy shaded.obj --texture-budget 200 && [ ! -s roomy.said ]'
tap_check 'refused: another word' refuses "^limner: --textures none: neither 'drawn' nor 'flat'$" --textures none
tap_check 'without a picture --no-textures has the colour of the material' without_picture missing.png
echo 'no picture' >bad.png
tap_check 'so it has where that is none' without_picture bad.png
mkdir -p deep && mv shaded.obj shaded.mtl deep && cd deep || exit 1
cp ../front.cam .
tap_check 'or lies outside of the folder' without_picture ../shaded.png
tap_check 'a bug report keeps the option' eval 'cp ../shaded.png . && "$limner" report-bug shaded.obj --textures flat --camera front.cam --size 64x48 -o flat.tar >said 2>&1 && tar -xOf flat.tar report.txt | grep -x "option: --textures=flat" && "$limner" replay flat.tar'
tap_done
