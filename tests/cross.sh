# SPDX-License-Identifier: MIT
#
# firmware/ and hal/ compile without a warning for every kind of processor that they are meant for, and
# the objects are what a microcontroller wants: no library, no mutable globals, no floating point. Other configurations
# are compiled for every fourth kind, for the others with other commits; SEED=all: for all.
. tests/tap.sh
. tests/one_file.sh
. tests/part_of.sh

targets='x86-64 cortex-m0plus cortex-m4 rv32imc avr'

# Prefix of the tools, and flags. With -mgeneral-regs-only the PC has no floating point either.
tools_of() {
    case $1 in
    x86-64) echo '' ;;
    cortex-*) echo arm-none-eabi- ;;
    rv32imc) echo riscv64-unknown-elf- ;;
    avr) echo avr- ;;
    esac
}

flags_of() {
    case $1 in
    x86-64) echo -std=c11 -mgeneral-regs-only -fno-pie ;;
    cortex-m0plus) echo -std=c11 -mthumb -mcpu=cortex-m0plus ;;
    cortex-m4) echo -std=c11 -mthumb -mcpu=cortex-m4 -mfloat-abi=soft ;;
    rv32imc) echo -std=c11 -march=rv32imc -mabi=ilp32 ;;
    avr) echo -std=gnu11 -mmcu=atmega32u4 ;; # gnu: __flash is no part of C
    esac
}

compile() { # TARGET OBJECT SOURCE [FLAG...]
    cross_target=$1 cross_object=$2 cross_source=$3
    shift 3
    # shellcheck disable=SC2046,SC2086 # flags are words
    ${CCACHE:-} "$(tools_of "$cross_target")gcc" $(flags_of "$cross_target") -O2 -ffreestanding $WARNINGS -Ifirmware -Ihal "$@" \
        -c -o "$cross_object" "$cross_source"
}

