#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Finds which lines of what is mutated (MUTATED, a pattern) a test program executes: sh tests/mutants/cover.sh NAME. Takes a program that was
# built for gcov below $BUILD/mutants/cover and writes $BUILD/mutants/run/NAME, lines "SOURCE LINE OBJECT" of those
# executed, and $BUILD/mutants/lines/NAME, lines "SOURCE L LINE" and "SOURCE F FIRST LAST" of the lines and functions
# that could have been; $BUILD/mutants/times/NAME has the processor time that the usual program takes, in
# seconds, and $BUILD/mutants/sums/NAME what tells the program from a later one. A program that fails here is no judge of mutants: that is said, and ends it.
set -u

: "${BUILD:?is set by the Makefile}" "${MUTATED:?is set by mutants.sh}" "${LIMIT_S:=600}"
state=$(cd "$BUILD" && pwd)/mutants # tests change their folder
cover=$(cd "$state/cover" && pwd)
into=$state/counts/$1

rm -rf "$into"
mkdir -p "$into" "$state/run" "$state/lines"
depth=$(printf %s "$cover" | tr -cd / | wc -c)
if ! GCOV_PREFIX=$into GCOV_PREFIX_STRIP=$depth timeout "$LIMIT_S" "$cover/tests/$1" </dev/null >"$into.log" 2>&1; then
    echo "mutants: $1 fails without any mutant: it judges none" >&2
    rm -rf "$into"
    : >"$state/run/$1"
    cksum <"$cover/tests/$1" >"$state/sums/$1"
    exit 0
fi
# A program that takes the place of open() and close() cannot write counts: it counts as executing all that it is for.
all=0
find "$into" -name '*.gcda' | sed "s|^$into/||; s|\.gcda$||" >"$into.objects"
[ -s "$into.objects" ] || {
    all=1
    (cd "$cover" && find host/hal/linux -name '*.gcno') | sed 's|\.gcno$||' >"$into.objects"
}
while read -r object; do
    # Objects that have nothing of that within them do not matter.
    grep -qE "$MUTATED" "$cover/$object.gcno" || continue
    mkdir -p "$into/${object%/*}"
    ln -s "$cover/$object.gcno" "$into/$object.gcno"
    echo "$into/$object.gcda"
done <"$into.objects" | xargs gcov -t -j 2>"$into.log" | tr '{' '\n' |
    awk -v all=$all -v mutated="^($MUTATED)" -v lines="$state/lines/$1" -v folder="$into/" '
        function number(key) {
            return match($0, "\"" key "\": [0-9]+") ? substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) : ""
        }
        /"line_number"/ { at[++n] = number("line_number"); count[n] = number("count") }
        /"start_line"/ { first[++f] = number("start_line"); last[f] = number("end_line") }
        /"file": "/ {
            match($0, /"file": "[^"]*"/)
            file = substr($0, RSTART + 9, RLENGTH - 10)
            for (i = 1; i <= n && file ~ mutated; i++) {
                could[file " L " at[i]]
                if (all || count[i] > 0) did[++done] = file " " at[i]
            }
            for (i = 1; i <= f && file ~ mutated; i++) could[file " F " first[i] " " last[i]]
            n = f = 0
        }
        /"data_file": "/ {
            match($0, /"data_file": "[^"]*"/)
            object = substr($0, RSTART + 14, RLENGTH - 15)
            sub(folder, "", object)
            sub(/\.gcda$/, ".o", object)
            for (i = 1; i <= done; i++) print did[i], object
            done = 0
        }
        END { for (line in could) print line > lines }' >"$state/run/$1"
rm -rf "$into" "$into.log" "$into.objects"
(timeout "$LIMIT_S" "$BUILD/tests/$1" </dev/null >/dev/null 2>&1; times) |
    awk 'NR == 2 { split($1, u, /[ms]/); split($2, s, /[ms]/); print 60 * (u[1] + s[1]) + u[2] + s[2] }' >"$state/times/$1"
cksum <"$cover/tests/$1" >"$state/sums/$1"
