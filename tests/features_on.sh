# SPDX-License-Identifier: MIT
#
# For test scripts to source: builds the renderer with some of its features, and renders with it. Every build, without an
# optimizer and with all warnings as errors, must paint what the full renderer of `limner render` paints, by every method
# and in every way that it has (tests/features/main.c).
#
#   features_prepare NAME                 one of $features_scenes
#   features_draw COMPILER NAME FLAG...   FLAG: LIM_HAS_X=0 or 1; the others are what the scene's header says
#   features_pairs COMPILER OTHER [all]   a test for each pair of flags: an eighth of them, or all, both on and both off;
#                                         by one compiler with both on, by the other with both off
#
# Which flags can be set is read from firmware/config.h, which of them a scene leaves open from its header. What
# firmware/agree.h refuses is not legal.
# shellcheck shell=sh

features="$(sed -n 's/^#ifndef \(LIM_HAS_[A-Z_]*\)$/\1/p' firmware/config.h | tr '\n' ' ')LIM_RECIP_TABLE"
features_scenes='rooms icosahedron glass movers knot order quarters mesh'
features_frames=4

# Another eighth with each commit; SEED=0 to SEED=7 are all pairs, SEED=8 to SEED=15 again the other way round.
: "${SEED:=$(printf '%d' "0x$(git rev-parse --short=6 HEAD 2>/dev/null || echo 0)")}"

# Each has needs of its own: every order but the painter and the depth sort, planes on the axes and off them, movers,
# texture, transparency, a set.
features_model() { # NAME: its model, its cameras, options
    case $1 in
    icosahedron) echo sim/scenes/icosahedron.obj sim/scenes/teapot.cam --method convex ;;
    movers) echo sim/scenes/movers.gltf sim/scenes/movers.cam ;;
    knot) echo sim/scenes/knot.obj sim/scenes/knot.cam --method newell ;;
    mesh) echo sim/scenes/knot.obj sim/scenes/knot.cam --method mesh-depth ;;
    quarters | order) echo "tests/models/$1.obj" "$work/$1.cam" ;;
    *) echo "sim/scenes/$1.obj" "sim/scenes/$1.cam" ;;
    esac
}

# The hashes of one method and way, under a line with their names; nothing where the full renderer refuses.
features_expect() { # METHOD WAYS [OPTION...]
    features_method=$1 features_ways=$2
    shift 2
    "$BUILD/limner" render "$features_drawn" --method "$features_method" --camera "$work/few.cam" --size 96x64 --fps 3 "$@" \
        --write-hashes "$work/hashes" --write-cameras "$features_dir/cameras.h" 2>/dev/null || return 0
    for features_way in $features_ways; do
        echo "$features_method $features_way"
        cat "$work/hashes"
    done
}

# The scene as C, its cameras, and what the full renderer paints. By lines or pieces, into a framebuffer or in parts: the
# same picture.
features_prepare() { # NAME
    awk 'BEGIN { for (i = 0; i < 64; i++) print 0.5 + 0.6 * sin(i / 9), 0.5 + 0.3 * cos(i / 7), 0.15 + i / 90, 0.5, 0.4, 0 }' \
        >"$work/quarters.cam"
    awk 'BEGIN { for (i = 0; i < 64; i++) print 5.5 + 0.3 * sin(i), 0.6 + 0.4 * cos(i), 1.5 + i / 40, 2, 0.3, 0.2 }' >"$work/order.cam"
    features_dir=$kept/$1
    # shellcheck disable=SC2046 # words
    set -- $(features_model "$1")
    features_drawn=$1
    rm -rf "$features_dir"
    mkdir -p "$features_dir"
    awk '!/^#/ && NF && n++ % 7 == 0' "$2" | head -n "$features_frames" >"$work/few.cam"
    shift 2
    "$BUILD/limner" compile "$features_drawn" --size 96x64 "$@" -o "$features_dir/model" >/dev/null || return 1
    # What moves is no part of a .lim file.
    case $features_drawn in *.gltf) ;; *) features_drawn=$features_dir/model.lim ;; esac
    for features_method in nearest painter convex scanline depth newell mesh mesh-depth; do
        features_expect $features_method 'plain fill framebuffer parts'
        for features_way in wireframe antialias delta; do
            features_expect $features_method $features_way --$features_way
        done
        features_expect $features_method overlay --overlay 'over it'
    done >"$features_dir/expected"
    for features_source in firmware/*.c firmware/*/*.c; do
        echo "#include \"$features_source\""
    done >"$features_dir/renderer.c"
    features_differ
}

# All frames of the first method are different ones.
features_differ() {
    head -n $((1 + features_frames)) "$features_dir/expected"
    [ "$(sed -n "2,$((1 + features_frames))p" "$features_dir/expected" | cut -d ' ' -f 2 | sort -u | wc -l)" -eq $features_frames ]
}

