# SPDX-License-Identifier: MIT
#
# `limner render` and `limner view` from the outside: what they write, and that everything they
# cannot use ends with one line that names it and the reason, status 1 and nothing left behind.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
models=$(pwd)/sim/scenes
cd "$work" || exit 1
mkdir here
cd here || exit 1

# A pyramid that stands on the ground: quick to compile and to render.
cat >pyramid.obj <<'OBJ'
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
printf '%s\n' '3 2 3 0 0.5 0' '# a comment' '' '-3 2 3 0 0.5 0' '0 5 0 0 0 0' >path.cam
cp pyramid.obj path.cam ..

# refuse NAME PATTERN ARGUMENT...: limner with the arguments fails with one line that matches, and leaves no file.
refuse() {
    name=$1 pattern=$2
    shift 2
    tap_check "$name" is_refused "$pattern" "$@"
}

is_refused() {
    pattern=$1
    shift
    find . | sort >../before
    timeout 60 "$limner" "$@" >../out 2>../err </dev/null
    status=$?
    find . | sort >../after
    cat ../err
    [ $status -eq 1 ] || { echo "status $status" && return 1; }
    [ "$(wc -l <../err)" -eq 1 ] || { echo "not one line" && return 1; }
    [ ! -s ../out ] || { echo "something on stdout" && return 1; }
    grep -qE -- "$pattern" ../err || { echo "does not match $pattern" && return 1; }
    diff ../before ../after
}

render() { timeout 60 "$limner" render pyramid.obj --camera path.cam --size 64x48 "$@"; }

# -- What cannot be used -------------------------------------------------------------------------------------------------

refuse "no command is refused" '^limner: no command; `limner help`'
refuse "an unknown command is refused" "^limner: no command 'rendre'" rendre pyramid.obj
refuse "render without a scene is refused" '^limner: render: needs a model' render
refuse "two scenes are refused" "what is 'path.cam'" render pyramid.obj path.cam
refuse "an unknown option is refused" '^limner: --colour: no such option' render pyramid.obj --colour
refuse "an option without its value is refused" '^limner: --camera: needs a value' render pyramid.obj --camera
refuse "render's options are not view's" '^limner: --gif: no such option' view pyramid.obj --gif x.gif

for size in 0 0x0 0x240 240x0 100000 100000x100000 1025x240 240x1025 240 240x 240x240x -5x5 axb 99999999999999999999x1 ''; do
    refuse "size '$size' is refused" "^limner: --size $size: must be WxH" render pyramid.obj --size "$size"
done
for fov in 0 180 -60 nan x 60x ''; do
    refuse "field of view '$fov' is refused" "^limner: --fov" render pyramid.obj --fov "$fov"
done
refuse "a lens too wide is refused" '^limner: --fov 155: too wide' render pyramid.obj --fov 155
refuse "a picture too wide for the lens is refused, with the widest that fits" 'too wide at 1024x100, where 42.673 degrees are most' \
    render pyramid.obj --size 1024x100 --fov 60
refuse "a lens too narrow is refused, with the narrowest that fits" '^limner: --fov 0.05: too narrow at 240x240, where 0.056 degrees are least' \
    render pyramid.obj --fov 0.05
for near in 0 -1 nan inf x ''; do
    refuse "near plane '$near' is refused" '^limner: --near' render pyramid.obj --near "$near"
done
refuse "a near plane behind the scene is refused" '^limner: --near 100: out of range' render pyramid.obj --near 100
refuse "an unknown panel is refused" '^limner: --panel hd44780: no such panel; there are .*st7789, .*ls027b7dh01, and memory, and framebuffer$' \
    render pyramid.obj --panel hd44780
refuse "half a page is refused" '^limner: --panel ssd1306: 128x60: its height must be a multiple of 8 pixels$' \
    render pyramid.obj --panel ssd1306 --size 128x60
refuse "a format that a panel does not take is refused" '^limner: --panel ili9488:rgb565: .*there are rgb666$' \
    render pyramid.obj --panel ili9488:rgb565
