# SPDX-License-Identifier: MIT
#
# limner export, from outside: folders that are refused, names that are mapped, scenes that are too large, and the commands
# of README as they are written there. What exported folders draw is for the suite export.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
model=$(pwd)/sim/scenes/icosahedron.obj

says() { # STATUS EXPRESSION ARGUMENT...: one line on standard error, which has the words
    status=$1 words=$2
    shift 2
    "$limner" export "$@" >"$work/out" 2>"$work/said"
    [ $? -eq "$status" ] && grep -q -- "$words" "$work/said" && [ "$(wc -l <"$work/said")" -eq 1 ] || { cat "$work/said" && return 1; }
}

refuses() { says 1 "$@" && [ ! -s "$work/out" ]; } # EXPRESSION ARGUMENT...
exports() { "$limner" export "$@" >"$work/out" 2>"$work/said" || { cat "$work/said" && return 1; }; }

listing() { (cd "$1" && find . -type f -exec cksum {} + | sort -k 3); } # FOLDER

unknown_world() {
    refuses '^limner: --for esp8266: no such world; there are arduino, idf, pico, cmake and plain$' "$model" --for esp8266 -o "$work/x" &&
        refuses 'needs --for' "$model" -o "$work/x" && refuses 'needs -o' "$model" --for plain && refuses 'needs a model' --for plain -o "$work/x" &&
        [ ! -e "$work/x" ]
}

# What somebody put there stays, and so does all else.
foreign_files_stay() {
    exports "$model" --for plain -o "$work/mine" && echo mine >"$work/mine/notes.txt" && listing "$work/mine" >"$work/before" &&
        refuses 'mine/notes.txt: no export wrote this file; choose another folder' "$model" --for plain -o "$work/mine" &&
        listing "$work/mine" | diff "$work/before" - && rm "$work/mine/notes.txt" &&
        mkdir -p "$work/other/sub" && echo mine >"$work/other/sub/main.c" &&
        refuses 'other/sub/main.c: no export wrote' "$model" --for plain -o "$work/other" && [ "$(cat "$work/other/sub/main.c")" = mine ] &&
        ln -s "$model" "$work/mine/link.obj" && refuses 'mine/link.obj: no export wrote' "$model" --for plain -o "$work/mine" && rm "$work/mine/link.obj"
}

changed_files_stay() {
    echo '/* mine */' >>"$work/mine/main.c" && listing "$work/mine" >"$work/before" &&
        refuses 'mine/main.c: was changed since it was exported' "$model" --for plain -o "$work/mine" && listing "$work/mine" | diff "$work/before" -
}

# What it wrote itself it writes anew, and takes away what does not belong there any more.
writes_anew() {
    exports "$model" --for arduino -o "$work/again" && [ -f "$work/again/src/again_display.c" ] && [ -f "$work/again/examples/again/again.ino" ] &&
        exports "$model" --for arduino --size 100x80 -o "$work/again/" && [ ! -e "$work/again/src/again_display.c" ] && [ ! -e "$work/again/examples/again" ] &&
        (cd "$work/again" && find . -type f ! -name limner.files | sed 's,^\./,,' | sort) >"$work/there" &&
        sed 's/^[0-9a-f]* //' "$work/again/limner.files" | sort | diff "$work/there" -
}

is_a_file() {
    echo mine >"$work/file"
    refuses 'file: is a file, not a folder' "$model" --for plain -o "$work/file" && [ "$(cat "$work/file")" = mine ]
}

# Nothing half-written.
nothing_is_left() {
    refuses 'none.obj' "$work/none.obj" --for plain -o "$work/left" && refuses 'must be WxH' sim/scenes/rooms.obj --for plain --size 9999x9 -o "$work/left" &&
        refuses ili9999 "$model" --for plain --panel ili9999 -o "$work/left" && [ ! -e "$work/left" ]
}

too_large() {
    says 0 'note: .* is too large for an Arduino Leonardo, which other boards are not: at least [0-9]* of 28672 bytes of flash, [0-9]* of 2304 of RAM$' \
        sim/scenes/rooms.obj --for arduino -o "$work/large" && exports "$model" --for arduino --panel ssd1306 -o "$work/small" && [ ! -s "$work/said" ]
}

