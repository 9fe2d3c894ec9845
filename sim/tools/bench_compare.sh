# SPDX-License-Identifier: MIT
#
# What changed since the baseline, in CSV files as sim/tools/bench.sh makes them:
#   sh sim/tools/bench_compare.sh BASELINE NEW [PATTERN]   every change of more than 1 %; PATTERN, an extended regular expression
#                                                    that CORE,SCENE,SIZE,PATH matches: no other rows are expected in NEW
#   sh sim/tools/bench_compare.sh --baseline BASELINE NEW [PATTERN]   a new baseline: the compilers, NEW without its
#                                                    small stages, and of BASELINE reasons and rows that PATTERN does not match
#   sh sim/tools/bench_compare.sh --peers BASELINE NEW     rows in which another renderer is better (sim/tools/tables/peers.txt)
#                                                    and why, as a line of the baseline says: `# lost ROW: WHY`
# Exit status: 0; 1, something grew or is missing; 77, nothing could be compared. A stage may grow where the whole frame
# does not: its change is shown. Of peers, 1 is for a lost row without a reason. Counts of another compiler are skipped, and that is said. Needs $CC for the host.
set -eu
. sim/targets/targets.sh

cores='m0plus m3 m4 m33 rv32 host'

versions() {
    for core in $cores; do
        version=$(target_version "$core" 2>/dev/null) || version='not there'
        echo "# $core: ${version:-not there}"
    done
}

# Without stages that take less than a twentieth of their frame.
large_rows() { # CSV
    awk -F , '
        { key = $1 FS $2 FS $3 FS $4 }
        NR == FNR { if ($5 == "frame") frame[key] = $6; next }
        FNR == 1 || $5 ~ /_|^(frame|faces)$/ || $6 * 20 >= frame[key]' "$1" "$1"
}

compare() { # BASELINE NEW PATTERN
    [ -e "$1" ] || { echo "no baseline $1: \`make bench-baseline\` writes it"; exit 1; }
    versions >"$work/versions"
    large_rows "$2" >"$work/new"
    awk -F , -v pattern="$3" -f sim/tools/bench_compare.awk "$work/versions" "$1" "$work/new"
}

# Rows of other scenes are kept only if the same compilers counted them: else they would pass for this one's.
baseline() { # BASELINE NEW PATTERN
    versions >"$work/versions"
    large_rows "$2" | sed 1d >"$work/new"
    cat "$work/versions"
    [ ! -e "$1" ] || grep '^# lost ' "$1" || true
    sed -n 1p "$2"
    if [ "$3" != . ]; then
        grep -E '^# [a-z0-9]+: ' "$1" | diff - "$work/versions" >&2 || { echo "$1: counted with other compilers" >&2; exit 1; }
        grep -v '^#\|^core,' "$1" | awk -F , -v pattern="$3" '($1 "," $2 "," $3 "," $4) !~ pattern' >>"$work/new"
    fi
    sort -t , -k 2,4 -k 1,1 -s "$work/new"
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
case $1 in
--baseline) baseline "$2" "$3" "${4:-.}" ;;
--peers) awk -f sim/tools/bench_peers.awk "$2" sim/tools/tables/peers.txt "$3" ;;
*) compare "$1" "$2" "${3:-.}" ;;
esac
