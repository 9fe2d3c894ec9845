# SPDX-License-Identifier: MIT
#
# Whatever make is asked for, nothing calls a tool before the package that has it is there: the Makefile, in a system where
# nothing but Debian's essential packages is installed. Compilers are stand-ins that write empty files, and apt-get is one
# that takes a moment to install.
. tests/tap.sh

make=$(command -v make)
bin=$work/bin
mkdir "$bin"
export WORK="$work"

# Debian's essential packages.
for name in sh awk basename cat chmod cmp cp cut date dirname echo env false find findmnt grep head ln ls mkdir mktemp mv \
    nproc paste printf pwd rm rmdir sed sleep sort tail tee touch tr true uname uniq wc xargs; do
    ln -s "$(command -v "$name")" "$bin/$name"
done

stand_in() { # NAME: script on stdin
    { echo '#!/bin/sh' && cat; } >"$bin/$1"
    chmod +x "$bin/$1"
}

# tools PACKAGE NAME...: each notes when it is called before its package, or a library's, is installed, and writes what -o names.
tools() {
    package=$1
    shift
    for name; do
        stand_in "$name" <<EOF
package=$package name=$name
. "\$WORK/tool"
EOF
    done
}

cat >"$work/tool" <<'EOF'
need() { [ -e "$WORK/has/$1" ] || echo "$name, before $1 is there: $*" >>"$WORK/early"; }
need "$package"
echo "$name" >>"$WORK/called"
out= out_is_next=
for word; do
    case $word in
    -lassimp) need libassimp-dev ;;
    -lgd) need libgd-dev ;;
    -lgmp) need libgmp-dev ;;
    -lz) need zlib1g-dev ;;
    -lgpiod) need libgpiod-dev ;;
    -lhidapi) need libhidapi-dev ;;
    -lSDL2) need libsdl2-dev ;;
    -lcmocka) need libcmocka-dev ;;
    -lOSMesa) need libosmesa6-dev ;;
    -lsimavr) need libsimavr-dev ;;
    -lunicorn) need libunicorn-dev ;;
    -lelf) need libelf-dev ;;
    -fsanitize=fuzzer) need libclang-rt-dev ;;
    tests/*/test_*.c) need libcmocka-dev ;;
    esac
    [ -z "$out_is_next" ] || out=$word
    out_is_next=
    [ "$word" != -o ] || out_is_next=1
done
case $out in
'') ;;
*/limner | */generate_*) printf '#!/bin/sh\n' >"$out"; chmod +x "$out" ;;
*) : >"$out" ;;
esac
exit 0
EOF

tools gcc gcc ar ld objcopy nm size
tools clang clang
for prefix in avr:gcc-avr arm-none-eabi:gcc-arm-none-eabi riscv64-unknown-elf:gcc-riscv64-unknown-elf; do
    for name in gcc objcopy nm size; do
        tools "${prefix#*:}" "${prefix%%:*}-$name"
    done
done
stand_in pkg-config <<'EOF'
name=pkg-config
[ -e "$WORK/has/pkg-config" ] || { echo "pkg-config, before it is there" >>"$WORK/early"; exit 127; }
case "$*" in
"--exists sdl2") [ -e "$WORK/has/libsdl2-dev" ] ;;
"--modversion libgpiod") [ -e "$WORK/has/libgpiod-dev" ] && echo 1.6.3 ;;
--libs*) echo "-lassimp -lgd -lgpiod -lhidapi"; case "$*" in *sdl2*) echo -lSDL2 ;; esac ;;
*) echo ;;
esac
EOF
stand_in id <<'EOF'
echo 0
EOF
stand_in dpkg-query <<'EOF'
for package in "$WORK"/has/*; do echo "installed ${package##*/}, "; done
EOF
stand_in apt-get <<'EOF'
case " $* " in *" --print-uris "*) exit ;; *" update "*) exit ;; esac
sleep 0.3
echo install >>"$WORK/installs"
for word; do case $word in -* | DPkg* | install) ;; *) touch "$WORK/has/$word" ;; esac; done
EOF

# made GOAL...: makes that where no package is installed; what went wrong is in $work/early.
made() {
    rm -rf "$work/has" "$work/early" "$work/called" "$work/installs"
    mkdir "$work/has"
    touch "$work/early" "$work/called" "$work/installs"
    env -u DEPS PATH="$bin" "$make" BUILD="$work/build" CCACHE= "$@" >"$work/said" 2>&1 </dev/null
    sort "$work/early" | uniq -c | head -n 20
    [ ! -s "$work/early" ] && [ "$(wc -l <"$work/installs")" -eq 1 ]
}

