# SPDX-License-Identifier: MIT
#
# Reports: every one in tests/reports draws what it drew; one that is made of any scene is whole, says nothing of this
# machine's folders, and is the same file each time; frames that differ are named; and what is damaged or forged is
# refused in a line, and writes nothing outside of its own folder.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
mkdir -p "$work/tmp" "$work/made"
export TMPDIR="$work/tmp"

for report in tests/reports/*.tar; do
    tap_check "$report" "$limner" replay "$report"
done

# A report of a scene is made twice, replayed from elsewhere, and has no path of this machine in it.
report_of() { # NAME ARGUMENT...
    name=$1
    shift
    "$limner" report-bug "$@" -o "$work/made/$name.tar" && "$limner" report-bug "$@" -o "$work/made/again.tar" &&
        cmp "$work/made/$name.tar" "$work/made/again.tar" &&
        (cd / && "$limner" replay "$work/made/$name.tar") &&
        ! tar -xOf "$work/made/$name.tar" report.txt | grep -F -e "$(pwd)" -e "$work" -e "$(uname -n)" -e "$HOME/" &&
        leaves_nothing
}

leaves_nothing() {
    [ -z "$(ls -A "$work/tmp")" ] || { ls -R "$work/tmp"; return 1; }
}

holds() { # NAME FILE...
    name=$1
    shift
    printf '%s\n' report.txt "$@" | sort >"$work/expected"
    tar -tf "$work/made/$name.tar" | sort | diff "$work/expected" -
}

# A textured model in folders of its own, its picture and materials beside it; from a path with steps in it.
textured() {
    mkdir -p "$work/model/pictures"
    cp "$BUILD/scenes/textured/textured.cam" "$work/model/"
    cp -r "$BUILD"/scenes/textured/. "$work/model/"
    report_of textured "$work/./model/textured.obj" --camera "$work/model/textured.cam" --size 32x24 --precision fine
}

packs_what_it_names() {
    tar -tf "$work/made/textured.tar" >"$work/listed" && grep -qx scene/textured.obj "$work/listed" &&
        grep -qx scene/textured.mtl "$work/listed" && grep -qE '^scene/.*\.(png|jpg)$' "$work/listed"
}

# A glTF with a buffer in a file.
gltf_with_buffer() {
    mkdir -p "$work/gltf/buffers"
    printf '\000\000\000\000\000\000\000\000\000\000\000\000\000\000\200\077\000\000\000\000\000\000\000\000\000\000\000\000\000\000\200\077\000\000\000\000\000\000\001\000\002\000' \
        >"$work/gltf/buffers/triangle.bin"
    cat >"$work/gltf/triangle.gltf" <<END
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"buffers":[{"uri":"buffers/triangle.bin","byteLength":42}]}
END
    report_of gltf "$work/gltf/triangle.gltf" --size 16x16 &&
        holds gltf scene/triangle.gltf scene/buffers/triangle.bin frames.hashes
}

compiled() {
    "$limner" compile sim/scenes/glass.obj -o "$work/glass" >/dev/null && report_of compiled "$work/glass.lim" --size 24x24 &&
        holds compiled scene/glass.lim frames.hashes
}

# Face numbers change what is drawn: faces are not merged.
keeps_options() {
    report_of options sim/scenes/glass.obj --size=24x24 --method painter --fov 40 --ids "$work/ids" --gif "$work/x.gif" \
        --camera random:3:2 && tar -xOf "$work/made/options.tar" report.txt >"$work/text" && [ ! -e "$work/x.gif" ] &&
        grep -qx 'option: --method=painter' "$work/text" && grep -qx 'option: --ids=faces.ids' "$work/text" &&
        grep -qx 'option: --camera=random:3:2' "$work/text" && ! grep gif "$work/text"
}

# Those that all commands take which read models, and which change what is drawn.
keeps_model_options() {
    report_of plain "$work/model/textured.obj" --no-textures --camera random:3:2 --size 24x24 &&
        tar -xOf "$work/made/plain.tar" report.txt | grep -x 'option: --no-textures' &&
        report_of small "$work/model/textured.obj" --texture-budget 1 --camera random:3:2 --size 24x24 &&
        tar -xOf "$work/made/small.tar" report.txt | grep -x 'option: --texture-budget=1' &&
        ! "$limner" report-bug "$work/model/textured.obj" --sky "$(printf 'x\noption: --size=9x9')" -o "$work/none.tar" 2>"$work/err" &&
        grep -qx 'limner: --sky=x: a report holds options of one line' "$work/err" && [ ! -e "$work/none.tar" ] &&
        ! "$limner" replay "$work/made/textured.tar" --doors ajar 2>"$work/err" && grep -q 'no such doors' "$work/err" &&
        change small 's/^option: --texture-budget=1$/option: --texture-budget=much/' && refused 'not a number'
}

# What is refused today is refused by the same words; and where it is not, that is a difference.
refusals() {
    report_of refused sim/scenes/glass.obj --size 16x16 --method convex &&
        change refused 's/^option: --method=convex$/option: --method=painter/' && refused 'is drawn now, and was refused'
}

is_no_report_at_all() { # what render cannot make sense of is a mistake of whoever typed it
    ! "$limner" report-bug sim/scenes/glass.obj --method none -o "$work/none.tar" 2>"$work/err" &&
        grep -q 'no such method\|--method' "$work/err" && [ ! -e "$work/none.tar" ] && leaves_nothing
}

# NAME's report with another report.txt, as "$work/changed.tar".
change() { # NAME SED-SCRIPT
    rm -rf "$work/changed" && mkdir "$work/changed" && tar -xf "$work/made/$1.tar" -C "$work/changed" &&
        sed -i "$2" "$work/changed/report.txt" && pack_files
}

# "$work/changed.tar" is refused in one line that names the file and says why, and nothing is left.
refused() { # PATTERN [FILE]
    status=0
    (ulimit -v 4000000; timeout 60 "$limner" replay "${2:-$work/changed.tar}") >"$work/out" 2>"$work/err" || status=$?
    cat "$work/err"
    [ $status -eq 1 ] && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/err")" -eq 1 ] && grep -q -- "$1" "$work/err" &&
        grep -q "^limner: .*\.tar" "$work/err" && leaves_nothing
}

# A hash is changed, and the list's checksum with it.
names_the_frame() {
    rm -rf "$work/changed" && mkdir "$work/changed" && tar -xf "$work/made/options.tar" -C "$work/changed" &&
        awk '{ if (NR == 2) sub(/[0-9a-f]+$/, "0123456789abcdef"); print }' "$work/changed/frames.hashes" >"$work/hashes" &&
        cp "$work/hashes" "$work/changed/frames.hashes" && relist frames.hashes && pack_files && refused 'frame 1'
}

# The sums that report.txt has of a file are made those of what is in the folder.
relist() { # NAME
    sum=$(gzip -c "$work/changed/$1" | tail -c 8 | od -An -tx4 --endian=little | awk '{ print $1 }')
    size=$(wc -c <"$work/changed/$1")
    sed -i "s,^file: [0-9]* [0-9a-f]* $1\$,file: $size $sum $1," "$work/changed/report.txt"
}

pack_files() { # report.txt, then the others, no folders
    # shellcheck disable=SC2046 # names without spaces
    (cd "$work/changed" && tar --format=ustar -cf "$work/changed.tar" report.txt $(find . -type f ! -name report.txt -printf '%P\n' | sort))
}

accepts_what_is_drawn_now() { # -o: a report that names another frame becomes one that passes
    "$limner" replay "$work/changed.tar" -o "$work/new.tar" && "$limner" replay "$work/new.tar" &&
        cmp "$work/new.tar" "$work/made/options.tar" && leaves_nothing
}

# Options that a stranger wrote.
forged_option() { # OPTION PATTERN
    rm -rf "$work/changed" && mkdir "$work/changed" && tar -xf "$work/made/options.tar" -C "$work/changed" &&
        sed -i "s|^option: --fov=40\$|option: $1|" "$work/changed/report.txt" && pack_files && refused "$2"
}

forged_options() {
    forged_option '-o../x%d.png' 'names no files but its own' && forged_option "--gif=$work/stolen.gif" 'names no files' &&
        forged_option '--check=/etc/passwd' 'names no files' && forged_option '--camera=/etc/passwd' 'names no files' &&
        forged_option '--camera=cameras.cam' 'not in the report' && forged_option '--write-hashes=x' 'names no files' &&
        forged_option '--ids=../ids' 'names no files' && forged_option '--nonsense' 'no such option' &&
        forged_option 'scene/glass.obj' 'is none' && forged_option '--trust-paths' 'trusts no paths' &&
        forged_option '--sky' 'is none\|no such option' && forged_option '--no-textures=yes' 'is none\|no such option' && [ ! -e "$work/stolen.gif" ]
}

# Files where none may be.
forged_file() { # TAR-OPTIONS-AND-NAMES...
    rm -f "$work/changed.tar"
    (cd "$work/changed" && tar --format=ustar -cf "$work/changed.tar" report.txt && tar --format=ustar -rf "$work/changed.tar" "$@")
}

forged_names() {
    rm -rf "$work/changed" && mkdir -p "$work/changed/scene" && tar -xf "$work/made/options.tar" -C "$work/changed" &&
        echo out >"$work/outside" && cp "$work/outside" "$work/changed/y" && ln -s /etc/passwd "$work/changed/scene/link" &&
        ln "$work/changed/y" "$work/changed/scene/hard" && mkfifo "$work/changed/scene/pipe" || return 1
    forged_file -P --transform "s,^y\$,../../escaped," y && refused 'no file that a report has' &&
        forged_file -P --transform "s,^y\$,$work/escaped," y && refused 'no file that a report has' &&
        forged_file -P --transform 's,^y$,scene/../../escaped,' y && refused 'no file that a report has' &&
        forged_file -P --transform 's,^y$,scene//escaped,' y && refused 'no file that a report has' &&
        forged_file y && refused 'no file that a report has' && forged_file scene/link && refused 'not a plain file' &&
        forged_file scene/pipe && refused 'not a plain file' && forged_file scene && refused 'report has\|not a plain file' &&
        forged_file scene/glass.obj && refused 'are listed there' && tar --format=ustar -rf "$work/changed.tar" -C "$work/changed" scene/glass.obj &&
        refused 'there twice' && forged_file scene/hard y && refused 'no file that a report has\|not a plain file' &&
        forged_file report.txt && refused 'no file that a report has' &&
        [ ! -e "$work/escaped" ] && [ ! -e "$work/tmp/escaped" ] && [ ! -e escaped ]
}

# A file said to have 8 GB less a byte, the most that the format has digits for; and one of a hole of 4 GB.
forged_sizes() {
    (cd "$work/changed" && tar --format=ustar -cf "$work/head.tar" report.txt && truncate -s 8589934591 "$work/huge" &&
        tar --format=ustar -cf - -C "$work" --transform 's,huge,scene/huge,' huge | head -c 1024 >"$work/tail") || return 1
    rm -f "$work/huge"
    size=$(($(tar -tvf "$work/head.tar" | awk '{ print $3 }') + 511))
    { head -c $((512 + size / 512 * 512)) "$work/head.tar" && cat "$work/tail"; } >"$work/changed.tar"
    refused 'too large' || return 1
    truncate -s 4G "$work/changed/scene/hole" && (cd "$work/changed" && tar --format=gnu -S -cf "$work/changed.tar" report.txt scene/hole) &&
        rm "$work/changed/scene/hole" && refused 'too large'
}

# At any length; and with any byte changed, which is noticed or changes nothing.
cut_short() {
    size=$(wc -c <"$work/made/gltf.tar")
    at=0
    while [ $at -lt $((size - 1024)) ]; do
        head -c $at "$work/made/gltf.tar" >"$work/changed.tar"
        refused '' || { echo "cut at $at of $size"; return 1; }
        at=$((at + 331))
    done
}

damaged() {
    size=$(wc -c <"$work/made/gltf.tar")
    at=5
    while [ $at -lt $((size - 1024)) ]; do
        cp "$work/made/gltf.tar" "$work/changed.tar"
        printf '\245' | dd of="$work/changed.tar" bs=1 seek=$at conv=notrunc 2>/dev/null
        status=0
        timeout 60 "$limner" replay "$work/changed.tar" >"$work/out" 2>"$work/err" || status=$?
        [ $status -le 1 ] && [ "$(cat "$work/out" "$work/err" | wc -l)" -eq 1 ] && leaves_nothing || { echo "byte $at: $status"; cat "$work/err"; return 1; }
        at=$((at + 397))
    done
}

is_no_report() {
    cp README.md "$work/changed.tar" && refused 'no report\|report has' && : >"$work/changed.tar" && refused 'no report' &&
        refused 'No such file' "$work/missing.tar" && refused 'regular file' "$work/tmp/../fifo.tar"
}

outside_of_the_folder() { # of the model, from which its picture is a step up
    mkdir -p "$work/up/model" && cp "$BUILD"/scenes/textured/*.png "$work/up/" 2>/dev/null
    printf 'newmtl a\nmap_Kd ../picture.png\n' >"$work/up/model/a.mtl"
    printf 'mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n' >"$work/up/model/a.obj"
    cp "$(find "$BUILD/scenes/textured" -name '*.png' | head -n 1)" "$work/up/picture.png" || return 1
    if "$limner" report-bug "$work/up/model/a.obj" --size 16x16 -o "$work/up.tar" >"$work/out" 2>"$work/err"; then
        ! tar -tf "$work/up.tar" | grep picture
    else
        cat "$work/err" && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -e "$work/up.tar" ] && leaves_nothing
    fi
}

# Trusted, it names materials a step up, pictures two steps up, and one through a link: they lie in the report as they do
# on disk, without the names of folders above, and whoever replays it need not trust it.
trusted() {
    mkdir -p "$work/top/some/deep" "$work/top/pictures" && cp "$BUILD"/scenes/textured/textured.* "$work/top/some/deep/" &&
        cp "$BUILD"/scenes/textured/*.png "$BUILD"/scenes/textured/*.jpg "$work/top/pictures/" &&
        mv "$work/top/pictures/rug.png" "$work/top/rug.png" && ln -s ../../rug.png "$work/top/some/deep/rug.png" || return 1
    sed 's,^map_Kd ,&../../pictures/,; s,../../pictures/rug,rug,' "$work/top/some/deep/textured.mtl" >"$work/top/some/textured.mtl"
    rm "$work/top/some/deep/textured.mtl"
    sed -i 's,^mtllib ,&../,' "$work/top/some/deep/textured.obj"
    "$limner" render "$work/top/some/deep/textured.obj" --trust-paths --size 32x24 --write-hashes "$work/top.hashes" &&
        "$limner" render "$BUILD/scenes/textured/textured.obj" --size 32x24 --check "$work/top.hashes" || return 1
    report_of trusted "$work/top/some/deep/textured.obj" --trust-paths --size 32x24 &&
        holds trusted scene/up/up/textured.obj scene/up/textured.mtl scene/up/up/rug.png scene/pictures/boards.png \
            scene/pictures/bricks.png scene/pictures/painting.jpg scene/pictures/wallpaper.png frames.hashes &&
        tar -xOf "$work/made/trusted.tar" frames.hashes | cmp - "$work/top.hashes"
}

# Without trust it is refused, and so it is in the report.
untrusted() {
    report_of untrusted "$work/top/some/deep/textured.obj" --size 32x24 && holds untrusted scene/textured.obj &&
        tar -xOf "$work/made/untrusted.tar" report.txt | grep "^outcome: refused .*it names '../textured.mtl'"
}

# A model below up/ may name what is in scene/, and nothing above.
goes_too_far() { # NAME-IN-THE-MODEL
    rm -rf "$work/changed" && mkdir "$work/changed" && tar -xf "$work/made/trusted.tar" -C "$work/changed" || return 1
    sed "s,^mtllib .*,mtllib $1," "$work/changed/scene/up/up/textured.obj" >"$work/changed/obj" &&
        mv "$work/changed/obj" "$work/changed/scene/up/up/textured.obj" && relist scene/up/up/textured.obj && pack_files &&
        refused "it names '$1', which lies outside of its folder"
}
goes_nowhere_else() {
    goes_too_far ../../../report.txt && goes_too_far ../../../../textured.mtl && goes_too_far ../../../scene/up/textured.mtl &&
        goes_too_far /etc/passwd && goes_too_far ../../../../../../../etc/passwd
}

absolute() {
    printf 'newmtl a\nmap_Kd %s\n' "$work/top/rug.png" >"$work/up/model/a.mtl"
    ! "$limner" report-bug "$work/up/model/a.obj" --trust-paths --size 16x16 -o "$work/absolute.tar" >"$work/out" 2>"$work/err" &&
        cat "$work/err" && [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -e "$work/absolute.tar" ] && leaves_nothing &&
        grep -q 'top/rug.png: is not named by its way from the model' "$work/err"
}

mkfifo "$work/fifo.tar"
tap_check "a report of a textured model is made, and replayed" textured
tap_check "it holds what the model names" packs_what_it_names
tap_check "a report of a glTF holds its buffer" gltf_with_buffer
tap_check "a compiled scene is reported as it is" compiled
tap_check "options are kept, and outputs left out" keeps_options
tap_check "so are those of models" keeps_model_options
tap_check "a scene that is refused is reported too" refusals
tap_check "a command line that is wrong is no report" is_no_report_at_all
tap_check "what lies outside of the model's folder is not packed" outside_of_the_folder
tap_check "unless its paths are trusted: then all is packed, and replayed without trust" trusted
tap_check "without trust the report says what render says" untrusted
tap_check "in a report nothing leads out of its files" goes_nowhere_else
tap_check "what has an absolute name is refused" absolute
tap_check "a frame that differs is named" names_the_frame
tap_check "a report can be written anew" accepts_what_is_drawn_now
tap_check "forged options are refused" forged_options
tap_check "forged names are refused, and nothing is written elsewhere" forged_names
tap_check "forged sizes are refused before they take memory" forged_sizes
tap_check "reports that are cut short are refused" cut_short
tap_check "damage is noticed, or harmless" damaged
tap_check "what is no report is refused" is_no_report
tap_done
