# SPDX-License-Identifier: MIT
#
# What a frame costs on a board: sh boards/cost.sh FOLDER TITLE CPU_HZ SPI_HZ. In: FOLDER/takes (link.sh), what the
# emulator said of its frames (FOLDER/emulated) and, where it tells no cycles, counted instructions (FOLDER/counted).
# Prints a row of the table in boards/README.md. Frames a second are computed, as if each instruction took a cycle and memory never made
# the processor wait, where the emulator's cycles do not say otherwise, as the RP2040's do: not measured on hardware.
set -eu

folder=$1 title=$2 cpu_hz=$3 spi_hz=$4

# Of all frames but the first, whose bytes include what set the panel up.
bytes=$(awk '/^frame [0-9]*: [0-9]* bytes/ && n++ { sum += $3 } END { print (n > 1 ? sum / (n - 1) : 0) }' "$folder/emulated")
cycles=$(awk '
    /^# cycles frame / {
        n++
        for (i = 5; i < NF; i += 2) cost[$i] += $(i + 1)
    }
    END { if (n) printf "%d", ("cpu" in cost ? cost["cpu"] : cost["total"] - cost["wait"]) / n }' "$folder/emulated")
unit=cycles
if [ -z "$cycles" ]; then
    unit=instructions
    cycles=$(awk '/^# instructions frame / { n++; sum += $6 - $8 } END { if (n) printf "%d", sum / n }' "$folder/emulated")
fi
if [ -z "$cycles" ]; then
    [ -e "$folder/counted" ] || { echo "cost: $title: its emulator counts neither cycles nor instructions" >&2; exit 1; }
    cycles=$(awk '{ print $1 - $2 }' "$folder/counted")
fi
read -r flash_b static_b stack_b <"$folder/takes"
awk -v title="$title" -v flash="$flash_b" -v static="$static_b" -v stack="$stack_b" -v cycles="$cycles" -v unit="$unit" \
    -v bytes="$bytes" -v cpu_hz="$cpu_hz" -v spi_hz="$spi_hz" 'BEGIN {
        if (!(cycles > 0 && bytes > 0)) exit 1
        printf "| %s | %d | %d | %d | %d %s | %d | %.1f | %.1f |\n", title, flash, static, stack, cycles, unit, bytes,
            cpu_hz / cycles, spi_hz / (8 * bytes)
    }'
