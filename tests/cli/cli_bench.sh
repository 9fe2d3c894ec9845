# SPDX-License-Identifier: MIT
#
# What `make bench` counted is compared with the baseline, and nothing is passed over in silence; the tables are the
# baseline's; random cameras are the same every time.
. tests/tap.sh

rows() { # MEAN WORST STAGE-MEAN
    cat <<END
core,scene,size,path,stage,mean,worst
all,box,8x8,own,wrong_percent,0.0100,0.0500
host,box,8x8,own,frame,$1,$2
host,box,8x8,own,span,$3,600
host,box,8x8,own,eye,2.0,2
all,box,8x8,-,faces,12,12
END
}

# baseline_of MEAN WORST STAGE-MEAN: what later compare against.
rows 1000.0 1200 500.0 >"$work/same.csv"
sh sim/tools/bench_compare.sh --baseline "$work/same.csv" >"$work/baseline.csv"

compare() { # STATUS CSV [PATTERN]: and what is said, in $work/said
    expected=$1
    shift
    status=0
    sh sim/tools/bench_compare.sh "$work/baseline.csv" "$@" >"$work/said" || status=$?
    cat "$work/said"
    [ $status -eq "$expected" ]
}

says() { # PATTERN
    grep -qE "$1" "$work/said"
}

same_is_same() { compare 0 "$work/same.csv" && says '^4 rows compared, 0 fell, 0 grew$'; }

growth_fails() {
    rows 1011.0 1200 500.0 >"$work/new.csv"
    compare 1 "$work/new.csv" && says '^GREW +host,box,8x8,own,frame: 1000.0 -> 1011.0 \(\+1.1 %\)'
}

worst_growth_fails() {
    rows 1000.0 1213 500.0 >"$work/new.csv"
    compare 1 "$work/new.csv" && says '^GREW +host,box,8x8,own,frame: .*worst 1200 -> 1213 \(\+1.1 %\)'
}

wrong_growth_fails() {
    rows 1000.0 1200 500.0 | sed 's/0.0100/0.0102/' >"$work/new.csv"
    compare 1 "$work/new.csv" && says '^GREW +all,box,8x8,own,wrong_percent: 0.0100 -> 0.0102'
}

little_passes() {
    rows 1009.0 1188 500.0 >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^4 rows compared, 0 fell, 0 grew$'
}

shrinkage_is_shown() {
    rows 900.0 1200 500.0 >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^fell +host,box,8x8,own,frame: 1000.0 -> 900.0 \(-10.0 %\)'
}

stages_may_grow() {
    rows 1000.0 1200 600.0 >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^stage grew +host,box,8x8,own,span: 500.0 -> 600.0'
}

small_stages_are_left_out() { ! grep -q ',eye,' "$work/baseline.csv" && grep -q ',span,' "$work/baseline.csv"; }

missing_frames_fail() {
    grep -v ',frame,' "$work/same.csv" >"$work/new.csv"
    compare 1 "$work/new.csv" && says '^missing +host,box,8x8,own,frame$'
}

gone_stages_are_told() {
    grep -v ',span,' "$work/same.csv" >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^gone +host,box,8x8,own,span'
}

new_rows_are_told() {
    { cat "$work/same.csv"; echo host,box,16x16,own,frame,5.0,6; } >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^new +host,box,16x16,own,frame'
}

only_what_is_asked_for() {
    grep -v '^all' "$work/same.csv" >"$work/new.csv"
    compare 0 "$work/new.csv" '^host,' && says '^2 rows compared' && compare 1 "$work/new.csv" '.'
}

no_row_is_no_success() {
    head -n 1 "$work/same.csv" >"$work/new.csv"
    compare 1 "$work/new.csv" && compare 77 "$work/new.csv" '^m7,' && says '^nothing was compared$'
}

broken_rows_fail() {
    { cat "$work/same.csv"; echo host,box,8x8,own,paint,900; } >"$work/new.csv"
    compare 1 "$work/new.csv" && says 'not a row of seven fields: host,box,8x8,own,paint,900$'
}

