# SPDX-License-Identifier: MIT
#
# All 68 maps of Freedoom: each compiles, with textures and without, and the pictures of sixteen
# random cameras, eight of them with textures, have no holes and no errors of order. One hole of one pixel is known
# (firmware/DESIGN.md, Edge-on): that map is a skip, as long as this is all that is wrong. On demand, as it counts
# instructions for the table, too (sim/tools/level_rows.sh); stopped, it goes on where it was. LEVELS="E1M1 MAP01":
# these alone.
. tests/tap.sh

: "${LEVELS:=}"
sh sim/tools/level_rows.sh >"$work/rows" 2>"$work/said" || true

# Holes and errors of order with textures, then without: 0,0,0,0.
faults() { # MAP
    awk -v map="$1" '$1 == map && NF == 25 { print $10 "," $11 "," $22 "," $23 }' "$work/rows"
}

is_right() { # MAP
    grep "^$1 " "$work/rows" || { cat "$work/said"; return 1; }
    [ "$(faults "$1")" = 0,0,0,0 ]
}

for episode in 1 2 3 4; do
    for map in 1 2 3 4 5 6 7 8 9; do
        maps="${maps:-} E${episode}M$map"
    done
done
for map in $(seq 1 32); do
    maps="$maps MAP$(printf %02d "$map")"
done
for map in ${LEVELS:-$maps}; do
    if [ "$map: $(faults "$map")" = "MAP12: 0,0,1,0" ]; then
        tap_skip "$map" "a hole of one pixel without textures, known: firmware/DESIGN.md, Edge-on"
    else
        tap_check "$map" is_right "$map"
    fi
done
tap_done
