# SPDX-License-Identifier: MIT
#
# `limner worst`: what it finds is drawn by render and judged by measure as it says, is worse than random cameras, and the
# same every time; `compile --worst` makes pools that hold it, and says so in NAME.h; refusals leave nothing.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
scenes=$(pwd)/sim/scenes
firmware=$(pwd)/firmware
cd "$work" || exit 1
export LIMNER_TIME_LIMIT=0

# A field of 12 x 12 boxes in a corner of a wide ground: what costs most is seen from few places.
awk 'BEGIN {
    print "v -40 0 40\nv 40 0 40\nv 40 0 -40\nv -40 0 -40\nf 1 2 3 4"
    for (i = 0; i < 144; i++) {
        x = 25 + i % 12; z = 25 + int(i / 12); n = 8 * i + 5
        for (y = 0; y < 2; y++) {
            h = y * (0.5 + i % 5 / 4)
            print "v", x, h, z + 0.6 "\nv", x + 0.6, h, z + 0.6 "\nv", x + 0.6, h, z "\nv", x, h, z
        }
        for (k = 0; k < 4; k++) print "f", n + k, n + (k + 1) % 4, n + 4 + (k + 1) % 4, n + 4 + k
        print "f", n + 4, n + 5, n + 6, n + 7
    }
}' >field.obj

worst() { # MODEL NAME [OPTION...]: says what it finds in NAME.said, and writes found/NAME...
    model=$1 name=$2
    shift 2
    "$limner" worst "$model" --tries 600 -o "found/$name" "$@" >"$name.said" && cat "$name.said"
}

number_behind() { # WORDS FILE: the number after or before them
    sed -n "s/.*$1 \([0-9.]*\).*/\1/p" "$2" | head -n 1
}

is_whole() { # NAME
    ls found/"$1"* && [ "$(find found -name "$1*" | wc -l)" -eq 4 ] && ! find found -name '*.part' | grep . &&
        [ "$(grep -vc '^#' "found/$1.cam")" -eq 2 ] && grep -q 'searched, not proved' "found/$1.cam" "$1.said" &&
        [ "$(grep -c 'cameras tried' "$1.said")" -eq 2 ] && ! grep -q 'in the time' "$1.said"
}

hash_of() { "$limner" hashes "$1" | sed 's/.*hash \([0-9a-f]*\).*/\1/'; }

# The compiler may have chosen another method than render draws by: the picture is the same.
is_what_render_draws() { # MODEL NAME
    "$limner" render "$1" --camera "found/$2.cam" -o 'drawn/%d.png' &&
        [ "$(hash_of drawn/0.png)" = "$(hash_of "found/$2-cost.png")" ] && [ "$(hash_of drawn/1.png)" = "$(hash_of "found/$2-error.png")" ] &&
        [ "$(hash_of drawn/0.png)" != "$(hash_of drawn/1.png)" ]
}

# measure's comparison is another program's part; of the two frames the one that errs most.
is_what_measure_finds() { # MODEL NAME
    "$limner" measure "$1" --camera "found/$2.cam" --no-cost --precision fast >measured || return 1
    sed -n 's/^errs most: [0-9]* wrong pixels, \([0-9.]*\) %/\1/p' "$2.said" >said
    awk -F '|' '$2 ~ /fast/ { gsub(/ |\([0-9]*\)/, ""); print $5 }' measured >found_percent
    cat said found_percent && [ -s said ] && diff said found_percent
}

for scene in rooms teapot; do
    tap_check "$scene: cameras, pictures, words" worst "$scenes/$scene.obj" "$scene"
    tap_check "$scene: all files" is_whole "$scene"
    tap_check "$scene: render draws the same" is_what_render_draws "$scenes/$scene.obj" "$scene"
    tap_check "$scene: measure finds as many wrong pixels" is_what_measure_finds "$scenes/$scene.obj" "$scene"
done

costs_what_render_predicts() {
    "$limner" render "$scenes/rooms.obj" --camera found/rooms.cam --frames 1 --stats -o one.png >stats &&
        [ "$(number_behind 'costs most:' rooms.said)" = "$(sed -n 's/^predicted.*: \([0-9]*\) .*/\1/p' stats)" ]
}
tap_check "rooms: render --stats predicts the same instructions" costs_what_render_predicts

# By columns of --stats.
column() { # NAME FILE: of its frames
    awk -v name="$1" '$1 == "frame" { for (i = 1; i <= NF; i++) if ($i == name) at = i } at && $1 ~ /^[0-9]+$/ { print $at }' "$2"
}
# What each of 24 random cameras costs that nothing was searched on: render says the mean of the first ones.
predicted() { sed -n 's/^predicted.*: \([0-9]*\) .*/\1/p' "$1"; }
costs_most() {
    worst field.obj field --method nearest && "$limner" render field.obj --camera found/field.cam --frames 1 --stats -o one.png >one || return 1
    before=0
    for frames in $(seq 24); do
        "$limner" render field.obj --camera random:99 --frames "$frames" --stats -o 'random/%d.png' >many || return 1
        all=$(($(predicted many) * frames))
        echo "$(predicted one) against $((all - before))"
        [ "$(predicted one)" -gt $((all - before)) ] || return 1
        before=$all
    done
}
tap_check "a field of boxes: it costs more than any of 24 random cameras" costs_most

