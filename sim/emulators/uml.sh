# SPDX-License-Identifier: MIT
#
# Runs the program of boards/linux in the kernel of tests/kernel, User Mode Linux with a record of a display's wires,
# and gives what its frames put there to a command, as a wire log on its standard input:
#   sh sim/emulators/uml.sh PROGRAMS IMAGE FRAMES COMMAND...      PROGRAMS: the folder of power_off and wires
# The kernel is built if it is not there, which takes minutes, once.
set -eu

programs=$1 image=$2 frames=$3
shift 3

fail() {
    echo "uml.sh: $1" >&2
    exit 1
}

here=tests/kernel
why=$(sh $here/build.sh) || fail "$why"
kernel=$(sh $here/build.sh --path)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
. $here/guests.sh

prepare_guests
cp "$image" "$stage/usual/image.elf"
cp "$programs/wires" "$stage/usual"
cp "$programs/power_off" "$stage"
chmod -R a+rX "$stage"
guest board usual flight FRAMES="$frames"
! cannot_start board || fail "User Mode Linux does not start here: $(tail -n 1 "$work/board.console")"
is_good board >"$work/said" || {
    cat "$work/said" "$stage/on-board/guest.tap" >&2
    fail "$image: it did not draw $frames frames and end at a signal"
}
"$@" <"$stage/on-board/flight"
