#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Breaks the code on purpose, in one place at a time, and sees whether a test fails: sh tests/mutants.sh (make mutate). Of
# all mutants of firmware/, hal/ and the gates of sim/ (tests/mutants/candidates.awk) takes MUTANTS (300), drawn by SEED
# (1), of FILES (all); or MUTANT=NUMBER alone, and shows it. TESTS (all) judge. Prints those that live, then a score a
# file, an operator and a folder. Succeeds if LEAST_PERCENT (95) of each folder's are killed and the list of equivalents
# is up to date. See tests/mutants/README.md.
set -u

: "${BUILD:?is set by the Makefile}" "${SEED:=1}" "${MUTANTS:=300}" "${MUTANT:=}" "${FILES:=}" "${TESTS:=}" "${LEAST_PERCENT:=95}"
: "${TEST_JOBS:=$(nproc)}" "${TEST_EFFORT:=10}"
export TEST_JOBS TEST_EFFORT

# What stands between files of others and the program, or between the program and the user's files.
gates=$(grep -v '^#' tests/mutants/gates)
MUTATED="(firmware|hal)/|$(echo "$gates" | tr '\n ' '||' | sed 's/|$//')"
export MUTATED
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
state=$BUILD/mutants
here=tests/mutants

say() {
    echo "mutants: $*" >&2
}

# -- What executes what ------------------------------------------------------------------------------------------------

# All lines of a source, what could be executed in it and what is by which test.
write_map() {
    rm -rf "$state/map"
    mkdir -p "$state/map"
    sort -u "$state"/lines/* | awk -v map="$state/map/" '
        function put(source, text) {
            gsub("/", "_", source)
            if (source != open_) { if (open_ != "") close(map open_); open_ = source }
            print text >> (map source)
        }
        { put($1, $2 " " $3 " " $4) }'
    for test in $tests; do
        sort "$state/run/$test" | awk -v test="$test" -v map="$state/map/" '
            function flush() {
                if (line == "") return
                file = source
                gsub("/", "_", file)
                if (file != open_) { if (open_ != "") close(map open_); open_ = file }
                print line, test, list >> (map file)
            }
            $3 ~ /\/sim\/(measure_cost|cmd_measure|main)\.o$/ { next }
            $1 == source && $2 == line { list = list "," $3; next }
            { flush(); source = $1; line = $2; list = $3 }
            END { flush() }'
    done
}

# The programs that are not as they were when they were run for their lines.
changed() {
    for test in $tests; do
        cksum <"$state/cover/tests/$test" >"$state/sum"
        cmp -s "$state/sum" "$state/sums/$test" || echo "$test"
    done
}

goals() { # BUILD
    [ -n "$TESTS" ] || echo test-programs
    for test in $TESTS; do
        echo "$1/tests/$test"
    done
}

# What has changed since the last time is run with gcov for its lines, and without for its time.
survey() {
    say "builds the tests with gcov"
    # shellcheck disable=SC2046 # goals are words
    make DEPS=skip BUILD="$state/cover" OPT='-O1 --coverage' $(goals "$state/cover") >"$state/cover.log" 2>&1 || {
        cat "$state/cover.log" >&2
        return 1
    }
    mkdir -p "$state/sums" "$state/times" "$state/run" "$state/lines"
    changed >"$state/changed"
    [ -s "$state/changed" ] || [ ! -d "$state/map" ] || return 0
    say "finds which lines $(wc -l <"$state/changed") tests execute"
    xargs -n 1 -P "$TEST_JOBS" sh $here/cover.sh <"$state/changed"
    write_map
    # shellcheck disable=SC2046 # goals are words
    make -n DEPS=skip -W "$BUILD/host/liblimner.a" $(goals "$BUILD") | grep -F -- " -o $BUILD/tests/" >"$state/links"
}

# -- Which mutants ------------------------------------------------------------------------------------------------------

# The first of a list that the seed shuffles (Park and Miller's generator, for every awk the same).
draw() {
    awk -v seed="$SEED" 'BEGIN { x = (seed * 7919 + 12345) % 2147483647; for (i = 0; i < 9; i++) x = 16807 * x % 2147483647 }
        { x = 16807 * x % 2147483647; print x, $1 }' | sort -n | head -n "$MUTANTS" | cut -d ' ' -f 2
}

wanted() { # numbers of the candidates in FILES
    awk -F '\t' -v files="$FILES" 'BEGIN { n = split(files, file, " "); for (i = 1; i <= n; i++) of[file[i]] }
        !n || $1 in of { print NR }' "$state/candidates"
}

# Each equivalent's number, and on the standard error those that are no mutant any more. The list tells mutants by the
# line and what it becomes: they are found again wherever the line is.
equivalents() {
    awk -v list=$here/equivalent '
        function trimmed(text) { sub(/^ +/, "", text); return text }
        BEGIN {
            FS = "\t"
            while ((getline text < list) > 0) {
                if (text ~ /^(firmware|hal|sim)\/[^ ]*$/) file = text
                if (text ~ /^- /) old = substr(text, 3)
                if (text ~ /^\+ /) { key[++count] = file FS old FS substr(text, 3); wanted[key[count]] }
            }
        }
        {
            if ($1 != file) {
                file = $1
                n = 0
                while ((getline text < file) > 0) line[++n] = text
                close(file)
            }
            was = line[$2]
            k = $1 FS trimmed(was) FS trimmed(substr(was, 1, $3 - 1) $6 substr(was, $3 + $4))
            if (k in wanted) { print NR; found[k] }
        }
        END {
            for (i = 1; i <= count; i++)
                if (!(key[i] in found)) {
                    split(key[i], part, FS)
                    print "mutants: " list " has what is no mutant (any more): " part[1] ": " part[3] | "cat >&2"
                }
        }' "$state/candidates"
}

show() { # NUMBER: as a change
    IFS=$(printf '\t') read -r source line column length operator text <<END
$(sed -n "${1}p" "$state/candidates")
END
    echo "$source:$line: mutant $1 ($operator)"
    sed -n "${line}p" "$source" | sed 's/^ */- /'
    printf '%s\n' "$text" >"$state/text"
    awk -v line="$line" -v column="$column" -v length_="$length" '
        NR == FNR { text = $0; next }
        FNR == line { print substr($0, 1, column - 1) text substr($0, column + length_) }' "$state/text" "$source" |
        sed 's/^ */+ /'
}

