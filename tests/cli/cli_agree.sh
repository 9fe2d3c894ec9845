# SPDX-License-Identifier: MIT
#
# Parts of a firmware that were configured differently, or are of different versions, do not compile or link, and what
# the tools say names the cause (firmware/agree.h).
. tests/tap.sh

fitted='-DLIM_CONFIG="model.h"'

prepare() {
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --size 64x64 -o "$work/model" >/dev/null || return 1
    cat >"$work/main.c" <<'END'
#ifdef SCENE_FIRST
#include "model.h"
#endif
#include "limner.h"
#include "model.h"
static struct lim lim;
static uint32_t mem[MODEL_SCENE_MEM_B(64) / 4 + 1];
static uint32_t line[64];
static void *lend(void *ctx, uint16_t y_px) { (void)ctx, (void)y_px; return line; }
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px) { (void)ctx, (void)y_px, (void)x_px, (void)n_px; return 0; }
int main(void)
{
    const struct lim_target target = {.w_px = 64, .h_px = 64, .method = MODEL_SCENE_METHOD, .lend = lend, .done = done};
    const struct lim_camera camera = {.eye_q8 = {0, 0, 1 << 22}, .tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};
    const int err = lim_init(&lim, &model_scene, &target, mem, sizeof mem);
    return err ? err : lim_frame(&lim, &camera);
}
END
    for source in firmware/*.c firmware/*/*.c; do
        firmware_part "$source" "$work/$(basename "$source" .c).o" || return 1
    done
    ar rcs "$work/renderer.a" "$work"/*.o && part "$work/model.o" "$work/model.c" "$fitted"
}

part() { # OBJECT SOURCE FLAG...
    part_object=$1 part_source=$2
    shift 2
    ${CCACHE:-} "$CC" -std=c11 -O1 "$@" -Ifirmware -I"$work" -c -o "$part_object" "$part_source"
}

firmware_part() { # SOURCE OBJECT
    part "$2" "$1" "$fitted"
}

links() { # MAIN SCENE
    "$CC" -o "$work/program" "$1" "$2" "$work/renderer.a"
}

together() { # FLAG...: of the main file; the renderer and the scene are fitted to the scene
    part "$work/main.o" "$work/main.c" "$@" && links "$work/main.o" "$work/model.o" && "$work/program"
}

# What the linker says names the symbol and, in it, the reason.
apart() { # PATTERN FLAG...
    wanted=$1
    shift
    part "$work/main.o" "$work/main.c" "$@" || return 1
    ! links "$work/main.o" "$work/model.o" 2>"$work/said" || return 1
    cat "$work/said"
    grep -q "undefined reference to .lim_init\.needs_same_LIM_CONFIG$wanted" "$work/said"
}

renderer_is_not_fitted() {
    mkdir -p "$work/whole"
    for source in firmware/*.c firmware/*/*.c; do
        part "$work/whole/$(basename "$source" .c).o" "$source" || return 1
    done
    part "$work/main.o" "$work/main.c" "$fitted" &&
        ! "$CC" -o "$work/program" "$work/main.o" "$work/model.o" "$work"/whole/*.o 2>"$work/said" || return 1
    cat "$work/said"
    grep -q 'undefined reference to .lim_init\.needs_same_LIM_CONFIG\.v[0-9_]*\.fast_7\.64px.*\.scanline' "$work/said"
}

scene_is_apart() {
    part "$work/main.o" "$work/main.c" "$fitted" && part "$work/wide.o" "$work/model.c" "$fitted" -DLIM_HAS_WIDE=1 || return 1
    ! links "$work/main.o" "$work/wide.o" 2>"$work/said" || return 1
    cat "$work/said"
    grep -q 'undefined reference to .model_scene\.needs_same_LIM_CONFIG' "$work/said"
}

# Every setting of config.h that structs may depend on is in the symbol, or may not be changed by itself.
settings() {
    sed -n 's/^#ifndef \(LIM_[A-Z_]*\)$/\1/p' firmware/config.h | grep -vE '_H$'
}

# These decide how something is computed, and no struct.
free_settings='LIM_ASSERT LIM_DEBUG_ASSERT LIM_NEWELL_EFFORT LIM_OPTIMISE LIM_RECIP_TABLE LIM_DIVIDES'

# What is put behind a name; nothing where the configuration is refused.
symbol_of() { # FLAG...
    printf '#include "agree.h"\nLIM_AGREES(lim_init)\n' | "$CC" -std=c11 -E -P "$@" -Ifirmware -I"$work" - 2>"$work/refused" |
        sed -n 's/^__asm__//p'
}

# Adds to $told whether two values differ: a setting that is no matter of choice in one configuration is one in another.
tell() { # SETTING VALUE VALUE FLAG...
    first_flag=-D$1=$2 second_flag=-D$1=$3
    shift 3
    first=$(symbol_of "$@" "$first_flag") second=$(symbol_of "$@" "$second_flag")
    if [ -z "$first" ] || [ -z "$second" ]; then
        told="$told refused"
    elif [ "$first" = "$second" ]; then
        told="$told same"
    else
        told="$told apart"
    fi
}

# Two values of a setting.
values_of() { # SETTING
    case $1 in
    LIM_HAS_*) echo 0 1 ;;
    LIM_PROFILE) echo LIM_PROFILE_FINE LIM_PROFILE_EXACT ;;
    LIM_SUB_BITS) echo 4 5 ;;
    LIM_VIEW_CACHE_ENTRIES) echo 8 16 ;;
    *) echo 30 31 ;;
    esac
}

every_setting_is_told() {
    [ "$(settings | wc -l)" -ge 30 ] || return 1
    failed=0
    for setting in $(settings); do
        case " $free_settings " in *" $setting "*) continue ;; esac
        told=
        # shellcheck disable=SC2046 # two words
        set -- "$setting" $(values_of "$setting")
        tell "$@"
        tell "$@" "$fitted"
        tell "$@" "$fitted" -DLIM_HAS_FILL=1
        case $told in *same*) failed=1 ;; *apart*) continue ;; esac
        echo "$setting: $told"
        failed=1
    done
    return $failed
}

# A header of another version comes first among the places to look.
other_version() { # VERSION-MACRO NUMBER
    mkdir -p "$work/other"
    cp -R firmware/. "$work/other"
    sed -i "s/^#define $1 .*/#define $1 $2/" "$work/other/agree.h" "$work/other/scene.h"
}

