# SPDX-License-Identifier: MIT
#
# The two outward steps of counting instructions; `limner measure` does what lies between. From the
# project's folder:
#   sh sim/targets/count.sh build CORE FOLDER PLUGIN OPTIMISE   FOLDER/model.[ch], cameras.h -> image, image.map, marks
#   sh sim/targets/count.sh run CORE FOLDER PLUGIN     image, ranges -> counts; the frames' hashes -> hashes;
#                                                      the functions that a range's start is from -> inlined
# An image without statistics and with the scene's own method alone, as a product would be. What is for debuggers changes no code.
set -eu

: "${WARNINGS:=-Wall}"
. sim/targets/targets.sh

step=$1 core=$2 folder=$3 project=$PWD

# What code is for (LIM_OPTIMISE of firmware/config.h).
case ${5:-speed} in
speed) optimise=-O2 ;;
balance) optimise='-Os -DLIM_OPTIMISE=LIM_BALANCE' ;;
size) optimise=-Os ;;
esac

# Inside of the folder, whose name is another each time: so a cache of objects ($CCACHE) does not see it.
compile() { # OBJECT SOURCE FLAG...: both in the folder, or from the root
    object=$1 source=$2
    shift 2
    # shellcheck disable=SC2046,SC2086 # flags are words
    (cd "$folder" && ${CCACHE:-} $(target_compiler "$core") $(target_flags "$core") $optimise -g $WARNINGS -ffreestanding \
        -ffunction-sections -fdata-sections "-fdebug-prefix-map=$PWD=." "-I$project/firmware" -I. "$@" -c -o "$object" "$source")
}

# The renderer's objects in a folder of their own, so that the linker's map tells whose is what.
build() {
    set -- '-DLIM_CONFIG="model.h"' -DLIM_HAS_STATS=0
    mkdir -p "$folder"/firmware $(printf "$folder/%s " firmware/*/)
    for source in firmware/*.c firmware/*/*.c; do
        compile "${source%.c}.o" "$project/$source" "$@"
    done
    rm -f "$folder"/model*.o
    for source in "$folder"/model*.c; do # what moves has files of its own
        source=${source##*/}
        compile "${source%.c}.o" "$source" "$@"
    done
    # shellcheck disable=SC2086 # flags are words
    target_link "$core" "$folder/image" $optimise "$@" -I"$folder" -Wl,--wrap=main -Wl,-Map,"$folder/image.map" \
        sim/targets/count_check.c sim/targets/frames.c boards/common/app_scene.c "$folder"/model*.o "$folder"/firmware/*.o "$folder"/firmware/*/*.o
}

run() { # PLUGIN
    target_run "$core" "$folder/image" -icount shift=0 -plugin "$1,ranges=$folder/ranges,out=$folder/counts" \
        >"$folder/hashes"
    sed -n 's/^range \([0-9a-f]*\) .*/\1/p' "$folder/ranges" |
        "$(target_tools "$core")addr2line" -a -i -f -e "$folder/image" >"$folder/inlined"
}

case $step in
build) build ;;
run) run "$4" ;;
esac
