#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs test programs that print TAP, as many at once as there are processors: sh tests/run.sh PROGRAM...
# Says how many there are and, if an earlier run has left their times, how long they will take. Prints a line for each as
# it ends and every half minute what is running, then every failure with its diagnostics and every skip with its
# reason, then one closing line: N passed, N failed[, N skipped]. Succeeds if nothing failed and
# something passed. TEST_TIMEOUT_S bounds each program, TEST_JOBS the number at once; TEST_TIMES is the file of times,
# lines NAME SECONDS, TEST_TELL_S how often is told what is running. Long tests do half of their work (rigs/effort.h), or
# TEST_EFFORT per cent of it; all of it with SEED=all.
set -u

tallies() { find "$1" -name '*.tally' | wc -l; } # FOLDER

# run_one FOLDER COUNT PROGRAM: leaves the counts in FOLDER/NAME.tally and the text for the end in FOLDER/NAME.report.
run_one() {
    results=$1 count=$2 name=$(basename "$3")
    result=$results/$name
    case $3 in
    *.sh) set -- sh "$3" ;;
    *) set -- "$3" ;;
    esac
    : >"$result.running"
    began_s=$(date +%s)
    CMOCKA_MESSAGE_OUTPUT=TAP timeout -k 5 "$TEST_TIMEOUT_S" "$@" </dev/null >"$result.tap" 2>"$result.err" &
    trap 'kill $!' INT TERM
    wait $!
    status=$?
    took_s=$(($(date +%s) - began_s))
    line=$(awk -v name="$name" -v status="$status" -v tally="$result.tally" -v limit_s="$TEST_TIMEOUT_S" \
        -v took_s="$took_s" -v errors="$result.err" -v report="$result.report" \
        -f "$(dirname "$0")/tap.awk" "$result.tap")
    rm -f "$result.running"
    echo "$name $took_s" >"$result.time"
    echo "[$(tallies "$results")/$count] $line"
}

# left FOLDER PROGRAM...: how long the programs without a tally will take, in words; nothing if no time is known. One
# that is new counts as the mean of the others, and none starts before a processor is free.
left() {
    left_results=$1
    shift
    for program; do
        [ -e "$left_results/$(basename "$program").tally" ] || basename "$program"
    done | awk -v times="$TEST_TIMES" -v jobs="$TEST_JOBS" '
        BEGIN { while ((getline line < times) > 0) { split(line, field, " "); took[field[1]] = field[2]; all += field[2]; known++ } }
        { seconds = $1 in took ? took[$1] : known ? all / known : 0; sum += seconds; if (seconds > longest) longest = seconds }
        END {
            if (!known) exit
            seconds = sum / jobs > longest ? sum / jobs : longest
            if (seconds < 90) printf "about %d s", seconds + 0.5; else printf "about %d minutes", seconds / 60 + 0.5
        }'
}

tell() { # FOLDER PROGRAM...
    tell_running=$(cd "$1" && for file in *.running; do [ ! -e "$file" ] || printf ' %s' "${file%.running}"; done)
    tell_left=$(left "$@")
    echo "... $(tallies "$1") of $(($# - 1)) done${tell_left:+, $tell_left left}; running:$tell_running"
}

: "${TEST_TIMEOUT_S:=1800}" "${TEST_JOBS:=$(nproc)}" "${TEST_TELL_S:=30}"
[ ! -d "${BUILD:-}" ] || : "${TEST_TIMES:=$BUILD/test_times}"
: "${TEST_TIMES:=/dev/null}"
[ "${SEED:-}" = all ] || : "${TEST_EFFORT:=50}"
export TEST_TIMEOUT_S TEST_JOBS ${TEST_EFFORT:+TEST_EFFORT}

if [ "${1:-}" = --one ]; then
    run_one "$2" "$3" "$4"
    exit 0
fi

results=$(mktemp -d)
teller=
trap '[ -z "$teller" ] || kill "$teller" 2>/dev/null; rm -rf "$results"' EXIT
trap 'exit 1' INT TERM
whole=$(left "$results" "$@")
[ $# -eq 0 ] || echo "$# test programs, $TEST_JOBS at once${whole:+, $whole}"
(
    trap 'kill $sleeper 2>/dev/null; exit 0' TERM
    sleeper=
    : >"$results/telling" # from here on it can be ended
    while :; do
        sleep "$TEST_TELL_S" >/dev/null &
        sleeper=$!
        wait $sleeper
        tell "$results" "$@"
    done
) &
teller=$!
[ $# -eq 0 ] || printf '%s\n' "$@" | xargs -d '\n' -n 1 -P "$TEST_JOBS" sh "$0" --one "$results" $#
until [ -e "$results/telling" ]; do sleep 0.02; done
kill $teller && wait $teller
teller=

# Times of programs that did not run stay.
if [ "$TEST_TIMES" != /dev/null ]; then
    { cat "$TEST_TIMES" 2>/dev/null; for program; do cat "$results/$(basename "$program").time"; done; } |
        awk 'NF == 2 { took[$1] = $2 } END { for (name in took) print name, took[name] }' | sort >"$results/times" &&
        mv "$results/times" "$TEST_TIMES"
fi
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
