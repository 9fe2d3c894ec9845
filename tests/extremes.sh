# SPDX-License-Identifier: MIT
#
# The table of extremes: what the rows say that tests/test_extreme_*.c printed ("# extreme NAME PROFILE promised ...
# measured ..."), as Markdown. sh tests/extremes.sh FILE prints the table of the output in FILE.
set -eu

cat <<'END'
# Extremes: what is promised, what was measured

Each row is a test: a scene or generator in `tests/test_extreme_*.c`, drawn in one precision profile and compared with the
double-precision reference. *Holes* are pixels that show something behind a closed surface; *misplaced* ones show a face
that is not to be seen within a pixel, on a lattice of 1/64 pixels: none means that the order is exact. *Wrong* are pixels
that show another face than the reference: edges that are off by a fraction of a pixel. `make extremes` writes this page.

| extreme | profile | promised | measured |
|---|---|---|---|
END
sed -n 's/^# extreme \([^ ]*\) \([^ ]*\) promised \(.*\) measured \(.*\)$/| \1 | \2 | \3 | \4 |/p' "$1"
