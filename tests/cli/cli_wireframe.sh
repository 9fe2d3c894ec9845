# SPDX-License-Identifier: MIT
#
# Wireframe on the command line: the same lines as ever by every order, the firmware's configuration, and what is refused.
. tests/tap.sh

golden() { # SCENE CAMERAS ARGUMENT...
    golden_scene=$1 golden_cameras=$2
    shift 2
    "$BUILD/limner" render "sim/scenes/$golden_scene.obj" --camera "sim/scenes/$golden_cameras.cam" --size 96x72 \
        --wireframe "$@" --check "tests/wireframe/$golden_scene.hashes"
}

compiled() { # a scene compiled for it draws the same from its file
    "$BUILD/limner" compile sim/scenes/glass.obj --size 96x72 --wireframe -o "$work/glass" --report >"$work/report" &&
        "$BUILD/limner" render "$work/glass.lim" --camera sim/scenes/glass.cam --size 96x72 --wireframe \
            --check tests/wireframe/glass.hashes && grep -q 'LIM_HAS_WIREFRAME 1' "$work/glass.h" &&
        grep -qE 'with edges that are not drawn +[1-9]' "$work/report"
}

plain() { # without being asked for nothing is kept for it
    "$BUILD/limner" compile sim/scenes/glass.obj --size 96x72 -o "$work/plain" --report >"$work/report" &&
        grep -q 'LIM_HAS_WIREFRAME 0' "$work/plain.h" && ! grep -q 'edges that are not drawn' "$work/report" &&
        [ "$(wc -c <"$work/plain.lim")" -lt "$(wc -c <"$work/glass.lim")" ]
}

two_colours() { # the other way round is another picture
    "$BUILD/limner" render sim/scenes/rooms.obj --camera sim/scenes/rooms.cam --size 96x72 --wireframe=000000,FFFFFF \
        --write-hashes "$work/light" && "$BUILD/limner" render sim/scenes/rooms.obj --camera sim/scenes/rooms.cam \
        --size 96x72 --wireframe=FFFFFF,000000 --write-hashes "$work/dark" && ! cmp -s "$work/light" "$work/dark"
}

is_refused() { # VALUE
    ! "$BUILD/limner" render sim/scenes/icosahedron.obj --size 16x16 --wireframe="$1" -o "$work/none%d.png" 2>"$work/said" &&
        [ "$(cat "$work/said")" = \
            "limner: --wireframe=$1: must be two colours, the line's and the background's: RRGGBB,RRGGBB" ] &&
        ! ls "$work"/none* 2>/dev/null
}

newell_refuses() { # COMMAND OPTION...
    command=$1
    shift
    ! "$BUILD/limner" "$command" sim/scenes/icosahedron.obj --method newell --wireframe "$@" 2>"$work/said" &&
        grep -qx 'limner: .*--wireframe --method newell: .*' "$work/said" && ! ls "$work"/none* 2>/dev/null
}

for method in nearest painter; do
    tap_check "$method: the glass is as it was" golden glass glass --method $method
    tap_check "$method: the rooms are as they were" golden rooms rooms --method $method
done
for method in nearest painter convex; do
    tap_check "$method: the icosahedron is as it was" golden icosahedron teapot --method $method
done
tap_check "a scene compiled for it knows its edges" compiled
tap_check "another one does not" plain
tap_check "Newell's pieces have no outline: compile refuses" newell_refuses compile -o "$work/none"
tap_check "render refuses too" newell_refuses render -o "$work/none%d.png"
tap_check "lines and background take the colours given" two_colours
for value in '' 000000 000000, 000000,00000 000000,FFFFFF, 00000g,FFFFFF '000000 FFFFFF' +00000,FFFFFF; do
    tap_check "colours '$value' are refused" is_refused "$value"
done
tap_done
