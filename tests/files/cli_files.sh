# SPDX-License-Identifier: MIT
#
# The files that `limner` writes, and standard output: two runs into one place, links, permissions, signals at any time,
# full disks. What is not finished leaves nothing behind, and what could not be written is an error.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
scenes=$PWD/sim/scenes
# shellcheck disable=SC2086 # warnings are words
"${CC:-gcc}" -std=c11 -O1 $WARNINGS -o "$work/bounded" tests/bounded/main.c || exit 1
cd "$work" || exit 1
cp "$scenes/rooms.obj" "$scenes/rooms.mtl" . 2>/dev/null
mkdir here tmp
cd here || exit 1
export TMPDIR="$work/tmp"

within() { "$work/bounded" 10 300 "$@"; } # ten seconds of work, 300 MB

small() { # OPTION...: some frames, fast
    within "$limner" render "$scenes/icosahedron.obj" --size 64x48 "$@"
}

wait_for() { # COMMAND...: up to thirty seconds
    for _ in $(seq 300); do
        "$@" && return 0
        sleep 0.1
    done
    return 1
}

is_gone() { # PID
    ! kill -0 "$1" 2>/dev/null || grep -q '^State:.*zombie' "/proc/$1/status"
}

there_is() { # PATTERN...
    [ -n "$(find . -name "$1" | head -n 1)" ]
}

is_empty() { # FOLDER
    [ -z "$(ls -A "$1")" ] || { find "$1" && return 1; }
}

# -- Two runs into one place ---------------------------------------------------------------------------------------------

# A run that waits for its input has begun its file.
waits_with_a_file() { # SECONDS FILE
    sleep "$1" | "$limner" decode - --panel st7789 --write-hashes "$2" 2>/dev/null
}

does_not_mix() {
    small --write-hashes alone || return 1
    waits_with_a_file 5 both &
    wait_for there_is 'both*.part' || return 1
    [ "$(stat -c %h both.*.part)" -eq 1 ] || return 1
    small --write-hashes both || return 1
    cmp alone both || return 1
    wait $! && echo "no frames, and no error" && return 1
    cmp alone both && [ "$(find . | wc -l)" -eq 3 ] && rm alone both
}
tap_check "two runs into one file do not mix" does_not_mix

many_keep_their_sets() {
    for number in 1 2 3 4; do
        "$limner" compile "$scenes/icosahedron.obj" --size "${number}00x100" -o "set_$number/one" >/dev/null || return 1
    done
    for number in 1 2 3 4; do
        "$limner" compile "$scenes/icosahedron.obj" --size "${number}00x100" -o same/one >/dev/null &
    done
    wait
    for number in 1 2 3 4; do
        if cmp -s same/one.h "set_$number/one.h"; then
            cmp same/one.lim "set_$number/one.lim" && cmp same/one.c "set_$number/one.c" && [ "$(find same -type f | wc -l)" -eq 3 ] &&
                rm -r same set_*
            return
        fi
    done
    echo "a header of none" && return 1
}
tap_check "files that belong together come from one run" many_keep_their_sets

follows_no_planted_link() {
    echo precious >victim
    for name in x.gif.part x.gif.tmp .x.gif.part; do
        ln -s victim "$name"
    done
    small --gif x.gif && [ "$(cat victim)" = precious ] && rm -f victim x.gif x.gif.* .x.gif.part
}
tap_check "a link beside a file's place is left alone" follows_no_planted_link

refuses_one_file_twice() { # SECOND NAME
    mkdir -p sub
    small --gif same.bin --ids "$1" 2>said && echo accepted && return 1
    grep -q 'named for two outputs$' said && rm said && rmdir sub && is_empty .
}
tap_check "one file for two outputs is refused" refuses_one_file_twice same.bin
tap_check "so it is by another path" refuses_one_file_twice ./sub/../same.bin
tap_check "and by its whole path" refuses_one_file_twice "$PWD/same.bin"

