# SPDX-License-Identifier: MIT
#
# limner export --for cmake and --for idf, by CMake itself, for processors that QEMU emulates: a user's project takes the
# folder in, and draws the frames of `limner render`.
. tests/tap.sh
. tests/export/exported.sh
. sim/targets/targets.sh

command -v cmake >/dev/null || { tap_skip "CMake builds exported folders" "cmake is missing" && tap_done && exit; }

scenes=sim/scenes here=$(pwd)
mkdir -p "$work/names"
exported_names "$work/names"

# A toolchain file as users have them; start-up code and semihosting are the test's.
toolchain() { # CORE
    cat <<END
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER $(target_compiler "$1"))
set(CMAKE_C_FLAGS_INIT "$(target_flags "$1" | sed 's/-std=[^ ]*//') $WARNINGS -ffreestanding -ffunction-sections -fdata-sections")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
END
}

# The user's project. What makes an image goes to the linker; sources have names with slashes.
project() { # CORE FOLDER
    link_flags='' link_sources=''
    for word in $(target_image "$1"); do
        case $word in
        *.c) link_sources="$link_sources $here/$word" ;;
        -Wl,-T,*) link_flags="$link_flags -Wl,-T,$here/${word#-Wl,-T,}" ;;
        -L*) link_flags="$link_flags -L$here/${word#-L}" ;;
        *) link_flags="$link_flags $word" ;;
        esac
    done
    cat <<END
cmake_minimum_required(VERSION 3.13)
project(drawing C)
set(CMAKE_C_STANDARD 11)
add_subdirectory($2/model model)
add_executable(draws $here/tests/export/draw.c$link_sources)
target_include_directories(draws PRIVATE $2 $work/names $here/sim/targets $here/boards/common)
target_link_libraries(draws model$link_flags -Wl,--gc-sections -lgcc)
END
}

configure() { # CORE FOLDER
    toolchain "$1" >"$2/toolchain.cmake" && mkdir -p "$2/project" && project "$1" "$2" >"$2/project/CMakeLists.txt" &&
        cmake -S "$2/project" -B "$2/built" -DCMAKE_TOOLCHAIN_FILE="$2/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release >"$2/log" 2>&1 || { cat "$2/log" && return 1; }
}

draws() { # CORE MODEL CAMERAS|- OPTION...
    core=$1 model=$2 cameras=$3 folder=$work/$1
    shift 3
    exported_expected "$folder" "$model" "$cameras" --size 96x64 "$@" >/dev/null &&
        "$BUILD/limner" export "$model" --for cmake --size 96x64 -o "$folder/model" "$@" >/dev/null && configure "$core" "$folder" &&
        cmake --build "$folder/built" >"$folder/log" 2>&1 || { cat "$folder/log" && return 1; }
    target_run "$core" "$folder/built/draws" >"$folder/drawn" && diff "$folder/expected" "$folder/drawn"
}

# The example's project, with a display that is the user's to write.
example_builds() {
    "$BUILD/limner" export $scenes/teapot.obj --for cmake -o "$work/example" >/dev/null || return 1
    printf '#include <stdint.h>\nint display_send(void *ctx, uint16_t y, const uint16_t *pixels, uint16_t x, uint16_t n);\nint display_send(void *ctx, uint16_t y, const uint16_t *pixels, uint16_t x, uint16_t n)\n{\n    static unsigned calls;\n    (void)ctx, (void)y, (void)pixels, (void)x, (void)n;\n    return ++calls == 1000 ? -1 : 0;\n}\n' >"$work/example/example/display.c"
    sed -i 's/ main.c)/ main.c display.c)/' "$work/example/example/CMakeLists.txt"
    cmake -S "$work/example/example" -B "$work/example-built" >"$work/log" 2>&1 && cmake --build "$work/example-built" >>"$work/log" 2>&1 ||
        { cat "$work/log" && return 1; }
    timeout -k 5 30 "$work/example-built/example_example"
    [ $? -eq 255 ]
}

tap_check "Cortex-M0+ draws rooms" draws m0plus $scenes/rooms.obj $scenes/rooms.cam
tap_check "Cortex-M4 draws the teapot in profile exact" draws m4 $scenes/teapot.obj $scenes/teapot.cam --precision exact
tap_check "Cortex-M33 draws glass" draws m33 $scenes/glass.obj $scenes/glass.cam --precision fine
tap_check "RV32IMC draws what moves" draws rv32 $scenes/movers.gltf $scenes/movers.cam
tap_check "the example's project builds, and stops when the display fails" example_builds
tap_done