errs_more_than_random() {
    "$limner" measure "$scenes/rooms.obj" --camera random:4:48 --no-cost --precision fast >measured
    awk -F '|' -v found="$(sed -n 's/^errs most: .* \([0-9.]*\) %/\1/p' rooms.said)" \
        '$2 ~ /fast/ { sub(/\([0-9]*\)/, "", $5); print found, $5; ok = found + 0 > $5 + 0 } END { exit !ok }' measured
}
tap_check "rooms: more wrong pixels than in any of 48 random views" errs_more_than_random

same_again() {
    cp rooms.said first && cp found/rooms.cam first.cam && worst "$scenes/rooms.obj" rooms && diff first rooms.said && diff first.cam found/rooms.cam &&
        worst "$scenes/rooms.obj" seeded --seed 1 && ! diff first.cam found/seeded.cam
}
tap_check "the same every time, and another with another seed" same_again

# -- Time --------------------------------------------------------------------------------------------------------------
bound_by_time() {
    LIMNER_TIME_LIMIT='' timeout 60 "$limner" worst "$scenes/rooms.obj" --seconds 1 --tries 1000000 >said && cat said &&
        [ "$(grep -c 'in the time that there was' said)" -eq 2 ]
}
tap_check "--seconds ends it" bound_by_time
bound_by_tries() {
    timeout 60 "$limner" worst "$scenes/icosahedron.obj" >said && grep -q ' 2000 cameras tried$' said && ! grep -q 'in the time' said
}
tap_check "without a time limit tries alone do" bound_by_tries
shows_progress() {
    script -qec "$limner worst $scenes/rooms.obj --tries 200" /dev/null >out </dev/null
    grep -q 'what costs most, camera' out && grep -q 'what errs most, camera' out
}
tap_on_terminal "a line of progress on a terminal" shows_progress

# -- What moves --------------------------------------------------------------------------------------------------------
tap_check "movers: cameras, pictures, words" worst "$scenes/movers.gltf" movers
tap_check "movers: all files" is_whole movers
tap_check "movers: render draws them at their moments" is_what_render_draws "$scenes/movers.gltf" movers
has_times() { [ "$(grep -c ' @[0-9.]*$' found/movers.cam)" -eq 2 ] && [ "$(grep -c @ found/rooms.cam)" -eq 0 ]; }
tap_check "movers: each camera has its time" has_times

# -- compile --worst ---------------------------------------------------------------------------------------------------
compiles_both() {
    "$limner" compile "$scenes/rooms.obj" -o plain --report >plain.said && "$limner" compile "$scenes/rooms.obj" --worst=600 -o worse --report >worse.said &&
        "$limner" compile "$scenes/rooms.obj" --worst=600 -o again --report >again.said && cmp worse.lim again.lim
}
tap_check "compile --worst, the same every time" compiles_both
memory_of() { sed -n 's/^  working memory, bytes *//p' "$1"; }
takes_more() { [ "$(memory_of worse.said)" -gt "$(memory_of plain.said)" ] && ! grep -q WORST plain.h; }
tap_check "its pools are larger, and without it nothing is said" takes_more

# The camera that plain pools are too short for: bands there, none with the others, and the same picture.
walks_once() {
    for scene in plain worse; do
        "$limner" render "$scene.lim" --camera found/rooms.cam --frames 1 --stats --write-hashes "$scene.hashes" >"$scene.stats" || return 1
        column bands "$scene.stats"
    done
    [ "$(column bands plain.stats)" -gt 0 ] && [ "$(column bands worse.stats)" -eq 0 ] && cmp plain.hashes worse.hashes
}
tap_check "the worst view takes one walk with them" walks_once

