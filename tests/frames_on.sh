# SPDX-License-Identifier: MIT
#
# For test scripts to source: frames_on SCENE SIZE CORE[:FLAG]... renders eight frames of a scene's camera file
# in every precision profile on emulated processors (sim/targets/targets.sh), compiled with the flag if there is
# one, and compares the hashes of all pixels with those of `limner render`. Where RAM is scarce the
# renderer has half of it, whatever the scene asks for: the same frames, perhaps in more bands.
#
# frames_in_turn TURN SCENE SIZE CORE[:FLAG]... takes one profile on each processor, the next one on the next, from the
# TURNth on: with a turn for each of the features, every processor meets every profile, and every feature meets both,
# at a quarter of the time. EVERY_PROFILE=yes makes it frames_on.
# shellcheck shell=sh
. sim/targets/targets.sh
. tests/one_file.sh

frames_options=     # of compile and render, beside: --wireframe, --method newell
frames_compile=     # of what reads the model alone: --mesh-leaves all
frames_path=        # of render alone: --fps 3
frames_flags=       # of the target's compiler
frames_every=8      # camera of the file
frames_mem_b=8192   # of the renderer, where RAM is scarce
frames_suffix=obj
frames_firmware=$(one_file) # what it compiles of firmware/

frames_expected() { # PROFILE: the scene as C, its cameras, and the host's hashes, all different
    frames_dir=$kept/$1
    rm -rf "$frames_dir"
    mkdir -p "$frames_dir"
    awk -v every="$frames_every" '!/^#/ && NF && n++ % every == 0' "$scene.cam" | head -n 8 >"$work/few.cam"
    # shellcheck disable=SC2086 # options are words
    "$BUILD/limner" compile "$scene.$frames_suffix" --size "$size" --precision "$1" $frames_options $frames_compile \
        -o "$frames_dir/model" >/dev/null || return 1
    frames_drawn=$frames_dir/model.lim frames_read=
    if [ "$frames_suffix" != obj ]; then # what moves is no part of a .lim file
        frames_drawn=$scene.$frames_suffix frames_read=$frames_compile
    fi
    # shellcheck disable=SC2086
    "$BUILD/limner" render "$frames_drawn" --camera "$work/few.cam" --size "$size" --precision "$1" \
        $frames_options $frames_read $frames_path --write-hashes "$frames_dir/expected" \
        --write-cameras "$frames_dir/cameras.h" || return 1
    cat "$frames_dir/expected"
    [ "$(cut -d ' ' -f 2 "$frames_dir/expected" | sort -u | wc -l)" -eq 8 ]
}

frames_agree() { # PROFILE CORE[:FLAG]
    frames_dir=$kept/$1 frames_core=${2%%:*} frames_flag=${2#"${2%%:*}"}
    set -- ${frames_flag:+"${frames_flag#:}"}
    case $frames_core in
    microbit | avr) set -- -DSCENE_MEM_B=$frames_mem_b "$@" ;;
    esac
    # shellcheck disable=SC2086 # flags are words
    target_link "$frames_core" "$work/image" "$@" $frames_flags -I"$frames_dir" -DLIM_CONFIG='"model.h"' \
        sim/targets/frames.c boards/common/app_scene.c "$frames_dir"/model*.c $frames_firmware || return 1
    target_run "$frames_core" "$work/image" >"$work/frames" || echo "exit status $?" >>"$work/frames"
    diff "$frames_dir/expected" "$work/frames"
}

frames_of() { # PROFILE CORE[:FLAG]...
    frames_profile=$1
    shift
    tap_check "$frames_profile: the host renders eight different frames of ${scene##*/} at $size" \
        frames_expected "$frames_profile"
    for core; do
        tap_check "$frames_profile: $core paints the same pixels" frames_agree "$frames_profile" "$core"
    done
}

frames_on() { # SCENE SIZE CORE[:FLAG]...
    scene=$1 size=$2
    shift 2
    for profile in ${PROFILES:?is set by the Makefile}; do
        frames_of "$profile" "$@"
    done
}

frames_in_turn() { # TURN SCENE SIZE CORE[:FLAG]...
    turn=$1
    shift
    [ -z "${EVERY_PROFILE:-}" ] || { frames_on "$@"; return; }
    scene=$1 size=$2
    shift 2
    for profile in ${PROFILES:?is set by the Makefile}; do
        # shellcheck disable=SC2046 # a list of processors
        frames_of "$profile" $(printf '%s\n' "$@" | awk -v turn="$turn" -v of="$(echo "$PROFILES" | wc -w)" \
            '(NR + turn) % of == 0')
        turn=$((turn + 1))
    done
}
