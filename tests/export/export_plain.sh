# SPDX-License-Identifier: MIT
#
# limner export --for plain: on scenes of all kinds, with every option that changes the renderer, the folder is compiled by
# itself, and draws what `limner render` does; with a display's driver its bytes are that frame to the emulated display.
. tests/tap.sh
. tests/export/exported.sh

# Kept, for the compiler's cache.
mkdir -p "$kept"
exported_names "$kept/names"
scenes=sim/scenes turn=

export_to() { # FOLDER MODEL OPTION...
    folder=$1 model=$2
    shift 2
    "$BUILD/limner" export "$model" --for plain -o "$folder/model" "$@" >"$folder.said" 2>&1 || { cat "$folder.said" && return 1; }
}

compile() { # COMPILER STANDARD FOLDER MAIN...: $FOLDER/draws; as in C++ where the standard is one
    compiler=$1 standard=$2 folder=$3
    shift 3
    objects=
    for main; do
        objects="$objects $folder/$(basename "$main" .c).o"
        case $standard in
        c++*) cc="$compiler -x c++ -std=$standard -Wall -Wextra -pedantic -Werror" ;;
        *) cc="$compiler -std=$standard $WARNINGS" ;;
        esac
        # shellcheck disable=SC2086 # flags are words
        $CCACHE $cc -O2 -I"$folder/model" -I"$folder" -I"$kept/names" -Isim/targets -c -o "$folder/$(basename "$main" .c).o" "$main" || return 1
    done
    for source in sim/targets/start_host.c $(find "$folder/model" -name '*.c' ! -name main.c); do
        objects="$objects $folder/$(basename "$source" .c).o"
        # shellcheck disable=SC2086 # flags are words
        $CCACHE "$CC" -std=c11 -O2 $WARNINGS -I"$folder/model" -Isim/targets -c -o "$folder/$(basename "$source" .c).o" "$source" || return 1
    done
    # shellcheck disable=SC2086 # objects are words
    "$CC" -o "$folder/draws" $objects
}

draws() { # NAME MODEL CAMERAS|- OPTION...: the same options to both commands
    name=$1 model=$2 cameras=$3
    shift 3
    exported_expected "$kept/$name" "$model" "$cameras" --size 160x120 "$@" >/dev/null &&
        export_to "$kept/$name" "$model" --size 160x120 "$@" &&
        compile "$CC" c11 "$kept/$name" tests/export/draw.c && "$kept/$name/draws" >"$kept/$name/drawn" &&
        diff "$kept/$name/expected" "$kept/$name/drawn"
}

# On a display; $turn has options that turn its picture.
shows() { # NAME MODEL CAMERAS|- PANEL OPTION...
    name=$1 model=$2 cameras=$3 panel=$4
    shift 4
    # shellcheck disable=SC2086 # options of a panel are words
    exported_expected "$kept/$name" "$model" "$cameras" ${turned:---panel $panel} "$@" >/dev/null &&
        export_to "$kept/$name" "$model" --panel $panel $turn "$@" &&
        compile "$CC" c11 "$kept/$name" tests/export/wires.c tests/wire_board/board.c &&
        "$kept/$name/draws" >"$kept/$name/wires" &&
        "$BUILD/limner" decode "$kept/$name/wires" --panel $panel $turn --frames 8 --check "$kept/$name/expected"
}

