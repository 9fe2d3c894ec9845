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
sh sim/tools/bench_compare.sh --baseline "$work/none.csv" "$work/same.csv" >"$work/baseline.csv"

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

# Of some scenes alone: other scenes' rows and all reasons stay.
part_is_written() {
    { rows 700.0 800 300.0 | sed 's/,box,/,ball,/'; rows 900.0 1000 400.0 | sed 1d; } >"$work/two.csv"
    {
        sed -n '/^#/p' "$work/baseline.csv"
        echo '# lost a row: a reason'
        grep -v '^#' "$work/two.csv" | grep -v ',eye,'
    } >"$work/before.csv"
    rows 1.0 2 1.0 | sed 's/,box,/,ball,/' >"$work/new.csv"
    sh sim/tools/bench_compare.sh --baseline "$work/before.csv" "$work/new.csv" '^[^,]*,(ball),' >"$work/after.csv" &&
        grep -q '^# lost a row: a reason$' "$work/after.csv" && grep -q '^host,box,8x8,own,frame,900.0,1000$' "$work/after.csv" &&
        grep -q '^host,ball,8x8,own,frame,1.0,2$' "$work/after.csv" && ! grep -q 700.0 "$work/after.csv" &&
        [ "$(grep -c '^core,' "$work/after.csv")" -eq 1 ]
}

part_of_others_counts_is_refused() {
    sed 's/^# host: .*/# host: cc 1.0/' "$work/before.csv" >"$work/others.csv"
    ! sh sim/tools/bench_compare.sh --baseline "$work/others.csv" "$work/new.csv" '^[^,]*,(ball),' 2>"$work/err" >"$work/out" &&
        grep -q 'counted with other compilers' "$work/err"
}

# -- Against other renderers --------------------------------------------------------------------------------------

# peers STATUS MEAN WORST [REASON]: of one row, in which the best other takes 1000 and 1200 thousand.
peers() {
    expected=$1
    {
        echo "${4:-# nothing}"
    } >"$work/reasons"
    echo 'a box | m4 | box | 8x8 | frame | 1000 | other | 1000 | 1200 | 500 | -' >"$work/peers"
    echo "m4,box,8x8,own,frame,$2,$3" >"$work/counted"
    status=0
    awk -f sim/tools/bench_peers.awk "$work/reasons" "$work/peers" "$work/counted" >"$work/said" || status=$?
    cat "$work/said"
    [ $status -eq "$expected" ]
}

won_is_silent() { peers 0 999000 1200000 && [ ! -s "$work/said" ]; }
lost_fails() { peers 1 1001000 1100000 && says '^LOST +a box: 1001 / 1100, other: 1000 / 1200; the baseline has no reason$'; }
lost_by_worst_fails() { peers 1 900000 1201000 && says '^LOST +a box: '; }
reason_passes() { peers 0 1001000 1100000 '# lost a box: it is round' && says '^lost +a box: .*; it is round$'; }
reason_of_won_is_told() { peers 0 900000 1100000 '# lost a box: it is round' && says '^won +a box: .*it is round$'; }
reason_of_no_row_fails() { peers 1 900000 1100000 '# lost a bix: it is round' && says '^no row +a bix: '; }

baseline_has_all_reasons() {
    sh sim/tools/bench_compare.sh --peers sim/tools/bench.baseline.csv sim/tools/bench.baseline.csv
}

every_peer_is_of_the_bench() { # its scene is counted, or it is a dash
    grep -v '^#' sim/tools/tables/peers.txt | awk -F ' *[|] *' '$3 != "-" { print $2 "," $3 "," $4 "," }' | sort -u |
        while read -r place; do
            grep -q "^$place" sim/tools/bench.baseline.csv || { echo "no row $place"; exit 1; }
        done
}

# -- Scenes that are made for it ----------------------------------------------------------------------------------

u16() { # NUMBER...
    for number; do
        # shellcheck disable=SC2059 # it is bytes
        printf "\\$(printf %03o $((number & 255)))\\$(printf %03o $((number >> 8 & 255)))"
    done
}

u32() {
    for number; do u16 $((number & 65535)) $((number >> 16 & 65535)); done
}