refuse "a size beyond the panel is refused" '^limner: --panel st7789: 241x320 .* of 240x320$' render pyramid.obj --panel st7789 --size 241x320
refuse "an unknown method is refused" '^limner: --method z: no such method' render pyramid.obj --method z
refuse "an unknown splitter is refused" 'splitter' render pyramid.obj --splitter best
for tolerance in -1 nan x; do
    refuse "tolerance '$tolerance' is refused" '^limner: --tolerance' render pyramid.obj --tolerance "$tolerance"
done

# camera NAME PATTERN LINES: a camera file of these lines is refused.
camera() {
    printf '%b' "$3" >bad.cam
    refuse "$1" "$2" render pyramid.obj --camera bad.cam -o 'out/%d.png'
}
camera "a camera line with a word is refused by number" '^limner: bad.cam:2: not a number' '1 2 3 0 0 0\n1 2 three 0 0 0\n'
camera "a short camera line is refused by number" '^limner: bad.cam:3: fewer than six' '#\n\n1 2 3 4 5\n'
camera "a long camera line is refused by number" '^limner: bad.cam:1: more than six' '1 2 3 4 5 6 7\n'
camera "NaN in a camera file is refused" '^limner: bad.cam:1: a coordinate' 'nan 2 3 4 5 6\n'
camera "infinity in a camera file is refused" '^limner: bad.cam:1: a coordinate' '1 2 3 4 -inf 6\n'
camera "an eye on its target is refused by line" '^limner: bad.cam:2: eye and target' '3 2 3 0 0 0\n1 1 1 1 1 1\n'
camera "an eye out of range is refused by line" '^limner: bad.cam:2: the eye is too far' '3 2 3 0 0 0\n1 1 9e8 0 0 0\n'
camera "an empty camera file is refused" '^limner: bad.cam: no camera' ''
rm bad.cam
refuse "a missing camera file is refused" '^limner: none.cam: No such file' render pyramid.obj --camera none.cam
refuse "a folder as camera file is refused" '^limner: \.: is a folder' render pyramid.obj --camera .

refuse "a missing model is refused" 'none.obj' render none.obj
: >empty.obj
refuse "an empty model is refused" 'empty.obj' render empty.obj
echo 'Dear sir or madam' >letter.obj
refuse "a letter named .obj is refused" 'letter.obj' render letter.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >points.obj
refuse "a model without faces is refused" 'points.obj' render points.obj
printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n' >line.obj
refuse "a model of zero-area faces is refused" 'line.obj' render line.obj
printf 'v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
refuse "NaN in a model is refused" 'nan.obj' render nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >index.obj
refuse "an index out of range is refused" 'index.obj' render index.obj
refuse "a missing compiled scene is refused" 'none.lim' render none.lim
head -c 40 /dev/zero >zero.lim
refuse "zeros named .lim are refused" 'zero.lim' render zero.lim
rm empty.obj letter.obj points.obj line.obj nan.obj index.obj zero.lim

for pattern in '%s.png' '%n' '%d%d' '%%d' '%' '%*d' '%999d' ''; do
    refuse "pattern '$pattern' is refused" '^limner: -o ' render pyramid.obj -o "$pattern"
done
for option in --gif --sheet --ids --write-hashes; do
    refuse "$option to a place that cannot be is refused" '/dev/null/x' render pyramid.obj $option /dev/null/x
    refuse "$option to a folder is refused" 'it is a folder' render pyramid.obj $option .
done
refuse "frames in a folder that cannot be are refused" '/dev/null/000.png' render pyramid.obj -o '/dev/null/%03d.png'
refuse "a full disk is an error" '/dev/full' render pyramid.obj --ids /dev/full
refuse "one file for two outputs is refused" 'named for two outputs' render pyramid.obj --gif x --sheet x
refuse "--compare without source polygons is refused" '^limner: --compare: pyramid.lim holds no' render pyramid.lim --compare

fails_late() { # the last camera is out of range: 2 of 3 frames were rendered by then
    printf '3 2 3 0 0 0\n3 2 3 0 0 0\n1 1 9e8 0 0 0\n' >../late.cam
    is_refused 'late.cam:3' render pyramid.obj --camera ../late.cam -o 'new/folder/%d.png' --gif new/x.gif \
        --sheet new/sheet.png --ids new/ids --write-hashes new/hashes --stats --compare
}
tap_check "a failure at the last frame leaves no file and no folder" fails_late

