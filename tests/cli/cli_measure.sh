# SPDX-License-Identifier: MIT
#
# `limner measure` without counting: tables, files, refusals; and sim/MEASURED.md says what it says.
. tests/tap.sh

scene=sim/scenes/rooms.obj
head -n 3 sim/scenes/rooms.cam >"$work/few.cam"

measure() {
    "$BUILD/limner" measure "$scene" --camera "$work/few.cam" --size 120x120 "$@"
}

# refuses WORDS COMMAND...: fails, in one line that has the words, without a word on standard output.
refuses() {
    words=$1
    shift
    if "$@" >"$work/out" 2>"$work/err"; then
        echo "succeeded"
        return 1
    fi
    cat "$work/err"
    [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF -- "$words" "$work/err"
}

prints_a_row_for_each() {
    measure --no-cost >"$work/table" && cat "$work/table" && for name in draft fast fine exact; do
        grep -q "^| $name | [0-9]* | [0-9.]* | " "$work/table" || return 1
    done && [ "$(grep -c '^| [a-z_0-9]* | [0-9]* | ' "$work/table")" -eq 4 ]
}

decides_every_side() {
    grep '^| ' "$work/table" | grep -v precision | grep -v ' | 0 of [1-9][0-9]* |' && return 1
    grep -q ' | 0 of [1-9][0-9]* |' "$work/table"
}

is_the_same_again() {
    measure --no-cost >"$work/again" && diff "$work/table" "$work/again"
}

writes_markdown_and_csv() {
    measure --no-cost --precision fast,exact -o "$work/new/folder" >"$work/said" &&
        diff "$work/said" "$work/new/folder/measure.md" && [ "$(wc -l <"$work/new/folder/measure.csv")" -eq 3 ] &&
        [ "$(ls "$work/new/folder")" = "$(printf 'measure.csv\nmeasure.md')" ]
}

leaves_nothing_behind() {
    mkdir -p "$work/blocked/measure.csv" "$work/tmp"
    refuses "it is a folder" env TMPDIR="$work/tmp" "$BUILD/limner" measure "$scene" --camera "$work/few.cam" \
        --no-cost --precision fast -o "$work/blocked" &&
        [ "$(ls "$work/blocked")" = measure.csv ] && [ -z "$(ls "$work/tmp")" ]
}

# With a PATH in which there is a compiler for Arm and no emulator.
names_the_package() {
    mkdir -p "$work/bin"
    ln -sf /bin/true "$work/bin/arm-none-eabi-gcc"
    refuses "Debian's package gcc-arm-none-eabi" env PATH=/nowhere "$BUILD/limner" measure "$scene" --core m0plus &&
        refuses "Debian's package qemu-system-arm" env PATH="$work/bin" "$BUILD/limner" measure "$scene" --core m4 &&
        refuses "Debian's package gcc-riscv64-unknown-elf" env PATH=/nowhere "$BUILD/limner" measure "$scene" \
            --core rv32
}

# Nobody asked for what the missing tools do: accuracy is measured all the same, and one line names what to install.
does_without() { # PATH WORDS
    measure --no-cost --precision fast >"$work/table.alone" && PATH=$1 "$BUILD/limner" measure "$scene" --camera "$work/few.cam" --size 120x120 \
        --precision fast -o "$work/alone" >"$work/out" 2>"$work/err" || { cat "$work/err" && return 1; }
    diff "$work/out" "$work/table.alone" && [ "$(cat "$work/err")" = "limner: note: $2" ] && [ -s "$work/alone/measure.csv" ] ||
        { cat "$work/err" && return 1; }
}

all_tools='arm-none-eabi-gcc, qemu-system-arm, riscv64-unknown-elf-gcc, qemu-system-riscv32'
all_packages='gcc-arm-none-eabi qemu-system-arm gcc-riscv64-unknown-elf qemu-system-misc'
does_without_emulators() {
    mkdir -p "$work/compilers" && ln -sf /bin/true "$work/compilers/arm-none-eabi-gcc" && ln -sf /bin/true "$work/compilers/riscv64-unknown-elf-gcc" &&
        does_without "$work/compilers" "instructions are not counted: qemu-system-arm, qemu-system-riscv32 are not there; Debian's packages qemu-system-arm qemu-system-misc"
}

names_the_plotter() {
    ln -sf /bin/true "$work/bin/qemu-system-arm"
    refuses "Debian's package gnuplot-nox" env PATH="$work/bin" "$BUILD/limner" measure "$scene" --core m4 \
        -o "$work/plot"
}

# Other sub-pixel bits, which are compiled on the way.
variant() {
    measure --no-cost --precision fast_4,fast >"$work/said" && cat "$work/said" && grep -q '^| fast | 7 | ' "$work/said" &&
        grep -q '^| fast_4 | 4 | ' "$work/said" && ! grep -q '^| fine' "$work/said"
}

leaves_no_files() {
    mkdir -p "$work/own"
    TMPDIR=$work/own refuses "$@" && [ -z "$(ls "$work/own")" ]
}

tap_check "every profile has its row, and nothing else" prints_a_row_for_each
tap_check "other sub-pixel bits are measured, too" variant
tap_check "they need a compiler" refuses "nowhere-gcc: not found" env CC=nowhere-gcc "$BUILD/limner" measure "$scene" --no-cost --sub-bits
tap_check "one that fails says why" leaves_no_files "compiling fast_4: firmware/" \
    env CC="gcc -DLIM_MAX_SIDE_PX=0" "$BUILD/limner" measure "$scene" --no-cost --precision fast_4
tap_check "what does not fit the program is refused" leaves_no_files "fast_4 does not fit this program" \
    env CC="gcc -DLIM_HAS_WIDE=0" "$BUILD/limner" measure "$scene" --no-cost --precision fast_4
tap_check "bits that are the profile's own" refuses "the bits of fast itself" measure --no-cost --precision fast_7
tap_check "more bits than there are" refuses "0 to 12" measure --no-cost --precision exact_13
tap_check "bits that are no number" refuses "no such profile" measure --no-cost --precision fast_x
tap_check "one named twice" refuses "named twice" measure --no-cost --precision fast_4,fast_4
tap_check "a comparison of methods takes a profile" refuses "no such profile" "$BUILD/limner" compare "$scene" --precision fast_4
tap_check "no plane decision is wrong" decides_every_side
tap_check "the same again is the same" is_the_same_again
tap_check "-o writes what is printed, and CSV" writes_markdown_and_csv
tap_check "what cannot be written leaves nothing behind" leaves_nothing_behind
tap_check "a missing compiler or emulator is named with its package" names_the_package
tap_check "without any tool accuracy is measured, and one line says what to install" does_without /nowhere \
    "instructions are not counted: $all_tools are not there; Debian's packages $all_packages"
tap_check "without emulators likewise" does_without_emulators
tap_check "a missing plotter is named with its package" names_the_plotter
tap_check "no model" refuses "needs a model" "$BUILD/limner" measure
tap_check "a compiled scene is refused" refuses "not against a compiled scene" "$BUILD/limner" measure a.lim
tap_check "an unknown profile is refused" refuses "--precision brisk" measure --precision fast,brisk
tap_check "a profile named twice is refused" refuses "named twice" measure --precision fast,fast
tap_check "an unknown processor is refused" refuses "there are m0plus, m3, m4, m33 and rv32" measure --core z80
tap_check "an empty name is refused" refuses "divided by commas" measure --precision fast,
tap_check "a processor without counting is refused" refuses "exclude each other" measure --core m4 --no-cost
tap_check "code for what is unknown is refused" refuses "--optimise beauty: speed, balance or size" measure --optimise beauty
tap_check "code that is not counted is refused" refuses "exclude each other" measure --optimise size --no-cost
tap_check "a missing model is refused" refuses "none.obj" "$BUILD/limner" measure none.obj --no-cost
tap_check "sim/MEASURED.md's accuracy of rooms is what is measured now" sh sim/tools/tables.sh --check tradeoff:rooms
tap_done
