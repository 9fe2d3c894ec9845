# SPDX-License-Identifier: MIT
#
# Which way up models of others are, by the custom of their format, and what is said of it: each is drawn as it is, with z
# and with y up, and is as its custom says. Looked at once, on a contact sheet, whose script is tried here, too.
. tests/tap.sh

folder=/usr/share/assimp/models

hash_of() { # FILE ARGUMENT...
    file=$1
    shift
    "$BUILD/limner" render "$@" --size 48x48 --frames 1 --tree bsp --splitter first --no-textures --write-hashes "$work/$file" 2>"$work/$file.said" || { cat "$work/$file.said" && return 1; }
}

# is_up AXIS NOTICE MODEL: as with --up AXIS, not as with the other axis.
is_up() {
    hash_of plain "$folder/$3" && hash_of y "$folder/$3" --up y && hash_of z "$folder/$3" --up z && cat "$work/plain.said" &&
        cmp "$work/plain" "$work/$1" && ! cmp -s "$work/y" "$work/z" && if [ -n "$2" ]; then grep -qF -- "$2" "$work/plain.said"; else ! grep -q -e --up "$work/plain.said"; fi
}

if [ -d $folder ]; then
    custom='z is up, as in most files of that kind; --up y, if not'
    tap_check "Blender has z up" is_up z '' BLEND/TorusLightsCams_250_compressed.blend
    tap_check "so has trueSpace" is_up z '' COB/molecule.cob
    tap_check "3ds Max mostly has, and a notice says so" is_up z "$custom" 3DS/cubes_with_alpha.3DS
    tap_check "in its text format, too" is_up z "$custom" ASE/ThreeCubesGreen.ASE
    tap_check "STL mostly has" is_up z "$custom" STL/Spider_ascii.stl
    tap_check "others have y up" is_up y '' OBJ/spider.obj
    # Blender's cube, whose vertices are white in bytes that the library reads as -1.
    is_light() {
        "$BUILD/limner" render "$folder/$1" --size 48x48 --frames 1 --unlit -o "$work/light.png" 2>"$work/said" &&
            /usr/bin/python3 -c 'import sys; from PIL import Image; sys.exit(min(Image.open(sys.argv[1]).convert("RGB").getpixel((24, 30))) < 150)' "$work/light.png"
    }
    tap_check "colours of an old file of Blender are bytes" is_light BLEND/BlenderDefault_250_Compressed.blend
    what_is_dark() { hash_of off $folder/OFF/Wuson.off && grep -q 'it is lit from inside: --reverse-faces' "$work/off.said"; }
    tap_check "a model that is lit from inside is noticed" what_is_dark
    unknown() {
        ! "$BUILD/limner" render $folder/WRL/Wuson.wrl -o "$work/none.png" 2>"$work/said" && cat "$work/said" &&
            grep -qx 'limner: .*Wuson.wrl: not in a format that the importer knows; glTF, OBJ, PLY, STL and others are: limner formats' "$work/said"
    }
    tap_check "an unknown format is called so" unknown
else
    tap_skip "which way up others' models are" "assimp-testmodels is not installed"
fi

sheet() { # a model that is drawn, and one that is refused, in a folder whose name is none to match
    bad="$work/a#[b* c"
    mkdir "$bad" && make DEPS=skip BUILD="$BUILD" "$BUILD/contact_sheet" >"$work/said" 2>&1 && echo nonsense >"$bad/bad.obj" &&
        sh sim/tools/contact_sheet.sh "$work/sheet.png" sim/scenes/icosahedron.obj "$bad/bad.obj" >"$work/said" && cat "$work/said" &&
        grep -qx "contact-sheet: 2 models in $work/sheet.png" "$work/said" && [ -s "$work/sheet.png" ] &&
        sed -n '/^bad.obj$/,$p' "$work/said" | grep -q '^    [^/]*$'
}
tap_check "a contact sheet shows models and what was said of them" sheet
tap_done