# Names that C, CMake or a shell would take otherwise.
names_are_mapped() {
    cp "$model" "$work/my model-2.obj"
    says 0 "^limner: a house, 2nd: is called a_house__2nd in the folder's files$" "$work/my model-2.obj" --for cmake -o "$work/a house, 2nd" &&
        [ -f "$work/a house, 2nd/src/a_house__2nd.c" ] && grep -q 'add_library(a_house__2nd ' "$work/a house, 2nd/CMakeLists.txt" &&
        says 0 '7up: is called scene_7up in' "$model" --for arduino --panel ssd1306 -o "$work/7up" && grep -qx 'name=scene_7up' "$work/7up/library.properties" &&
        [ -f "$work/7up/examples/scene_7up/scene_7up.ino" ] || return 1
    for name in main test String limner Limner_pico SPI pico hardware_spi edit_cache features; do
        says 0 "^limner: $name: is called scene_$name in" "$model" --for cmake --panel ssd1306 -o "$work/taken/$name" &&
            [ -f "$work/taken/$name/src/scene_$name.c" ] || return 1
    done
}

# ESP-IDF calls a component as its folder is called.
idf_takes_plain_names() {
    for name in 'a house' 'a"b' "it's" 'a\b' 'a#b' 'a;b' 'a$b' 'a(b)' 'a@b' 'naïve'; do
        refuses ': ESP-IDF calls a component by its folder: letters, digits and [.] [+] - _ alone, please$' "$model" --for idf -o "$work/$name" || return 1
    done
}

# An option that only one of its readers would understand.
options_in_full() {
    refuses '^limner: --pan: write --panel and --size in full' "$model" --for pico --pan st7735 -o "$work/short" &&
        refuses '^limner: --siz=64x64: write' "$model" --for idf --siz=64x64 -o "$work/short"
}

