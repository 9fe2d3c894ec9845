# SPDX-License-Identifier: MIT
#
# Freedoom's maps: what they take as scenes, and what a frame costs; with textures, and without.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

sh sim/tools/level_rows.sh >"$work/rows"
echo "| map | faces | polygons | splits | flash, KB | without textures | textures, KB | RAM, KB | without | thousand instructions, M4F | without | wrong, % | compiled in s of a processor | memory for it, MB |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
awk 'function thousand(n) { return sprintf("%.0f", n / 1000) }
    { printf "| %s | %d | %d | %d | %s | %s | %s | %s | %s | %s | %s | %s | %s | %d |\n", $1, $14, $15, $16, thousand($5), thousand($17),
        thousand($6), thousand($7), thousand($19), thousand($8), thousand($20), $9, $12, $13
      seconds += $12; if ($12 > most) { most = $12; slowest = $1 } }
    END { printf "\nCompiling a map with its textures takes %.1f s of a processor in the mean, and %s s at most (%s).\n", seconds / NR, most, slowest }' "$work/rows"
