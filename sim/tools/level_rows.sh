# SPDX-License-Identifier: MIT
#
# Freedoom's 68 maps, a row each: sh sim/tools/level_rows.sh prints them, and tells on standard error which is measured.
# Each row is kept in $BUILD/levels as soon as it is there, so that a run that was stopped goes on where it was; a row is measured
# anew when a source of the compiler or the renderer is younger. LEVELS="E1M1 MAP01": these alone.
#
# A row, divided by blanks: map; faces, polygons, splits, bytes of the scene in flash, those of its textures, RAM in bytes, instructions of
# a mean frame on Cortex-M4F, wrong pixels in %, holes, errors of order, seconds of a processor that compiling took, its memory in MB; the
# same figures without textures, from other cameras. Eight cameras at random in free space, 240x240, profile fast.
set -eu

: "${BUILD:=build}" "${LEVELS:=}"
wads=/usr/share/games/doom
rows=$BUILD/levels
mkdir -p "$rows"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

maps() {
    for wad in freedoom1 freedoom2; do
        "$BUILD/limner" wad "$wads/$wad.wad" | sed 1,2d | while read -r map rest; do
            echo "$wads/$wad.wad:$map"
        done
    done
}

is_wanted() { # MODEL
    [ -z "$LEVELS" ] && return 0
    case " $LEVELS " in *" ${1#*:} "*) return 0 ;; esac
    return 1
}

is_done() { # ROW
    [ -s "$1" ] && [ -z "$(find firmware sim/base sim/cameras sim/compiler sim/levels sim/model sim/readers sim/scene sim/trees -name '*.[ch]' -newer "$1" -print -quit)" ]
}

# Twelve figures, from cameras of their own.
figures() { # SEED MODEL OPTION...
    seed=$1
    shift
    "$BUILD/limner" compile "$@" --report >"$work/report" 2>"$work/said" || { cat "$work/said" >&2; return 1; }
    "$BUILD/limner" measure "$@" --precision fast --core m4 --camera "random:$seed:8" -o "$work/measured" >"$work/said" 2>&1 ||
        { cat "$work/said" >&2; return 1; }
    awk '/^  faces in the model/ { faces = $NF } /^  polygons in the scene/ { polygons = $NF } /^  splits/ { splits = $NF }
        /^  in all/ { flash = $3 } /^    of these textures/ { textures = $4 }
        END { printf " %d %d %d %d %d", faces, polygons, splits, flash, textures }' "$work/report"
    awk -F , 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
        { printf " %d %d %.4f %d %d", $c["state_b"] + $c["pools_b"] + $c["static_b"], $c["instructions"], $c["wrong_percent"],
            $c["holes"], $c["order_errors"] }' \
        "$work/measured/measure.csv"
    awk '/^processor time for compiling/ { seconds = $(NF - 1) } /^memory for compiling/ { memory_mb = $(NF - 1) }
        END { printf " %s %d", seconds, memory_mb }' "$work/report"
}

maps >"$work/maps"
while read -r model; do
    is_wanted "$model" || continue
    row=$rows/${model#*:}
    if ! is_done "$row"; then
        echo "${model##*/}" >&2
        { printf '%s' "${model#*:}" && figures 1 "$model" && figures 2 "$model" --no-textures && echo; } >"$work/row" </dev/null || exit 1
        mv "$work/row" "$row"
    fi
    cat "$row"
done <"$work/maps"