no_baseline() {
    ! sh sim/tools/bench_compare.sh "$work/none.csv" "$work/same.csv" >"$work/said" && cat "$work/said" &&
        says "^no baseline $work/none.csv: .make bench-baseline. writes it$"
}

# Only what needs no compiler can be compared then.
other_compilers_are_skipped() {
    cp "$work/baseline.csv" "$work/kept.csv"
    sed -i 's/^# host: .*/# host: cc 1.0/' "$work/baseline.csv"
    rows 5000.0 5200 500.0 >"$work/new.csv"
    compare 0 "$work/new.csv" && says '^skipped +host: counted with cc 1.0, but here is ' && says '^2 rows compared' &&
        compare 77 "$work/new.csv" '^host,'
    passed=$?
    sed -i '/^# host/d' "$work/baseline.csv"
    compare 0 "$work/new.csv" && says '^skipped +host: counted with a compiler that nobody named' || passed=1
    cp "$work/kept.csv" "$work/baseline.csv"
    return $passed
}

# -- What is committed --------------------------------------------------------------------------------------------

# Every frame that is promised, once, and no row that is not one.
baseline_is_whole() {
    grep -v '^#' sim/tools/bench.baseline.csv >"$work/rows.csv"
    awk -F , '
        NR == 1 { if ($0 != "core,scene,size,path,stage,mean,worst") bad = "header"; next }
        NF != 7 || $6 !~ /^[0-9]+(\.[0-9]+)?$/ || $7 !~ /^[0-9]+(\.[0-9]+)?$/ || $7 + 0 < $6 + 0 { bad = $0 }
        seen[$1, $2, $3, $4, $5]++ { bad = "twice: " $0 }
        $5 == "frame" { frames++ }
        END {
            split("m0plus m3 m4 m33 rv32 host", cores, " "); split("rooms teapot demo mesh5000", scenes, " ")
            for (c in cores) for (s in scenes) for (z = 0; z < 2; z++) for (p = 0; p < 2; p++) {
                key = cores[c] SUBSEP scenes[s] SUBSEP (z ? "240x240" : "128x64") SUBSEP (p ? "own" : "random") SUBSEP "frame"
                if (!(key in seen)) bad = "no frame of " cores[c] ", " scenes[s]
            }
            for (c in cores) for (s = 1; s <= 2; s++) for (p = 0; p < 2; p++) {
                key = cores[c] SUBSEP scenes[s] SUBSEP "128x64-framebuffer" SUBSEP (p ? "own" : "random") SUBSEP "frame"
                if (!(key in seen)) bad = "no frame of " cores[c] ", " scenes[s] ", framebuffer"
            }
            if (bad) print bad
            exit bad != "" || frames != 120
        }' "$work/rows.csv" && [ "$(grep -c '^# [a-z0-9]*: .*[0-9]' sim/tools/bench.baseline.csv)" -eq 6 ]
}

tables_need_their_rows() {
    grep -v '^m4,rooms' sim/tools/bench.baseline.csv >"$work/new.csv"
    ! BENCH_CSV=$work/new.csv sh sim/tools/tables.sh peers >"$work/said" 2>"$work/err" && cat "$work/err" &&
        [ ! -s "$work/said" ] && grep -q '^no row m4,rooms,240x240,own,frame' "$work/err"
}

# -- Callgrind's profiles -----------------------------------------------------------------------------------------

# A renderer's function with another one inlined, its call of the target, which is not counted, and the C library's.
profile() { # SELF
    cat <<END
fl=/x/firmware/lines/span.c
fn=lim_span
10 $1
fi=/x/firmware/math/fixed.h
11 5
fe=/x/firmware/lines/span.c
cfi=/x/sim/targets/frames.c
cfn=done
calls=3 20
12 7000

fl=/x/firmware/frame.c
fn=lim_frame
10 1

fl=/x/sim/targets/frames.c
fn=done
20 7000

fl=???
fn=memset
0 400
END
}

