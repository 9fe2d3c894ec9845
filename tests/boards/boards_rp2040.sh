# SPDX-License-Identifier: MIT
#
# The Pico's second stage on flash chips of several kinds, what the emulated flash interface does not let pass, and the
# model of the cache before it, on loops whose misses are known: tests/boards/rp2040_flash.mjs.
. tests/tap.sh

code=$kept/boards/pico/common/boot2.bin

stage_fits() {
    make DEPS=skip BUILD="$BUILD" BOARD=pico BOARDS="$kept/boards" "$code" && [ "$(wc -c <"$code")" -le 252 ]
}

all_were_run() {
    [ "$status" -eq 0 ] && [ "$ran" -gt 40 ]
}

tap_check "the second stage fits, with its checksum" stage_fits
status=0
modules=$(sh sim/emulators/npm.sh) &&
    node tests/boards/rp2040_flash.mjs "$modules" "$code" "$tap_count" >"$work/units" || status=$?
cat "$work/units"
ran=$(grep -c '^ok\|^not ok' "$work/units")
tap_count=$((tap_count + ran))
tap_check "all of these were run" all_were_run
tap_done