# All flags of a build: of what config.h can set, what the scene's header says, or 1, and on top of it what is given.
features_all() { # NAME FLAG...
    features_dir=$kept/$1
    shift
    awk -v names="$features" -v given="$*" '
        /#define LIM_HAS_/ { on[$2] = $3 }
        END {
            count = split(given, word, " ")
            for (i = 1; i <= count; i++) { split(word[i], part, "="); on[part[1]] = part[2] }
            count = split(names, name, " ")
            for (i = 1; i <= count; i++) printf "-D%s=%d ", name[i], name[i] in on ? on[name[i]] : 1
        }' "$features_dir/model.h"
}

features_are_legal() { # NAME FLAG...
    # shellcheck disable=SC2046 # flags are words
    "$CC" -std=c11 -fsyntax-only -Ifirmware -I"$kept/$1" -DLIM_CONFIG='"model.h"' $(features_all "$@") \
        -include agree.h -x c /dev/null >/dev/null 2>&1
}

# The renderer in one piece: no two of its files may use a name for two things.
features_build() { # COMPILER NAME ALL-FLAGS
    # shellcheck disable=SC2086 # flags are words
    $1 -std=c11 -O0 $WARNINGS $3 -DLIM_CONFIG='"model.h"' -I. -Ifirmware -I"$kept/$2" -o "$kept/$2/program" \
        tests/features/main.c "$kept/$2/renderer.c" "$kept/$2"/model*.c
}

# Of each method and way that is linked and that the full renderer has, the hashes; one at least.
features_compare() { # NAME ALL-FLAGS
    awk -v flags="$2" '
        function linked(method, way) {
            flag["fill"] = "FILL"; flag["framebuffer"] = "FRAMEBUFFER"; flag["parts"] = flag["plain"] = "LINES"
            gsub(/-/, "_", method)
            return on["LIM_HAS_" toupper(method)] && on["LIM_HAS_" (way in flag ? flag[way] : toupper(way))]
        }
        BEGIN {
            count = split(flags, word, " ")
            for (i = 1; i <= count; i++) { split(substr(word[i], 3), part, "="); on[part[1]] = part[2] }
        }
        FNR == 1 { file++ }
        /^[a-z-]+ [a-z]+$/ { section = $0; known[section, file] = 1; if (file == 1) order[++sections] = section; next }
        { text[section, file] = text[section, file] $0 "\n" }
        END {
            for (i = 1; i <= sections; i++) {
                section = order[i]
                split(section, part, " ")
                if (!linked(part[1], part[2])) continue
                compared++
                if (text[section, 1] == text[section, 2]) continue
                printf "%s: expected\n%sis\n%s", section, text[section, 1], text[section, 2]
                bad = 1
            }
            print compared + 0, "compared"
            exit bad || !compared
        }' "$kept/$1/expected" "$kept/$1/frames"
}

features_draw() { # COMPILER NAME FLAG...
    features_compiler=$1
    shift
    features_given=$(features_all "$@")
    echo "$features_compiler $features_given"
    features_build "$features_compiler" "$1" "$features_given" && "$kept/$1/program" >"$kept/$1/frames" &&
        features_compare "$1" "$features_given"
}

# A line of tests/features/plan.awk after the other of one pair, until one is legal.
features_pair() { # COMPILER FILE
    while read -r _ _ features_name features_flags; do
        # shellcheck disable=SC2086 # flags are words
        features_are_legal "$features_name" $features_flags || continue
        # shellcheck disable=SC2086
        features_draw "$1" "$features_name" $features_flags
        return
    done <"$2"
    echo "not legal" >>"$work/illegal"
}

features_pairs() { # COMPILER OTHER [all]
    echo "# SEED=$SEED"
    set -- "$1" "$2" "${3:-}"
    for features_name in $features_scenes; do
        tap_check "the full renderer paints $features_name" features_prepare "$features_name"
    done
    # shellcheck disable=SC2046 # names are words
    awk -v features="$features" -v seed="$SEED" -v all="${3:+1}" -f tests/features/plan.awk \
        $(printf "$kept/%s/model.h " $features_scenes) >"$work/plan"
    : >"$work/illegal"
    for features_this in $(awk '{ print $1 "/" $2 }' "$work/plan" | uniq); do
        awk -v pair="${features_this%/*}" -v side="${features_this#*/}" '$1 == pair && $2 == side' "$work/plan" >"$work/tries"
        case $features_this in
        *bare) features_by=$1 features_what="with ${features_this%/*} beside what a scene needs" ;;
        *) features_by=$2 features_what="without ${features_this%/*}" ;;
        esac
        tap_check "SEED=$SEED, $features_by: $features_what" features_pair "$features_by" "$work/tries"
    done
    tap_check "agree.h refuses a fifth of the pairs at most" features_are_mostly_legal
}

# And none was forgotten: n flags have n (n - 1) / 2 pairs.
features_are_mostly_legal() {
    tried=$(awk '{ print $1, $2 }' "$work/plan" | uniq | wc -l) refused=$(wc -l <"$work/illegal")
    # shellcheck disable=SC2086 # flags are words
    set -- $features
    echo "$refused of $tried, of $# flags"
    [ "$tried" -ge $(($# * ($# - 1) / 2 / 8 * 4 / 5)) ] && [ $((refused * 5)) -le "$tried" ]
}
