# SPDX-License-Identifier: MIT
#
# Every choice of features that the rooms and the icosahedron leave open, built by gcc and clang, paints what
# the full renderer paints. Several hundred builds: minutes.
. tests/tap.sh
. tests/features_on.sh

# All choices, those that come to the same flags once.
choices() { # NAME
    choice=0
    while [ $choice -lt $((1 << features_count)) ]; do
        echo "$(features_flags "$1" $choice) $choice"
        choice=$((choice + 1))
    done | sort -u -k "1,$features_count" | awk '{ print $NF }'
}

tap_check "the full renderer paints the rooms" features_prepare rooms
tap_check "the full renderer paints the icosahedron" features_prepare icosahedron teapot
for name in rooms icosahedron; do
    for choice in $(choices $name); do
        for compiler in gcc clang; do
            tap_check "$compiler: $name with features $choice" features_draw $compiler $name "$choice"
        done
    done
done
tap_done