text8() { # a name, and zeros up to eight bytes
    printf %s "$1"
    head -c $((8 - ${#1})) /dev/zero
}

# One room of 128 x 128 units, 96 high, cut by a node in its middle; its walls face inwards. LINEDEF: what the first has
# for a side.
room_lumps() { # FOLDER [SIDE]
    u16 64 32 90 1 7 >"$1/THINGS"
    { u16 0 1 0 0 0 "${2:-0}" 65535; for i in 1 2 3; do u16 $i $(((i + 1) % 4)) 0 0 0 $i 65535; done; } >"$1/LINEDEFS"
    for i in 0 1 2 3; do u16 0 0; text8 -; text8 -; text8 STONE; u16 0; done >"$1/SIDEDEFS"
    u16 0 0 0 128 128 128 128 0 >"$1/VERTEXES"
    for i in 0 1 2 3; do u16 $i $(((i + 1) % 4)) 0 $i 0 0; done >"$1/SEGS"
    u16 4 0 >"$1/SSECTORS"
    u16 64 0 0 128 0 0 0 0 0 0 0 0 32768 32768 >"$1/NODES"
    { u16 0 96; text8 FLOOR; text8 CEIL; u16 255 0 0; } >"$1/SECTORS"
}

make_wad() { # FILE MAP FOLDER
    kinds='THINGS LINEDEFS SIDEDEFS VERTEXES SEGS SSECTORS NODES SECTORS'
    {
        printf IWAD
        u32 9
        total=12
        for kind in $kinds; do total=$((total + $(wc -c <"$3/$kind"))); done
        u32 $total
        for kind in $kinds; do cat "$3/$kind"; done
        u32 0 0
        text8 "$2"
        at=12
        for kind in $kinds; do
            size=$(wc -c <"$3/$kind")
            u32 $at "$size"
            text8 $kind
            at=$((at + size))
        done
    } >"$1"
}

# Two halves of a floor and of a ceiling, four walls: 2 m wide, 1.5 m high.
room_becomes_a_model() {
    mkdir "$work/lumps" && room_lumps "$work/lumps" && make_wad "$work/room.wad" MAP01 "$work/lumps" &&
        "$BUILD/generate_bench" level "$work/room" "$work/room.wad" MAP01 && [ "$(grep -c '^f ' "$work/room.obj")" -eq 8 ] &&
        awk '$1 == "v" {
                for (i = 2; i <= 4; i++) { if ($i < least[i]) least[i] = $i; if ($i > most[i]) most[i] = $i }
            }
            END { exit !(most[2] == 2 && most[3] == 1.5 && least[3] == 0 && least[4] == -2 && most[4] == 0) }' "$work/room.obj" &&
        grep -q '^1.000000 0.640625 -0.500000 1.000000 0.640625 -1.500000$' "$work/room.cam" &&
        [ "$(grep -c . "$work/room.cam")" -eq 64 ]
}

# Each face looks at the middle of the room, and all of the room's surface is there.
room_looks_inside() {
    awk '$1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
        $1 == "f" {
            nx = ny = nz = 0
            for (i = 2; i <= NF; i++) {
                a = $i; b = $(i == NF ? 2 : i + 1)
                nx += (y[a] - y[b]) * (z[a] + z[b]); ny += (z[a] - z[b]) * (x[a] + x[b]); nz += (x[a] - x[b]) * (y[a] + y[b])
            }
            if (nx * (1 - x[$2]) + ny * (0.75 - y[$2]) + nz * (-1 - z[$2]) <= 0) { print "looks away: " $0; bad = 1 }
            area += sqrt(nx * nx + ny * ny + nz * nz) / 2
        }
        END { print area; exit bad || area < 19.9999 || area > 20.0001 }' "$work/room.obj"
}

textured_is_the_same_room() {
    cp sim/scenes/mapped/t*.png "$work" && [ "$(grep -c '^f ' "$work/roomtex.obj")" -eq 8 ] &&
        "$BUILD/limner" render "$work/roomtex.obj" --camera "$work/room.cam" --frames 1 --size 64x64 -o "$work/tex%d.ppm" --compare \
            >"$work/said" && cat "$work/said" && says 'holes 0$'
}

refuses_wad() { # WHY FILE MAP
    ! "$BUILD/generate_bench" level "$work/none" "$2" "$3" 2>"$work/err" && cat "$work/err" && grep -q "$1\$" "$work/err" &&
        [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -e "$work/none.obj" ]
}

broken_maps_are_refused() {
    room_lumps "$work/lumps" 9 && make_wad "$work/broken.wad" MAP01 "$work/lumps" &&
        refuses_wad 'the map is broken' "$work/broken.wad" MAP01 && head -c 200 "$work/room.wad" >"$work/short.wad" &&
        refuses_wad 'no such map in this file' "$work/short.wad" MAP01 && refuses_wad 'no such map in this file' "$work/room.wad" MAP02 &&
        refuses_wad 'cannot be read' "$work/no.wad" MAP01
}

# As many triangles as it is named for, and each edge in two of them, once each way.
solid_is_closed() {
    "$BUILD/generate_bench" solid "$work/solid" && cp sim/scenes/mapped/t0.png "$work" && [ "$(grep -c '^f ' "$work/solid.obj")" -eq 3648 ] &&
        for model in solid solidtex; do
            awk '$1 == "f" {
                    for (i = 2; i <= 4; i++) sub("/.*", "", $i)
                    for (i = 2; i <= 4; i++) edge[$i, $(i == 4 ? 2 : i + 1)]++
                }
                END {
                    for (key in edge) { split(key, end, SUBSEP); if (edge[key] != 1 || edge[end[2], end[1]] != 1) exit 1 }
                }' "$work/$model.obj" || return 1
        done
}

orbit_sees_all_of_it() { # the whole model, with a margin
    awk -f sim/scenes/orbit.awk "$work/solid.obj" >"$work/solid.cam" && [ "$(grep -c . "$work/solid.cam")" -eq 64 ] &&
        awk 'NR == FNR && $1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4; next }
            FNR != NR {
                dx = $4 - $1; dy = $5 - $2; dz = $6 - $3; away = sqrt(dx * dx + dy * dy + dz * dz)
                for (i = 1; i <= n; i++) {
                    ahead = ((x[i] - $1) * dx + (y[i] - $2) * dy + (z[i] - $3) * dz) / away
                    far = (x[i] - $1) ^ 2 + (y[i] - $2) ^ 2 + (z[i] - $3) ^ 2 - ahead ^ 2
                    if (ahead <= 0.1 || sqrt(far) / ahead > 0.5774) exit bad = 1
                }
            }
            END { exit bad }' "$work/solid.obj" "$work/solid.cam"
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
            more = split("solid3648tex wuson solid3648 spider map01tex map01 teapot-smooth rooms-smooth teapottex roomstex movers furnished", names, " ")
            for (i = 1; i <= more; i++) for (c = 0; c < 2; c++) for (p = 0; p < 2; p++) {
                key = (c ? "m4" : "m0plus") SUBSEP names[i] SUBSEP "240x240" SUBSEP (p ? "own" : "random") SUBSEP "frame"
                if (!(key in seen)) bad = "no frame of " names[i]
            }
            if (bad) print bad
            exit bad != "" || frames != 120 + 4 * more
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

so_are_those_of_another() {
    awk -v own='/targets/' -f sim/tools/bench_host.awk "$work/callgrind.1" "$work/callgrind.2" >"$work/counted"
    printf 'frame 7000.0 7000\nframes 7000.0 7000\n' | diff - "$work/counted"
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
    "$BUILD/limner" compile sim/scenes/rooms.obj -o "$work/rooms" --report >"$work/report" &&
        "$BUILD/limner" render "$work/rooms.lim" --camera random:5:4 --size 32x32 --write-hashes "$work/compiled" &&
        diff "$work/first" "$work/compiled"
}

random_is_measured() {
    "$BUILD/limner" measure sim/scenes/rooms.obj --camera random:5:3 --size 32x32 --precision fast --no-cost >"$work/said" &&
        says '^# rooms, 32x32 pixels, 3 frames$' &&
        "$BUILD/limner" compile sim/scenes/rooms.obj --max-error 1% --camera random:5:3 -o "$work/chosen" --report >"$work/said" &&
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
tap_check "some scenes are written into a baseline of more" part_is_written
tap_check "not into one of other compilers" part_of_others_counts_is_refused
tap_check "a row that is won against the best peer is silent" won_is_silent
tap_check "a lost row fails" lost_fails
tap_check "so does one that is lost by its worst frame" lost_by_worst_fails
tap_check "a lost row whose reason stands in the baseline passes" reason_passes
tap_check "a reason that is no longer needed is told" reason_of_won_is_told
tap_check "a reason for no row fails" reason_of_no_row_fails
tap_check "the baseline has a reason for each row that is lost" baseline_has_all_reasons
tap_check "every peer stands beside a scene of the baseline" every_peer_is_of_the_bench
tap_check "a map of one room becomes eight faces" room_becomes_a_model
tap_check "they are all of it, seen from inside" room_looks_inside
tap_check "the textured one is the same room" textured_is_the_same_room
tap_check "broken maps are refused, and leave nothing" broken_maps_are_refused
tap_check "the benchmark's solid is closed" solid_is_closed
tap_check "an orbit sees all of a model" orbit_sees_all_of_it
tap_check "the baseline is well formed, and has every frame" baseline_is_whole
tap_check "the pages' tables are the baseline's" \
    sh sim/tools/tables.sh --check figures peers bench bench-stages bench-memory
tap_check "a table whose row is missing is refused" tables_need_their_rows
tap_check "of callgrind's functions the renderer's own are counted" own_functions_are_counted
tap_check "or those of another renderer" so_are_those_of_another
tap_check "profiles without a frame are an error" no_frame_is_an_error
tap_check "a seed gives the same cameras again, another others" random_is_the_same_again
tap_check "a compiled scene has the same" random_of_a_compiled_scene
tap_check "they are measured, and chosen for" random_is_measured
for seed in '' x -1 1: 1:0 1:2:3; do
    tap_check "random:$seed is refused" refuses "$seed"
done
tap_done
