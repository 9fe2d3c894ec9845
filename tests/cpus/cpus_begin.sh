# SPDX-License-Identifier: MIT
#
# NAME_MEMORY and name_begin() of a scene's header (firmware/limner.h), in C and in C++: the memory fits whatever the scene
# is drawn by, and the frames are those of `limner render`. What does not fit is refused when it is compiled.
. tests/tap.sh
. sim/targets/targets.sh
. tests/one_file.sh
. tests/example/example.sh

# Four cameras of a scene's own file, four frames: all are different.
render_few() { # MODEL CAMERAS OPTION...
    rendered=$1 all_cameras=$2
    shift 2
    awk '!/^#/ && NF && n++ % 11 == 0' "$all_cameras" | head -n 4 >"$work/few.cam"
    "$BUILD/limner" render "$rendered" --camera "$work/few.cam" "$@" --write-hashes "$work/expected" \
        --write-cameras "$work/cameras.h" && [ "$(cut -d ' ' -f 2 "$work/expected" | sort -u | wc -l)" -eq 4 ]
}

prepare() { # MODEL SIZE "OPTION..." "OPTION...": of compile, and of render
    rm -f "$work"/model* "$work/expected"
    # shellcheck disable=SC2086 # options are words
    "$BUILD/limner" compile "$1" --size "$2" $3 -o "$work/model" >/dev/null && render_few "$1" "${1%.*}.cam" --size "$2" $4
}

draws() { # CORE STANDARD FLAG...: what was prepared
    core=$1 standard=$2
    shift 2
    cp tests/targets/begin.c "$work/begin.c"
    example_main_for "$core" begin "$standard" -Isim/targets "$@" &&
        target_link "$core" "$work/image" -I"$work" -DLIM_CONFIG='"model.h"' "$work/begin.o" "$work"/model*.c "$(one_file)" || return 1
    target_run "$core" "$work/image" >"$work/frames" || echo "exit status $?" >>"$work/frames"
    diff "$work/expected" "$work/frames"
}

draws_in_both() { # FLAG...
    draws host c11 "$@" && draws host c++11 "$@"
}