# The example as it was written, on a display that looks at its pictures.
example_shows_all() { # WIDTHxHEIGHT MODEL OPTION...
    size=$1 model=$2 folder=$kept/whole
    shift 2
    rm -rf "$folder" && mkdir -p "$folder" && export_to "$folder" "$model" --size "$size" "$@" || return 1
    $CCACHE "$CC" -std=c11 -O2 $WARNINGS -DW_PX=${size%x*} -DH_PX=${size#*x} -c -o "$folder/whole.o" tests/export/whole.c &&
        for source in "$folder"/model/*.c; do
            # shellcheck disable=SC2086 # flags are words
            $CCACHE "$CC" -std=c11 -O2 $WARNINGS -I"$folder/model" -c -o "$folder/$(basename "$source" .c).o" "$source" || return 1
        done && "$CC" -o "$folder/draws" "$folder"/*.o && timeout -k 5 60 "$folder/draws"
}

stretched() { # X Y Z: the icosahedron, of other proportions
    awk -v x="$1" -v y="$2" -v z="$3" '/^v / { print "v", $2 * x, $3 * y, $4 * z; next } { print }' $scenes/icosahedron.obj >"$kept/stretched.obj"
}

examples_show_all() {
    for shape in '1 1 1' '1 6 1' '8 1 8' '1 1 9' '0.001 0.002 0.001' '4000 900 4000'; do
        # shellcheck disable=SC2086 # sides are words
        stretched $shape
        for size in 240x240 128x64 64x128; do
            example_shows_all $size "$kept/stretched.obj" || { echo "$shape on $size" && return 1; }
        done
    done
}

options_of_examples() {
    for options in --antialias --wireframe '--precision draft'; do
        # shellcheck disable=SC2086 # options are words
        example_shows_all 160x120 $scenes/teapot.obj $options || { echo "$options" && return 1; }
    done
}

example_moves() { # its pictures differ, though the camera stands still
    example_shows_all 96x96 $scenes/movers.gltf >"$work/said" || grep -q ' across' "$work/said" || return 1
    sed 's/time_ms \/ 40 \* LIM_DEGREES(3)/0/' "$kept/whole/model/main.c" >"$kept/whole/still.c" && ! cmp -s "$kept/whole/still.c" "$kept/whole/model/main.c" || return 1
    # shellcheck disable=SC2086 # flags are words
    rm -f "$kept/whole"/main.o "$kept/whole"/whole.o && "$CC" -std=c11 -O2 $WARNINGS -I"$kept/whole/model" -c -o "$kept/whole/still.o" "$kept/whole/still.c" &&
        "$CC" -std=c11 $WARNINGS -DW_PX=96 -DH_PX=96 -DFRAMES_DIFFER -c -o "$kept/whole/differ.o" tests/export/whole.c &&
        "$CC" -o "$kept/whole/draws" "$kept/whole"/*.o && timeout -k 5 60 "$kept/whole/draws"
}

in_cplusplus() { # STANDARD
    # shellcheck disable=SC2034 # compile has it
   
    compile g++ "$1" "$kept/rooms" tests/export/draw.c && "$kept/rooms/draws" | diff "$kept/rooms/expected" -
}

# Which complains of more that is not used.
in_clang() { # FOLDER
    for source in "$kept/$1"/model/*.c; do
        clang -std=c11 -Wall -Wextra -Werror -fsyntax-only -I"$kept/$1/model" "$source" || return 1
    done
}

tap_check "rooms, nearest first" draws rooms $scenes/rooms.obj $scenes/rooms.cam
tap_check "its main file is C++11" in_cplusplus c++11
tap_check "the teapot, by scan lines, in profile exact" draws teapot $scenes/teapot.obj $scenes/teapot.cam --precision exact
tap_check "a convex solid" draws icosahedron $scenes/icosahedron.obj - --method convex --precision draft
tap_check "glass, with smooth edges" draws glass $scenes/glass.obj $scenes/glass.cam
tap_check "what moves" draws movers $scenes/movers.gltf $scenes/movers.cam
tap_check "textures" draws textured "$BUILD/scenes/textured/textured.obj" "$BUILD/scenes/textured/textured.cam" --precision fine
tap_check "knots, sorted and split" draws newell $scenes/knot.obj $scenes/knot.cam --method newell
tap_check "back to front" draws painter $scenes/rooms.obj $scenes/rooms.cam --method painter
tap_check "sorted by depth" draws depth $scenes/knot.obj $scenes/knot.cam --method depth

tap_check "examples show all of a scene, of any proportions, on any display" examples_show_all
tap_check "smooth, in outlines" options_of_examples
tap_check "examples show what moves" example_moves

tap_check "on an ST7789" shows st7789 $scenes/rooms.obj $scenes/rooms.cam st7789
tap_check "on an ILI9488, three bytes a pixel" shows ili9488 $scenes/teapot.obj $scenes/teapot.cam ili9488
turn='--rotate 90' turned='--size 160x128'
tap_check "on an ST7735, turned" shows st7735 $scenes/rooms.obj $scenes/rooms.cam 'st7735 --size 128x160'
turn='' turned=''
tap_check "on an SSD1306, a convex solid without a line of memory" shows ssd1306 $scenes/icosahedron.obj - ssd1306
tap_check "on an SSD1306, rooms" shows ssd1306rooms $scenes/rooms.obj $scenes/rooms.cam ssd1306
tap_check "on a PCD8544" shows pcd8544 $scenes/teapot.obj $scenes/teapot.cam pcd8544
tap_check "on an SSD0323, greys" shows ssd0323 $scenes/rooms.obj $scenes/rooms.cam ssd0323
tap_check "on an SSD1351" shows ssd1351 $scenes/rooms.obj $scenes/rooms.cam ssd1351
tap_check "on round glass" shows gc9a01 $scenes/rooms.obj $scenes/rooms.cam gc9a01
tap_check "on a memory LCD" shows sharp $scenes/rooms.obj $scenes/rooms.cam ls013b7dh03
tap_check "what moves, on a UC1701" shows uc1701 $scenes/movers.gltf $scenes/movers.cam uc1701
tap_check "what changes alone" shows delta $scenes/rooms.obj $scenes/rooms.cam st7789 --delta
if command -v clang >/dev/null; then
    tap_check "clang has nothing to say of any" eval 'in_clang rooms && in_clang icosahedron && in_clang ssd1306 && in_clang ssd0323 && in_clang sharp && in_clang uc1701'
else
    tap_skip "clang has nothing to say of any" "clang is missing"
fi
tap_check "in outlines" shows outlines $scenes/icosahedron.obj - st7789 --wireframe
tap_check "with smooth edges" shows smooth $scenes/rooms.obj $scenes/rooms.cam st7789 --antialias
tap_done
