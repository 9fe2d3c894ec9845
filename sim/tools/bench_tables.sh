# SPDX-License-Identifier: MIT
#
# Tables of what sim/tools/bench.sh counted, from its CSV or from the baseline: sh sim/tools/bench_tables.sh [--write|--check] CSV.
# Prints that against other renderers (sim/tools/peers.txt); --write puts all of them between their markers, in sim/MEASURED.md and,
# of the one against others five rows, in README.md; --check says how these differ.
set -eu
. sim/tools/page_table.sh

names='peers figures bench bench-stages bench-memory'
cores='m0plus m3 m4 rv32 host'

# README's rows: of the table against others `what is there=what README calls it`.
figures() { # < TABLE
    awk -F ' *[|] *' '
        BEGIN {
            count = split("Cortex-M4F, rooms 240x240=thousand instructions a frame, rooms, Cortex-M4F;" \
                "Cortex-M4F, teapot 240x240=thousand instructions a frame, teapot, Cortex-M4F;" \
                "RAM in all, rooms 240x240, KB=RAM in all, rooms, KB;" \
                "code and tables, rooms, Cortex-M4, -Os, KB=code and tables, rooms, Cortex-M4, -Os, KB;" \
                "wrong pixels, rooms 240x240, %=wrong pixels, rooms, %", wanted, ";")
            print "| mean / worst | Limner | the best of seven others |"
            print "|---|---|---|"
        }
        { limner[$2] = $5; best[$2] = $3 }
        END {
            for (i = 1; i <= count; i++) {
                split(wanted[i], name, "=")
                if (!(name[1] in limner)) { print "no row " name[1] >"/dev/stderr"; exit 1 }
                print "| " name[2] " | " limner[name[1]] " | " best[name[1]] " |"
            }
        }'
}

table() { # NAME CSV
    case $1 in
    figures)
        table peers "$2" | figures
        return
        ;;
    peers) set -- "$1" sim/tools/peers.txt "$2" ;;
    *) set -- "$1" "$2" ;;
    esac
    table_name=$1
    shift
    awk -v table="$table_name" -v cores="$cores" -f sim/tools/bench_tables.awk "$@"
}

each() { # page_write or readme_has, CSV
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    for name in $names; do
        table "$name" "$2" >"$work/$name"
        "$1" "$name" "$work/$name"
    done
}

case $1 in
--write) each page_write "$2" ;;
--check) each page_has "$2" ;;
*) table peers "$1" ;;
esac
