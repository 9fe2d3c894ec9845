#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Tries one mutant: sh tests/mutants/try.sh NUMBER, a line of $BUILD/mutants/candidates. Makes it in a copy of its folder,
# compiles what has the line within it, links what executes it and runs that, the fastest first, until a test
# fails or those that passed take BUDGET_S (20) together: what slow tests alone would find counts as alive. What lives
# runs a fifth as long under the address sanitizer. Leaves a line "OUTCOME NUMBER PLACE OPERATOR BY" in $BUILD/mutants/results/NUMBER. Outcomes:
#   killed      BY names the test that failed; or it ran into its time limit
#   survived    BY says how many tests passed
#   uncovered   no test executes the line
#   same        all compiled code is the same: equivalent by the compiler's own proof, or not built for the host
#   broken      the compiler refuses it
set -u

: "${BUILD:?is set by the Makefile}" "${CC:=gcc}" "${BUDGET_S:=20}"
number=$1
root=$(pwd)
state=$root/$BUILD/mutants
tree=$state/trees/$number
tab=$(printf '\t')

IFS=$tab read -r source line column length operator text <<END
$(sed -n "${number}p" "$state/candidates")
END

finish() { # OUTCOME BY
    printf '%s\t%s\t%s:%s\t%s\t%s\n' "$1" "$number" "$source" "$line" "$operator" "$2" >"$state/results/$number"
    rm -rf "$tree"
    exit 0
}

# -- The mutated copy --------------------------------------------------------------------------------------------------

rm -rf "$tree"
mkdir -p "$tree/objects" "$state/results"
for folder in firmware hal sim tests boards; do
    case $source in
    "$folder"/*) cp -r "$folder" "$tree" ;;
    *) ln -s "$root/$folder" "$tree" ;;
    esac
done
# The text is read from a file: awk takes a backslash in an argument for the beginning of an escape.
printf '%s\n' "$text" >"$tree/text"
awk -v line="$line" -v column="$column" -v length_="$length" '
    NR == FNR { text = $0; next }
    FNR == line { $0 = substr($0, 1, column - 1) text substr($0, column + length_) }
    { print }' "$tree/text" "$source" >"$tree/$source"

# -- Which tests execute the line, and which objects have it ------------------------------------------------------------

# The line itself or, within an expression of several lines, the one that it begins on. Tables are executed nowhere:
# then each line of the file counts as its.
map=$state/map/$(echo "$source" | tr / _)
judges() { # lines "TEST OBJECT,OBJECT..."
    [ -s "$map" ] || return 0
    awk -v line="$line" '
        $1 == "F" { if (line >= $2 && line <= $3) inside = 1; next }
        $1 == "L" { if ($2 <= line && $2 > owner) owner = $2; next }
        # A small function is no function any more where it was inlined before lines were counted.
        inside || line - owner < 5 ? $1 != owner : 0 { next }
        {
            n = split($3, object, ",")
            for (i = 1; i <= n; i++)
                if (!(($2, object[i]) in seen)) {
                    seen[$2, object[i]]
                    objects[$2] = objects[$2] (objects[$2] == "" ? "" : ",") object[i]
                }
        }
        END { for (test in objects) print test, objects[test] }' "$map"
}

# A file without functions: what has its first name linked into it.
linked() {
    name=$(nm --defined-only "$BUILD/host/${source%.c}.o" 2>/dev/null | awk '$2 ~ /[RDTB]/ { print $3; exit }')
    [ -n "$name" ] || return 0
    for test in "$state"/times/*; do
        nm "$BUILD/tests/${test##*/}" | grep -q " $name\$" && echo "${test##*/} host/${source%.c}.o"
    done
}

