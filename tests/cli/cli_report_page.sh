# SPDX-License-Identifier: MIT
#
# `limner report`: one page that is valid, whole, loads nothing, and is the same every time; its pictures are render's, its
# figures those of compile, measure and the boards' own files; what it advises follows from the scene; names are escaped;
# refusals leave nothing.
. tests/tap.sh

built=$(cd "$BUILD" && pwd)
limner=$built/limner
source=$(pwd)
scenes=$source/sim/scenes
cp -r "$built/scenes/textured" "$work"
cp "$scenes/rooms.obj" "$scenes/teapot.obj" "$scenes/movers.gltf" "$scenes/icosahedron.obj" "$work"
head -n 6 "$scenes/rooms.cam" >"$work/walk.cam"
cd "$work" || exit 1
export LIMNER_TIME_LIMIT=0

page() { # MODEL NAME [OPTION...]
    model=$1 name=$2
    shift 2
    "$limner" report "$model" -o "$name.html" --tries 100 --size 120x120 "$@" && [ -s "$name.html" ] && ! find . -name '*.part' | grep .
}

# Text without tags, entities as they are meant, a block or a row a line.
text_of() {
    tr '\n' ' ' <"$1" | sed 's/<style>.*<\/style>//; s/<\/\(tr\|p\|li\|h1\|h2\|h3\|figcaption\|div\)>/\n/g' |
        sed 's/src="[^"]*"//g; s/<[^>]*>/ /g; s/&#8239;//g; s/&#215;/x/g; s/  */ /g; s/^ //; s/ $//'
}
has() { text_of "$1" | grep -E -- "$2" || { echo "nothing like: $2"; return 1; }; } # PAGE PATTERN

is_valid() { tidy -qe -utf8 "$1" >said 2>&1 || [ $? -eq 0 ] || { cat said; return 1; }; [ ! -s said ] || { cat said; return 1; }; }
loads_nothing() {
    ! grep -oE '<(script|link|iframe|object|embed|base|form)|(src|href)="[^d#][^"]{0,40}|url\(|@import|https?:' "$1" && grep -q 'src="data:image/png;base64,' "$1"
}
has_sections() {
    for id in next views worst cost memory tree front; do
        [ "$(grep -c "<section id=\"$id\">" "$1")" -eq 1 ] && grep -q "href=\"#$id\"" "$1" || { echo "$id"; return 1; }
    done
}