compile_all() { # TARGET FOLDER: compiles every file of the folder, tells all the warnings
    mkdir -p "$work/$1/$2"
    failed=0
    for source in "$2"/*.c "$2"/*/*.c; do
        case $source in *\**) continue ;; hal/*/*) continue ;; esac
        mkdir -p "$work/$1/${source%/*}"
        compile "$1" "$work/$1/${source%.c}.o" "$source" || failed=1
    done
    return $failed
}

all=$(one_file)

# What the compiler has to say of a configuration without making code of it. One file is read faster than all.
check_variant() { # TARGET FLAG...
    cross_target=$1
    shift
    # shellcheck disable=SC2046,SC2086 # flags are words
    "$(tools_of "$cross_target")gcc" $(flags_of "$cross_target") -ffreestanding $WARNINGS -Ifirmware -Ihal "$@" \
        -fsyntax-only "$all"
}

check_variants() { # TARGET: other profiles, other screen coordinates, fewer features
    failed=0
    for profile in $(echo "${PROFILES:?is set by the Makefile}" | tr '[:lower:]' '[:upper:]'); do
        check_variant "$1" -DLIM_PROFILE="LIM_PROFILE_$profile" -DLIM_MAX_SIDE_PX=128 || failed=1
    done
    check_variant "$1" -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_STATS=0 -DLIM_HAS_PAINTER=0 || failed=1
    check_variant "$1" -DLIM_HAS_STATS=0 -DLIM_HAS_PAINTER=0 -DLIM_HAS_NEAREST=0 -DLIM_HAS_DEPTH=0 -DLIM_HAS_NEWELL=0 \
        -DLIM_HAS_CULL=0 -DLIM_HAS_LARGE=0 -DLIM_HAS_SLANTED=0 || failed=1
    check_variant "$1" -DLIM_HAS_STATS=0 -DLIM_HAS_PAINTER=0 -DLIM_HAS_NEAREST=0 -DLIM_HAS_DEPTH=0 -DLIM_HAS_NEWELL=0 \
        -DLIM_HAS_CONVEX=0 -DLIM_MAX_SIDE_PX=240 || failed=1
    check_variant "$1" -DLIM_HAS_PAINTER=0 -DLIM_HAS_NEAREST=0 -DLIM_HAS_DEPTH=0 -DLIM_HAS_NEWELL=0 -DLIM_HAS_CONVEX=0 \
        -DLIM_HAS_TEXTURE=0 -DLIM_HAS_TRANSPARENT=0 -DLIM_HAS_WIREFRAME=0 -DLIM_HAS_ANTIALIAS=0 -DLIM_HAS_DELTA=0 \
        -DLIM_HAS_ROUND=0 || failed=1
    check_variant "$1" -DLIM_HAS_NEAREST=0 -DLIM_HAS_SCANLINE=0 -DLIM_HAS_DEPTH=0 -DLIM_HAS_NEWELL=0 -DLIM_HAS_CONVEX=0 \
        -DLIM_HAS_TRANSPARENT=0 -DLIM_HAS_WIREFRAME=0 || failed=1
    check_variant "$1" -DLIM_HAS_FRAMEBUFFER=0 -DLIM_HAS_FILL=0 || failed=1
    check_variant "$1" -DLIM_HAS_FILL=0 -DLIM_HAS_PAINTER=0 -DLIM_HAS_SCANLINE=0 || failed=1
    return $failed
}

# Static names are unique over the folder, so all of it compiles as one file.
is_one_file() { # TARGET
    failed=0
    for profile in $(echo "$PROFILES" | tr '[:lower:]' '[:upper:]'); do
        compile "$1" "$work/all.o" "$all" -DLIM_PROFILE="LIM_PROFILE_$profile" || failed=1
    done
    return $failed
}

sizes_hold() { # TARGET
    compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=480 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_WIDE=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_TEXTURE=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_SKY=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_MESH_DEPTH=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_MESH_DEPTH=0 -DLIM_HAS_WIDE=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_ANTIALIAS=0 &&
        compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_HAS_ANTIALIAS=0 -DLIM_HAS_TEXTURE=0 || return 1
    for profile in FINE EXACT; do
        for has in 0 1; do
            compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_PROFILE=LIM_PROFILE_$profile &&
                compile "$1" "$work/sizes.o" tests/targets/sizes.c -DLIM_HAS_STATS=0 -DLIM_MAX_SIDE_PX=240 -DLIM_PROFILE=LIM_PROFILE_$profile -DLIM_HAS_ANTIALIAS=0 -DLIM_HAS_TEXTURE=$has || return 1
        done
    done
}

# Integer support of libgcc, by the ABI's names: arithmetic on 8 to 64 bits (no sf, df: those are
# floating point), switch tables, AVR's reads of flash. __do_copy_data and __do_clear_bss are not
# among them: AVR objects ask for these when constants would take up RAM.
integer_support='^(memcpy|memmove|memset|memcmp)$
^__aeabi_(u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr|u?lcmp|mem(cpy|move|set|clr)[48]?)$
^__[a-z]+([qhds]i|psi)[234](_s8)?$
^__gnu_thumb1_case_[us](qi|hi|si)$
^__(tablejump2?__|.?load_[1-4])$'

own_symbols_only() { # TARGET
    "$(tools_of "$1")nm" --defined-only -P "$work/$1"/firmware/*.o "$work/$1"/firmware/*/*.o | awk 'NF > 1 { print $1 }' >"$work/defined"
    "$(tools_of "$1")nm" --undefined-only -P -A "$work/$1"/firmware/*.o "$work/$1"/firmware/*/*.o | sed "s,^$work/,," >"$work/undefined"
    printf '%s\n' "$integer_support" >"$work/support"
    awk -v defined="$work/defined" -v support="$work/support" '
        BEGIN {
            while ((getline name < defined) > 0) known[name] = 1
            while ((getline pattern < support) > 0) allowed = allowed (allowed ? "|" : "") pattern
        }
        !known[$2] && $2 !~ allowed { print; bad = 1 }
        END { exit bad }' "$work/undefined"
}

no_mutable_data() { # TARGET
    "$(tools_of "$1")nm" -P -A "$work/$1"/*/*.o | sed "s,^$work/,," |
        awk '$3 ~ /^[BbCcDdGgSs]$/ { print; bad = 1 } END { exit bad }'
}

standard_headers_only() {
    ! grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' firmware/*.[ch] firmware/*/*.[ch] |
        grep -vE '<(stdint|stddef|stdbool)\.h>'
}

tap_check "firmware includes only <stdint.h>, <stddef.h>, <stdbool.h> and itself" standard_headers_only
for target in $targets; do
    tap_check "$target: firmware compiles without a warning" compile_all "$target" firmware
    tap_check "$target: hal compiles without a warning" compile_all "$target" hal
    tap_check "$target: firmware needs only itself and integer support" own_symbols_only "$target"
    tap_check "$target: no mutable data" no_mutable_data "$target"
done
# shellcheck disable=SC2086 # names
for target in $(part_of 4 $targets); do
    tap_check "$target: other configurations give no warning" check_variants "$target"
    tap_check "$target: all of firmware compiles as one file" is_one_file "$target"
done
for target in cortex-m0plus cortex-m4 rv32imc; do
    tap_check "$target: structs are as large as the compiler reports" sizes_hold "$target"
done
tap_done
