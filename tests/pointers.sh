# SPDX-License-Identifier: MIT
#
# The bound of a stack knows where calls through pointers lead because the C says it (sim/tools/pointers.awk): for all of
# firmware/, hal/ and boards/, but for hal/adapters, which is in no image of ours. What it does not say, or says otherwise
# than calls are written, is named with file and line.
. tests/tap.sh

sources='firmware hal boards'

pointers_of() { # FOLDER...
    find "$@" -name '*.[ch]' ! -path 'hal/adapters/*' -exec awk -f sim/tools/pointers.awk {} +
}

all_is_said() {
    # shellcheck disable=SC2086 # folders are words
    pointers_of $sources >"$work/pointers" && grep -q '^call ' "$work/pointers" && grep -q '^to ' "$work/pointers"
}

# Of the sources with another file in the place of one.
pointers_with() { # FILE SED-COMMAND
    mkdir -p "$work/changed" && sed "$2" "$1" >"$work/changed/${1##*/}" && ! cmp -s "$1" "$work/changed/${1##*/}" || return 1
    # shellcheck disable=SC2086
    find $sources -name '*.[ch]' ! -path 'hal/adapters/*' ! -path "$1" -exec awk -f sim/tools/pointers.awk "$work/changed/${1##*/}" {} +
}

# A function's place is named, if it was not.
names() { # FUNCTION FILE SED-COMMAND
    if pointers_with "$2" "$3" >/dev/null 2>"$work/said"; then
        echo "$2: nobody misses anything after $3"
        return 1
    fi
    cat "$work/said" && grep -q "^.*\.[ch]:[0-9]*: $1: its address is taken" "$work/said"
}

# Without the line `static TYPE NAME;` the place at which NAME is given away is named; so it is with a letter missing.
types_are_needed() {
    declared='^(static )?[a-z_0-9]+ [a-z_0-9]+;$'
    # shellcheck disable=SC2086
    types=$(find $sources -name '*.[ch]' -exec sed -n 's/^typedef [^(]*[ *]\([a-z_0-9]*\)(.*/\1/p' {} + | tr '\n' '|')
    # shellcheck disable=SC2086
    grep -rnE "$declared" $sources --include='*.[ch]' | grep -E ":(static )?(${types%|}) " >"$work/declared"
    [ "$(wc -l <"$work/declared")" -ge 8 ] || return 1
    while IFS=: read -r file line text; do
        name=${text##* } name=${name%;}
        names "$name" "$file" "${line}d" || return 1
    done <"$work/declared"
    names push firmware/lines/smooth.c 's/^\(static lim_strip_sink pus\)h;/\1;/'
}

# Whatever is set to a member: by another name, it is missed.
members_are_needed() {
    for place in 'hal/dcs.c|\.window = dcs_window' 'boards/common/screen.c|\.done = screen_done' \
        'firmware/pixels/delta.c|target\.lend = delta_lend' 'hal/mcu/stm32_dma.c|\.write = write'; do
        file=${place%%|*} set=${place#*|}
        names "${set##* }" "$file" "s/$set/.nothing = ${set##* }/" || return 1
    done
}

# Good code: a member, set in both ways, and a type; whoever calls knows neither name.
good='struct the_target {
    int (*lend)(int y);
};
typedef int sink(void *ctx);
static sink push;
static int push(void *ctx) { return !ctx; }
static int lend(int y) { return y; }
static int late(int y) { return y + 1; }
int begin(struct the_target *target);
int begin(struct the_target *target)
{
    *target = (struct the_target){.lend = lend};
    if (!target->lend) target->lend = late;
    return target->lend(3) + give(push, 0);
}
int give(sink *to, void *ctx)
{
    return to(ctx);
}'

good_is_said() {
    mkdir -p "$work/good" && echo "$good" >"$work/good/code.c" && pointers_of "$work/good" | sort >"$work/said" || return 1
    cat "$work/said"
    printf '%s\n' 'call code.c:14 target.lend' 'call code.c:18 sink' 'to sink code.c:push' \
        'to target.lend code.c:late' 'to target.lend code.c:lend' | cmp - "$work/said"
}

is_refused() { # MESSAGE SED-COMMAND: of the good code, changed
    mkdir -p "$work/bad" && echo "$good" | sed "$2" >"$work/bad/code.c" || return 1
    if pointers_of "$work/bad" >/dev/null 2>"$work/said"; then
        echo "it passed"
        return 1
    fi
    cat "$work/said" && grep -q "$1" "$work/said"
}

# As avr-objdump has it: the last thing that begin() does is to call what it was given, on a line that is not the call's; lend()
# pushes three bytes beside its return address, late() one.
avr_jumps_count() {
    printf '00000010 <begin>:\n/far/away/good/code.c:11\n  10:\t09 94 \tijmp\n' >"$work/listing"
    printf '00000020 <lend>:\n/far/away/good/code.c:7\n  20:\tcf 93 \tpush\tr28\n  22:\tdf 93 \tpush\tr29\n' >>"$work/listing"
    printf '  24:\tef 93 \tpush\tr30\n00000030 <late>:\n  30:\tcf 93 \tpush\tr28\n' >>"$work/listing"
    awk -f sim/tools/avr_graph.awk "$work/listing" >"$work/graph" &&
        awk -f sim/tools/stack.awk -v roots=begin "$work/said" "$work/graph" >"$work/bound" && cat "$work/bound" &&
        [ "$(cat "$work/bound")" = '7: begin 2, lend 5' ]
}

tap_check "the sources say where each call through a pointer leads" all_is_said
tap_check "a function that is given away without its type is named" types_are_needed
tap_check "so is one that is set to what is no pointer's member" members_are_needed
tap_check "a member leads to what is set to it, a type to what is declared by it" good_is_said
tap_check "a jump through a pointer is a call, where lines are not exact as well" avr_jumps_count
tap_check "a call through a struct of another name is refused" is_refused 'code.c:14: calls through glass.lend' \
    '14s/target->/glass->/'
tap_check "a member that is called and set to nothing is refused" is_refused 'code.c:14: calls through target.done' \
    '3s/.*/    int (*done)(int y); };/;14s/lend/done/'
tap_check "a member that nobody calls is refused" is_refused 'target.lend: is set, and nobody calls it' '14s/target->lend(3)/3/'
tap_check "a value that is no function's name is refused" is_refused 'code.c:13: target.lend: is set to what' '13s/late/other/'
tap_check "nor is one that a function chooses taken for it" is_refused 'code.c:13: target.lend: is set to what' '13s/late/give(0, 0)/'
tap_check "a member's value that goes elsewhere is refused" is_refused 'code.c:14: target.lend: its value' \
    '14s/^/    other = target->lend;/'
tap_check "a value by position is refused" is_refused 'code.c:12: lend: its address is taken' '12s/\.lend = //'
tap_check "a pointer without a type is refused" is_refused 'code.c:16: to: is no struct' '16s/sink \*to/int (*to)(void *ctx)/'
tap_check "so is an array of them" is_refused 'code.c:2: lend.3.: is no struct' '2s/lend/lend[3]/'
tap_check "and an address in a macro" is_refused 'code.c:9: lend: its address is taken' '9s/.*/#define OTHER give(lend, 0)/'
tap_check "two types for the same functions are refused" is_refused 'code.c:9: other: is the same type as sink' \
    '9s/.*/typedef int other(void *context);/'
tap_done
