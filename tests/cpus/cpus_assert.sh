# SPDX-License-Identifier: MIT
#
# A caller's bug stops the program where it is (LIM_ASSERT, firmware/config.h), on every kind of processor; a program
# without one runs on. What the asserts call may be replaced.
. tests/tap.sh
. sim/targets/targets.sh

prepare() {
    "$BUILD/limner" compile sim/scenes/icosahedron.obj --size 16x16 -o "$work/model" >/dev/null
}

# The renderer's objects are made once for each processor and its features. It prints how the program ended.
ran_with() { # CORE BUG FLAG...
    core=$1 bug=$2
    shift 2
    mkdir -p "$work/$core"
    echo "$*" | cmp -s - "$work/$core/flags" || renderer_of "$core" "$@" || return 1
    target_link "$core" "$work/image" -I"$work" -DLIM_CONFIG='"model.h"' -DBUG="$bug" "$@" tests/targets/caller_bug.c \
        "$work/$core"/*.o || return 1
    target_run "$core" "$work/image" >"$work/said" 2>&1
    status=$?
    cat "$work/said"
    echo "status $status"
    grep -qx before "$work/said"
}

renderer_of() { # CORE FLAG...
    core=$1
    shift
    for source in "$work/model.c" firmware/*.c firmware/*/*.c; do
        target_compile "$core" "$work/$core/$(basename "$source" .c).o" "$source" -ffreestanding -I"$work" \
            -DLIM_CONFIG='"model.h"' "$@" || return 1
    done
    echo "$*" >"$work/$core/flags"
}

runs_on() { # CORE BUG FLAG...
    ran_with "$@" && [ "$status" -eq 0 ] && grep -qx after "$work/said"
}

stops_at() { # CORE STATUS-PATTERN BUG FLAG...
    core=$1 pattern=$2 bug=$3
    shift 3
    ran_with "$core" "$bug" "$@" && ! grep -qx after "$work/said" && echo "$status" | grep -qxE "$pattern"
}

# All that an entry checks, with all features.
stops_at_each() { # CORE STATUS-PATTERN
    for each in 1 2 3 4 5 6 7 8 9 10 13; do
        stops_at "$1" "$2" $each -DLIM_HAS_NEAREST=1 -DLIM_HAS_MOVERS=1 -DLIM_HAS_ANTIALIAS=1 -DLIM_HAS_DELTA=1 || return 1
    done
}

# An AVR has no trap: it stays there, and the emulator would wait for ever.
stays_at() { # CORE BUG
    target_simavr() {
        timeout -k 1 3 simavr -m atmega1284p -f 16000000 "$target_output" </dev/null 2>&1 | tr -d '\r' |
            sed 's/^.*\[32m//; s/\.[^a-z]*$//'
    }
    ran_with "$1" "$2" && ! grep -q after "$work/said"
}

hook_is_called() {
    cat >"$work/hook.h" <<'END'
#include <stdio.h>
#include <stdlib.h>
static inline void program_failed(const char *condition) { printf("not so: %s\n", condition); exit(7); }
#define LIM_ASSERT(condition) ((condition) ? (void)0 : program_failed(#condition))
END
    ran_with host 4 -include "$work/hook.h" || return 1
    [ "$status" -eq 7 ] && grep -q '^not so: .*mem' "$work/said"
}

nothing_is_evaluated() {
    ran_with host 5 '-DLIM_ASSERT(condition)=((void)0)' && [ "$status" -eq 0 ]
}

# What stands in loops is evaluated where a build asks for it.
inner_asserts_are_had() {
    stops_at host '1(32|33)' 12 -DLIM_HAS_NEAREST=1 -DLIM_DEBUG_ASSERT=LIM_ASSERT
}

tap_check "a scene compiles" prepare
for core in host m0plus rv32; do
    tap_check "$core: a program without a bug runs on" runs_on $core 0
done
tap_check "avr: so does one whose memory begins at an odd place" runs_on avr 11
tap_check "host: each bug ends the program by a signal" stops_at_each host '1(32|33)'
tap_check "m0plus: each bug takes an exception" stops_at_each m0plus 2
tap_check "rv32: memory that begins between two words takes a trap" stops_at rv32 2 5
tap_check "avr: a sender without a function stays where it is" stays_at avr 13
tap_check "what happens may be replaced" hook_is_called
tap_check "and may be nothing" nothing_is_evaluated
tap_check "a scene that is not a compiler's is found out where a build asks for it" inner_asserts_are_had
tap_done
