# SPDX-License-Identifier: MIT
#
# --time-limit: commands that would go on for minutes end soon after it, say what counts, and leave nothing half-written;
# without pressure of time they write what they write without a limit.
. tests/tap.sh
export LIMNER_CACHE=/nonexistent/limner # what was decided before takes no time

limner=$(cd "$BUILD" && pwd)/limner
rooms=$(pwd)/sim/scenes/rooms.obj
cd "$work" || exit 1
unset LIMNER_TIME_LIMIT
patience_s=30 # beyond any limit here; machines may be busy

# soup NAME COUNT SIZE: triangles anywhere in a cube of 20 m that cut each other: planes, splits and holes without end.
soup() {
    awk -v count="$2" -v size="$3" 'BEGIN {
        srand(5)
        for (i = 0; i < count; i++) {
            x = 20 * rand(); y = 20 * rand(); z = 20 * rand()
            for (k = 0; k < 3; k++)
                printf "v %f %f %f\n", x + size * (rand() - 0.5), y + size * (rand() - 0.5), z + size * (rand() - 0.5)
            print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
        }
    }' >"$1.obj"
}
soup heavy 20000 6
soup medium 120 14
soup few 12 20

# A ground of 240 km with boxes of 0.6 m on it, 126 faces.
awk 'BEGIN {
    print "v -120000 0 120000\nv 120000 0 120000\nv 120000 0 -120000\nv -120000 0 -120000\nf 1 2 3 4"
    for (i = 0; i < 25; i++) {
        x = 2 * (i % 5); z = 2 * int(i / 5); n = 8 * i + 5
        for (y = 0; y < 1; y += 0.6)
            print "v", x, y, z + 0.6 "\nv", x + 0.6, y, z + 0.6 "\nv", x + 0.6, y, z "\nv", x, y, z
        for (k = 0; k < 4; k++) print "f", n + k, n + (k + 1) % 4, n + 4 + (k + 1) % 4, n + 4 + k
        print "f", n + 4, n + 5, n + 6, n + 7
    }
}' >ground.obj

# ends STATUS COMMAND [OPTION...]: in a folder of its own; what it says is in ./said, and what it leaves in ./left.
ends() {
    wanted=$1
    shift
    rm -rf here && mkdir here && cd here || return 1
    timeout "$patience_s" "$limner" "$@" >../out 2>../said </dev/null
    status=$?
    cd .. && find here -mindepth 1 | sort >left
    sed 's/^/said: /' said
    [ "$status" -eq "$wanted" ] || { echo "status $status"; return 1; }
}

nothing_found() { # COMMAND [OPTION...]: time is over before there is anything
    ends 1 "$@" --time-limit 1 && [ ! -s left ] && [ "$(grep -c . said)" -eq 1 ] &&
        grep -q '^limner: .*stopped after [0-9.]* s (.*--time-limit 1): ' said
}
# Streams without an end, and files that take long: a log, a dump, blanks in one, a comment in one.
ends_decoding() { # COMMAND that writes the input
    { eval "$1"; } 2>/dev/null | timeout "$patience_s" "$limner" decode - --panel st7789 --time-limit 1 >out 2>said
    [ "$(tail -n 1 said | grep -c '^limner: .*stopped after [0-9.]* s (--time-limit 1): standard input.*, after 0 frames$')" -eq 1 ] ||
        { cat said && return 1; }
}
dump='printf "%s\n" "\$timescale 1 ns \$end" "\$var wire 1 a sck \$end" "\$var wire 1 b mosi \$end" "\$var wire 1 c dc \$end" "\$enddefinitions \$end" "#0 0a 0b 0c"'
tap_check "decode ends a log that goes on" ends_decoding 'yes "b 00"'
tap_check "and a dump" ends_decoding "$dump; awk 'BEGIN { while (1) print \"#\" ++t * 100 \"\\n\" t % 2 \"a\" }'"
tap_check "and one of blanks" ends_decoding "$dump; yes ''"
tap_check "and one that is a comment" ends_decoding "$dump; echo '\$comment'; yes x"
seq 3000000 | sed 's/.*/b 00 00 00 00/' >long.wire
tap_check "and a file" ends 1 decode ../long.wire --panel st7789 --time-limit 0
tap_check "which it reads by its end without" grep -q 'long.wire: ends after 0 frames' said

for command in 'compile -o x' 'compile --report' 'compile --max-error 1 -o x' 'compile --max-vertex-error 1 -o x' 'compile --tree clusters -o x' \
    'compile --tree axis -o x' 'compile --tree octree -o x' 'render -o %d.png --gif x.gif --ids x.ids --write-hashes x.hashes' \
    'measure --no-cost -o m' splitters view 'play --panel st7789 --spi /dev/spidev0.0 --dc 1'; do
    # shellcheck disable=SC2086 # an option is a word
    tap_check "$command: nothing yet, which is an error" nothing_found $command ../heavy.obj
done

