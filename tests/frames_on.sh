# SPDX-License-Identifier: MIT
#
# For test scripts to source: frames_on SCENE SIZE CORE[:FLAG]... renders eight frames of a scene's camera file
# in every precision profile on emulated processors (sim/targets/targets.sh), compiled with the flag if there is
# one, and compares the hashes of all pixels with those of `limner render`. Where RAM is scarce the
# renderer has half of it, whatever the scene asks for: the same frames, perhaps in more bands.
# shellcheck shell=sh
. sim/targets/targets.sh

frames_options= # of compile and render, beside: --wireframe, --method newell

frames_expected() { # PROFILE: the scene as C, its cameras, and the host's hashes, all different
    frames_dir=$work/$1
    mkdir -p "$frames_dir"
    awk '!/^#/ && NF && n++ % 8 == 0' "$scene.cam" | head -n 8 >"$work/few.cam"
    # shellcheck disable=SC2086 # options are words
    "$BUILD/limner" compile "$scene.obj" --size "$size" --precision "$1" $frames_options -o "$frames_dir/model" \
        >/dev/null &&
        "$BUILD/limner" render "$frames_dir/model.lim" --camera "$work/few.cam" --size "$size" --precision "$1" \
            $frames_options \
            --write-hashes "$frames_dir/expected" --write-cameras "$frames_dir/cameras.h" || return 1
    cat "$frames_dir/expected"
    [ "$(cut -d ' ' -f 2 "$frames_dir/expected" | sort -u | wc -l)" -eq 8 ]
}

frames_agree() { # PROFILE CORE[:FLAG]
    frames_dir=$work/$1 frames_core=${2%%:*} frames_flag=${2#"${2%%:*}"}
    set -- ${frames_flag:+"${frames_flag#:}"}
    case $frames_core in
    microbit | avr) set -- -DFRAMES_MEM_B=8192 "$@" ;;
    esac
    target_link "$frames_core" "$work/image" "$@" -I"$frames_dir" -DLIM_CONFIG='"model.h"' sim/targets/frames.c \
        "$frames_dir/model.c" firmware/*.c || return 1
    target_run "$frames_core" "$work/image" >"$work/frames" || echo "exit status $?" >>"$work/frames"
    diff "$frames_dir/expected" "$work/frames"
}

frames_on() { # SCENE SIZE CORE[:FLAG]...
    scene=$1 size=$2
    shift 2
    for profile in ${PROFILES:?is set by the Makefile}; do
        tap_check "$profile: the host renders eight different frames of ${scene##*/} at $size" frames_expected "$profile"
        for core; do
            tap_check "$profile: $core paints the same pixels" frames_agree "$profile" "$core"
        done
    done
}