# A header of constants: all that include it.
including() {
    find "$BUILD/host" "$BUILD/core-draft" "$BUILD/core-fast" "$BUILD/core-fine" "$BUILD/core-exact" -name '*.d' |
        xargs grep -lF " $source" | sed "s|^$BUILD/||; s|\.d\$|.o|" | grep -vE '/sim/[a-z]*/(measure_cost|cmd_measure|main)\.o' >"$tree/includers"
    [ -s "$tree/includers" ] || return 0
    for test in "$state"/times/*; do
        test=${test##*/}
        awk -v test="$test" '
            NR == FNR { wanted[$1]; next }
            $3 in wanted && !($3 in seen) { seen[$3]; list = list (list == "" ? "" : ",") $3 }
            END {
                own = "host/tests/" test ".o" # it may have nothing but constants of it
                if (own in wanted && !(own in seen)) list = list (list == "" ? "" : ",") own
                if (list != "") print test, list
            }' "$tree/includers" "$state/run/$test"
    done
}

order() { # the source's own test and the golden frames, then those with few objects and little time
    (cd "$state/times" && grep . ./*) | sed 's|^./||; s|:| |' >"$tree/times"
    own=test_$(basename "$source" | sed 's/[.].*//')
    awk -v own="$own" 'NR == FNR { time[$1] = $2; next }
        $1 in time {
            n = split($2, object, ",")
            cost = $1 == own ? 0 : $1 ~ /^test_golden_/ ? 0.4 + time[$1] / 100 : time[$1] + 0.1 * n
            printf "%.3f %s %s\n", cost, $1, $2
        }' \
        "$tree/times" - | sort -n | cut -d ' ' -f 2-
}

{
    judges
    [ -s "$map" ] || case $source in
    *.c) linked ;;
    *.h) including ;;
    esac
} | order >"$tree/judges"

# -- Compiling and linking ----------------------------------------------------------------------------------------------

# Warnings are no judges, but swapped arguments of types that do not fit are refused.
refused='-w -Werror=incompatible-pointer-types -Werror=int-conversion'

# The suite of the sanitizers judges, too: what has no defined behaviour ends in a trap.
traps='-fsanitize=undefined -fsanitize-undefined-trap-on-error'

compile() { # OBJECT [FLAGS]: into the tree, 1 if that is refused
    case $1 in
    core-*)
        name=${1%%/*} name=${name#core-}
        flags="-DCORE=core_$name -DLIM_PROFILE=LIM_PROFILE_$(echo "$name" | tr a-z A-Z)"
        ;;
    *) flags= ;;
    esac
    from=${1#*/}
    mkdir -p "$tree/objects/${1%/*}"
    # shellcheck disable=SC2086 # flags are words
    (cd "$tree" && "$CC" @"$root/$BUILD/host/flags" $refused $flags ${2:-} -c -o "objects/$1" "${from%.o}.c" 2>>"$tree/errors")
}

# What is compiled and differs from what is built: host objects stay, those of a core are linked anew as it.
differs() { # OBJECT
    [ -e "$tree/objects/$1" ] || [ -e "$tree/objects/$1.same" ] || {
        compile "$1" || finish broken "$(sed -n '/error:/{s/^[^ ]* *//p;q}' "$tree/errors")"
        if cmp -s "$tree/objects/$1" "$BUILD/$1"; then
            mv "$tree/objects/$1" "$tree/objects/$1.same"
        else
            compile "$1" "$traps"
            rm -f "$tree/${1%%/*}.o" # a core that was linked before
        fi
    }
    [ -e "$tree/objects/$1" ]
}

core() { # core-NAME
    [ -e "$tree/$1.o" ] && return
    # Those of the build, but for the objects that were compiled here.
    (cd "$BUILD" && find "$1" -name '*.o') | while read -r object; do
        [ -e "$tree/objects/$object" ] && echo "$tree/objects/$object" || echo "$root/$BUILD/$object"
    done | xargs ld -r -o "$tree/$1.o"
    objcopy --keep-global-symbol="core_${1#core-}" "$tree/$1.o"
}

