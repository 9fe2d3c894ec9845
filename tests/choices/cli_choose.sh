# SPDX-License-Identifier: MIT
#
# limner compile --max-error: the cheapest precision that meets a bound, the evidence for it, and clear
# refusals.
. tests/tap.sh

limner=$BUILD/limner
model='sim/scenes/teapot.obj --tree clusters' # one tree, as all are tried otherwise

chooses() { # PRECISION OPTION...
    wanted=$1
    shift
    # shellcheck disable=SC2086 # words
    "$limner" compile $model -o "$work/pot" --report --size 64x64 "$@" >"$work/out" || return 1
    cat "$work/out"
    [ "$(awk '$NF == "chosen" { print $1 }' "$work/out")" = "$wanted" ]
}

header_says() { # PROFILE
    grep -q "define LIM_PROFILE LIM_PROFILE_$1\$" "$work/pot.h"
}

fractions_are_there() { grep -q 'pot_fractions' "$work/pot.c"; }
fractions_are_not_there() { ! fractions_are_there; }

# Whoever is chosen meets the bound, and whoever comes before misses it.
first_that_meets() { # PERCENT
    # shellcheck disable=SC2086 # words
    "$limner" compile $model --report --size 64x64 --max-error "$1" >"$work/out" || return 1
    awk -v bound="$1" '/^(draft|fast|fine|exact)/ {
        if ($NF == "chosen") { found = 1; if ($2 > bound) exit 1 }
        else if (!found && $2 <= bound) exit 1
    } END { exit !found }' "$work/out"
}

refuses() { # PATTERN OPTION...
    pattern=$1
    shift
    # shellcheck disable=SC2086 # words
    if "$limner" compile $model -o "$work/none" --size 64x64 "$@" >"$work/out" 2>"$work/err"; then return 1; fi
    cat "$work/err"
    [ "$(wc -l <"$work/err")" -eq 1 ] && grep -q "$pattern" "$work/err" && ! ls "$work"/none* 2>/dev/null
}

tap_check "a loose bound takes the fewest bits" chooses draft --max-error 50%
tap_check "its header names the profile" header_says DRAFT
tap_check "its scene has no fractions" fractions_are_not_there
tap_check "a tight bound takes exact" chooses exact --max-error 0.003 --max-vertex-error 0.01px
tap_check "its header names the profile" header_says EXACT
tap_check "its scene has fractions" fractions_are_there
for bound in 5 0.5 0.2; do
    tap_check "at $bound % the first that meets the bound is chosen" first_that_meets $bound
done
tap_check "a bound that nothing meets is refused, and nothing is written" refuses "no precision meets the bound" \
    --max-vertex-error 0.000001px
tap_check "a bound must be a number" refuses "not a number of %" --max-error much
tap_check "a bound must be above 0" refuses "must be above 0" --max-error 0%
tap_check "a processor must exist" refuses "no such processor" --max-error 1 --core z80
tap_check "a precision leaves nothing to choose" refuses "nothing to choose" --max-error 1 --precision fast
tap_check "a camera goes with a bound" refuses "go with" --camera sim/scenes/teapot.cam
tap_check "a camera file must exist" refuses "No such file" --max-error 1 --camera "$work/none.cam"
tap_done
