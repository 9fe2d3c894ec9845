# SPDX-License-Identifier: MIT
#
# What `limner formats` says of formats is what is drawn, and said, of a small file that has the feature, which
# tests/formats/one_square.py writes; and a table that says something else is told.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
cases=$(pwd)/tests/formats/what_is_read.py
export PYTHONDONTWRITEBYTECODE=1
cd "$work" || exit 1

holds() { # FORMAT
    mkdir "$work/$1" && cd "$work/$1" && python3 "$cases" "$limner" "$1"
}

"$limner" formats >table
sed -n 's/^\([^ ].*\):$/\1/p' table >names
names_formats() { [ "$(wc -l <names)" -ge 9 ]; }
tap_check "there are eight formats at least, and extensions of glTF" names_formats
while read -r name; do
    tap_check "every cell of $name is what becomes of a file" holds "$name"
done <names

# A program whose table says something else of one cell, or has one more.
doctored() { # EXPECTED SED-SCRIPT FORMAT
    printf '#!/bin/sh\nif [ "$1" = formats ]; then sed -e "%s" "%s/table"; else exec "%s" "$@"; fi\n' "$2" "$work" "$limner" >doctored
    chmod +x doctored
    ! python3 "$cases" "$work/doctored" "$3" >said || return 1
    cat said
    [ "$(wc -l <said)" = 1 ] && grep -q "^$1" said
}
tap_check "a cell without a case is told" doctored 'STL: skins: no case for STL/skins' 's/^STL:/STL:\n'"$(printf '  %-36s drawn' skins)"'/' STL
tap_check "so is a cell that says more than is drawn" doctored 'STL: normals: ' '/^  normals  /s/left out/drawn/' STL
tap_check "and one that says less" doctored 'STL: colours of faces: ' '/^  colours of faces  /s/drawn/left out/' STL
tap_check "and one of other words" doctored 'STL: up axis: not said' 's/as in most files/as in some files/' STL
tap_check "and one that is not there" doctored 'STL: normals: no cell for STL/normals' '/^  normals/d' STL
tap_done
