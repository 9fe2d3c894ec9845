# SPDX-License-Identifier: MIT
#
# Prints the table of displays behind a USB-HID bridge. With --write puts it into sim/MEASURED.md between its markers;
# with --check says how that differs. Needs $BUILD/limner.
set -eu
. sim/tools/page_table.sh
. sim/scenes/cube.sh

: "${BUILD:=build}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cube_make "$work"
"$BUILD/limner" bridge "$work/cube.dae" "$work/cube.cam" sim/scenes/rooms.obj sim/scenes/rooms-walk.cam >"$work/table"
case ${1:-} in
--write) page_write bridge "$work/table" ;;
--check) page_has bridge "$work/table" ;;
*) cat "$work/table" ;;
esac
