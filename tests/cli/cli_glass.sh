# SPDX-License-Identifier: MIT
#
# Transparent models on the command line: the scene glass paints what it always did, by both orders, in every profile;
# the report says what became of opacities; what makes no sense is refused.
. tests/tap.sh

render() { # ARGUMENT...
    "$BUILD/limner" render sim/scenes/glass.obj --camera sim/scenes/glass.cam --size 96x72 "$@"
}

golden() { # PROFILE METHOD
    render --precision "$1" --method "$2" --check "tests/glass/$1.hashes"
}

compile() { # MODEL
    "$BUILD/limner" compile "$1" -o "$work/model" --report >"$work/report"
}

reports() { # MODEL LINE...
    compile "$1" || return 1
    shift
    for line; do
        grep -qE "^ +$line\$" "$work/report" || return 1
    done
}

is_refused() { # MODEL TEXT
    rm -f "$work"/model.*
    ! compile "$1" 2>"$work/said" && [ "$(cat "$work/said")" = "limner: $1: $2" ] && ! ls "$work"/model.* 2>/dev/null
}

same_faces() { # both orders see the same faces, those of glass among them
    render --ids "$work/nearest" && render --method painter --ids "$work/painter" && cmp "$work/nearest" "$work/painter"
}

# --compare finds less than 0.1 % of wrong pixels, and no holes: glass counts as what is seen.
compares() {
    render --compare | awk '/^compared/ { found = 1; bad = $8 >= 0.1 || $NF != 0 } END { exit !found || bad }'
}

for profile in ${PROFILES:?is set by the Makefile}; do
    for method in nearest painter; do
        tap_check "$profile, $method: the glass is as it was" golden "$profile" $method
    done
done
tap_check "both orders give the same faces numbers" same_faces
tap_check "compared with the reference, the nearest face is seen whether it is glass or not" compares
tap_check "the report counts what is transparent" reports sim/scenes/glass.obj 'of these transparent +[1-9][0-9]*' \
    'layers on a line, room for +[1-9][0-9]*'
tap_check "the report counts opacities that were clamped, and what is invisible" reports tests/models/opacity.obj \
    'opacity beyond 0..1, clamped +2' 'invisible, dropped +1'
names_its_line() {
    ! compile tests/models/opacity_nan.obj 2>"$work/said" && cat "$work/said" &&
        [ "$(cat "$work/said")" = "limner: opacity_nan.mtl:5: 'nan' is not a decimal number up to 3.4e38" ]
}
tap_check "an opacity that is no number is refused" names_its_line
tap_check "a model of which nothing is visible is refused" is_refused tests/models/invisible.obj \
    'every face is invisible: the opacity of all materials is 0'
tap_check "an opaque model's header leaves transparency out" sh -c \
    "'$BUILD/limner' compile sim/scenes/icosahedron.obj -o '$work/solid' >/dev/null && grep -q 'HAS_TRANSPARENT 0' '$work/solid.h'"
tap_done
