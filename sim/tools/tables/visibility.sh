# SPDX-License-Identifier: MIT
#
# What visible sets would spare on Freedoom's maps, flat: polygons and predicted instructions are means of 64 sampled cameras, as
# `limner compile --portals on --report` tells them. Each of their pictures is drawn with and without, and one that differed would
# be an error. LEVELS="E1M1 MAP01": these alone.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

: "${LEVELS:=}"

maps() {
    for wad in freedoom1 freedoom2; do
        "$BUILD/limner" wad "/usr/share/games/doom/$wad.wad" | sed 1,2d | while read -r map rest; do
            case " ${LEVELS:-$map} " in *" $map "*) echo "/usr/share/games/doom/$wad.wad:$map" ;; esac
        done
    done
}

echo '| map | rooms | all is seen from | sets | bytes | polygons reached | with sets | thousand instructions, M0+, predicted | with sets | spared, % |'
echo '|---|---|---|---|---|---|---|---|---|---|'
maps >"$work/maps"
while read -r model; do
    if ! "$BUILD/limner" compile "$model" --no-textures --portals on --report >"$work/report" 2>"$work/said" </dev/null; then
        cat "$work/said" >&2
        exit 1
    fi
    awk -v map="${model#*:}" '
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
        END { printf "| %s | %d | %d | %d | %d | %.0f | %.0f | %.0f | %.0f | %.1f |\n", map, rooms, all, sets, bytes, before, after,
            cost / 1000, with / 1000, spared }' "$work/report"
done <"$work/maps"
