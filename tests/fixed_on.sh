# SPDX-License-Identifier: MIT
#
# For test scripts to source: fixed_on CORE... runs the fixed-point vectors in every precision profile on the
# host and on emulated processors (sim/targets/targets.sh); what they print must be equal to the letter.
# shellcheck shell=sh
. sim/targets/targets.sh

# What the vectors reach of the renderer.
fixed_sources='firmware/aim.c firmware/angle.c firmware/arctangent.c firmware/eye.c firmware/eye_long.c firmware/view/view_long.c firmware/view/clip_long.c firmware/view/plane_unpacked.c firmware/math/fixed.c
    firmware/math/orientation.c firmware/screen/edge.c
    firmware/screen/edge_bounds.c firmware/screen/small.c firmware/view/rows.c firmware/view/view.c'

fixed_link() { # CORE PROFILE
    # shellcheck disable=SC2086 # sources are words
    target_link "$1" "$work/fixed-$1" -DLIM_PROFILE="LIM_PROFILE_$(echo "$2" | tr '[:lower:]' '[:upper:]')" \
        tests/targets/fixed_main.c -Itests/rigs tests/rigs/fixed_vectors.c $fixed_sources
}

fixed_expected() { # PROFILE
    fixed_link host "$1" && target_run host "$work/fixed-host" >"$work/$1.txt" && [ -s "$work/$1.txt" ]
}

fixed_agree() { # CORE PROFILE
    fixed_link "$1" "$2" && target_run "$1" "$work/fixed-$1" >"$work/$1.txt" || return 1
    diff "$work/$2.txt" "$work/$1.txt"
}

fixed_on() { # CORE...
    for profile in ${PROFILES:?is set by the Makefile}; do
        tap_check "$profile: the fixed-point vectors hold on the host" fixed_expected "$profile"
        for core; do
            tap_check "$profile: $core gives what the host gives" fixed_agree "$core" "$profile"
        done
    done
}
