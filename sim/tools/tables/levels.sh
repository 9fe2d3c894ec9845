# SPDX-License-Identifier: MIT
#
# Freedoom's maps: what they take as scenes, and what a frame costs; with textures, and without.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

sh sim/tools/level_rows.sh >"$work/rows"
echo "| map | faces | polygons | splits | flash, KB | without textures | RAM, KB | thousand instructions: M0+ | M4F | without textures: M0+ | M4F | wrong, % |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
awk 'function kb(bytes) { return bytes == "-" ? "-" : sprintf("%.0f", bytes / 1000) }
    { printf "| %s | %d | %d | %d | %s | %s | %s | %s | %s | %s | %s | %s |\n",
        $1, $12, $13, $14, kb($5), kb($15), kb($6 == "-" ? $16 : $6), kb($7), kb($8), kb($17), kb($18), $9 == "-" ? $19 : $9 }' "$work/rows"
