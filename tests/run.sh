#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs test programs that print TAP, as many at once as there are processors: sh tests/run.sh PROGRAM...
# Prints a line for each as it ends, then every failure with its diagnostics and every skip with its
# reason, then one closing line: N passed, N failed[, N skipped]. Succeeds if nothing failed and
# something passed. TEST_TIMEOUT_S bounds each program, TEST_JOBS the number at once.
set -u

# run_one FOLDER PROGRAM: leaves the counts in FOLDER/NAME.tally and the text for the end in FOLDER/NAME.report.
run_one() {
    name=$(basename "$2")
    result=$1/$name
    case $2 in
    *.sh) set -- sh "$2" ;;
    *) set -- "$2" ;;
    esac
    began_s=$(date +%s)
    CMOCKA_MESSAGE_OUTPUT=TAP timeout -k 5 "$TEST_TIMEOUT_S" "$@" </dev/null >"$result.tap" 2>"$result.err" &
    trap 'kill $!' INT TERM
    wait $!
    status=$?
    awk -v name="$name" -v status="$status" -v tally="$result.tally" -v limit_s="$TEST_TIMEOUT_S" \
        -v took_s=$(($(date +%s) - began_s)) -v errors="$result.err" -v report="$result.report" \
        -f "$(dirname "$0")/tap.awk" "$result.tap"
}

: "${TEST_TIMEOUT_S:=1800}" "${TEST_JOBS:=$(nproc)}"
export TEST_TIMEOUT_S TEST_JOBS

if [ "${1:-}" = --one ]; then
    run_one "$2" "$3"
    exit 0
fi

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
trap 'exit 1' INT TERM
[ $# -eq 0 ] || printf '%s\n' "$@" | xargs -d '\n' -n 1 -P "$TEST_JOBS" sh "$0" --one "$results"
for program; do
    cat "$results/$(basename "$program").report"
done
for program; do
    cat "$results/$(basename "$program").tally"
done | awk '
    { passed += $1; failed += $2; skipped += $3 }
    END {
        printf "%d passed, %d failed%s\n", passed, failed, skipped ? ", " skipped " skipped" : ""
        exit failed || !passed
    }'
