# SPDX-License-Identifier: MIT
#
# `limner measure` counts instructions on emulated processors: the same every time, and never by a counter
# that is wrong.
. tests/tap.sh

scene=sim/scenes/rooms-tilted.obj
head -n 2 sim/scenes/rooms-tilted.cam >"$work/few.cam"

measure() { # FOLDER CORES
    "$BUILD/limner" measure "$scene" --camera "$work/few.cam" --precision fast --core "$2" -o "$work/$1" \
        >"$work/$1.said"
}

field() { # FOLDER CORE COLUMN
    awk -F , -v core="$2" -v name="$3" '
        NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
        NR > 1 && $column["core"] == core { print $column[name] }' "$work/$1/measure.csv"
}

counts() {
    measure first m0plus,m4 && cat "$work/first.said" && for core in m0plus m4; do
        for name in instructions worst_instructions a_vertex a_plane_test state_b pools_b code_b scene_b; do
            value=$(field first $core $name)
            echo "$core $name $value"
            awk -v value="$value" 'BEGIN { exit !(value > 0) }' || return 1
        done
    done
}

# Every instruction of a frame is some stage's.
stages_add_up() {
    awk -F , '$3 == "m4" { sum += $5 } END { printf "%.0f\n", sum }' "$work/first/stages.csv" >"$work/sum"
    whole=$(field first m4 instructions)
    echo "stages $(cat "$work/sum"), frame $whole"
    awk -v sum="$(cat "$work/sum")" -v whole="$whole" 'BEGIN { exit !(sum - whole < 2 && whole - sum < 2) }'
}

# The M0+ has no division and no wide product: it needs more for the same.
smaller_is_slower() {
    awk -v small="$(field first m0plus instructions)" -v large="$(field first m4 instructions)" \
        'BEGIN { exit !(small > large) }'
}

is_the_same_again() {
    measure second m0plus,m4 && diff -r -x '*.png' "$work/first" "$work/second"
}

draws_the_plot() {
    head -c 8 "$work/first/measure.png" | od -An -c | grep -q 'P   N   G'
}

# An emulator whose plugin counts one instruction too many in the loop of known length.
sees_a_wrong_counter() {
    mkdir -p "$work/bin"
    cat >"$work/bin/qemu-system-arm" <<END
#!/bin/sh
$(command -v qemu-system-arm) "\$@" || exit
for argument; do
    case \$argument in
    *out=*) sed -i '1s/ 108643 / 108644 /' "\${argument##*out=}" ;;
    esac
done
END
    chmod +x "$work/bin/qemu-system-arm"
    if PATH="$work/bin:$PATH" measure wrong m4 2>"$work/err"; then return 1; fi
    cat "$work/err"
    grep -q "the counter is wrong: a loop of 108643 instructions counts as 108644" "$work/err" && [ ! -e "$work/wrong" ]
}

counts_riscv() {
    measure riscv rv32 && [ "$(field riscv rv32 instructions | cut -d . -f 1)" -gt 0 ]
}

tap_check "instructions, kernels and bytes are counted" counts
tap_check "the stages add up to the frame" stages_add_up
tap_check "Cortex-M0+ takes more instructions than Cortex-M4" smaller_is_slower
tap_check "the same again is the same" is_the_same_again
tap_check "a plot is drawn" draws_the_plot
tap_check "a counter that is wrong by one is seen, and nothing is written" sees_a_wrong_counter
if command -v riscv64-unknown-elf-gcc >/dev/null && command -v qemu-system-riscv32 >/dev/null; then
    tap_check "RISC-V is counted too" counts_riscv
else
    tap_skip "RISC-V is counted too" "needs gcc-riscv64-unknown-elf and qemu-system-misc"
fi
tap_done