# What counts: all files or none, and a line for whatever is left out.
best_so_far() { # PATTERN COMMAND [OPTION...]
    pattern=$1
    shift
    ends 0 "$@" && ! grep -q '\.part$' left && grep -q "^limner: stopped after [0-9.]* s (.*--time-limit [0-9.]*): best so far: .*$pattern" said
}
every_frame_is_whole() {
    awk 'BEGIN { for (i = 0; i < 20000; i++) print i % 20, 30, 30, 10, 10, 10 }' >long.cam
    best_so_far 'of 20000 frames' render ../few.obj --camera ../long.cam --size 240x240 -o '%d.png' --write-hashes x.hashes --time-limit 3 || return 1
    frames=$(grep -c '\.png$' left)
    [ "$frames" -gt 0 ] && [ "$frames" -lt 20000 ] && [ "$(wc -l <here/x.hashes)" -eq "$frames" ] &&
        grep -q "best so far: $frames of 20000 frames" said
}
tap_check "render: the frames so far, and lists of them" every_frame_is_whole
some_accuracy() {
    best_so_far 'of 20000 frames' measure ../few.obj --camera ../long.cam --no-cost -o m --time-limit 3 &&
        grep -q '^here/m/measure.csv$' left
}
tap_check "measure: the frames so far" some_accuracy
some_choice() {
    best_so_far 'of 20000 frames' compile ../few.obj --max-error 100 --camera ../long.cam -o x --time-limit 4 && grep -q '^here/x.lim$' left &&
        grep -q ' chosen$' out
}
tap_check "compile --max-error: the precision that the frames so far ask for" some_choice
none_meets() {
    ends 1 compile ../few.obj --max-vertex-error 1e-9 --camera ../long.cam -o x --time-limit 4 && [ ! -s left ] &&
        grep -q 'time ended (--time-limit): so far no precision meets the bound; .* comes nearest: ' said
}
tap_check "compile --max-error: if none meets the bound, that time ended, and the nearest" none_meets
some_methods() {
    best_so_far '' compare ../few.obj --camera ../long.cam --frames 20000 --size 480x480 --no-cost -o c --time-limit 4 && grep -q '^here/c/compare.csv$' left
}
tap_check "compare: the methods and frames so far" some_methods

# A limit between none and enough: there is a scene, or there is none and an error says so.
one_or_the_other() { # LIMIT
    timeout "$patience_s" "$limner" compile medium.obj -o one --report --time-limit "$1" >out 2>said </dev/null
    status=$?
    cat said
    case $status in
    0) [ -s one.lim ] && "$limner" render one.lim --size 64x64 --write-hashes one.hashes >/dev/null ;;
    1) [ ! -e one.lim ] && grep -q 'stopped after' said ;;
    *) return 1 ;;
    esac
    ok=$?
    rm -f one.*
    return $ok
}
# A mesh needs no tree: it may be compiled in time, and then compare has a row. One run is judged: another may end otherwise.
rows_or_nothing() {
    rm -rf here && mkdir here
    (cd here && timeout "$patience_s" "$limner" compare -o c ../heavy.obj --size 64x64 --time-limit 1 >../out 2>../said </dev/null)
    status=$?
    sed 's/^/said: /' said
    case $status in
    0) grep -q 'stopped after.*best so far: ' said && [ -e here/c/compare.csv ] ;;
    1) [ "$(ls here)" = '' ] && [ "$(grep -c . said)" -eq 1 ] && grep -q '^limner: .*stopped after ' said ;;
    *) echo "status $status" && return 1 ;;
    esac
}
tap_check "compare -o c: a mesh's row, or nothing, which is an error" rows_or_nothing
for limit in 0.05 0.2 0.5 1 2; do
    tap_check "a scene or an error within $limit s" one_or_the_other "$limit"
done

# On a terminal a command says where it is, before it says how it ended.
shows_progress() { # COMMAND [OPTION...]
    script -qec "timeout $patience_s $limner $* --time-limit 1" /dev/null >out </dev/null
    grep -q '% \|reading ' out && grep -q 'stopped after' out
}
for command in 'compile heavy.obj --report' 'render heavy.obj --write-hashes x' 'measure heavy.obj --no-cost' 'compare heavy.obj' \
    'splitters heavy.obj' 'view heavy.obj' 'compile heavy.obj --report --max-error 1'; do
    tap_on_terminal "progress is shown: $command" shows_progress "$command"
done

same_as_ever() {
    "$limner" compile "$rooms" -o free --report --time-limit 0 >/dev/null 2>said && "$limner" compile "$rooms" -o within --report --time-limit 500 >/dev/null 2>>said &&
        cmp free.lim within.lim && [ ! -s said ]
}
tap_check "a limit that is not reached changes nothing" same_as_ever
in_environment() {
    LIMNER_TIME_LIMIT=0.01 timeout "$patience_s" "$limner" compile heavy.obj --report >out 2>said
    [ $? -eq 1 ] && grep -q -- '--time-limit 0.01' said && LIMNER_TIME_LIMIT=0.01 "$limner" compile few.obj --report --time-limit 0 >out 2>said && [ ! -s said ]
}
tap_check "LIMNER_TIME_LIMIT is the default, and an option's is stronger" in_environment
soon_on_large_ground() {
    timeout "$patience_s" "$limner" compile ground.obj --max-error 0.01 --report --time-limit 10 >out 2>said
    [ $? -le 1 ]
}
tap_check "--max-error on a ground of 240 km with small boxes ends" soon_on_large_ground
refuses() { ends 1 "$@" && [ ! -s left ] && [ "$(grep -c . said)" -eq 1 ]; }
for limit in -1 nan inf x ''; do
    tap_check "--time-limit '$limit' is refused" refuses compile "$rooms" -o x --time-limit "$limit"
done
tap_check "commands without long work have no limit" refuses hashes x.png --time-limit 1
tap_done