# Two scenes in one header, drawn by different methods unless an option says else; each is rendered by itself.
prepare_two() { # OPTION...
    rm -f "$work"/model* "$work/expected"
    mkdir -p "$work/two"
    cp sim/scenes/*.mtl "$work/two"
    cp sim/scenes/rooms.obj "$work/two/first.obj"
    cp sim/scenes/teapot.obj "$work/two/second.obj"
    "$BUILD/limner" compile "$work/two/first.obj" "$work/two/second.obj" --size 80x60 -o "$work/model" "$@" >/dev/null &&
        render_few "$work/model_second.lim" sim/scenes/teapot.cam --size 80x60 || return 1
    mv "$work/expected" "$work/second"
    sed 's/ cameras\[/ second_cameras[/; s/CAMERAS_H$/SECOND_&/' "$work/cameras.h" >"$work/second_cameras.h"
    render_few "$work/model_first.lim" sim/scenes/rooms.cam --size 80x60 && mv "$work/expected" "$work/first" &&
        paste -d '\n' "$work/first" "$work/second" | awk '/^#/ || (NR % 2 ? $1 % 2 == 0 : $1 % 2 == 1)' | uniq >"$work/expected"
    cat "$work/expected"
}

# The largest of both.
shares_memory() {
    printf '#include "model.h"\nLIM_STATIC_ASSERT(%s, "");\nLIM_STATIC_ASSERT(%s, "");\n' \
        'MODEL_SCENE_MEM_B(60) >= MODEL_FIRST_SCENE_MEM_B(60) && MODEL_SCENE_MEM_B(60) >= MODEL_SECOND_SCENE_MEM_B(60)' \
        'MODEL_SCENE_LINES(60) == (MODEL_FIRST_SCENE_LINES(60) > 1 || MODEL_SECOND_SCENE_LINES(60) > 1 ? 60 : 1)' >"$work/shares.c"
    "$CC" -std=c11 -fsyntax-only -Ifirmware -I"$work" "$work/shares.c"
}

# Metres of a camera file, as constants: the eyes are those that `limner render` writes, or as far off as a `double` of 32
# bits makes them, and a camera that looks at the target is its camera.
write_metres() { # MOST-OFF, units with 8 fraction bits
    awk -v off="$1" '
        BEGIN {
            print "#include \"model.h\"\n#include \"cameras.h\"\n#include \"console.h\"\nint main(void);"
            print "static bool is_near(int32_t a, int32_t b, int32_t off) { return a - b <= off && b - a <= off; }"
            print "static const int32_t points_q8[][3] = {"
        }
        !/^#/ && NF {
            printf "    MODEL_POINT_Q8(%s, %s, %s), MODEL_POINT_Q8(%s, %s, %s),\n", $1, $2, $3, $4, $5, $6
        }
        END {
            print "};\nint main(void)\n{\n    for (uint8_t i = 0; i < CAMERAS_COUNT; i++) {"
            print "        struct lim_camera camera = {.yaw = 0};"
            print "        lim_look_at(&camera, points_q8[2 * i], points_q8[2 * i + 1]);"
            print "        for (uint8_t k = 0; k < 3; k++)"
            print "            if (!is_near(camera.eye_q8[k], cameras[i].eye_q8[k], " off ")) return 1;"
            print "        if (!is_near((int32_t)(camera.yaw - cameras[i].yaw), 0, 4000 * (1 + " off "))) return 2;"
            print "        if (!is_near((int32_t)(camera.pitch - cameras[i].pitch), 0, 4000 * (1 + " off "))) return 3;"
            print "    }\n    console_put(CAMERAS_COUNT == 4 ? \"near\\n\" : \"few\\n\");\n    return 0;\n}"
        }' "$work/few.cam" >"$work/metres.c"
}

metres_are_units() { # CORE MOST-OFF
    write_metres "$2" && target_link "$1" "$work/image" -I"$work" -DLIM_CONFIG='"model.h"' "$work/metres.c" firmware/aim.c \
        firmware/arctangent.c firmware/angle.c firmware/math/fixed.c || return 1
    target_run "$1" "$work/image" >"$work/said" && grep -qx near "$work/said"
}

refuses() { # DECLARATION PATTERN
    printf '#include "model.h"\n%s;\nconst void *used(void);\nconst void *used(void) { return &model_memory; }\n' "$1" >"$work/refused.c"
    for refusing in "$CC -std=c11" "$(example_cplusplus "$CC") -x c++ -std=c++11"; do
        # shellcheck disable=SC2086 # words
        $refusing -fsyntax-only -Ifirmware -I"$work" "$work/refused.c" 2>"$work/said" && return 1
        cat "$work/said"
        grep -q "$2" "$work/said" || return 1
    done
}

rooms=sim/scenes/rooms.obj teapot=sim/scenes/teapot.obj
tap_check "rooms compile, nearest first" prepare $rooms 81x60 '' ''
tap_check "they are drawn in C and C++" draws_in_both
tap_check "m0plus: so they are in C++20" draws m0plus c++20
tap_check "avr: so they are in C++11, with 8 KB of memory" draws avr c++11 -DMEM_B=8192
tap_check "metres of constants are the units of limner render" metres_are_units host 0
tap_check "m0plus: so they are there" metres_are_units m0plus 0
tap_check "avr: nearly so" metres_are_units avr 2
tap_check "a display that is wider than the scene was compiled for is refused" refuses 'MODEL_MEMORY(82, 60)' 'limner compile --size'
tap_check "so is one that is higher" refuses 'MODEL_MEMORY(60, 82)' 'limner compile --size'
tap_check "and one without lines" refuses 'MODEL_MEMORY(60, 0)' 'limner compile --size'
tap_check "rooms compile for a framebuffer" prepare $rooms 81x60 --framebuffer ''
tap_check "they are drawn in C and C++, into all lines" draws_in_both
tap_check "the teapot compiles for the painter" prepare $teapot 80x60 '--method painter' '--method painter'
tap_check "it is drawn in C and C++" draws_in_both
tap_check "the knot compiles for the depth sort" prepare sim/scenes/knot.obj 80x60 '--method newell' '--method newell'
tap_check "it is drawn in C and C++" draws_in_both
tap_check "what moves compiles, with a light that turns" prepare sim/scenes/movers.gltf 80x60 '--mover-light turning' \
    '--mover-light turning --fps 3'
tap_check "it is drawn in C and C++" draws_in_both -DFRAMES_PER_S=3
tap_check "m0plus: so it is in C" draws m0plus c11 -DFRAMES_PER_S=3
tap_check "metres of what moves are, too, whose origin is elsewhere" metres_are_units host 0
tap_check "two scenes share a header" prepare_two
tap_check "and memory" shares_memory
tap_check "they are drawn in turns" draws_in_both -DSECOND
tap_check "two scenes share a framebuffer" prepare_two --framebuffer
tap_check "and memory" shares_memory
tap_check "they are drawn in turns" draws_in_both -DSECOND
tap_done
