# SPDX-License-Identifier: MIT
#
# What moves is placed, lit, cut by the scene's planes and by one another, and painted alike on every processor.
. tests/tap.sh
. sim/targets/targets.sh

readonly size=120x90 fps=3

expected() { # PROFILE: the scene as C, its cameras, and the host's hashes, all different
    dir=$work/$1
    mkdir -p "$dir"
    awk '!/^#/ && n++ % 6 == 0' sim/scenes/movers.cam >"$work/few.cam"
    "$BUILD/limner" compile sim/scenes/movers.gltf --size $size --precision "$1" --mover-light turning -o "$dir/model" \
        >/dev/null &&
        "$BUILD/limner" render sim/scenes/movers.gltf --camera "$work/few.cam" --size $size --precision "$1" \
            --mover-light turning --fps $fps --write-hashes "$dir/expected" --write-cameras "$dir/cameras.h" || return 1
    cat "$dir/expected"
    [ "$(cut -d ' ' -f 2 "$dir/expected" | sort -u | wc -l)" -eq 8 ]
}

agrees() { # PROFILE CORE[:FLAG]
    dir=$work/$1 core=${2%%:*} flag=${2#"${2%%:*}"}
    target_link "$core" "$work/image" ${flag:+"${flag#:}"} -DFRAMES_PER_S=$fps -I"$dir" -DLIM_CONFIG='"model.h"' \
        sim/targets/frames.c "$dir"/model*.c firmware/*.c || return 1
    target_run "$core" "$work/image" >"$work/frames" || echo "exit status $?" >>"$work/frames"
    diff "$dir/expected" "$work/frames"
}

for profile in ${PROFILES:?is set by the Makefile}; do
    tap_check "$profile: the host renders eight different frames of movers at $size" expected "$profile"
    for core in host m0plus m3 m4 rv32 powerpc m0plus:-Os rv32:-O0; do
        tap_check "$profile: $core paints the same pixels" agrees "$profile" "$core"
    done
done
tap_done
