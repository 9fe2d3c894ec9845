# SPDX-License-Identifier: MIT
#
# The near plane in scenes so wide that the renderer cannot have it where it usually is: every command says from where on
# things are drawn, the reference sees the same, and a nearer one is refused. What is too small to be judged hangs on the
# near plane that was asked for.
. tests/tap.sh

limner=$BUILD/limner
"$BUILD/generate_scale" ground 240000 "$work" # +-120,000 m, boxes of 0.6 m
"$BUILD/generate_scale" floor 1000 "$work"    # boxes of 0.1 to 1.5 m
ground=$work/ground240000.obj

# The walls of a cube of 200 km, seen from inside, and eyes in its corners and before its floor.
cat >"$work/walls.obj" <<'TEXT'
v -100000 -100000 -100000
v -100000 -100000 100000
v -100000 100000 -100000
v -100000 100000 100000
v 100000 -100000 -100000
v 100000 -100000 100000
v 100000 100000 -100000
v 100000 100000 100000
f 3 4 2 1
f 6 8 7 5
f 2 6 5 1
f 7 8 4 3
f 5 7 3 1
f 4 8 6 2
TEXT
cat >"$work/corners.cam" <<'TEXT'
99985 99985 99985 100000 99990 99990
-99986 99980 -99990 -100000 99970 -99970
0 -99985 0 30 -100000 10
-99984 -99984 -99984 100000 100000 100000
TEXT
cat >"$work/low.cam" <<'TEXT'
0 1.7 0 5 1 0
50 1.7 50 60 1.5 60
1000 2 1000 1010 1 1000
100 10 100 200 0 200
TEXT

# MODEL CAMERAS MOST-WRONG-% OPTION...
right() {
    model=$1 cameras=$2 most=$3
    shift 3
    "$limner" render "$model" --camera "$cameras" --compare "$@" >"$work/table" 2>"$work/notes" || return 1
    tail -n 1 "$work/table"
    awk -v most="$most" '/^compared/ { wrong = $8 } END { exit !(wrong != "" && wrong + 0 <= most) }' "$work/table"
}
for profile in draft fast fine exact; do
    most=0.1
    [ $profile != draft ] || most=0.5
    for lens in '--fov 60' '--fov 20' '--fov 5' '--fov 120' '--size 64x240'; do
        # shellcheck disable=SC2086 # words
        tap_check "walls of 200 km from near, $profile, $lens" right "$work/walls.obj" "$work/corners.cam" $most --precision $profile $lens
    done
    tap_check "eyes low above a ground of 240 km, $profile" right "$ground" "$work/low.cam" 4 --drop-small --precision $profile
done

says() { # PATTERN COMMAND...
    pattern=$1
    shift
    "$limner" "$@" >"$work/said" 2>"$work/err" </dev/null && cat "$work/err" && [ "$(grep -c "$pattern" "$work/err")" -eq 1 ]
}
nothing='^limner: note: .*ground240000\.obj: nothing nearer to the eye than 11\.2 m is drawn, because its grid has units of 3\.66 m'
tap_check "compile says from where on things are drawn" says "$nothing" compile "$ground" --drop-small --report
tap_check "render does" says "$nothing" render "$ground" --drop-small --size 16x16 -o "$work/%d.png"
tap_check "measure does" says "$nothing" measure "$ground" --drop-small --no-cost --precision fast --size 16x16
tap_check "compare does" says "$nothing" compare "$ground" --drop-small --no-cost --size 16x16 --frames 1
silent() { "$limner" compile "$@" --report >"$work/said" 2>"$work/err" && ! grep 'nothing nearer' "$work/err"; }
tap_check "not of one that was asked for" silent "$ground" --drop-small --near 11.2
tap_check "and not of rooms" silent sim/scenes/rooms.obj

ignored='^limner: note: '
. tests/refused.sh
nearer='--near 1: nothing nearer than 11\.2 m can be drawn on a grid with units of 3\.66 m'
tap_check "compile refuses a nearer one" refused "$nearer" compile "$ground" --drop-small --near 1 -o "$work/out/x"
tap_check "render does" refused "$nearer" render "$ground" --drop-small --near 1 -o "$work/out/%d.png"
tap_check "measure does" refused "$nearer" measure "$ground" --drop-small --near 1 --no-cost -o "$work/out"
tap_check "view does" refused "$nearer" view "$ground" --drop-small --near 1
tap_check "a lens of 20 degrees has it farther off" refused '--near 12: nothing nearer than 3[0-9]\.[0-9] m' render "$ground" --drop-small --near 12 --fov 20 -o "$work/out/%d.png"
range_is_true() { # MODEL: the nearest plane that a refusal names is drawn with, half of it is refused
    ! "$limner" render "$1" --near 1000000 -o "$work/out/%d.png" 2>"$work/said" || return 1
    cat "$work/said"
    least_m=$(sed -n 's/.*out of range; this scene allows \([^ ]*\) to [^ ]* m$/\1/p' "$work/said")
    "$limner" render "$1" --camera random:1:1 --near "$least_m" && echo "$least_m" &&
        ! "$limner" render "$1" --coordinates 16 --camera random:1:1 --near "$(echo "$least_m" | awk '{ print $1 / 2 }')"
}
tap_check "one that is too far off is told the range, whose lower end is the nearest" range_is_true sim/scenes/teapot.obj
tap_check "compile refuses none at all" refused '--near 0: the near plane must lie in front of the eye' compile "$ground" --near 0 -o "$work/out/x"

# A box of 0.3 mm: less than a pixel from 10 cm, half a screen from 1 mm. Boxes of 0.1 to 0.4 m: less than a pixel from 90 m.
{
    echo 'v -5 0 -5' && echo 'v -5 0 5' && echo 'v 5 0 5' && echo 'v 5 0 -5' && echo 'f 1 2 3 4'
    for y in 0 0.0003; do
        for x in '0.00003 Y 0.00003' '0.00003 Y 0.00033' '0.00033 Y 0.00033' '0.00033 Y 0.00003'; do
            echo "v $x" | sed "s/Y/$y/"
        done
    done
    printf 'f %s\n' '9 10 11 12' '5 6 10 9' '6 7 11 10' '7 8 12 11' '8 5 9 12'
} >"$work/speck.obj"
speck='speck\.obj: face [2-6] \(0\.0003 m\).* faces would vanish or move too far'
tap_check "what no camera sees is not judged" "$limner" compile "$work/speck.obj" --report
tap_check "a nearer near plane sees it" refused "$speck" compile "$work/speck.obj" --coordinates 16 --near 0.01 -o "$work/out/x"
tap_check "in render, too" refused "$speck" render "$work/speck.obj" --coordinates 16 --near 0.01 -o "$work/out/%d.png"
tap_check "and in measure" refused "$speck" measure "$work/speck.obj" --coordinates 16 --near 0.01 --no-cost --precision fast
tap_check "and in splitters" refused "$speck" splitters "$work/speck.obj" --coordinates 16 --near 0.01
tap_check "boxes of a floor move too far" refused 'floor1000\.obj: face' compile "$work/floor1000.obj" --coordinates 16 -o "$work/out/x"
tap_check "but not for a camera that stays away" "$limner" compile "$work/floor1000.obj" --coordinates 16 --near 90 --report
tap_check "nor for measure's" "$limner" measure "$work/floor1000.obj" --coordinates 16 --near 90 --no-cost --precision fast --size 16x16
tap_check "a bound is met by what that camera needs" "$limner" compile "$work/floor1000.obj" --coordinates 16 --near 90 --max-error 50 --report
tap_done