# What a command reads, however it is spelled, is none of its outputs: no file is lost, and none is checked against itself.
spares_what_it_reads() {
    cp "$scenes/icosahedron.obj" model.obj
    echo '3 3 3 0 0 0' >path
    small --write-hashes hashes || return 1
    cp hashes picture.png
    echo '00 00' >wire
    ln -s model.obj link.obj
    for read in "model.obj render model.obj --gif" "model.obj render ./model.obj --ids" "link.obj render model.obj --sheet" \
        "path render model.obj --camera path --write-hashes" "hashes render model.obj --check hashes --write-hashes" \
        "wire decode wire --panel st7789 --write-hashes" "hashes decode wire --panel st7789 --check hashes --write-hashes" \
        "picture.png hashes picture.png --write-hashes" "hashes hashes picture.png --check ./hashes --write-hashes"; do
        name=${read%% *}
        cp "$name" before
        # shellcheck disable=SC2086 # words
        "$limner" ${read#* } "$PWD/$name" 2>said && echo "accepted: $read" && return 1
        echo "limner: $PWD/$name: cannot be written: the same command reads it" | cmp said - && cmp before "$name" || return 1
    done
    rm model.obj path hashes picture.png wire link.obj before said && is_empty .
}
tap_check "what a command reads is not written" spares_what_it_reads

# A model of several files. Its textures are read, left out or of no use to the reader, as a bump map is.
make_house() {
    printf '%s\n' 'mtllib house.mtl' 'v 0 0 0' 'v 9 0 0' 'v 0 9 0' 'v 0 0 9' 'vt 0 0' 'vt 1 0' 'vt 0 1' 'usemtl a' \
        'f 1/1 3/3 2/2' 'f 1/1 2/2 4/3' 'f 1/1 4/2 3/3' 'f 2/1 3/2 4/3' >house.obj
    printf '%s\n' 'newmtl a' 'map_Kd house.png' 'map_d bumps.gif' >house.mtl
    small -o house.png && small --gif bumps.gif
    base64=$(printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\77\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\77\0\0\0\0' | tee points.bin | base64 -w 0)
    [ -n "$base64" ] || return 1
    cat >points.gltf <<'GLTF'
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"points.bin","byteLength":36}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]}
GLTF
    echo '3 3 3 0 0 0' >way.cam
}