keeps_old_files() {
    echo old >old.gif
    is_refused 'late.cam:3' render pyramid.obj --camera ../late.cam --gif old.gif && [ "$(cat old.gif)" = old ]
}
tap_check "a failure leaves an older file of the name as it was" keeps_old_files
rm -f old.gif

# -- What is written -----------------------------------------------------------------------------------------------------

writes_frames() {
    rm -rf out && render -o 'out/%03d.png' && [ "$(ls out)" = "$(printf '%s\n' 000.png 001.png 002.png)" ] &&
        [ "$(head -c 8 out/002.png | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ]
}
tap_check "frames are numbered PNG files" writes_frames

writes_by_default() { mkdir default && cd default && timeout 60 "$limner" render ../pyramid.obj --size 24x24 && [ "$(find out -name '*.png' | wc -l)" -eq 16 ]; }
tap_check "without options an orbit of 16 frames goes to out/" writes_by_default

draws_lines() {
    for size in 200x1 1x200 1024x1 1x1024; do
        timeout 60 "$limner" render ../pyramid.obj --size $size --compare --sheet x.png >said && grep -q 'holes 0$' said || return 1
    done
}
tap_check "displays of one line or column draw without a lens said" draws_lines

draws_long() { timeout 60 "$limner" render ../pyramid.obj --size 320x200 --fov 1 --compare --sheet x.png >said && grep -q 'holes 0$' said; }
tap_check "a lens of 1 degree draws, as far away as an eye can be" draws_long

writes_films() { render --gif x.gif --sheet x.png && [ "$(head -c 6 x.gif)" = GIF89a ] && [ -s x.png ] && [ ! -e x.png.part ]; }
tap_check "an animated GIF and a contact sheet are written" writes_films

is_quiet() { render --gif x.gif >said 2>&1 && [ ! -s said ]; }
tap_check "nothing is said in a pipe" is_quiet

writes_ids() {
    render --ids ids && [ "$(wc -c <ids)" -eq $((3 * 64 * 48 * 4)) ] &&
        [ "$(od -An -v -tu4 -w4 ids | sort -un | tr -d ' ' | tr '\n' ' ')" = '0 2 3 4 5 ' ]
}
tap_check "--ids holds a face number a pixel, without the faces seen from behind" writes_ids

ids_agree() { render --ids near && render --ids far --method painter && cmp near far; }
tap_check "both methods see the same faces" ids_agree

checks_hashes() { render --write-hashes hashes && [ "$(wc -l <hashes)" -eq 3 ] && render --check hashes; }
tap_check "hashes written are hashes met" checks_hashes

notices_change() { # the first character of the second frame's hash
    awk 'NR == 2 { $2 = (substr($2, 1, 1) == "0" ? "1" : "0") substr($2, 2) } { print }' hashes >changed
    is_refused '^limner: changed: frame 1 differs' render pyramid.obj --camera path.cam --size 64x48 --check changed
}
tap_check "a frame that differs is named" notices_change
refuse "a missing hash file is an error" '^limner: none: No such file' render pyramid.obj --size 24x24 --check none
: >none.hashes
refuse "a hash file of another length is an error" '^limner: none.hashes: has 0 frames, 16 were rendered' \
    render pyramid.obj --size 24x24 --check none.hashes
rm none.hashes

panels_agree() {
    for panel in memory st7789 st7735 st7796 ili9341 ili9488 st7789:rgb666; do
        render --panel $panel --check hashes || return 1
    done
    render --method painter --check hashes && render --method painter --panel ili9488 --check hashes
}
tap_check "panels, plain memory and the painter show the same" panels_agree
lying_panels_agree() { # glass that stands has not the width
    "$limner" render pyramid.obj --camera path.cam --size 160x128 --panel memory --write-hashes lying || return 1
    for panel in st7735 st7735:rgb666; do
        "$limner" render pyramid.obj --camera path.cam --size 160x128 --panel $panel --check lying || return 1
    done
    "$limner" render pyramid.obj --camera path.cam --size 320x240 --panel memory --write-hashes lying &&
        "$limner" render pyramid.obj --camera path.cam --size 320x240 --panel ili9341 --stats --check lying >stats &&
        awk '$1 == 0 { exit !($NF > 2 * 320 * 240) }' stats
}
tap_check "so do those that turn a picture to have room for it" lying_panels_agree
refuse "a size beyond the panel, however it is turned, is refused" '^limner: --panel st7735: 163x100 .* of 132x162$' \
    render pyramid.obj --panel st7735 --size 163x100
refuse "and one that a chip cannot turn" '^limner: --panel ssd1306: 64x128 .* of 128x64$' \
    render pyramid.obj --panel ssd1306 --size 64x128
draws_pages() { # twice the same, all pixels black or white, a byte for eight of them and three a page
    for panel in ssd1306 sh1106 st7567; do
        "$limner" render pyramid.obj --camera path.cam --size 128x64 --panel $panel --stats --write-hashes pages >stats &&
            awk '$1 == 0 { exit !($NF == 1024 + 8 * 3) }' stats || return 1
        [ $panel = ssd1306 ] && cp pages first_pages
        cmp pages first_pages || return 1
    done
    "$limner" render pyramid.obj --camera path.cam --size 84x48 --panel pcd8544 --method painter --write-hashes pages &&
        "$limner" render pyramid.obj --camera path.cam --size 84x48 --panel pcd8544 --check pages
}
tap_check "panels of pages show the same as one another, and by the painter" draws_pages
tap_check "fewer colours do not" is_refused '^limner: hashes: frame 0 differs' \
    render pyramid.obj --camera path.cam --size 64x48 --panel st7789:rgb444 --check hashes

prints_stats() {
    render --method nearest --stats >stats && grep -q '64x48 pixels, through the emulated st7789' stats &&
        [ "$(awk 'NR == 2 { print $1, $NF } NR > 2 { printf "%s ", $1 }' stats)" = "$(printf 'frame bus_b\n0 1 2 mean worst predicted in ')" ] &&
        awk '$1 == "frame" { for (i = 1; i <= NF; i++) column[$i] = i }
            $1 ~ /^[0-9]+$/ && ($(NF) < 64 * 48 * 2 || $column["overdraw"] != "1.000") { bad = 1 }
            END { exit bad }' stats
}
tap_check "--stats prints a table of all frames, their mean and worst" prints_stats

says_memory() { timeout 60 "$limner" render pyramid.obj --size 300x200 --stats | grep -q 'plain memory'; }
tap_check "--stats says when no panel was emulated" says_memory

notices_full_stdout() { ! render --stats >/dev/full 2>err && grep -q '^limner: standard output: No space' err; }
tap_check "a table that cannot be printed is an error" notices_full_stdout

compares() { render --compare | tail -n 1 | grep -E '^compared with the reference: 3 frames, wrong 0\.[0-9]+ % .*, holes 0$'; }
tap_check "--compare sums up the deviations from the reference" compares

compiled_scene_agrees() {
    timeout 60 "$limner" compile pyramid.obj -o pyramid >/dev/null &&
        timeout 60 "$limner" render pyramid.lim --camera path.cam --size 64x48 --check hashes
}
tap_check "a compiled scene renders like its model" compiled_scene_agrees

dumps() {
    LIMNER_DUMP=last.png render --stats >/dev/null && cmp last.png out/002.png && LIMNER_CHECK=last.png render --stats >/dev/null
}
tap_check "LIMNER_DUMP writes the last frame, LIMNER_CHECK accepts it" dumps

check_differs() {
    ! LIMNER_CHECK=out/000.png render --stats >/dev/null 2>err && grep -q '^limner: out/000.png: .* pixels differ' err
}
tap_check "LIMNER_CHECK refuses another frame" check_differs

renders_benchmarks() { # a frame of each, from the first line of its camera path
    for name in rooms rooms-tilted teapot; do
        head -n 1 "$models/$name.cam" >"$name.cam" || return 1
        "$limner" render "$models/$name.obj" --camera "$name.cam" --compare >said || return 1
        tail -n 1 said | grep 'holes 0$' || return 1
    done
}
tap_check "a frame of each benchmark scene has no holes" renders_benchmarks

# Background jobs of a shell without job control ignore SIGINT for good: TERM stands for it.
cleans_up_when_interrupted() {
    yes '0 1 3 0 0 0' | head -n 100000 >long.cam
    mkdir stopped && cd stopped || return 1
    "$limner" render ../pyramid.obj --size 64x48 --camera ../long.cam -o 'f/%06d.png' --gif x.gif >said 2>&1 &
    pid=$!
    for _ in 1 2 3 4 5 6 7 8 9 10; do # until it is well under way
        sleep 0.2
        [ ! -e f ] || break
    done
    kill -TERM $pid && { wait $pid; [ $? -eq 143 ]; } && [ ! -s said ] && rm said && [ -z "$(ls)" ]
}
tap_check "an interrupted render leaves nothing behind" cleans_up_when_interrupted

# -- View ----------------------------------------------------------------------------------------------------------------

shows_in_terminal() {
    env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11 LIMNER_DUMP=view.png "$limner" view pyramid.obj \
        --camera path.cam --size 64x48 >picture </dev/null && [ "$(wc -l <picture)" -eq 24 ] && cmp view.png out/000.png
}
tap_check "view without a display shows the first frame as text" shows_in_terminal

says_that_there_is_nowhere_to_fly() {
    ! env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=x11 "$limner" view pyramid.obj --size 64x48 >picture 2>said </dev/null &&
        [ ! -s picture ] && [ "$(wc -l <said)" -eq 1 ] && grep -q '^limner: view: neither a window.* nor a terminal to fly in; limner render MODEL --gif' said &&
        { pkg-config --exists sdl2 || grep -q 'package libsdl2-dev' said; }
}
tap_check "view with neither a display nor a terminal fails" says_that_there_is_nowhere_to_fly

# SDL opens windows that nobody sees by these drivers, the first where it finds no other.
flies_in_terminal() { # DRIVER
    for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do # typed until it is read
        sleep 0.5
        printf q 2>/dev/null || break
    done | env -u DISPLAY -u WAYLAND_DISPLAY ${1:+SDL_VIDEODRIVER=$1} timeout 20 \
        script -qec "$limner view pyramid.obj --size 64x48" /dev/null >picture && grep -q "$(printf '\342\226\200')" picture
}
for driver in '' offscreen dummy; do
    tap_on_terminal "view flies in the terminal where SDL's driver is '$driver'" flies_in_terminal "$driver"
done

flies_in_window() { # SDL ends the program's loop on SIGINT
    LIMNER_UNSEEN=1 SDL_VIDEODRIVER=dummy LIMNER_DUMP=window.png timeout --preserve-status -s INT 3 "$limner" view pyramid.obj \
        --camera path.cam --size 64x48 >picture </dev/null || return 1
    [ ! -s picture ] && cmp window.png out/000.png
}
if ldd "$limner" | grep -q libSDL2; then
    tap_check "view in a window shows the first frame" flies_in_window
else
    tap_skip "view in a window shows the first frame" "built without SDL2"
fi

names_mean_what_they_say() {
    mkdir alone && (cd alone && "$limner" render ../pyramid.obj --frames 2 -o walk.gif && [ "$(ls)" = walk.gif ] &&
        [ "$(head -c 4 walk.gif)" = GIF8 ]) && rm -r alone
}
tap_check "-o NAME.gif is an animation" names_mean_what_they_say
refuse "a GIF is no PNG by its name" '^limner: --gif x\.png: it writes gif files; name it x\.gif$' render pyramid.obj --gif x.png
refuse "a PNG is no JPEG by its name" "^limner: -o x\.jpg: it writes png files; name it x\.png$" render pyramid.obj -o x.jpg
brief_tables() {
    "$limner" render pyramid.obj --frames 9 --stats >all && "$limner" render pyramid.obj --frames 9 --stats --brief >some &&
        sed '/^ *[0-9][0-9]* /d' all | diff - some && [ "$(wc -l <some)" -lt "$(wc -l <all)" ]
}
tap_check "--brief leaves out the frames' lines" brief_tables
tap_done
