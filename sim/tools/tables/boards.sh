# SPDX-License-Identifier: MIT
#
# Boards: what their images take, and what a frame costs, drawn and checked in an emulator. The images are a line each of
# boards/images.txt: arguments of `make cost`.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work

echo "| board | scene | panel | flash, bytes | RAM, bytes | stack, bytes | processor, a frame | bus, bytes a frame | frames/s: processor | bus |"
echo "|---|---|---|---|---|---|---|---|---|---|"
while read -r row; do
    # shellcheck disable=SC2086 # arguments are words
    make -s cost DEPS=skip BUILD="$BUILD" $row </dev/null >"$work/said" || { cat "$work/said" >&2; exit 1; }
    tail -n 1 "$work/said"
done <boards/images.txt
