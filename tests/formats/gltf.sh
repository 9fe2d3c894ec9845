# SPDX-License-Identifier: MIT
#
# glTF in all the ways that it can say a thing: frames are those of an OBJ that says the same plainly. The files, and what
# they are to show, come from tests/formats/gltf.py.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
files=$(pwd)/tests/formats/gltf.py
cd "$work" || exit 1
printf '6 4 9 1.5 1 0.5\n-5 6 7 2 1 1\n3 -6 5 2 1 1\n12 9 14 1 1 3\n' >wedge.cam
printf '2 2 4.2 2 2 0\n' >square.cam

hashes() { # FILE MODEL CAMERA OPTION...
    hashes_to=$1 hashes_of=$2 hashes_camera=$3
    shift 3
    timeout 60 "$limner" render "$hashes_of" --camera "$hashes_camera" --size 96x96 --up y --two-sided --write-hashes "$hashes_to" "$@" 2>said
}

same() { # MODEL CAMERA OPTION...: as the OBJ of its name; and as the reference's own reader has it
    model=$1 camera=$2
    shift 2
    hashes one "$model" "$camera" "$@" || { cat said; return 1; }
    cp said first
    hashes other "${model%.*}.obj" "$camera" "$@" && hashes none "$model" "$camera" "$@" --compare >compared || { cat said; return 1; }
    cat first
    cmp one other
}

all_same() { # CAMERA MODEL...: each pair
    with=$1
    shift
    for one in "$@"; do
        tap_check "$one" same "$one" "$with" --unlit
    done
}

pieces() { # PART...
    mkdir "$1" && python3 "$files" "$1" "$1" && cd "$1" || exit 1
    cp ../*.cam .
}

pieces accessors
all_same wedge.cam *.gltf *.glb
cd .. || exit 1
pieces instances
all_same wedge.cam *.gltf
cd .. || exit 1
pieces textures
all_same square.cam *.gltf
cd .. || exit 1

# What emits is not dimmed, where there is nothing else.
is_undimmed() { # NAME
    hashes lit "$1.gltf" square.cam && hashes unlit "$1.obj" square.cam --unlit || return 1
    cmp lit unlit
}

pieces emission
all_same square.cam *.gltf
for name in emits_alone emits_more emits_picture; do
    tap_check "no lamp dims it: $name" is_undimmed $name
done
cd .. || exit 1

tells() { # MODEL LINE...: these and no more
    told_of=$1
    shift
    same "$told_of" wedge.cam --unlit >/dev/null || return 1
    for line; do echo "limner: note: $told_of: $line"; done >expected
    diff first expected
}

refuses() { # MODEL PATTERN
    hashes none "$1" wedge.cam && return 1
    cat said
    [ "$(wc -l <said)" = 1 ] && grep -q "^limner: $1: .*$2" said
}

accepts() { # MODEL
    hashes none "$1" wedge.cam || { cat said; return 1; }
}

pieces said
tap_check "extensions that are left out: a line for each kind" tells lights.gltf \
    "KHR_lights_punctual: its lights are not drawn; faces are lit by a lamp of the renderer's own" \
    "KHR_materials_sheen, KHR_materials_clearcoat: shine is not drawn" "ACME_dust: not known, and not drawn"
tap_check "an extension that is required and not known is refused by its name" \
    refuses dust.gltf 'it requires the extension ACME_dust, which is not read; export it without that'
tap_check "points and lines are counted" tells lines.gltf "2 lists of points or lines are not drawn; faces are"
tap_check "skins and morph targets are counted" tells posed.gltf \
    "1 meshes are drawn without their morph targets, whose weights change their shape" \
    "1 meshes have a skeleton (skin): they are drawn as they were modelled, not posed"
cd .. || exit 1

looks_as() { # CAMERA OPTION...: as the cameras of look.gltf do
    as=$1
    shift
    hashes one wedge.gltf look.gltf --fov 45 "$@" && cp said first && hashes other wedge.gltf "$as" --fov 45 "$@" || { cat said; return 1; }
    cat first
    [ "$(wc -l <one)" = 2 ] && cmp one other
}

says() { # LINE MODEL CAMERA
    hashes none "$2" "$3" && cat said && grep -qx "$1" said
}

refuses_camera() { # TEXT CAMERA
    ! hashes none wedge.gltf "$2" && cat said && grep -qx "limner: $2: $1" said
}

pieces cameras
tap_check "cameras of a glTF file, below nodes, are cameras" looks_as look.cam
tap_check "where z is up, they turn with the model" looks_as turned.cam --up z
tap_check "another field of view is told" says 'limner: note: look.gltf: 2 cameras have another field of view than the 60 degrees that are drawn; --fov 45 is that of the first of them' wedge.gltf look.gltf
tap_check "an orthographic one is refused by its name" refuses_camera "camera 'first' is not a perspective one, which alone are drawn" flat.gltf
tap_check "a file without cameras is none of cameras" refuses_camera "there is no camera in it" wedge.gltf
cd .. || exit 1

pieces bounds
for name in count offset view buffer stride sparse_count huge; do
    tap_check "what is whole is read: $name" accepts ${name}_n.gltf
    tap_check "one more is refused: $name" refuses ${name}_n1.gltf 'accessor [0-9]*) leads out of its buffer'
done
tap_check "other lists must be as long as the positions" refuses huge_zeros_n1.gltf 'vertex indices of some faces are out of range'

tap_done