page_of() { # MODEL NAME [OPTION...]: all that holds for any page
    tap_check "$2: a page" page "$@"
    tap_check "$2: valid" is_valid "$2.html"
    tap_check "$2: loads nothing" loads_nothing "$2.html"
    tap_check "$2: every section, and the way there" has_sections "$2.html"
}
quick='--tree bsp --splitter fewest' # no other trees are tried
# shellcheck disable=SC2086 # words
{
    page_of rooms.obj rooms --camera walk.cam
    page_of teapot.obj teapot $quick
    page_of movers.gltf movers
    page_of icosahedron.obj solid
    page_of textured/textured.obj textured $quick
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >triangle.obj
page_of triangle.obj triangle --precision exact

same_again() { page triangle.obj again --precision exact && cmp triangle.html again.html; }
tap_check "the same bytes again" same_again

# -- Pictures ----------------------------------------------------------------------------------------------------------
picture() { # PAGE NUMBER: into picture.png
    grep -o 'src="data:image/png;base64,[^"]*"' "$1" | sed -n "$2{s/.*base64,//; s/\"\$//; p}" | base64 -d >picture.png
}
hash_of() { "$limner" hashes "$1" | sed 's/.*hash \([0-9a-f]*\).*/\1/'; }
views_are_renders() { # MODEL NAME COUNT RENDER'S-OPTION...
    model=$1 name=$2 count=$3
    shift 3
    rm -rf drawn && "$limner" render "$model" --size 120x120 --panel memory -o 'drawn/%d.png' "$@" || return 1
    for i in $(seq "$count"); do
        picture "$name.html" "$i" && [ "$(hash_of picture.png)" = "$(hash_of drawn/$((i - 1)).png)" ] || { echo "view $i"; return 1; }
    done
}
tap_check "views of a file are render's" views_are_renders rooms.obj rooms 6 --camera walk.cam
tap_check "what stands alone is seen from an orbit" views_are_renders teapot.obj teapot 12 --frames 12 --tree bsp --splitter fewest
is_random_inside() { page rooms.obj inside --tree bsp --splitter fewest && has inside.html '24 random cameras' && views_are_renders rooms.obj inside 12 --camera random:1:24 --tree bsp --splitter fewest; }
tap_check "a closed building is seen from inside" is_random_inside
counts_pictures() { [ "$(grep -c '<img ' rooms.html)" -eq 15 ] && [ "$(grep -c '<img ' teapot.html)" -eq 27 ]; }
tap_check "as many pictures as views, differences and worst frames" counts_pictures

# -- Figures -----------------------------------------------------------------------------------------------------------
compiled() { sed -n "s/^ *$1   *\([0-9.]*\).*/\1/p" report | head -n 1; } # NAME
figures_are_compiles() {
    "$limner" compile rooms.obj --report --size 120x120 >report && has rooms.html "^splits $(compiled splits)\$" && has rooms.html "^nodes $(compiled nodes)\$" && has rooms.html "^depth $(compiled 'depth of the tree')\$" &&
        has rooms.html "^vertices [0-9]+ $(compiled vertices)\$" && has rooms.html "^polygons [0-9]+ $(compiled polygons)\$" &&
        has rooms.html "^in all $(compiled 'in all')\$" && has rooms.html "^in all $(($(compiled 'working memory, bytes') + 240))\$"
}
tap_check "flash, RAM and tree are compile's" figures_are_compiles
wrong_pixels_are_measures() {
    "$limner" measure rooms.obj --camera walk.cam --size 120x120 --no-cost >table || return 1
    for name in draft fast fine exact; do
        percent=$(awk -F '|' -v name=$name '{ gsub(/ /, "") } $2 == name { print $4 }' table)
        [ -n "$percent" ] && has rooms.html "^[0-9] $name (\(this page\) )?$percent " || return 1
    done
}
tap_check "wrong pixels of each precision are measure's" wrong_pixels_are_measures
parts_make_the_whole() { # PAGE HEAD
    text_of "$1" | awk -v head="$2" 'index($0, head) { inside = 1; next } inside && /^in all / { print sum, $3; exit sum != $3 } inside { sum += $NF }'
}
for name in rooms teapot movers solid textured triangle; do
    tap_check "$name: bytes of flash by array add up" parts_make_the_whole $name.html 'flash, by array'
    tap_check "$name: bytes of RAM by pool add up" parts_make_the_whole $name.html 'RAM, by pool'
done
# What is shared holds so many cells, gaps and active polygons as NAME.c's limits say, of 4, 6 and 36 bytes on a small
# screen (firmware/stages.h); a line's head is two words.
pools_have_their_sizes() {
    "$limner" compile "$scenes/rooms.obj" --size 120x120 -o "$work/limits" >/dev/null || return 1
    sum=$(sed -n 's/.*\.retained_cells = \([0-9]*\), \.gaps = \([0-9]*\), \.active = \([0-9]*\).*/4 * \1 + 6 * \2 + 36 * \3/p' "$work/limits.c")
    text_of rooms.html | awk -v shared_b="$(($sum))" '
        /^gaps, polygons that wait/ { shared = $NF - shared_b; print $NF, shared_b }
        /^heads of the screen/ { heads = $(NF - 1) * 8 == $NF }
        END { exit !(heads && shared >= 0 && shared < 4) }'
}
tap_check "pools take what their entries do" pools_have_their_sizes
histogram_has_all_nodes() {
    bars=$(sed -n '/aria-label="nodes by depth"/,/<\/svg>/p' rooms.html | grep -c '<rect')
    has rooms.html "^depth $bars\$"
}
tap_check "a bar for each depth of the tree" histogram_has_all_nodes
boards_are_theirs() {
    grep -o '{"[a-z0-9]*", "[^"]*", [0-9]*, [0-9]*}' "$source/sim/page/page_board.c" | sed 's/{"\([a-z0-9]*\)", "[^"]*", /\1 /; s/[,}]//g' >there
    cat there && [ "$(wc -l <there)" -ge 7 ] || return 1
    while read -r board ram_b flash_b; do
        grep -qE "^ *RAM_B *:= $ram_b\$" "$source/boards/$board/board.mk" || { echo "$board: RAM"; return 1; }
        [ "$flash_b" = 0 ] || grep -qE "^FLASH_B *:= $flash_b\$" "$source/boards/$board/board.mk" || { echo "$board: flash"; return 1; }
    done <there
}
tap_check "boards have what their board.mk says" boards_are_theirs
precision_is_the_pages() { has triangle.html 'profile exact' && has triangle.html 'exact \(this page\)' && ! has triangle.html 'fast \(this page\)'; }
meshes_are_rows() { has rooms.html '^[0-9]+ a mesh, by distance [0-9]+[.][0-9]' && has rooms.html '^[0-9]+ a mesh, by depth [0-9]+[.][0-9]'; }
tap_check "a mesh, by distance and by depth, is among the choices" meshes_are_rows
tap_check "--precision is what the page is about" precision_is_the_pages

# -- Advice ------------------------------------------------------------------------------------------------------------
# Triangles that cut each other: a tree of many splits.
awk 'BEGIN {
    srand(3)
    for (i = 0; i < 30; i++) {
        x = 6 * rand(); y = 6 * rand(); z = 6 * rand()
        for (k = 0; k < 3; k++) printf "v %f %f %f\n", x + 5 * (rand() - 0.5), y + 5 * (rand() - 0.5), z + 5 * (rand() - 0.5)
        print "f", 3 * i + 1, 3 * i + 2, 3 * i + 3
    }
}' >cut.obj
splits_are_told() { page cut.obj cut --tree bsp && has cut.html 'splits [0-9]+ times on [0-9]+ polygons.*--tree clusters' && ! has rooms.html 'splits [0-9]+ times'; }
tap_check "many splits: clusters" splits_are_told
pools_are_told() { page rooms.obj short --tries 1500 --size 240x240 --tree bsp --splitter fewest && has short.html 'walks the tree [0-9]+ times.*--worst' && page rooms.obj larger --worst=1500 --size 240x240 --tree bsp --splitter fewest && ! has larger.html 'walks the tree [0-9]+ times'; }
tap_check "pools that are short in the worst frame: --worst" pools_are_told
errors_are_told() { page rooms.obj draft --precision draft --tree bsp --splitter fewest && has draft.html 'of the pixels are wrong; precision fast has' && ! has teapot.html 'of the pixels are wrong'; }
tap_check "many wrong pixels: a finer precision" errors_are_told
memory_is_told() {
    page rooms.obj large --size 1000x1000 --framebuffer --camera walk.cam && has large.html 'Pico: it has too little RAM' && has large.html 'Raspberry Pi Pico 264.0 2048 too little RAM' &&
        has rooms.html 'Raspberry Pi Pico 264.0 2048 fits' && ! has rooms.html 'Pico: it has too little RAM'
}
tap_check "boards without room are named" memory_is_told

