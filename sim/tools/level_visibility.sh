# SPDX-License-Identifier: MIT
#
# What visible sets would spare on Freedoom's maps, flat, a row each: sh sim/tools/level_visibility.sh prints a table. LEVELS="E1M1
# MAP01": these alone. Polygons and predicted instructions are means of 64 sampled cameras, as `limner compile --portals on --report`
# tells them; every picture of these is drawn with and without, and one that differed would be an error here.
set -eu

: "${BUILD:=build}" "${LEVELS:=}"
wads=/usr/share/games/doom
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

maps() {
    for wad in freedoom1 freedoom2; do
        "$BUILD/limner" wad "$wads/$wad.wad" | sed 1,2d | while read -r map rest; do
            case " ${LEVELS:-$map} " in *" $map "*) echo "$wads/$wad.wad:$map" ;; esac
        done
    done
}

echo '| map | rooms | all is seen from | sets | bytes | polygons reached | with | thousand instructions, M0+, predicted | with | spared, % | compiling, s |'
echo '|---|---|---|---|---|---|---|---|---|---|---|'
maps >"$work/maps"
while read -r model; do
    began=$(date +%s.%N)
    if ! "$BUILD/limner" compile "$model" --no-textures --portals on --report >"$work/report" 2>"$work/said" </dev/null; then
        echo "| ${model#*:} | $(tail -n 1 "$work/said" | sed 's/.*portals: //') |"
        continue
    fi
    awk -v map="${model#*:}" -v s="$(echo "$(date +%s.%N) $began" | awk '{ printf "%.1f", $1 - $2 }')" '
        /^portals/ { told = 1 }
        !told { next }
        /^  rooms / { rooms = $2 }
        /that all is seen from/ { all = $NF }
        /^  different visible sets/ { sets = $NF }
        /^  bytes/ { bytes = $2 }
        /^  polygons reached, without/ { before = $4 + 0 }
        /^  polygons reached, with / { after = $4 }
        /^  instructions, without/ { cost = $3 + 0 }
        /^  instructions, with / { with = $3 + 0; spared = $4 }
        END { printf "| %s | %d | %d | %d | %d | %.0f | %.0f | %.0f | %.0f | %.1f | %s |\n", map, rooms, all, sets, bytes, before, after,
            cost / 1000, with / 1000, spared, s }' "$work/report"
done <"$work/maps"