# What a model calls its nodes stays in a comment.
nodes_say_nothing() {
    awk '!done && sub(/"name": *"ball"/, "\"name\": \"x */ #error hi /* \\\\n#error ho\"") { done = 1 } { print }' sim/scenes/movers.gltf >"$work/evil.gltf" && ! cmp -s "$work/evil.gltf" sim/scenes/movers.gltf &&
        exports "$work/evil.gltf" --for plain --size 32x32 -o "$work/evil" && grep -q "'x / #error hi / " "$work/evil/evil.h" &&
        "$CC" -std=c11 $WARNINGS -I"$work/evil" -fsyntax-only "$work"/evil/*.c
}

# Scenes of one folder share a renderer, a display and memory.
several_models() {
    exports "$model" sim/scenes/movers.gltf --for plain --panel st7789 -o "$work/set" &&
        "$CC" -std=c11 $WARNINGS -I"$work/set" -c -o "$work/set.o" "$work/set/set_display.c" &&
        "$CC" -std=c11 $WARNINGS -I"$work/set" -c -o "$work/limner.o" "$work/set/limner.c" &&
        nm "$work/set.o" | grep -q 'T set_movers_display_show' && nm "$work/set.o" | grep -q 'T set_icosahedron_display_show' &&
        "$CC" -std=c11 $WARNINGS -I"$work/set" -c -o "$work/main.o" "$work/set/main.c"
}

# The page says how the others are shown.
others_are_told() {
    exports "$model" sim/scenes/rooms.obj --for plain --size 64x64 -o "$work/two" && grep -q 'TWO_MEMORY()` has room .*`two_rooms_begin()` shows' "$work/two/README.md" &&
        grep -q 'two_rooms_begin(' "$work/two/two.h" && exports "$model" sim/scenes/rooms.obj --for plain --panel st7735 -o "$work/two" &&
        grep -q '`two_rooms_display_show()` shows the second' "$work/two/README.md" && ! grep -q 'of several, which' "$work/near/README.md"
}

# Their sources are more than a page of names.
many_models() {
    mkdir "$work/many"
    for i in $(seq 100 175); do
        cp "$model" "$work/many/a_model_with_a_name_that_goes_on_and_on_$i.obj"
    done
    exports "$work/many"/*.obj --for cmake --size 16x16 -o "$work/many_models" || return 1
    for source in "$work/many_models"/src/*.c; do
        grep -q " src/$(basename "$source")\>" "$work/many_models/CMakeLists.txt" || { basename "$source" && return 1; }
    done
}

# The example looks where the model is, however far from the origin.
example_looks_at_it() {
    awk '/^v / { printf "v %.4f %s %.4f\n", $2 + 1234567, $3, $4 - 54321; next } { print }' "$model" >"$work/far.obj"
    exports "$model" --for plain -o "$work/near" && exports "$work/far.obj" --for plain -o "$work/far" || return 1
    for folder in near far; do
        sed -n 's/.*POINT_Q8(\(.*\));/\1/p' "$work/$folder/main.c" | tr -d ,
    done | awk 'NR == 1 { x = $1; z = $3; next } { d = $1 - x - 1234567; e = $3 - z + 54321; print d, e; exit !(d * d + e * e < 0.01) }'
}

# An adapter's picture is asked for by its size alone; no display of ours is there then.
size_alone() {
    exports "$model" --for arduino --size 128x96 -o "$work/sized" && [ ! -e "$work/sized/src/limner_display.h" ] &&
        grep -q 'SIZED_MEMORY(128, 96)' "$work/sized/examples/sized_TFT_eSPI/sized_TFT_eSPI.ino"
}

# A list that somebody else wrote leads nowhere else.
list_stays_inside() {
    exports "$model" --for plain -o "$work/listed" && echo kept >"$work/outside" && echo kept >"$work/listed-too" || return 1
    printf '00000000 ../outside\n00000000 src/../../outside\n00000000 %s\n' "$work/listed-too" >>"$work/listed/limner.files"
    exports "$model" --for plain -o "$work/listed" && [ -s "$work/outside" ] && [ -s "$work/listed-too" ]
}

needs_a_name() {
    mkdir -p "$work/named" && ln -s named "$work/linked" || return 1
    says 1 "^limner: -o $work/named/.: gives the export no name; name the folder itself$" "$model" --for plain -o "$work/named/." &&
        says 1 "^limner: -o ..: gives" "$model" --for plain -o .. && says 1 "^limner: -o /: gives" "$model" --for plain -o / &&
        says 1 "^limner: $work/linked: is a link" "$model" --for plain -o "$work/linked"
}

# What would start nothing.
needs_a_display() {
    says 1 "^limner: --fill: st7789 does not keep pictures so" "$model" --for plain --panel st7789 --fill -o "$work/none" &&
        [ ! -e "$work/none" ] && says 0 "^limner: --fill: is for a struct lim_target of yours" "$model" --for plain --fill -o "$work/filled" &&
        says 0 "^limner: --delta: is for a struct lim_target of yours; the example" "$model" --for plain --delta -o "$work/delta" &&
        exports sim/scenes/rooms.obj --for plain --panel ssd0323 --fill -o "$work/kept"
}

# As a shell reads it, however long and strange.
command_is_told() {
    odd="it's \$odd"
    mkdir "$work/many words" && for i in $(seq 100 140); do cp "$model" "$work/many words/a model with a name that goes on $i.obj"; done
    exports "$work/many words"/*.obj --for plain --size 16x16 -o "$work/$odd" || return 1
    told=$(sed -n 's/^Written by `limner export \(.*\)` (Limner.*/\1/p' "$work/$odd/README.md")
    eval "set -- $told"
    [ $# -eq 47 ] && [ "$1" = "$work/many words/a model with a name that goes on 100.obj" ] && shift 46 && [ "$1" = "$work/$odd" ]
}

# What the example takes beside the renderer's own memory.
ram_is_told() { # LEAST OPTION...
    least=$1
    shift
    exports sim/scenes/rooms.obj --for plain "$@" -o "$work/told" || return 1
    sed -n 's/.* and \([0-9]*\) of RAM, without.*/\1/p' "$work/told/README.md" | awk -v least="$least" '{ print; known = $1 >= least } END { exit !known }'
}

ram_has_lines() { ram_is_told 153600 --size 320x240 --method painter && ram_is_told 57600 --panel st7789 --framebuffer --method nearest; }

names_what_is_there() { # FOLDER: paths in its page, with the folder's own name before them or without
    grep -o '`[^` ]*/[^` ]*`\|`limner[a-z_]*\.h`\|"[^"]*/[^"]*"' "$1/README.md" | tr -d '`"' | sort -u | while read -r named; do
        case $named in
        src/main.cpp) continue ;;
        "$(basename "$1")"/*) named=${named#*/} ;;
        esac
        [ -e "$1/$named" ] || [ -e "$1/src/$named" ] || [ -e "$1/include/$named" ] || { echo "$1: there is no $named" && return 1; }
    done
}

