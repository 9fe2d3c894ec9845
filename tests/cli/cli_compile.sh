# SPDX-License-Identifier: MIT
#
# `limner compile` from the outside: three files or none, a report, and one line for what it
# cannot use.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
mkdir "$work/here"
cd "$work/here" || exit 1

cat >../pyramid.obj <<'OBJ'
v -1 0 1
v 1 0 1
v 1 0 -1
v -1 0 -1
v 0 1.5 0
f 1 4 3 2
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
OBJ
: >../empty.obj
echo 'once upon a time' >../story.obj
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' >../line.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n' >../nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >../faceless.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n' >../range.obj

# refuse NAME PATTERN ARGUMENT...: fails with one line that matches, and leaves the folder as it was.
refuse() {
    name=$1 pattern=$2
    shift 2
    tap_check "$name" is_refused "$pattern" "$@"
}

is_refused() {
    pattern=$1
    shift
    find . | sort >../before
    timeout 60 "$limner" compile "$@" >../out 2>../err </dev/null
    status=$?
    find . | sort >../after
    cat ../err
    [ $status -eq 1 ] || { echo "status $status" && return 1; }
    [ "$(wc -l <../err)" -eq 1 ] || { echo "not one line" && return 1; }
    [ ! -s ../out ] || { echo "something on stdout" && return 1; }
    grep -qE -- "$pattern" ../err || { echo "does not match $pattern" && return 1; }
    diff ../before ../after
}

writes_three_files() {
    "$limner" compile ../pyramid.obj -o made/hall --report >../report 2>../err || return 1
    [ "$(cd made && echo *)" = "hall.c hall.h hall.lim" ] && [ ! -s ../err ]
}

reports() {
    grep -qE '^  faces in the model +5$' ../report && grep -qE '^  splits +0$' ../report &&
        grep -qE '^  in all +[0-9]+ +[0-9.]+$' ../report && grep -qE 'certified +0\.[0-9]+ units$' ../report
}

report_alone_writes_nothing() {
    find . | sort >../before
    "$limner" compile ../pyramid.obj --report >../report.alone 2>../err || return 1
    find . | sort | diff ../before - && reports && [ ! -s ../err ]
}

renders_alike() { # the scene file shows what the model shows
    "$limner" render ../pyramid.obj --size 64x64 -o 'a/%d.png' && "$limner" render made/hall.lim --size 64x64 -o 'b/%d.png' &&
        diff -r a b && rm -r a b
}

replaces_old_files() {
    cp made/hall.c old.c
    echo nonsense >made/hall.c
    "$limner" compile ../pyramid.obj -o made/hall --report >../report && cmp old.c made/hall.c
}

# A lens's smaller side decides: 14 degrees have a tangent below 1/8, and 60 on a display of one column.
long_lenses_are_told() {
    tele() { # VALUE OPTION...
        value=$1
        shift
        "$limner" compile ../pyramid.obj "$@" -o made/tele --report >../report && grep -q "define LIM_HAS_TELE $value" made/tele.h &&
            grep "exact through lenses" ../report | grep -q "$([ "$value" = 1 ] && echo 'of any angle' || echo 'of less: --fov')"
    }
    tele 0 && tele 0 --fov 15 && tele 1 --fov 14 && tele 1 --fov 1 && tele 0 --fov 20 --size 100x70 && tele 1 --fov 20 --size 60x100 &&
        tele 1 --size 1x200 && tele 1 --size 200x1 && rm made/tele.*
}

tap_check "three files are written, in a new folder" writes_three_files
tap_check "the report says what became of the model" reports
tap_check "--report alone writes nothing" report_alone_writes_nothing
tap_check "a scene file shows what its model shows" renders_alike
tap_check "files of an earlier run are replaced" replaces_old_files
tap_check "firmware has what long lenses take if it is told of one, and the report says so" long_lenses_are_told

refuse "compile without a model is refused" '^limner: compile: needs a model'
refuse "compile without a name is refused" '^limner: compile: needs -o NAME' ../pyramid.obj
refuse "a second model that is missing is refused" '^limner: b\.obj: .*No such file' ../pyramid.obj b.obj -o x
refuse "two scenes of one name are refused" 'a scene of that name is there already' ../pyramid.obj ../pyramid.obj -o x
refuse "an unknown option is refused" '^limner: --colour: no such option' --colour ../pyramid.obj -o x
refuse "a missing value is refused" '^limner: --tolerance: needs a value' ../pyramid.obj -o x --tolerance
refuse "a negative tolerance is refused" '^limner: --tolerance -1: must be 0 to 1024 units' ../pyramid.obj -o x --tolerance -1
refuse "a tolerance of words is refused" '^limner: --tolerance much' ../pyramid.obj -o x --tolerance much
refuse "an unknown splitter is refused" 'best: no such heuristic' ../pyramid.obj -o x --splitter best
refuse "a missing model is refused" '^limner: \.\./none\.obj: .*No such file' ../none.obj -o x
refuse "an empty model is refused" '^limner: \.\./empty\.obj: ' ../empty.obj -o x
refuse "a text called .obj is refused" '^limner: \.\./story\.obj: ' ../story.obj -o x
refuse "a model without faces is refused" '^limner: \.\./faceless\.obj: ' ../faceless.obj -o x
refuse "a model of no area is refused" '^limner: \.\./line\.obj: ' ../line.obj -o x
refuse "coordinates that are no numbers are refused" '^limner: \.\./nan\.obj:3: ' ../nan.obj -o x
refuse "indices out of range are refused" '^limner: \.\./range\.obj:4: vertex index 7' ../range.obj -o x
refuse "a folder as a name is refused" '^limner: -o .made/.: names a folder' ../pyramid.obj -o made/
refuse "a folder that cannot be made is refused" '^limner: /proc/none' ../pyramid.obj -o /proc/none/x
refuse "a file in the way of a folder is refused" '^limner: old\.c' ../pyramid.obj -o old.c/x

mkdir blocked blocked/hall.lim
refuse "a file that cannot be replaced leaves nothing new" '^limner: blocked/hall\.lim' ../pyramid.obj -o blocked/hall
tap_done
