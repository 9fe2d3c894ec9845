# SPDX-License-Identifier: MIT
#
# How many frames `limner render` draws and where they go: one file for one frame, --frames, films of animations whose end
# meets their beginning; and the line that says what was written.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
scenes=$(pwd)/sim/scenes
cd "$work" || exit 1
seq 1 9 | awk '{ print 3 + $1 / 10, 2, 3, 0, 0.5, 0 }' >nine.cam

small() { timeout 60 "$limner" render "$scenes/icosahedron.obj" --size 24x16 "$@"; }
moving() { timeout 60 "$limner" render --size 24x16 "$@"; }
count() { find "$1" -name '*.png' | wc -l; }

# refused WORDS ARGUMENT...: one line that has the words, nothing else said, nothing written.
refused() {
    words=$1
    shift
    find . | sort >../before
    small "$@" >../out 2>../err
    [ $? -eq 1 ] && [ ! -s ../out ] && [ "$(wc -l <../err)" -eq 1 ] && cat ../err && grep -qF -- "$words" ../err &&
        find . | sort | diff ../before -
}

mkdir here && cd here || exit 1

one_file() { small -o house.png && small -o 'o/%d.png' --frames 1 && cmp house.png o/0.png; }
tap_check "-o house.png is one frame, the first of an orbit" one_file

first_camera() {
    small -o first.png --camera ../nine.cam --frames 1 && small -o 'all/%d.png' --camera ../nine.cam && cmp first.png all/0.png &&
        [ "$(count all)" -eq 9 ]
}
tap_check "--frames 1 is the first camera of a file" first_camera

first_ones() {
    small -o 'four/%d.png' --camera ../nine.cam --frames 4 && [ "$(count four)" -eq 4 ] && cmp four/3.png all/3.png &&
        small -o 'random/%d.png' --camera random:7 --frames 5 && [ "$(count random)" -eq 5 ]
}
tap_check "--frames takes the first ones of a file, and so many at random" first_ones

orbits() { small -o 'orbit/%d.png' --frames 3 && [ "$(count orbit)" -eq 3 ] && ! cmp -s orbit/0.png orbit/1.png; }
tap_check "--frames says how many an orbit has" orbits

tap_check "one file for several frames is refused" refused "one file for 3 frames" -o x.png --frames 3
tap_check "one file for a camera file is refused" refused "one file for the 9 frames" -o x.png --camera ../nine.cam
tap_check "one file for random cameras is refused" refused "one file for 64 frames" -o x.png --camera random:1
tap_check "more frames than cameras are refused" refused "--frames 10: ../nine.cam has 9" -o '%d.png' --camera ../nine.cam --frames 10
for frames in 0 -1 x 100001 ''; do
    tap_check "--frames '$frames' is refused" refused "--frames" -o '%d.png' --frames "$frames"
done
tap_check "a pattern that is none is refused" refused "exactly one %d" -o 'a%sb.png'

# -- What moves ----------------------------------------------------------------------------------------------------------

# Frames and hundredths of seconds of a GIF, by its graphic control extensions.
gif_facts() {
    od -An -v -tx1 -w1 "$1" | tr -d ' \n' | sed 's/21f904/\n&/g' | awk '
        function digit(c) { return index("0123456789abcdef", c) - 1 }
        function byte(s, i) { return 16 * digit(substr(s, i, 1)) + digit(substr(s, i + 1, 1)) }
        /^21f904/ { frames++; cs += byte($0, 9) + 256 * byte($0, 11) }
        END { print frames, cs }'
}

film_has() { # FRAMES CENTISECONDS OPTION...
    wanted="$1 $2"
    shift 2
    moving "$@" --gif film.gif >/dev/null && gif_facts film.gif && [ "$(gif_facts film.gif)" = "$wanted" ]
}
# generate_movers.c: LENGTH_S is 4.
tap_check "a film of an animation takes as long as the animation" film_has 60 400 "$scenes/movers.gltf"
tap_check "a film of few frames takes as long, too" film_has 10 400 "$scenes/movers.gltf" --frames 10
tap_check "an animation that is shorter than an orbit is shown twice" film_has 16 800 "$scenes/movers.gltf" --fps 2
tap_check "--frames and --fps together are what they say" film_has 6 60 "$scenes/movers.gltf" --frames 6 --fps 10
tap_check "--fps is a film's of what stands still, too" film_has 16 64 "$scenes/icosahedron.obj" --fps 25

# Of 4 s, 8 frames are 2 a second.
loop_closes() {
    moving "$scenes/movers.gltf" --frames 8 -o 'eight/%d.png' >/dev/null &&
        moving "$scenes/movers.gltf" --frames 8 --fps 2 -o 'same/%d.png' >/dev/null && diff -r eight same
}
tap_check "frames of an animation are spread evenly over all of it" loop_closes

# -- What is said --------------------------------------------------------------------------------------------------------

# On a terminal alone: what a script reads has nothing else in it.
says() { # LINE ARGUMENT...
    line=$1
    shift
    script -qec "'$limner' render '$scenes/icosahedron.obj' --size 24x16 $*" /dev/null </dev/null | tr '\r' '\n' | sed 's/.*\x1b\[K//' >said
    cat said
    grep -qxF "$line" said
}
if script -qec true /dev/null >/dev/null 2>&1; then
    tap_check "numbered frames are one item" says "wrote s/0.png to s/4.png (5 files)" -o s/%d.png --frames 5
    tap_check "files are named in their order" says "wrote f.gif, f.png and h.txt" --gif f.gif --sheet f.png --write-hashes h.txt
else
    tap_skip "a terminal is told what was written" "there are no pseudo-terminals here"
fi
is_quiet() { small -o 'quiet/%d.png' --frames 2 >said 2>&1 && [ ! -s said ]; }
tap_check "a pipe is told nothing" is_quiet
tap_done
