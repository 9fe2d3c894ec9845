# SPDX-License-Identifier: MIT
#
# One decision for all commands: what `limner render` draws of a model is what `limner compile` writes of it with the same
# options, frame by frame and count by count, whatever was decided: trees of all kinds, scan lines, meshes, mesh leaves,
# portals, 32 bits, profiles, panels. Decisions are remembered, and nothing hangs on that.
. tests/tap.sh
. tests/part_of.sh
unset LIMNER_CACHE
export XDG_CACHE_HOME=/nonexistent # each command decides for itself

limner=$(cd "$BUILD" && pwd)/limner
scenes=$(pwd)/sim/scenes
furnished=$(pwd)/tests/furnished.awk ball=$(pwd)/tests/ball.awk
cd "$work" || exit 1

# Models --------------------------------------------------------------------------------------------------

# Of 16 rings, a mesh by distance draws it.
awk -v n=16 -f "$ball" >ball.obj
awk -v n=5 -f "$ball" >small.obj

# Tetrahedra that go through each other, which take depths; numbers of Park and Miller.
awk -v n=40 'function random() { seed = seed * 16807 % 2147483647; return seed / 2147483647 - 0.5 }
BEGIN {
    seed = 7
    for (k = 0; k < n; k++) {
        for (i = 0; i < 3; i++) middle[i] = 1.5 * random()
        for (c = 0; c < 4; c++) for (i = 0; i < 3; i++) p[c, i] = middle[i] + 1.6 * random()
        for (c = 1; c < 4; c++) for (i = 0; i < 3; i++) e[c, i] = p[c, i] - p[0, i]
        turn = e[1, 0] * (e[2, 1] * e[3, 2] - e[2, 2] * e[3, 1]) - e[1, 1] * (e[2, 0] * e[3, 2] - e[2, 2] * e[3, 0]) + e[1, 2] * (e[2, 0] * e[3, 1] - e[2, 1] * e[3, 0])
        for (c = 0; c < 4; c++) { d = turn < 0 && (c == 1 || c == 2) ? 3 - c : c; printf "v %.5f %.5f %.5f\n", p[d, 0], p[d, 1], p[d, 2] }
        o = 4 * k
        printf "f %d %d %d\nf %d %d %d\nf %d %d %d\nf %d %d %d\n", o + 1, o + 3, o + 2, o + 1, o + 2, o + 4, o + 2, o + 3, o + 4, o + 3, o + 1, o + 4
    }
}' >grains.obj
awk -v seed=7 -v things=5 -v how=inside -v dense=14 -v mtl=inside.mtl -f "$furnished" >inside.obj

# What is drawn is what is written ----------------------------------------------------------------------------

# decided NAME WORDS: what NAME's header and report say was decided.
decided() {
    { grep '_SCENE_METHOD ' "$1.h"; cat "$1.report"; } >said
    for word in $2; do
        grep -Eq -- "$word" said || { cat said; echo "no $word"; return 1; }
    done
}

# alike WORDS MODEL OPTIONS OPTIONS: words that tell what was decided; options of a model; those that a .lim takes, too.
alike() {
    rm -f flashed* drawn*
    # shellcheck disable=SC2086 # lists of options
    "$limner" compile "$2" -o flashed --report $3 $4 >flashed.report 2>&1 || { cat flashed.report; return 1; }
    # shellcheck disable=SC2086 # lists of options
    decided flashed "$1" && draw drawn "$2" $3 $4 && draw flashed flashed.lim $4 && diff drawn.hashes flashed.hashes && diff drawn.stats flashed.stats
}

draw() { # NAME SCENE OPTION...
    name=$1
    shift
    "$limner" render "$@" --frames 4 --camera random:5 --stats --write-hashes "$name.hashes" >"$name.stats" 2>err || { cat err; return 1; }
}