own_functions_are_counted() {
    profile 100 >"$work/callgrind.1"
    profile 300 >"$work/callgrind.2"
    awk -f sim/tools/bench_host.awk "$work/callgrind.1" "$work/callgrind.2" >"$work/counted"
    printf 'frame 206.0 306\nframe.c 1.0 1\nspan 205.0 305\n' | diff - "$work/counted"
}

no_frame_is_an_error() {
    grep -v firmware "$work/callgrind.1" >"$work/callgrind.3"
    ! awk -f sim/tools/bench_host.awk "$work/callgrind.3" 2>"$work/err" && grep -q 'not one frame' "$work/err"
}

# -- Random cameras -----------------------------------------------------------------------------------------------

draw() { # SEED NAME
    "$BUILD/limner" render sim/scenes/rooms.obj --camera "random:$1" --size 32x32 --write-hashes "$work/$2"
}

random_is_the_same_again() {
    draw 5:4 first && draw 5:4 again && draw 6:4 other && diff "$work/first" "$work/again" &&
        ! diff "$work/first" "$work/other" && [ "$(grep -c . "$work/first")" -eq 4 ]
}

# Also without a model: the tree is in the file.
random_of_a_compiled_scene() {
    "$BUILD/limner" compile sim/scenes/rooms.obj -o "$work/rooms" >"$work/report" &&
        "$BUILD/limner" render "$work/rooms.lim" --camera random:5:4 --size 32x32 --write-hashes "$work/compiled" &&
        diff "$work/first" "$work/compiled"
}

random_is_measured() {
    "$BUILD/limner" measure sim/scenes/rooms.obj --camera random:5:3 --size 32x32 --precision fast --no-cost >"$work/said" &&
        says '^# rooms, 32x32 pixels, 3 frames$' &&
        "$BUILD/limner" compile sim/scenes/rooms.obj --max-error 1% --camera random:5:3 -o "$work/chosen" >"$work/said" &&
        says 'random:5:3'
}

refuses() { # SEED
    ! draw "$1" refused 2>"$work/err" && cat "$work/err" && grep -q '^limner: --camera random:SEED' "$work/err" &&
        [ ! -e "$work/refused" ]
}

tap_check "the same counts are no change" same_is_same
tap_check "a frame that grew by more than 1 % fails" growth_fails
tap_check "so does a worst frame" worst_growth_fails
tap_check "and more wrong pixels" wrong_growth_fails
tap_check "less than 1 % passes" little_passes
tap_check "what fell is shown" shrinkage_is_shown
tap_check "a stage that grew is shown" stages_may_grow
tap_check "stages below a twentieth of the frame are left out" small_stages_are_left_out
tap_check "a missing frame fails" missing_frames_fail
tap_check "a missing stage is told" gone_stages_are_told
tap_check "a new row is told" new_rows_are_told
tap_check "other rows than those asked for are not missed" only_what_is_asked_for
tap_check "comparing nothing is no success" no_row_is_no_success
tap_check "a row that is none fails" broken_rows_fail
tap_check "a missing baseline is told, and fails" no_baseline
tap_check "counts of another compiler are skipped, with the reason" other_compilers_are_skipped
tap_check "the baseline is well formed, and has every frame" baseline_is_whole
tap_check "the pages' tables are the baseline's" \
    sh sim/tools/tables.sh --check figures peers bench bench-stages bench-memory
tap_check "a table whose row is missing is refused" tables_need_their_rows
tap_check "of callgrind's functions the renderer's own are counted" own_functions_are_counted
tap_check "profiles without a frame are an error" no_frame_is_an_error
tap_check "a seed gives the same cameras again, another others" random_is_the_same_again
tap_check "a compiled scene has the same" random_of_a_compiled_scene
tap_check "they are measured, and chosen for" random_is_measured
for seed in '' x -1 1: 1:0 1:2:3; do
    tap_check "random:$seed is refused" refuses "$seed"
done
tap_done