version_is_apart() {
    other_version LIM_VERSION_MINOR 99 && "$CC" -std=c11 "$fitted" -I"$work/other" -I"$work" -c -o "$work/main.o" "$work/main.c" &&
        ! links "$work/main.o" "$work/model.o" 2>"$work/said" || return 1
    cat "$work/said"
    grep -q 'lim_init\.needs_same_LIM_CONFIG\.v0_99_0' "$work/said"
}

refuses_scene() { # SOURCE FLAG...
    refused=$1
    shift
    ! "$CC" -std=c11 "$fitted" "$@" -I"$work" -c -o "$work/refused.o" "$refused" 2>"$work/said" || return 1
    cat "$work/said"
    grep -q 'compile this scene again' "$work/said"
}

format_is_apart() { # FILE: of the scene, or one that includes it
    other_version LIM_SCENE_FORMAT 99 && refuses_scene "$1" -I"$work/other"
}

# What was written before scenes told their format.
older_source_is_refused() {
    printf '#include "scene.h"\n\n_Static_assert(LIM_SCENE_VERSION == 6, "compile this scene again");\n' >"$work/older.c"
    refuses_scene "$work/older.c" -Ifirmware
}

tap_check "a renderer fitted to a scene builds" prepare
tap_check "a main file with the same LIM_CONFIG links and draws" together "$fitted"
tap_check "so does one that includes the scene's header first, without LIM_CONFIG" together -DSCENE_FIRST
tap_check "one without LIM_CONFIG does not link" apart '.*fast_7\.1024px'
tap_check "nor one for another precision" apart '.*\.fine_9\.' "$fitted" -DLIM_PROFILE=LIM_PROFILE_FINE
tap_check "nor one for another screen" apart '.*\.100px' "$fitted" -DLIM_MAX_SIDE_PX=100
tap_check "nor one with something more" apart '.*\.stats' "$fitted" -DLIM_HAS_STATS=1
tap_check "nor does a renderer without LIM_CONFIG link with a file that has it" renderer_is_not_fitted
tap_check "nor a scene's source with wider indices" scene_is_apart
tap_check "nor a main file of another LIM_VERSION" version_is_apart
tap_check "every setting is told in the symbol" every_setting_is_told
tap_check "a scene's source of another format does not compile" format_is_apart "$work/model.c"
tap_check "nor does a file that includes its header" format_is_apart "$work/main.c"
tap_check "nor does a scene's source from before 0.1.0" older_source_is_refused
tap_done