# -- Names -------------------------------------------------------------------------------------------------------------
escapes() {
    name='a<script>b&"c'\''d'
    cp triangle.obj "$name.obj" && page "$name.obj" escaped && is_valid escaped.html && loads_nothing escaped.html &&
        grep -q '<h1>a&lt;script&gt;b&amp;&quot;c&#39;d</h1>' escaped.html && grep -q '<title>a&lt;script&gt;' escaped.html
}
tap_check "a model's name is text" escapes
broken_utf8() {
    name=$(printf 'n\303\251\377\355\240\200x')
    cp triangle.obj "$name.obj" && page "$name.obj" utf8 && is_valid utf8.html && iconv -f UTF-8 -t UTF-8 utf8.html >copy &&
        grep -q "$(printf '<h1>n\303\251????x</h1>')" utf8.html
}
tap_check "bytes that are no UTF-8 are none in the page" broken_utf8

# -- Refusals ----------------------------------------------------------------------------------------------------------
refuses() { # WORDS OPTION...
    words=$1
    shift
    rm -rf left && mkdir left && cp triangle.obj left/ && echo old >left/old.html && (cd left && "$limner" report "$@" >../out 2>../said)
    status=$?
    cat said && ls left
    [ "$status" -eq 1 ] && [ ! -s out ] && [ "$(wc -l <said)" -eq 1 ] && grep -qF -- "$words" said && [ "$(ls left | tr '\n' ' ')" = 'old.html triangle.obj ' ] &&
        [ "$(cat left/old.html)" = old ]
}
tap_check "no -o is refused" refuses '-o FILE.html' triangle.obj
tap_check "no model is refused" refuses 'needs a model' -o x.html
tap_check "a model that is not there is refused, and an old page stays" refuses none.obj none.obj -o old.html
tap_check "the model's own file is refused" refuses triangle.obj triangle.obj -o triangle.obj
tap_check "a folder that cannot be is refused" refuses triangle.obj triangle.obj -o triangle.obj/x.html
tap_check "two precisions are refused" refuses 'one --precision' triangle.obj -o x.html --precision fast,fine
tap_check "an unknown processor is refused" refuses '--core z80' triangle.obj -o x.html --core z80
broken_models() {
    : >empty.obj
    printf 'v 0 0 0\nv 1 0 0\nf 1 2 3\n' >missing.obj
    head -c 3000 rooms.obj >half.obj
    for name in empty missing half; do
        "$limner" report "$name.obj" -o "$name.html" >out 2>said && return 1
        cat said
        [ "$(wc -l <said)" -eq 1 ] && grep -q "^limner: $name.obj:" said && [ ! -e "$name.html" ] || return 1
    done
    ! find . -name '*.part' | grep .
}
tap_check "broken models are refused, and nothing is written" broken_models
in_time() {
    timeout 60 "$limner" report rooms.obj -o limited.html --time-limit 4 >out 2>said
    status=$?
    cat said
    case $status in
    0) is_valid limited.html ;;
    1) [ ! -e limited.html ] && grep -q 'stopped after' said ;;
    *) return 1 ;;
    esac
}
tap_check "a page, or an error, in a short time" in_time
tap_done