# -- The trials and the score -------------------------------------------------------------------------------------------

try_all() {
    count=$(wc -l <"$state/drawn")
    [ "$count" -gt 0 ] || { say "nothing to try: no mutant in FILES='$FILES', or number '$MUTANT'"; exit 1; }
    rm -rf "$state/results" "$state/trees"
    mkdir -p "$state/results"
    # shellcheck disable=SC2016 # the inner shell's
    xargs -n 1 -P "$TEST_JOBS" sh -c 'sh tests/mutants/try.sh "$2"
        [ -t 2 ] && printf "\rmutants: %d of %d" "$(ls "$0/results" | wc -l)" "$1" >&2' "$state" "$count" <"$state/drawn"
    [ -t 2 ] && printf '\n' >&2
    # shellcheck disable=SC2046 # numbers
    (cd "$state/results" && cat $(ls | sort -n)) >"$state/outcomes"
}

score() {
    for outcome in survived uncovered; do
        awk -F '\t' -v outcome=$outcome '$1 == outcome { print $2, $5 }' "$state/outcomes" | while read -r number passed; do
            show "$number"
            [ $outcome = uncovered ] && echo "= no test executes it" || echo "= $passed tests pass"
        done
    done
    awk -F '\t' -v least="$LEAST_PERCENT" -v drawn="$(wc -l <"$state/drawn")" '
        function percent(key) { return 100 * killed[key] / of[key] }
        function add(kind, name) {
            key = kind FS name
            if (!(key in of)) { killed[key] = 0; keys[++n] = key }
            of[key]++
            killed[key] += $1 == "killed"
        }
        function table(kind, title,    i, part) {
            printf "%-28s %7s %5s %7s\n", title, "killed", "of", "%"
            for (i = 1; i <= n; i++) {
                split(keys[i], part, FS)
                if (part[1] == kind) printf "%-28s %7d %5d %7.1f\n", part[2], killed[keys[i]], of[keys[i]], percent(keys[i])
            }
        }
        { outcomes[$1]++ }
        $1 == "same" || $1 == "broken" { next }
        {
            split($3, place, ":")
            folder = place[1]
            sub(/\/.*/, "", folder)
            add("file", place[1])
            add("operator", $4)
            add("folder", folder)
            times += $1 == "killed" && $5 ~ /\(time\)/
        }
        END {
            table("file", "file")
            table("operator", "operator")
            table("folder", "folder")
            printf "%d mutants: %d killed (%d of them by the time limit), %d survived, %d executed by no test; not counted: " \
                "%d of the same machine code, %d refused by the compiler\n", NR, outcomes["killed"], times, \
                outcomes["survived"], outcomes["uncovered"], outcomes["same"], outcomes["broken"]
            for (i = 1; i <= n; i++)
                if (keys[i] ~ /^folder/ && percent(keys[i]) < least) bad = 1
            exit bad || NR != drawn
        }' "$state/outcomes"
}

mkdir -p "$state"
tests=${TESTS:-$(ls "$BUILD/tests" | grep '^test_[a-z0-9_]*$')}
survey || exit 1
# shellcheck disable=SC2012 # plain names
awk -f $here/candidates.awk $(ls firmware/*.[ch] firmware/*/*.[ch] hal/*.[ch] hal/*/*.[ch]) $gates >"$state/candidates"
equivalents >"$state/equivalents" 2>"$state/stale"
cat "$state/stale" >&2

if [ -n "$MUTANT" ]; then
    show "$MUTANT"
    grep -qx "$MUTANT" "$state/equivalents" && echo "= listed as equivalent"
    echo "$MUTANT" >"$state/drawn"
    try_all
    cat "$state/outcomes"
    exit 0
fi
say "seed $SEED, $(wc -l <"$state/candidates") mutants, $(wc -l <"$state/equivalents") of them listed as equivalent"
wanted | grep -vxFf "$state/equivalents" | draw >"$state/drawn"
try_all
score || exit 1
[ ! -s "$state/stale" ]
