# SPDX-License-Identifier: MIT
#
# Freedoom's maps: what they take as scenes, and what a frame costs; with textures, and without.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

sh sim/tools/level_rows.sh >"$work/rows"
echo "| map | faces | polygons | splits | flash, KB | without textures | RAM, KB | without | thousand instructions, M4F | without | wrong, % |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
awk 'function thousand(n) { return sprintf("%.0f", n / 1000) }
    { printf "| %s | %d | %d | %d | %s | %s | %s | %s | %s | %s | %s |\n", $1, $11, $12, $13, thousand($5), thousand($14),
        thousand($6), thousand($15), thousand($7), thousand($16), $8 }' "$work/rows"