# NAME.h's camera is that of the report, and a firmware draws with it what render draws.
cat >main.c <<'END'
#include "worse.h"
#include <stdio.h>
WORSE_MEMORY(240, 240);
static int put(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)pixels, (void)x_px, (void)n_px;
    return 0;
}
int main(void)
{
    struct lim_camera camera = {.eye_q8 = WORSE_WORST_EYE_Q8, .yaw = WORSE_WORST_YAW, .pitch = WORSE_WORST_PITCH};
    int err = worse_begin(&worse_memory, put, NULL);
    if (!err) err = lim_camera_set_fov(&camera, LIM_DEGREES(60), 240, 240);
    camera.near_q8 = WORSE_M_Q8(0.1);
    if (!err) err = lim_frame(worse_memory.lim, &camera);
    const struct lim_stats *stats = lim_stats(worse_memory.lim);
    printf("%d %d %u %u %u %u\n", err, (int)stats->bands, (unsigned)stats->polygons_seen, (unsigned)stats->vertices,
           (unsigned)stats->nodes, (unsigned)stats->lines);
    printf("%d %d %d %d\n", WORSE_WORST_M0PLUS_INSTRUCTIONS, WORSE_WORST_CELLS, WORSE_WORST_GAPS, WORSE_WORST_ACTIVE);
    return err != 0;
}
END
firmware_draws_it() {
    sed -n 's/^    camera: //p' worse.said >report.cam && [ "$(wc -w <report.cam)" -eq 6 ] || return 1
    ${CC:-gcc} -std=c11 -O1 -I"$firmware" -I. -DLIM_HAS_STATS=1 -DLIM_CONFIG='"worse.h"' main.c worse.c "$firmware"/*.c "$firmware"/*/*.c -o main &&
        ./main >drawn_by && cat drawn_by && "$limner" render worse.lim --camera report.cam --stats -o one.png >stats || return 1
    printf '0 0 %s %s %s %s\n' "$(column seen stats)" "$(column vertices stats)" "$(column nodes stats)" "$(column lines stats)" >expected
    head -n 1 drawn_by | diff expected - &&
        [ "$(sed -n 's/^    instructions *\([0-9]*\) on.*/\1/p' worse.said)" = "$(tail -n 1 drawn_by | cut -d ' ' -f 1)" ] &&
        [ "$(sed -n 's/^predicted.*: \([0-9]*\) .*/\1/p' stats)" = "$(tail -n 1 drawn_by | cut -d ' ' -f 1)" ]
}
tap_check "a firmware draws NAME_WORST_..., and takes what the report says" firmware_draws_it
other_scenes_take_it() {
    for scene in teapot icosahedron glass movers; do
        file=$(ls "$scenes/$scene".obj "$scenes/$scene".gltf 2>/dev/null)
        "$limner" compile "$file" --worst=200 -o "other_$scene" --report >said && grep -q 'cameras searched, not proved' said && grep -q _WORST_YAW "other_$scene.h" &&
            ${CC:-gcc} -std=c11 -fsyntax-only -I"$firmware" -I. -DLIM_CONFIG="\"other_$scene.h\"" "other_$scene.c" || return 1
    done
    grep -q OTHER_MOVERS_WORST_TIME_MS other_movers.h
}
tap_check "scenes of other methods, of glass and with movers have it, too" other_scenes_take_it

# -- Refusals ----------------------------------------------------------------------------------------------------------
refuses() { # WORDS OPTION...
    words=$1
    shift
    rm -rf left && mkdir left && cp "$scenes/icosahedron.obj" left/ && (cd left && timeout 60 "$limner" "$@" >../out 2>../said)
    status=$?
    cat said
    [ "$status" -eq 1 ] && [ ! -s out ] && [ "$(wc -l <said)" -eq 1 ] && grep -qF -- "$words" said && [ "$(ls left)" = icosahedron.obj ]
}
for bad in '--tries 0' '--tries x' '--tries 1.5' '--seconds -1' '--seconds nan' '--seed -1' '--seed 4294967296' '--camera random:1' '--no-cost' '--frames 3'; do
    # shellcheck disable=SC2086 # an option and its value
    tap_check "$bad is refused" refuses "${bad%% *}" worst icosahedron.obj -o x/y $bad
done
tap_check "two precisions are refused" refuses 'one --precision' worst icosahedron.obj --precision fast,fine
tap_check "a model that is not there is refused" refuses none.obj worst none.obj -o x/y
tap_check "a compiled scene is refused" refuses 'compiled scene' worst x.lim -o x/y
tap_check "a folder that cannot be is refused before the search" refuses icosahedron.obj worst icosahedron.obj -o icosahedron.obj/x
tap_check "--worst=0 is refused" refuses --worst compile icosahedron.obj --worst=0 -o x
# What measures sees the objects where render draws them: the same pixels are wrong, and others than without the times.
times_count() {
    cp found/movers.cam timed.cam && sed 's/ @.*//' timed.cam >untimed.cam
    for path in timed untimed; do
        "$limner" render "$scenes/movers.gltf" --camera $path.cam --size 240x240 --method scanline --compare -o "$path%d.png" 2>said |
            sed -n 's/.*frames*, wrong \([0-9.]*\) %.*/\1/p' >$path.drawn || return 1
        "$limner" measure "$scenes/movers.gltf" --camera $path.cam --method scanline --precision fast --no-cost -o $path >said 2>&1 &&
            awk -F , 'NR == 2 { printf "%.4f\n", $7 }' $path/measure.csv >$path.measured || { cat said; return 1; }
        cat $path.drawn $path.measured
    done
    [ -s timed.drawn ] && diff timed.drawn timed.measured && ! cmp -s timed.measured untimed.measured
}
tap_check "cameras with times are measured at these" times_count
times_are_no_players() {
    "$limner" view "$scenes/movers.gltf" --camera timed.cam >out 2>said && return 1
    cat said && grep -qx 'limner: timed.cam:3: a camera with a time, which this command does not draw' said
}
tap_check "whoever has a clock of its own refuses them" times_are_no_players
tap_done
