# SPDX-License-Identifier: MIT
#
# Proves what the contracts (ACSL) of the arithmetic kernels state, and that nothing in them overflows, divides by
# zero, shifts too far or reaches outside of its memory: Frama-C's WP makes the goals, Z3 discharges them. A
# goal that is lost fails, and so does one that is missing: tests/prove/expected has how many there must be,
# and `sh tests/prove.sh --table` writes it anew. What the provers say of a goal is kept outside of the project, by the
# goal's text: only goals that have changed are proved again; and of a build whose text is the same to the letter, with
# comments and all, not even the goals are made again.
. tests/tap.sh

export WHY3CONFIG="$work/why3.conf"

# A build's name, and what it defines: each has forms of the kernels that the others have not.
builds='fast fine_limbs exact'
flags_of() {
    case $1 in
    fast) echo -DLIM_PROFILE=LIM_PROFILE_FAST ;;
    fine_limbs) echo -DLIM_PROFILE=LIM_PROFILE_FINE -D__ARM_ARCH_6M__ ;;
    exact) echo -DLIM_PROFILE=LIM_PROFILE_EXACT ;;
    esac
}

# Lines "BUILD FUNCTION PROVED OF" for the functions, which are divided by commas. Provers are given steps, not seconds:
# a busy machine takes longer, and proves the same. The seconds only end a prover that hangs.
hung_s=900
prove() { # BUILD FUNCTIONS MILLION-STEPS
    # shellcheck disable=SC2046 # flags_of prints a list
    (cd tests/prove && frama-c -c11 -cpp-extra-args="-I../../firmware $(flags_of "$1")" -wp -wp-rte -wp-fct "$2" \
        -wp-prover tip,z3 -wp-auto wp:range -wp-auto-width 31 -wp-steps "${3}000000" -wp-timeout $hung_s -wp-par "$(nproc)" \
        -wp-session "$work/$1.session" -wp-cache update -wp-cache-dir "$cache" kernels.c) >"$work/$1.log" 2>&1 || return 1
    awk -v build="$1" -v functions="$2" '
        BEGIN { count = split(functions, names, ",") }
        /^\[wp\] \[.*\] Goal typed_/ {
            goal = $0
            sub(/.* Goal typed_/, "", goal)
            best = ""
            for (i = 1; i <= count; i++)
                if (index(goal, names[i] "_") == 1 && length(names[i]) > length(best)) best = names[i]
            of[best]++
            if ($0 ~ / : Valid/) proved[best]++
        }
        END { for (i = 1; i <= count; i++) print build, names[i], proved[names[i]] + 0, of[names[i]] + 0 }' "$work/$1.log"
}

# Most goals take few steps; functions of which one is lost have another try, and more of them.
prove_all() { # BUILD: the functions that tests/prove/kernels lists for it
    prove "$1" "$(awk -v build="$1" '$1 == build { print $2 }' tests/prove/kernels | paste -sd ,)" 20 \
        >"$work/$1.tried" || return 1
    lost=$(awk '$3 < $4 { print $2 }' "$work/$1.tried" | paste -sd ,)
    awk '$3 == $4' "$work/$1.tried"
    [ -z "$lost" ] || prove "$1" "$lost" 150
}

# What hangs on nothing else: the build's text, what is asked for, and who proves it.
text_of() { # BUILD
    # shellcheck disable=SC2046 # flags_of prints a list
    (cd tests/prove && gcc -std=c11 -E -P -CC -I../../firmware $(flags_of "$1") kernels.c) &&
        cat tests/prove/kernels tests/prove.sh && frama-c -version && why3 --version && z3 --version
}

# Only what is proved as a whole is kept.
prove_or_recall() { # BUILD
    text_of "$1" >"$work/$1.text" || return 1
    recalled=$cache/$(sha256sum <"$work/$1.text" | cut -d ' ' -f 1).goals
    if [ ! -f "$recalled" ]; then
        prove_all "$1" >"$work/$1.goals" || return 1
        awk '$3 < $4 { exit 1 }' "$work/$1.goals" || return 0
        cp "$work/$1.goals" "$work/$1.proved" && mv "$work/$1.proved" "$recalled"
    fi
    cp "$recalled" "$work/$1.goals"
}

cache=${XDG_CACHE_HOME:-$HOME/.cache}/limner/prove
mkdir -p "$cache"
why3 config detect >"$work/why3.log" 2>&1
# All builds at once: with what is kept, most of each one's time is spent in waiting.
for build in $builds; do
    (prove_or_recall "$build" >"$work/$build.said" 2>&1 || echo failed >"$work/$build.failed") &
done
wait
for build in $builds; do
    [ ! -f "$work/$build.failed" ] || { cat "$work/$build.said" "$work/$build.log" >&2; exit 1; }
    cat "$work/$build.goals" >>"$work/goals"
done

if [ "${1:-}" = --table ]; then
    awk '{ print $1, $2, $4 }' "$work/goals" >tests/prove/expected
    cat "$work/goals"
    exit 0
fi

while read -r build kernel proved of; do
    expected=$(awk -v build="$build" -v kernel="$kernel" '$1 == build && $2 == kernel { print $3 }' tests/prove/expected)
    name="$kernel ($build): $proved goals proved of $of"
    if [ "$proved" -eq "$of" ] && [ "$proved" -ge "${expected:-1}" ]; then
        tap_ok "$name"
    else
        grep "Goal typed_${kernel}_" "$work/$build.log" | grep -v ': Valid' >"$work/lost" || true
        echo "expected: ${expected:-some}" >>"$work/lost"
        tap_fail "$name" "$work/lost"
    fi
done <"$work/goals"
tap_done
