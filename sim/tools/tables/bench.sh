# SPDX-License-Identifier: MIT
#
# What sim/tools/bench.sh counted, from $BENCH_CSV or the baseline: frames (bench), their stages (bench-stages), memory
# (bench-memory), all against other renderers (peers, sim/tools/tables/peers.txt), and five rows of that (figures).
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

: "${BENCH_CSV:=sim/tools/bench.baseline.csv}"
cores='m0plus m3 m4 m33 rv32 host'

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

table() { # NAME FILE...
    name=$1
    shift
    awk -v table="$name" -v cores="$cores" -f sim/tools/tables/bench.awk "$@"
}

case $1 in
figures)
    table peers sim/tools/tables/peers.txt "$BENCH_CSV" >"$work/peers"
    figures <"$work/peers"
    ;;
peers) table peers sim/tools/tables/peers.txt "$BENCH_CSV" ;;
*) table "$1" "$BENCH_CSV" ;;
esac
