# SPDX-License-Identifier: MIT
#
# Tables of what sim/tools/bench.sh counted, from its CSV or from the baseline: sh sim/tools/bench_tables.sh [--write|--check] CSV.
# Prints README's, against other renderers (sim/tools/peers.txt); --write puts all four between their markers, in README.md and
# sim/MEASURED.md; --check says how these differ.
set -eu
. sim/tools/readme_table.sh

names='peers bench bench-stages bench-memory'
cores='m0plus m3 m4 rv32 host'

table() { # NAME CSV
    case $1 in
    peers) set -- "$1" sim/tools/peers.txt "$2" ;;
    *) set -- "$1" "$2" ;;
    esac
    table_name=$1
    shift
    awk -v table="$table_name" -v cores="$cores" -f sim/tools/bench_tables.awk "$@"
}

each() { # readme_write or readme_has, CSV
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    for name in $names; do
        table "$name" "$2" >"$work/$name"
        "$1" "$name" "$work/$name"
    done
}

case $1 in
--write) each readme_write "$2" ;;
--check) each readme_has "$2" ;;
*) table peers "$1" ;;
esac
