# SPDX-License-Identifier: MIT
#
# Builds programs for emulated processors and runs them, for scripts to source: target_link, target_run.
# Needs $WARNINGS; runs in the project's folder. Processors:
#   m0plus    Cortex-M0+ code with 4 MB of RAM (QEMU has no such machine with as much: it runs on a Cortex-M3)
#   microbit  the same code on the Cortex-M0 of a micro:bit, which refuses any other; 16 KB of RAM
#   m3 m4     Cortex-M3; Cortex-M4 with floating-point unit
#   m33       Cortex-M33 with floating-point unit and DSP instructions, in secure state
#   m33nofp   the same machine, code that touches no floating-point register
#   rv32      RISC-V RV32IMC in machine mode
#   lx106     the ESP8266's core, an Xtensa without division and long products
#   avr       ATmega1284P, 128 KB of flash and 16 KB of RAM
#   powerpc   32-bit big-endian, under Linux
#   host      this computer
# shellcheck shell=sh

target_tools() { # CORE: the prefix of its tools
    case $1 in
    m0plus | microbit | m3 | m4 | m33 | m33nofp) echo arm-none-eabi- ;;
    rv32) echo riscv64-unknown-elf- ;;
    lx106) echo xtensa-lx106-elf- ;;
    avr) echo avr- ;;
    powerpc) echo powerpc-linux-gnu- ;;
    esac
}

target_compiler() { # CORE
    [ "$1" = host ] && echo "${CC:-gcc}" || echo "$(target_tools "$1")gcc"
}

target_flags() { # CORE: of the compiler, for code that is to be the target's
    case $1 in
    m0plus | microbit) echo -std=c11 -mthumb -mcpu=cortex-m0plus ;;
    m3) echo -std=c11 -mthumb -mcpu=cortex-m3 ;;
    m4) echo -std=c11 -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard ;;
    m33) echo -std=c11 -mthumb -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard ;;
    m33nofp) echo -std=c11 -mthumb -mcpu=cortex-m33+nofp -mfloat-abi=soft ;;
    rv32) echo -std=c11 -march=rv32imc -mabi=ilp32 ;;
    avr) echo -std=gnu11 -mmcu=atmega1284p ;; # gnu: __flash is no part of C
    *) echo -std=c11 ;;
    esac
}

# target_version CORE: what decides how many instructions a program has; for the host its own processor, too.
target_version() {
    echo "$("$(target_compiler "$1")" --version | head -n 1)$([ "$1" != host ] || echo ", $(uname -m)")"
}

# Start-up sources and flags that make an image of them. A bare one has no library but the compiler's.
target_image() { # CORE
    case $1 in
    m0plus | m3 | m4) target_bare cortex_m mps2 ;;
    microbit) target_bare cortex_m microbit ;;
    m33 | m33nofp) target_bare cortex_m an505 ;;
    rv32) target_bare riscv virt ;;
    lx106) target_bare_of lx106 sim/targets/start_lx106.c sim/targets/integers_lx106.c ;;
    avr) echo sim/targets/start_avr.c ;;
    powerpc) echo -static sim/targets/start_host.c ;;
    host) echo sim/targets/start_host.c ;;
    esac
}

target_bare() { # ARCHITECTURE MACHINE
    target_bare_of "$2" "boards/common/start_$1.c" sim/targets/semihost.c
}

target_bare_of() { # MACHINE SOURCE...
    target_script=sim/targets/$1.ld
    shift
    echo -ffreestanding -nostdlib -Wl,--fatal-warnings -Wl,--no-warn-rwx-segments -Lboards/common \
        "-Wl,-T,$target_script" boards/common/bare_image.c "$@"
}

# target_compile CORE OBJECT SOURCE FLAG...: one file, -O2 if not told otherwise; $CCACHE is of sim/tools/compiler_cache.sh, or
# empty.
target_compile() {
    target_core=$1 target_object=$2 target_source=$3
    shift 3
    # shellcheck disable=SC2046,SC2086 # flags are words
    ${CCACHE:-} $(target_compiler "$target_core") $(target_flags "$target_core") -O2 $WARNINGS -ffunction-sections \
        -fdata-sections -Ifirmware -Ihal -Iboards/common -Isim/targets "$@" -c -o "$target_object" "$target_source"
}

# target_link CORE IMAGE FLAG|OBJECT|SOURCE...: compiles the sources, and the start-up with them, into an image. Its
# objects stay beside it. No argument has spaces.
target_link() {
    target_core=$1 target_output=$2 target_given='' target_count=0
    shift 2
    # shellcheck disable=SC2046 # sources and flags are words
    set -- "$@" $(target_image "$target_core")
    for target_word; do
        case $target_word in
        *.[co] | -Wl,* | -L*) ;;
        *) target_given="$target_given $target_word" ;;
        esac
    done
    rm -rf "$target_output.objects"
    mkdir "$target_output.objects" || return 1
    for target_word; do
        shift
        if [ "${target_word%.c}" != "$target_word" ]; then
            target_count=$((target_count + 1))
            # shellcheck disable=SC2086 # flags are words
            target_compile "$target_core" "$target_output.objects/$target_count.o" "$target_word" $target_given || return 1
            target_word=$target_object
        fi
        set -- "$@" "$target_word"
    done
    # shellcheck disable=SC2046 # flags are words
    $(target_compiler "$target_core") $(target_flags "$target_core") -O2 -Wl,--gc-sections -o "$target_output" "$@" -lgcc
}

# QEMU's MPS2 boards always have their network chip and warn when it has no peer: this one leads nowhere.
target_peer='-nic user,restrict=on'

# target_run CORE IMAGE [QEMU-ARGUMENT...]: runs it; its output and exit status become ours. Ends after two minutes.
target_run() {
    target_core=$1 target_output=$2
    shift 2
    # shellcheck disable=SC2086 # flags are words
    case $target_core in
    m0plus | m3) target_qemu arm mps2-an385 $target_peer "$@" ;;
    m4) target_qemu arm mps2-an386 $target_peer "$@" ;;
    m33 | m33nofp) target_qemu arm mps2-an505 $target_peer "$@" ;;
    microbit) target_qemu arm microbit -nic none "$@" ;;
    rv32) target_qemu riscv32 virt -nic none -bios none "$@" ;;
    lx106) target_qemu xtensa sim -cpu lx106 -nic none "$@" ;;
    avr) target_simavr ;;
    powerpc) timeout -k 5 120 qemu-ppc "$@" "$target_output" ;;
    host) timeout -k 5 120 "$target_output" ;;
    esac
}

target_qemu() { # SYSTEM MACHINE ARGUMENT...
    target_system=$1 target_machine=$2
    shift 2
    timeout -k 5 120 "qemu-system-$target_system" -M "$target_machine" -kernel "$target_output" -nodefaults \
        -display none -serial none -monitor none -chardev stdio,id=host \
        -semihosting-config enable=on,target=native,chardev=host "$@" </dev/null
}

# simavr shows what the serial port says in green, with a dot for the end of the line; the last line is the exit status.
target_simavr() {
    timeout -k 5 120 simavr -m atmega1284p -f 16000000 "$target_output" </dev/null 2>&1 |
        awk -F '\033' '
            NF > 1 { line = $NF; sub(/^\[32m/, "", line); sub(/\.$/, "", line) }
            line ~ /^exit [0-9]$/ { status = substr(line, 6); ended = 1 }
            NF > 1 && !ended { print line }
            END { exit ended ? status : 3 }'
}