# A quarter of the ways in each run (tests/part_of.sh).
chosen=" $(part_of 4 $(seq 40) | tr '\n' ' ')" number=0
way() { # NAME COMMAND...
    number=$((number + 1))
    case $chosen in *" $number "*) tap_check "$@" ;; esac
}
way "a BSP tree" alike "LIM_NEAREST_FIRST tree.*bsp" "$scenes/rooms.obj" "" ""
way "its portals, where they are asked for" alike "portals.*kept" "$scenes/rooms.obj" "--portals on" ""
way "clusters, by scan lines" alike "LIM_SCANLINE tree.*clusters" "$scenes/teapot.obj" "" ""
way "a tree by scan lines" alike "LIM_SCANLINE tree.*bsp" "$scenes/knot.obj" "" ""
way "32 bits" alike "LIM_SCANLINE" "$scenes/knot.obj" "--coordinates 32" ""
way "a mesh by distance" alike "LIM_MESH$" ball.obj "" ""
way "a mesh by depth" alike "LIM_MESH_DEPTH$" grains.obj "" ""
way "mesh leaves" alike "dense.parts.of" inside.obj "" ""
way "no mesh leaves" alike "LIM_" inside.obj "--mesh-leaves none" ""
way "a set" alike "LIM_NEWELL" "$scenes/knot.obj" "--tree none" ""
way "glass" alike "LIM_NEAREST_FIRST" "$scenes/glass.obj" "" ""
way "what moves stands still" alike "LIM_SCANLINE" "$scenes/movers.gltf" "--movers off" ""
way "profile exact" alike "LIM_NEAREST_FIRST" "$scenes/rooms.obj" "" "--precision exact"
way "profile draft" alike "LIM_" ball.obj "" "--precision draft"
way "outlines" alike "LIM_NEAREST_FIRST" "$scenes/knot.obj" "" "--wireframe"
way "smooth edges" alike "LIM_SCANLINE" "$scenes/knot.obj" "" "--antialias"
way "changes alone" alike "LIM_NEAREST_FIRST" "$scenes/knot.obj" "" "--delta"
way "the cameras that a program has" alike "LIM_" "$scenes/teapot.obj" "--path $scenes/teapot.cam" ""
way "one convex solid on a black and white panel" alike "LIM_CONVEX" "$scenes/icosahedron.obj" "" "--panel ssd1306"

# What moves is in no .lim; the methods are told apart by what they count.
moves_alike() {
    method=$("$limner" compile "$scenes/movers.gltf" -o moving >/dev/null && awk '/_SCENE_METHOD/ { print tolower(substr($3, 5)) }' moving.h)
    [ "$method" = scanline ] || return 1
    "$limner" render "$scenes/movers.gltf" --frames 4 --size 96x64 --stats --write-hashes chosen.hashes >chosen 2>/dev/null &&
        "$limner" render "$scenes/movers.gltf" --method scanline --frames 4 --size 96x64 --stats --write-hashes named.hashes >named 2>/dev/null &&
        "$limner" render "$scenes/movers.gltf" --method nearest --frames 4 --size 96x64 --stats >otherwise 2>/dev/null &&
        diff chosen named && diff chosen.hashes named.hashes && ! cmp -s chosen otherwise
}
tap_check "what moves is drawn by the method that the header names" moves_alike

judged() {
    "$limner" compile ball.obj -o judged --size 64x64 >/dev/null 2>&1 &&
        "$limner" render judged.lim --camera random:3:6 --size 64x64 --stats >flashed 2>/dev/null &&
        "$limner" render ball.obj --camera random:3:6 --size 64x64 --stats --compare >both 2>/dev/null &&
        rows=$(wc -l <flashed) && [ "$rows" -gt 6 ] && [ "$(wc -l <both)" -gt "$rows" ] && head -n "$rows" both >begin &&
        diff begin flashed
}
tap_check "--compare judges what is flashed" judged

same_everywhere() { # worst and report take the same method as compile
    "$limner" worst grains.obj --tries 40 2>/dev/null | head -n 1 | tee said | grep -q 'as a mesh, by depth'
}
tap_check "worst searches in what is flashed" same_everywhere

# Eyes that 16 bits cannot have: all who are given them compile for them.
echo '0 3000 4000 0 0 0' >far.cam
sees_far() { # COMMAND OPTION...
    "$limner" "$@" >said 2>&1 || { cat said; return 1; }
}
for far in 'render --frames 1 -o far.png' 'measure --no-cost --precision fast -o far' 'compare --no-cost' 'report --tries 20 -o far.html'; do
    # shellcheck disable=SC2086 # words
    tap_check "${far%% *} draws for far eyes" sees_far $far "$scenes/icosahedron.obj" --fov 3 --camera far.cam
done
bounded_from_afar() {
    sees_far compile "$scenes/icosahedron.obj" --fov 3 --camera far.cam --max-error 0.05% -o far && grep 'LIM_HAS_LONG 1' far.h &&
        "$limner" render far.lim --fov 3 --camera far.cam -o far.png
}
tap_check "compile finds a precision for them, and writes that scene" bounded_from_afar

