# SPDX-License-Identifier: MIT
#
# For test scripts to source: kinds_on CORE[:FLAG]... draws frames of every kind of scene on emulated processors, as
# frames_on.sh does, each kind in one precision profile, so that each profile is met; EVERY_PROFILE=yes: in all.
# shellcheck shell=sh
. tests/frames_on.sh

kind() { # PROFILE SCENE SIZE CORE[:FLAG]...
    kind_profile=$1
    shift
    [ -z "${EVERY_PROFILE:-}" ] || { frames_on "$@"; return; }
    scene=$1 size=$2
    shift 2
    frames_of "$kind_profile" "$@"
}

kinds_on() { # CORE[:FLAG]...
    frames_every=8
    kind fine sim/scenes/rooms 160x48 "$@"
    frames_options='--method scanline'
    kind draft sim/scenes/teapot 80x60 "$1"
    cp sim/scenes/icosahedron.obj "$work/solid.obj"
    cp sim/scenes/teapot.cam "$work/solid.cam"
    frames_options='--method convex'
    kind exact "$work/solid" 80x60 "$1"
    frames_options=
    kind fast "$BUILD/scenes/textured/textured" 80x60 "$1"
    kind draft sim/scenes/glass 80x60 "$1"
    frames_options=--delta
    kind fast sim/scenes/rooms 80x60 "$1"
    frames_options=--antialias
    kind exact sim/scenes/rooms 80x60 "$1"
    frames_options='--method newell'
    kind fast sim/scenes/knot 80x60 "$1"
    frames_suffix=gltf frames_every=6 frames_options='--mover-light turning' frames_path='--fps 3'
    frames_flags=-DSCENE_FRAMES_PER_S=3
    kind fine sim/scenes/movers 80x60 "$1"
}
