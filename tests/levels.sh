# SPDX-License-Identifier: MIT
#
# All 68 maps of Freedoom: each compiles, with textures and without, and the pictures of sixteen
# random cameras, eight of them with textures, have no holes and no errors of order. On demand, as it counts instructions for the table, too
# (sim/tools/level_rows.sh); stopped, it goes on where it was. LEVELS="E1M1 MAP01": these alone.
. tests/tap.sh

: "${LEVELS:=}"
sh sim/tools/level_rows.sh >"$work/rows" 2>"$work/said" || true

is_right() { # MAP
    row=$(grep "^$1 " "$work/rows") || { cat "$work/said"; return 1; }
    echo "$row"
    # shellcheck disable=SC2086 # figures are words
    set -- $row
    [ $# -eq 25 ] && [ "${10}${11}${22}${23}" = 0000 ]
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
    tap_check "$map" is_right "$map"
done
tap_done
