# SPDX-License-Identifier: MIT
#
# Freedoom's maps: what they take as scenes, and what a frame costs; with textures, and without.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

sh sim/tools/level_rows.sh >"$work/rows"
echo "| map | faces | polygons | splits | flash, KB | without textures | textures, KB | RAM, KB | without | thousand instructions, M4F | without | wrong, % |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
awk 'function thousand(n) { return sprintf("%.0f", n / 1000) }
    { printf "| %s | %d | %d | %d | %s | %s | %s | %s | %s | %s | %s | %s |\n", $1, $12, $13, $14, thousand($5), thousand($15),
        thousand($6), thousand($7), thousand($17), thousand($8), thousand($18), $9 }' "$work/rows"
