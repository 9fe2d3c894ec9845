# SPDX-License-Identifier: MIT
#
# Every public header of firmware/ and hal/ can be included first and before any other one, in C11 and in C++11 to 20, by
# each compiler without a warning. firmware/DESIGN.md says which of the renderer's headers are public; of hal/ all are.
. tests/tap.sh

# In the page's list.
firmware_headers() {
    sed -n '/^## Public headers/,/^## /s/^| `\([a-z_]*\.h\)`.*/\1/p' firmware/DESIGN.md
}

# Of peripherals, those that the processor may have; of Linux and hidapi, on the PC alone.
hal_headers() { # COMPILER
    case $1 in
    avr-*) ls hal/*.h hal/mcu/avr_*.h hal/mcu/mcu.h hal/mcu/wait.h ;;
    arm-* | riscv64-*) ls hal/*.h hal/mcu/*.h ;;
    *) ls hal/*.h hal/mcu/*.h hal/linux/*.h hal/hid/*.h ;;
    esac | sed 's,^hal/,,'
}

standards_of() { # COMPILER: C11 by the same compiler's C; AVR's is of 2015
    case $1 in
    avr-gcc) echo gnu11 ;; # gnu: __flash is no part of C
    *gcc | clang) echo c11 ;;
    avr-g++) echo c++11 c++14 c++1z ;;
    *) echo c++11 c++14 c++17 c++20 ;;
    esac
}

flags_of() { # COMPILER
    case $1 in
    avr-*) echo -mmcu=atmega32u4 ;;
    arm-*) echo -mthumb -mcpu=cortex-m0plus -ffreestanding ;;
    riscv64-*) echo -march=rv32imc -mabi=ilp32 -ffreestanding ;;
    *) pkg-config --cflags hidapi-hidraw ;;
    esac
}

# Of n headers in a ring, file k begins with header k and goes round the ring: there header k comes first, and before
# each other one.
include_in_turns() { # LANGUAGE HEADER...
    language=$1
    shift
    mkdir -p "$work/$language"
    rm -f "$work/$language"/*
    printf '%s\n' "$@" | awk -v folder="$work/$language" -v language="$language" '
        { header[NR - 1] = $0 }
        END {
            for (k = 0; k < NR; k++)
                for (i = 0; i < NR; i++)
                    print "#include \"" header[(k + i) % NR] "\"" > sprintf("%s/%03d.%s", folder, k, language)
        }'
}

accepts() { # COMPILER STANDARD FILE...
    compiler=$1 standard=$2
    shift 2
    # shellcheck disable=SC2046 # flags are words
    "$compiler" "-std=$standard" $(flags_of "$compiler") -Wall -Wextra -pedantic -Werror -Ifirmware -Ihal -fsyntax-only "$@"
}

# The renderer's headers begin a file in every standard, those of displays and ports each in one of them.
headers_are_accepted() { # COMPILER STANDARD NUMBER-OF-STANDARD
    case $1 in *++) language=cpp ;; *) language=c ;; esac
    renderer=$(firmware_headers)
    [ "$(echo "$renderer" | wc -l)" -ge 10 ] || return 1
    # shellcheck disable=SC2046,SC2086 # names are words
    include_in_turns $language $renderer $(hal_headers "$1")
    # shellcheck disable=SC2046 # files are words
    accepts "$1" "$2" $(printf '%s\n' "$work/$language"/* | awk -v first="$(echo "$renderer" | wc -l)" -v turn="$3" \
        -v of="$(standards_of "$1" | wc -w)" 'NR <= first || NR % of == turn % of')
}

# A header that C++ does not take, and one whose name clashes with another's, are found.
faults_are_found() {
    mkdir -p "$work/faulty"
    echo 'struct fault { int class; };' >"$work/faulty/one.h"
    echo 'enum { FAULT };' >"$work/faulty/two.h"
    echo '#define FAULT 1' >"$work/faulty/three.h"
    include_in_turns cpp one.h && ! accepts g++ c++11 -I"$work/faulty" "$work/cpp/000.cpp" || return 1
    include_in_turns cpp two.h three.h && accepts g++ c++11 -I"$work/faulty" "$work/cpp/000.cpp" &&
        ! accepts g++ c++11 -I"$work/faulty" "$work/cpp/001.cpp"
}

# Who uses the renderer includes no private header but those that struct lim is made of.
public_are_told() {
    for header in $(firmware_headers); do
        [ -e "firmware/$header" ] || { echo "firmware/$header is not there"; return 1; }
    done
    sed -n 's/^#include "\(.*\)".*/\1/p' firmware/limner.h | grep -vxE "(stages|orders).h" | while read -r header; do
        firmware_headers | grep -qx "$header" || { echo "limner.h includes $header, which is not told"; exit 1; }
    done
}

tap_check "headers with faults are found" faults_are_found
tap_check "what limner.h includes is told in firmware/DESIGN.md" public_are_told
for compiler in gcc clang arm-none-eabi-gcc riscv64-unknown-elf-gcc avr-gcc \
    g++ clang++ arm-none-eabi-g++ riscv64-unknown-elf-g++ avr-g++; do
    number=0
    for standard in $(standards_of "$compiler"); do
        tap_check "$compiler, $standard: public headers, each of them first" headers_are_accepted "$compiler" "$standard" $number
        number=$((number + 1))
    done
done
tap_done