page_is_whole() { # FOLDER: no word is left to be replaced, and the licence is there
    ! grep -rn '@[A-Za-z_]*@' "$1" && grep -q 'MIT License' "$1/LICENSE" && grep -q "^Written by .limner export " "$1/README.md" && names_what_is_there "$1"
}

pages_are_whole() {
    for world in arduino idf pico cmake plain; do
        exports "$model" --for $world --panel st7789 -o "$work/pages/$world" && page_is_whole "$work/pages/$world" &&
            exports "$model" --for $world --size 64x64 -o "$work/pages/$world-sized" && page_is_whole "$work/pages/$world-sized" &&
            exports "$model" --for $world --panel sh1106 -o "$work/pages/my-$world" && page_is_whole "$work/pages/my-$world" || { echo "$world" && return 1; }
    done
}

# Of README: three commands at most each, run as they stand.
readme_commands() { # WORLD: its commands, with the model of the tests and what stands in for an SDK
    sed -n "/^    build\/limner export .*--for $1/,/^\$/p" README.md | sed 's/^ *//; s/ *#.*//' | grep . >"$work/commands"
    cat "$work/commands"
    [ -s "$work/commands" ] && [ "$(wc -l <"$work/commands")" -le 3 ] || return 1
    (cd "$work" && mkdir -p build && ln -sf "$limner" build/limner && cp "$model" house.obj &&
        PICO_SDK_PATH=$here/tests/export/stubs/pico HOME=$work sh -e commands) >"$work/said" 2>&1 || { cat "$work/said" && return 1; }
}

readme_pico() {
    command -v cmake >/dev/null || { echo "cmake is missing" && return 1; }
    readme_commands pico && [ -x "$work/build-house/house_example" ]
}

readme_arduino() { readme_commands arduino && [ -f "$work/Arduino/libraries/house/library.properties" ]; }

here=$(pwd)
tap_check "an unknown world is refused, and what is missing named" unknown_world
tap_check "foreign files stay, and the export is refused" foreign_files_stay
tap_check "so do files that somebody changed" changed_files_stay
tap_check "its own folder it writes anew" writes_anew
tap_check "a file is no folder" is_a_file
tap_check "of an export that failed nothing is left" nothing_is_left
tap_check "a scene too large for the smallest board is told, with bytes" too_large
tap_check "names that toolchains cannot have are mapped, and told" names_are_mapped
tap_check "a component has no blank in its name" idf_takes_plain_names
tap_check "--panel and --size are not abbreviated" options_in_full
tap_check "names of nodes do not leave their comment" nodes_say_nothing
tap_check "several models share one folder" several_models
tap_check "and so do many with long names" many_models
tap_check "an example looks at a model that is far from the origin" example_looks_at_it
tap_check "of several scenes the page says how others are shown" others_are_told
tap_check "a list of files leads nowhere out of its folder" list_stays_inside
tap_check "an export needs a name of its own" needs_a_name
tap_check "what would draw on no display is refused, or told" needs_a_display
tap_check "the page has the command, as it was typed" command_is_told
tap_check "it tells the RAM of all lines where they are all there" ram_has_lines
tap_check "a size alone leaves the display to another library" size_alone
tap_check "pages have no word left to be replaced" pages_are_whole
if command -v cmake >/dev/null; then
    tap_check "README's commands for a Pico" readme_pico
else
    tap_skip "README's commands for a Pico" "cmake is missing"
fi
tap_check "README's commands for an Arduino library" readme_arduino
tap_done
