# SPDX-License-Identifier: MIT
#
# Runs the tests of extremes, each for every precision profile, and compares tests/EXTREMES.md with what they print.
# `make extremes` (EXTREMES=write) writes that page instead.
. tests/tap.sh

page=tests/EXTREMES.md

holds() { # PROGRAM
    CMOCKA_MESSAGE_OUTPUT=TAP "$1" >"$work/output" 2>"$work/errors"
    status=$?
    cat "$work/output" >>"$work/rows"
    grep -v '^# extreme' "$work/output"
    cat "$work/errors"
    return $status
}

page_is_current() {
    sh tests/extremes.sh "$work/rows" >"$work/page"
    [ "${EXTREMES:-}" != write ] || cp "$work/page" "$page"
    diff "$page" "$work/page"
}

for program in "$BUILD"/tests/test_extreme_*; do
    [ -x "$program" ] || continue
    tap_check "$(basename "$program")" holds "$program"
done
tap_check "$page says what was measured" page_is_current
tap_done