# Remembered -----------------------------------------------------------------------------------------------

mkdir remembered
with_cache() { XDG_CACHE_HOME=$work/remembered "$limner" "$@"; }
entries() { find remembered/limner -type f | wc -l; }

remembers() {
    "$limner" compile small.obj -o fresh >/dev/null 2>&1 && with_cache compile small.obj -o first >/dev/null 2>&1 && [ "$(entries)" -eq 1 ] &&
        with_cache compile small.obj -o again --report >said 2>&1 && cat said && cmp fresh.lim first.lim && cmp first.lim again.lim &&
        sed 's/first/again/g; s/FIRST/AGAIN/g' first.h | diff - again.h && [ "$(entries)" -eq 1 ]
}
tap_check "a decision is taken once, and what is written is the same" remembers

# By the time of the last reading, where the file system keeps it.
forget_readings() { find remembered/limner -type f -exec touch -a -d 2001-01-01 {} +; }
was_read() { [ "$(find remembered/limner -type f -anewer old | wc -l)" -eq 1 ]; }
touch -a -m -d 2002-01-01 old
forget_readings && cat remembered/limner/* >read_once
if was_read; then
    tap_check "the second time it is read" eval 'forget_readings && with_cache compile small.obj -o again >said 2>&1 && was_read'
else
    tap_skip "the second time it is read" "this file system keeps no times of reading"
fi

for_others() {
    with_cache render small.obj --frames 1 -o one.png 2>/dev/null >/dev/null && [ "$(entries)" -eq 1 ]
}
tap_check "render takes what compile decided" for_others

by_content() {
    sed 's/^v 0\.0* 1\.0* .*/v 0 1.3 0/; 1,1s/.*/v 0 1.2 0/' small.obj >other.obj && cp small.obj copy.obj &&
        with_cache compile copy.obj -o copy >/dev/null 2>&1 && [ "$(entries)" -eq 1 ] &&
        with_cache compile other.obj -o other >/dev/null 2>&1 && [ "$(entries)" -eq 2 ] && ! cmp -s other.lim first.lim &&
        with_cache compile small.obj -o wide --size 320x200 >/dev/null 2>&1 && [ "$(entries)" -eq 3 ]
}
tap_check "a model's content and options are what counts, not its name" by_content

companions() {
    cp "$scenes/glass.obj" "$scenes/glass.mtl" . && with_cache compile glass.obj -o glass1 >/dev/null 2>&1 &&
        sed 's/^Kd .*/Kd 0.1 0.9 0.1/' "$scenes/glass.mtl" >glass.mtl && with_cache compile glass.obj -o glass2 >/dev/null 2>&1 &&
        "$limner" compile glass.obj -o glass3 >/dev/null 2>&1 && cmp glass2.lim glass3.lim && ! cmp -s glass1.lim glass2.lim
}
tap_check "files that a model names count, too" companions

damaged() {
    for entry in remembered/limner/*; do
        case $(($(wc -l <tried) % 3)) in
        0) head -c 100 "$entry" >part && cp part "$entry" ;;
        1) truncate -s 0 "$entry" ;;
        2) printf 'x' | dd of="$entry" bs=1 seek=200 conv=notrunc 2>/dev/null ;;
        esac
        echo "$entry" >>tried
    done
    with_cache compile small.obj -o mended >/dev/null 2>&1 && cmp mended.lim first.lim &&
        with_cache compile other.obj -o mended >/dev/null 2>&1 && cmp mended.lim other.lim
}
: >tried
tap_check "damaged entries are ignored" damaged

none_there() {
    XDG_CACHE_HOME=/nonexistent "$limner" render small.obj --frames 1 -o none.png >said 2>&1 && cmp none.png one.png && ! grep -i cache said &&
        env -u XDG_CACHE_HOME HOME=/nonexistent "$limner" render small.obj --frames 1 -o none.png >said 2>&1 && ! grep -i cache said
}
tap_check "without a folder nothing is remembered, and nothing said" none_there

cut_short() {
    rm -r remembered/limner
    with_cache compile grains.obj -o cut --time-limit 1 >/dev/null 2>&1
    [ ! -d remembered/limner ] || [ "$(entries)" -eq 0 ]
}
tap_check "what the time cut short is not remembered" cut_short

tap_done