called() { grep -qx -- "$1" "$work/called" || { tail -n 20 "$work/said"; return 1; }; }
has() { for package; do [ -e "$work/has/$package" ] || { echo "$package was not asked for"; return 1; }; done; }
afresh() { rm -rf "$work/build"; }

bare_board() { afresh && made BOARD=arduboy && called gcc && called avr-gcc && has avr-libc; }
board() { made BOARD="$1" && called "$2"; }
board_file() { rm -rf "$work/build/boards" && made BOARD=pico "$work/build/boards/pico/rooms-st7789-fast/image.elf" && called arm-none-eabi-gcc; }
with_jobs() { rm -rf "$work/build/boards" && made -j8 BOARD=arduboy all && called avr-gcc; }
flashing() { rm -rf "$work/build/boards" && made BOARD=arduboy flash FLASH=true && called avr-gcc && has avrdude; }
emulating() { rm -rf "$work/build/boards" && made BOARD=arduboy emulate EMULATE=true && called avr-gcc && called gcc && has libsimavr-dev; }
rules() { rm -rf "$work/build/boards" && made BOARD=stm32f405 rules RULES=true && called arm-none-eabi-gcc && called gcc && has libunicorn-dev; }
rules_checker_alone() { rm -f "$work/build/stm32" && made "$work/build/stm32" && called gcc; }
emulator_alone() { rm -f "$work/build/simavr_oled" && made "$work/build/simavr_oled" && called gcc; }
libraries_known() {
    rm -rf "$work/build/boards" && made BOARD=linux && grep -q -- '-DLIM_GPIOD=1 ' "$work/build/host/flags" &&
        grep -q -- '-DLIM_GPIOD=1 ' "$work/build/boards/linux/common/flags"
}
program() { afresh && made "$work/build/limner" && called gcc && [ -x "$work/build/limner" ]; }
two_goals() { made run test-programs && called gcc && has libcmocka-dev libosmesa6-dev sigrok-cli; }
one_test() { rm -rf "$work/build/tests" "$work/build/host/tests" && made "$work/build/tests/test_span" && called gcc; }
one_object() { rm -rf "$work/build/host/tests" && made "$work/build/host/tests/unit/firmware/test_span.o" && called gcc; }
kernel_program() { made "$work/build/tests/kernel/replay" && called gcc; }
plugin() { rm -f "$work/build/count_plugin.so" && made "$work/build/count_plugin.so" && called gcc; }
other_compiler() { made CC=clang BUILD="$work/clang" "$work/clang/host/sim/base/error.o" && called clang && has clang; }
window() { made view && called gcc && has libsdl2-dev && grep -q -- '-DLIM_HAVE_SDL2=1 ' "$work/build/host/sdl2" && ! grep -q SDL2 "$work/build/host/flags"; }

tap_check "make BOARD=arduboy, from nothing" bare_board
for pair in bluepill:arm-none-eabi-gcc hifive1:riscv64-unknown-elf-gcc esp32c3:riscv64-unknown-elf-gcc lm3s6965evb:arm-none-eabi-gcc pico:arm-none-eabi-gcc pico2:arm-none-eabi-gcc \
    stm32f405:arm-none-eabi-gcc linux:gcc; do
    tap_check "make BOARD=${pair%%:*}" board "${pair%%:*}" "${pair#*:}"
done
tap_check "every board is among these" [ "$(ls -d boards/*/board.mk | wc -l)" -eq 9 ]
tap_check "make BOARD=pico FILE" board_file
tap_check "make -j8 BOARD=arduboy all" with_jobs
tap_check "make BOARD=arduboy flash" flashing
tap_check "make BOARD=arduboy emulate" emulating
tap_check "the host of an emulator alone" emulator_alone
tap_check "make BOARD=stm32f405 rules" rules
tap_check "the chip that holds an image to rules alone" rules_checker_alone
tap_check "libraries are looked for once they are there" libraries_known
tap_check "the host program alone, from nothing" program
tap_check "make run test-programs" two_goals
tap_check "one test's program" one_test
tap_check "one test's object" one_object
tap_check "a test with a kernel" kernel_program
tap_check "the counting plugin" plugin
tap_check "another compiler" other_compiler
tap_check "make view, with a window" window
tap_done