# The command of make, with the mutated objects before the libraries: an archive's member is not taken for what is there.
link() { # TEST OBJECTS [FLAG]
    awk -v test="$1" -v out="$tree/$1" -v build="$BUILD" -v objects="$2" -v flag="${3:-}" '
        BEGIN { n = split(objects, object, " "); own = build "/host/tests/" test ".o" }
        index($0, " -o " build "/tests/" test " ") {
            for (i = 1; i <= NF; i++) {
                if ($(i - (i > 1)) == "-o") $i = out
                if ($i == own)
                    for (k = 1; k <= n; k++)
                        if (object[k] ~ "/objects/host/tests/" test "[.]o$") $i = ""
                if ($i ~ "^" build "/host/lib[a-z]*[.]a$") { archives = archives " " $i; $i = "" }
                if ($i == "-lcmocka") $i = objects archives " " $i
            }
            print $0, flag
            exit
        }' "$state/links" >"$tree/link"
    sh "$tree/link" 2>>"$tree/errors"
}

# -- The trial ----------------------------------------------------------------------------------------------------------

# Every object of a judge's that differs, each core linked anew as one: into $link_objects; "" if none does.
judge_objects() { # OBJECT,OBJECT...
    changed=
    for object in $(echo "$1" | tr , ' '); do
        differs "$object" || continue
        case $object in
        core-*) case " $changed " in *" ${object%%/*} "*) ;; *) changed="$changed ${object%%/*}" ;; esac ;;
        *) changed="$changed $tree/objects/$object" ;;
        esac
    done
    link_objects=
    for object in $changed; do
        case $object in
        core-*)
            core "$object"
            object=$tree/$object.o
            ;;
        esac
        link_objects="$link_objects $object"
    done
}

# Ends with "killed" if the test fails.
run() { # TEST LIMIT_S LIMIT_KB
    # Processor time, which others on the machine do not spend; and a wall time for what waits.
    (ulimit -t "$2" && ulimit -c 0 && ulimit -f 200000 && ulimit -v "$3" &&
        exec timeout -k 2 $(($2 * 20)) "$tree/$1" </dev/null >"$tree/said" 2>&1) 2>/dev/null
    status=$?
    rm -f "$tree/$1"
    case $status in
    0) return ;;
    124 | 137 | 152) finish killed "$1 (time)" ;;
    esac
    finish killed "$1"
}

passed=0 spent_ms=0
while read -r test objects; do
    judge_objects "$objects"
    [ -n "$link_objects" ] || continue
    link "$test" "$link_objects" || finish broken "does not link"
    usual_ms=$(awk '{ print int($1 * 1000) }' "$state/times/$test")
    spent_ms=$((spent_ms + usual_ms))
    [ $spent_ms -le $((BUDGET_S * 1000)) ] || break
    run "$test" $((usual_ms * 4 / 1000 + 2)) 8000000
    passed=$((passed + 1))
done <"$tree/judges"

# What lives is tried once more with what it changes under the address sanitizer, whose suite judges, too.
traps='-fsanitize=address,undefined -fno-sanitize-recover=all'
spent_ms=0
[ $passed -eq 0 ] || {
    rm -f "$tree"/core-*.o
    find "$tree/objects" -name '*.o' -exec rm {} +
    while read -r test objects; do
        usual_ms=$(awk '{ print int($1 * 1000) }' "$state/times/$test")
        spent_ms=$((spent_ms + usual_ms))
        [ $spent_ms -le $((BUDGET_S * 200)) ] || break
        judge_objects "$objects"
        [ -n "$link_objects" ] || continue
        link "$test" "$link_objects" -fsanitize=address,undefined || break
        run "$test" $((usual_ms * 12 / 1000 + 4)) unlimited
    done <"$tree/judges"
    finish survived "$passed"
}

[ -s "$tree/judges" ] && finish same ""

# Nothing executes it: is it compiled at all?
for object in host/${source%.c}.o core-draft/${source%.c}.o core-fast/${source%.c}.o core-fine/${source%.c}.o \
    core-exact/${source%.c}.o; do
    [ "$source" != "${source%.c}" ] && [ -e "$BUILD/$object" ] || continue
    differs "$object" && finish uncovered ""
done
case $source in
*.h) finish uncovered "" ;;
esac
finish same ""
