# SPDX-License-Identifier: MIT
#
# Users compile the renderer with their own warnings. Beyond those that cross.sh has of every target, these are what
# projects turn on, and code that they include or get by `limner export` heeds them all: with all features in one file,
# each header in C++, and an exported folder as it is.
. tests/tap.sh
. tests/one_file.sh

all=$(one_file)

kind_of() { case $1 in *clang*) echo clang ;; *) echo gcc ;; esac; }

# What depends on the flow of values is found by the optimizer.
extra_of() { # COMPILER
    echo -Wall -Wextra -Wcast-align -Wswitch-enum -Wnull-dereference -Wundef -Wshadow -Wconversion
    case $(kind_of "$1") in
    gcc) echo -Wimplicit-fallthrough=5 -Wlogical-op ;;
    clang) echo -Wimplicit-fallthrough -Wconditional-uninitialized ;;
    esac
}

target_of() { # TARGET: what follows the compiler's name
    case $1 in
    pc) ;;
    cortex-m0plus) echo -mthumb -mcpu=cortex-m0plus ;;
    cortex-m4) echo -mthumb -mcpu=cortex-m4 -mfloat-abi=soft ;;
    rv32imc) echo -march=rv32imc -mabi=ilp32 ;;
    clang-cortex-m0plus) echo --target=thumbv6m-none-eabi -mcpu=cortex-m0plus ;;
    clang-rv32imc) echo --target=riscv32-unknown-elf -march=rv32imc -mabi=ilp32 ;;
    esac
}

# COMPILER TARGET STANDARD ARGUMENT...
accepts() {
    compiler=$1 target=$2 standard=$3
    shift 3
    # shellcheck disable=SC2046 # flags are words
    ${CCACHE:-} "$compiler" $(target_of "$target") "-std=$standard" -O2 -ffreestanding $(extra_of "$compiler") -Werror \
        "$@" -o "$work/object.o"
}

renderer_is_accepted() { # COMPILER TARGET
    accepts "$1" "$2" c11 -Ifirmware -DLIM_HAS_STATS=1 -DLIM_HAS_LONG=1 -c "$all"
}

# Renderer and scene as the folder has them; what calls a library of the board's is the board's.
export_is_accepted() { # COMPILER TARGET
    [ -d "$work/plain" ] ||
        "$BUILD/limner" export sim/scenes/teapot.obj --for plain --panel st7789 --size 240x240 -o "$work/plain" \
            >/dev/null || return 1
    find "$work/plain" -name '*.c' | grep -v '/main\.c$' >"$work/sources"
    [ "$(wc -l <"$work/sources")" -ge 2 ] || return 1
    while read -r source; do
        accepts "$1" "$2" c11 $(find "$work/plain" -name '*.h' -exec dirname {} + | sort -u | sed 's/^/-I/') \
            -c "$source" || return 1
    done <"$work/sources"
}

# All that a program in C++ writes of macros, and every inline function of the headers.
program_is_accepted() { # COMPILER
    "$BUILD/limner" compile sim/scenes/teapot.obj --size 240x240 -o "$work/teapot" >/dev/null || return 1
    cat >"$work/program.cpp" <<'END' || return 1
#include "teapot.h"

#include "collide.h"
#include "colour.h"
#include "inspect.h"
#include "text.h"

TEAPOT_MEMORY(240, 240);

static uint32_t antialias[LIM_ANTIALIAS_MEM_B(240) / 4], delta[LIM_DELTA_MEM_B(240, 240, 1000) / 4],
    movers[LIM_MOVERS_MEM_B(10, 4, 10) / 4], portals[LIM_PORTALS_MEM_B(100, 10) / 4],
    mesh[LIM_MESH_MEM_B(240, 100, 100, 10) / 4 + LIM_MESH_LEAF_MEM_B(10, 10) / 4];
static const lim_camera camera = {TEAPOT_POINT_Q8(0, 0.5, 3), LIM_DEGREES(-22.5), LIM_DEGREES(0), LIM_DEGREES(360),
    1u << 28, 1u << 28, LIM_CAMERA_END(LIM_UNITS_Q8(1.5) + LIM_UNITS(2.0) + TEAPOT_M_Q8(0.1), 0, 0, 0)};
static const uint16_t red = LIM_MEMORY_COLOUR(0xF800);

static int send(void *, uint16_t, const uint16_t *, uint16_t, uint16_t)
{
    return 0;
}

int draw()
{
    antialias[0] = delta[0] = movers[0] = portals[0] = mesh[0] = LIM_TEXT_RUNS(5, 1) + red;
    const int err = teapot_begin(&teapot_memory, send, nullptr);
    return err ? err : lim_frame(teapot_memory.lim, &camera);
}
END
    "$1" -std=c++17 -O2 -Wall -Wextra -pedantic -Wold-style-cast -Wcast-align -Wswitch-enum -Werror -DLIM_HAS_DELTA=1 \
        -DLIM_HAS_ANTIALIAS=1 -DLIM_HAS_OVERLAY=1 -DLIM_HAS_MOVERS=1 -DLIM_HAS_PORTALS=1 -DLIM_HAS_TEXTURE=1 \
        -DLIM_HAS_LEAVES=1 -DLIM_HAS_MESH=1 -Ifirmware -I"$work" -fsyntax-only "$work/program.cpp"
}

# A compiler that finds nothing finds these.
faults_are_found() { # COMPILER TARGET
    echo 'int *fault(short *at); int *fault(short *at) { return (int *)at; }' >"$work/cast.c"
    echo 'int fault(int x); int fault(int x) { switch (x) { case 1: x++; default: return x; } }' >"$work/falls.c"
    for fault in cast falls; do
        ! accepts "$1" "$2" c11 -c "$work/$fault.c" || { echo "$fault.c passes" && return 1; }
    done
}

tap_check "warnings of Arm's gcc find faults" faults_are_found arm-none-eabi-gcc cortex-m0plus
tap_check "clang's for Arm find them" faults_are_found clang clang-cortex-m0plus
for pair in gcc:pc clang:pc arm-none-eabi-gcc:cortex-m0plus arm-none-eabi-gcc:cortex-m4 \
    riscv64-unknown-elf-gcc:rv32imc clang:clang-cortex-m0plus clang:clang-rv32imc; do
    tap_check "$pair: the renderer" renderer_is_accepted "${pair%:*}" "${pair#*:}"
done
for pair in arm-none-eabi-gcc:cortex-m0plus clang:clang-cortex-m0plus; do
    tap_check "$pair: an exported folder" export_is_accepted "${pair%:*}" "${pair#*:}"
done
for compiler in g++ clang++; do
    tap_check "$compiler: a program's macros and headers" program_is_accepted "$compiler"
done
tap_done
