# SPDX-License-Identifier: MIT
#
# Frames of rooms and teapot cost no more than the committed baseline says, which `make bench-baseline` writes.
. tests/tap.sh

# With another compiler than the baseline's the counts mean nothing.
costs_no_more() { # SCENE
    sh sim/tools/bench.sh --rows m4,m0plus "$1" 240x240 own >"$work/$1.csv" || { tap_fail "$1 is counted"; return; }
    status=0
    sh sim/tools/bench_compare.sh sim/tools/bench.baseline.csv "$work/$1.csv" "^(m4|m0plus|all),$1,240x240,own$" >"$work/said" || status=$?
    if [ $status -ne 1 ] && grep -q '^skipped' "$work/said"; then
        tap_skip "$1 costs no more than the baseline" "$(sed -n 's/^skipped  *//p' "$work/said" | head -n 1)"
        return
    fi
    tap_check "$1 costs no more than the baseline" reported "$status"
}

reported() { # STATUS
    cat "$work/said"
    return "$1"
}

costs_no_more rooms
costs_no_more teapot
tap_done