# Each line: a file, and a command that would write it under a name which follows.
spares_a_models_files() { # NAME OF THE OUTPUT, made of the file's by: same, soft, hard, whole
    make_house || return 1
    mkdir kept && cp house.* bumps.gif points.* way.cam kept || return 1
    while read -r file command; do
        case $1 in
        same) name=$file ;;
        whole) name=$PWD/./$file ;;
        *) name=other_${file##*/} ;;
        esac
        [ "$1" != soft ] || ln -s "$file" "$name"
        [ "$1" != hard ] || ln "$file" "$name"
        # shellcheck disable=SC2086 # words
        within "$limner" $command "$name" >../out 2>said && echo "accepted: $command $name" && return 1
        grep -q '^limner: .*: cannot be written: the same command reads it$' said || { echo "$command $name" && cat said && return 1; }
        for was in kept/*; do
            cmp "$was" "${was#kept/}" || { echo "$command $name" && return 1; }
        done
        [ -z "$(find . -name '*.part' -o -name '.limner*')" ] || return 1
        rm -f other_*
    done <<LIST
house.png render house.obj --size 64x48 -o
house.obj render house.obj --size 64x48 --ids
bumps.gif render house.obj --size 64x48 --gif
house.png render house.obj --size 64x48 --sheet
house.mtl render house.obj --size 64x48 --ids
house.mtl render house.obj --size 64x48 --write-hashes
house.mtl render house.obj --size 64x48 --write-cameras
house.png render house.obj --size 64x48 --no-textures -o
points.bin render points.gltf --size 64x48 --ids
house.mtl report house.obj --size 64x48 -o
way.cam report house.obj --size 64x48 --camera way.cam -o
house.png report-bug house.obj --size 64x48 -o
LIST
    rm -r kept house.* bumps.gif points.* way.cam said && is_empty .
}
for name in same soft hard whole; do
    tap_check "what a model names is not written: $name" spares_a_models_files $name
done

# Names that the command makes are those of a model's files by chance.
spares_by_made_names() { # FILE COMMAND...: the model names FILE
    file=$1
    shift
    make_house || return 1
    mkdir -p "$(dirname "$file")" && mv house.mtl "$file" && sed -i "s|house.mtl|$file|" house.obj && cp "$file" before || return 1
    within "$limner" "$@" >../out 2>said && echo "accepted" && return 1
    cat said
    grep -q "^limner: .*$file: cannot be written: the same command reads it\$" said && cmp "$file" before && rm -r ./*
}
tap_check "nor by a pattern" spares_by_made_names out/001.png render house.obj --size 64x48 --frames 3 -o 'out/%03d.png'
tap_check "nor as a scene's header" spares_by_made_names scene.h compile house.obj --no-textures --tree none -o scene
tap_check "nor as its source" spares_by_made_names scene.c compile house.obj --no-textures --tree none -o scene
tap_check "nor as its scene" spares_by_made_names scene.lim compile house.obj --no-textures --tree none -o scene
tap_check "nor as a table" spares_by_made_names out/measure.csv measure house.obj --no-cost --precision fast --size 64x48 -o out
tap_check "nor as searched cameras" spares_by_made_names best.cam worst house.obj --size 64x48 -o best

# -- Permissions and links -----------------------------------------------------------------------------------------------

has_mode() { # MODE FILE
    [ "$(stat -c %a "$2")" = "$1" ] || { stat -c '%a %n' "$2" && return 1; }
}

has_usual_permissions() {
    (umask 022 && small --gif usual.gif) && has_mode 644 usual.gif || return 1
    (umask 077 && small --gif own.gif -o 'own/%d.png') && has_mode 600 own.gif && has_mode 600 own/0.png &&
        has_mode 700 own || return 1
    chmod 640 usual.gif
    (umask 022 && small --gif usual.gif) && has_mode 640 usual.gif && rm -r own usual.gif own.gif
}
tap_check "files have the permissions that the umask leaves, and keep what they had" has_usual_permissions

writes_through_links() {
    mkdir far
    small --gif plain.gif || return 1
    echo old >far/there.gif
    ln -s far/there.gif link.gif
    ln -s link.gif link2.gif
    ln -s far/later.gif dangling.gif
    small --gif link2.gif && small --gif dangling.gif || return 1
    [ -h link.gif ] && [ -h link2.gif ] && [ -h dangling.gif ] && cmp plain.gif far/there.gif &&
        cmp plain.gif far/later.gif && [ "$(find far -type f | wc -l)" -eq 2 ] && rm -r far ./*.gif
}
tap_check "a link stays, and what it names is written" writes_through_links

refuses_a_ring() {
    ln -s two.gif one.gif
    ln -s one.gif two.gif
    small --gif one.gif 2>said && return 1
    grep -q '^limner: one.gif: cannot be written: ' said && [ "$(wc -l <said)" -eq 1 ] && rm one.gif two.gif said
}
tap_check "a ring of links is refused" refuses_a_ring

takes_long_names() {
    name=$(printf '%0250d' 7).gif
    small --gif "$name" && [ -s "$name" ] && rm "$name" && is_empty .
}
tap_check "a name of 254 bytes is written" takes_long_names

writes_to_descriptors() {
    small --gif plain.gif && small --gif /dev/stdout >by_number.gif && cmp plain.gif by_number.gif &&
        small --gif /dev/fd/3 3>by_number.gif && cmp plain.gif by_number.gif &&
        small --gif /dev/stdout | cmp plain.gif - && [ -h /dev/stdout ] && rm ./*.gif
}
tap_check "open files and pipes by their number are written as they are" writes_to_descriptors

# -- Signals -------------------------------------------------------------------------------------------------------------

end_with() { # SIGNAL PATTERN COMMAND...: once a file like PATTERN exists; must die of the signal and leave nothing
    signal=$1 pattern=$2
    shift 2
    rm -rf ../running
    mkdir ../running
    cd ../running || return 1
    env --default-signal=INT,QUIT "$@" >../out 2>../err &
    pid=$!
    wait_for there_is "$pattern" || { kill $pid && echo "has not begun" && cat ../err && cd ../here && return 1; }
    kill "-$signal" $pid
    wait_for is_gone $pid || kill -9 $pid
    wait $pid
    status=$?
    cat ../err
    cd ../here || return 1
    [ "$(kill -l $status)" = "$signal" ] || { echo "status $status" && return 1; }
    is_empty ../running && is_empty ../tmp
}

yes '0 1 3 0 0 0' | head -n 100000 >../long.cam
for signal in TERM INT HUP QUIT PIPE; do
    tap_check "render dies of $signal and leaves nothing" end_with $signal 'x.gif*' "$limner" render ../rooms.obj --size 64x48 \
        --camera ../long.cam -o 'a/b/%06d.png' --gif c/x.gif --ids x.ids --write-hashes x.hashes
done

# A program that hangs stands for the compiler: it and what it runs end with their parent.
mkdir ../tools
for tool in gcc g++ ld objcopy addr2line nm size; do
    ln -s hang "../tools/arm-none-eabi-$tool"
done
printf '%s\n' '#!/bin/sh' "sleep 100 & echo \$! >>'$work/pids'; touch begun; wait" >../tools/hang
printf '%s\n' '#!/bin/sh' 'exit 0' >../tools/qemu-system-arm
chmod +x ../tools/*

ends_children() { # SIGNAL COMMAND...
    rm -f "$work/pids"
    touch "$work/pids"
    signal=$1
    shift
    (
        PATH="$work/tools:$PATH"
        mkdir -p ../running
        cd ../running || exit 1
        env --default-signal=INT,QUIT CCACHE= "$@" >../out 2>../err &
        pid=$!
        wait_for test -s "$work/pids" || { kill $pid && cat ../err && exit 1; }
        kill "-$signal" $pid
        wait_for is_gone $pid || kill -9 $pid
        wait $pid
        [ "$(kill -l $?)" = "$signal" ]
    ) || return 1
    while read -r pid; do
        wait_for is_gone "$pid" || { echo "$pid runs on" && return 1; }
    done <"$work/pids"
    is_empty ../running && is_empty ../tmp
}

for signal in TERM INT; do
    tap_check "measure ends its compiler on $signal" ends_children $signal "$limner" measure "$scenes/icosahedron.obj" \
        --core m0plus --precision fast --size 64x48 -o tables
    tap_check "compile --max-error does" ends_children $signal "$limner" compile "$scenes/icosahedron.obj" --max-error 5% \
        --core m0plus --size 64x48 -o scene
done

# Nothing can be done at SIGKILL: the next run in that place does it.
cleans_up_after_a_killed_run() {
    rm -rf ../running && mkdir ../running && cd ../running || return 1
    "$limner" render ../rooms.obj --size 64x48 --camera ../long.cam -o 'a/b/%06d.png' --gif a/x.gif --ids x.ids 2>/dev/null &
    pid=$!
    wait_for there_is '000100.png.*.part' && kill -9 $pid
    wait $pid 2>/dev/null
    there_is '*.part' || { echo "nothing was left" && return 1; }
    echo mine >a/b/mine.part && small --gif a/y.gif || return 1
    find . -name '*.part' -o -name '.limner*'
    [ "$(find . -type f | sort | tr '\n' ' ')" = "./a/b/mine.part ./a/y.gif " ] && cd ../here && rm -r ../running
}
tap_check "the next run cleans up after a killed one" cleans_up_after_a_killed_run

leaves_what_a_run_writes() {
    waits_with_a_file 5 both &
    wait_for there_is 'both*.part' && small --write-hashes other && there_is 'both*.part' || return 1
    wait $!
    [ "$(ls -A)" = other ] && rm other
}
tap_check "it leaves what a running one writes" leaves_what_a_run_writes

is_ignored_by_nohup() {
    rm -rf ../running
    mkdir ../running
    (trap '' HUP && exec "$limner" render ../rooms.obj --size 64x48 --camera ../long.cam --gif ../running/x.gif) &
    pid=$!
    wait_for there_is_running || return 1
    kill -HUP $pid
    sleep 0.3
    kill -0 $pid || { echo ended && return 1; }
    kill $pid
    wait $pid
    is_empty ../running
}
there_is_running() { [ -n "$(ls ../running)" ]; }
tap_check "a signal that was ignored stays so" is_ignored_by_nohup

# -- Standard output -----------------------------------------------------------------------------------------------------

tells_full() { # COMMAND...
    within "$limner" "$@" >/dev/full 2>said
    [ $? -eq 1 ] && [ "$(wc -l <said)" -eq 1 ] && grep '^limner: standard output: ' said || return 1
    within "$limner" "$@" >&- 2>said
    [ $? -eq 1 ] && [ "$(wc -l <said)" -eq 1 ] && grep '^limner: standard output: ' said && rm said
}
small -o "../%d.png"
while read -r arguments; do
    # shellcheck disable=SC2086 # words
    tap_check "full and closed standard output: $arguments" tells_full $arguments
done <<LIST
help
compile --help
devices
bridge
splitters $scenes/icosahedron.obj
compile $scenes/icosahedron.obj --report
render $scenes/icosahedron.obj --stats
render $scenes/icosahedron.obj --compare --size 64x48
measure $scenes/icosahedron.obj --no-cost --precision fast --size 64x48
compare $scenes/icosahedron.obj --no-cost --frames 1 --size 64x48
hashes ../0.png
LIST

needs_no_output() {
    small --gif x.gif >&- && small --gif y.gif >&- <&- && cmp x.gif y.gif && small --gif y.gif >&- 2>&- <&- &&
        cmp x.gif y.gif && rm ./*.gif
}
tap_check "who says nothing needs no standard streams, and files get none of their numbers" needs_no_output

ends_by_a_closed_pipe() {
    { env --default-signal=PIPE "$limner" help 2>said; echo $? >status; } | head -n 1 >/dev/null
    case $(cat status) in
    0) ;; # the pipe took it all
    *) [ "$(kill -l "$(cat status)")" = PIPE ] || return 1 ;;
    esac
    [ ! -s said ] && rm said status
}
tap_check "a reader that has enough is no error" ends_by_a_closed_pipe

tells_a_broken_pipe() { # with the signal ignored
    (trap '' PIPE && { sleep 0.2; "$limner" help 2>said; echo $? >status; } | true)
    [ "$(cat status)" -eq 1 ] && grep -q '^limner: standard output: ' said && rm said status
}
tap_check "with SIGPIPE ignored it is one" tells_a_broken_pipe

# -- Disk full -----------------------------------------------------------------------------------------------------------

refuses_large_files() { # OPTION...: more than the limit
    rm -rf ./*
    (ulimit -f 16 && "$work/bounded" 10 300 "$limner" "$@" >../out 2>../err)
    status=$?
    cat ../err
    [ $status -eq 1 ] && [ "$(wc -l <../err)" -eq 1 ] && grep -qE '^limner: [^ ]*: (cannot be written|File too large|the importer)' ../err &&
        is_empty .
}
tap_check "a GIF beyond the limit on files leaves nothing" refuses_large_files render "$scenes/icosahedron.obj" --gif a/x.gif \
    --size 240x240
tap_check "so do face numbers" refuses_large_files render "$scenes/icosahedron.obj" --ids x.ids --write-hashes h
tap_check "and a sheet" refuses_large_files render "$scenes/icosahedron.obj" --sheet x.png --gif x.gif
tap_check "and a compiled scene" refuses_large_files compile "$scenes/rooms.obj" --tree none -o b/hall

refuses_full_disk() {
    small --gif /dev/full 2>said && return 1
    cat said
    [ "$(wc -l <said)" -eq 1 ] && grep -q '^limner: /dev/full: ' said && rm said && is_empty .
}
tap_check "a device without space is an error" refuses_full_disk

tap_done
