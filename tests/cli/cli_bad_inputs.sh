# SPDX-License-Identifier: MIT
#
# Input that has no end, is too large, is cut short or leads elsewhere: each ends within ten seconds of work and 300 MB with one
# line on standard error that says what is wrong, status 1, and leaves no file. What the same limits must let through is
# tried as well.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
models=$PWD/tests/models
for program in main blank_png; do
    # shellcheck disable=SC2086 # warnings are words
    "${CC:-gcc}" -std=c11 -O1 $WARNINGS -o "$work/$program" tests/bounded/$program.c -lz || exit 1
done
cd "$work" || exit 1
mkdir here out tmp
cd here || exit 1
export TMPDIR="$work/tmp"

within() { "$work/main" 10 300 "$limner" "$@" </dev/null; }

is_refused() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    within "$@" >../said 2>../err
    status=$?
    cat ../err
    [ $status -eq 1 ] || { echo "status $status" && return 1; }
    [ "$(wc -l <../err)" -eq 1 ] || { echo "not one line" && return 1; }
    [ ! -s ../said ] || { echo "something on stdout" && return 1; }
    grep -qE -- "^limner: .*$pattern" ../err || { echo "does not match $pattern" && return 1; }
    [ -z "$(find ../out ../tmp -mindepth 1)" ] || { find ../out ../tmp && return 1; }
}

refuse() { # NAME PATTERN ARGUMENT...
    name=$1
    shift
    tap_check "$name" is_refused "$@"
}

accepts() { # ARGUMENT...
    within "$@" >../said 2>../err || { cat ../err && return 1; }
}

compile() { # NAME PATTERN MODEL OPTION...
    name=$1 pattern=$2
    shift 2
    refuse "$name" "$pattern" compile "$@" -o ../out/deep/scene
}

# -- Models of one triangle, and what they name ------------------------------------------------------------------------

triangle='v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n'
# shellcheck disable=SC2059 # newlines
printf "${triangle}f 1 2 3\n" >good.obj

textured() { # NAME TEXTURE
    # shellcheck disable=SC2059 # newlines
    printf "mtllib $1.mtl\n${triangle}usemtl a\nf 1/1 2/2 3/3\n" >"$1.obj"
    printf 'newmtl a\nKd 1 1 1\nmap_Kd %s\n' "$2" >"$1.mtl"
}

materials() { # NAME FILE
    # shellcheck disable=SC2059 # newlines
    printf "mtllib $2\n${triangle}usemtl a\nf 1 2 3\n" >"$1.obj"
}

# 36 bytes: the corners 0 0 0, 1 0 0, 0 1 0.
corners='AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA'
gltf() { # NAME URI [BYTES [COUNT]]
    cat >"$1.gltf" <<JSON
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"$2","byteLength":${3:-36}}],
"bufferViews":[{"buffer":0,"byteLength":${3:-36}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":${4:-3},"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]}
JSON
}

mkfifo pipe pipe.lim pipe.obj pipe.png
mkdir folder folder.obj sub
echo "$corners" | base64 -d >good.bin
cp good.bin ../outside.bin
cp good.bin 'sub/a b.bin'
printf 'newmtl a\nKd 1 0 0\n' >../outside.mtl
"$work/blank_png" 8 8 >../outside.png
cp ../outside.png good.png

# -- Every option that names a file ------------------------------------------------------------------------------------

for file in pipe /dev/zero /dev/random /dev/full folder none; do
    case $file in
    none) why='No such file' ;;
    folder) why='is a folder, not a file' ;;
    pipe) why='is a pipe, not a regular file' ;;
    *) why='is a device, not a regular file' ;;
    esac
    refuse "render --camera $file" "$file: $why" render good.obj --camera $file --gif ../out/x.gif
    refuse "render --check $file" "$file: $why" render good.obj --size 64x48 --check $file
    refuse "decode $file" "$file: $why" decode $file --panel st7789 --write-hashes ../out/h
    refuse "decode --qemu $file" "$file: $why" decode good.obj --panel st7789 --qemu $file --write-hashes ../out/h
    refuse "hashes $file" "$file: $why" hashes $file --write-hashes ../out/h
    refuse "uf2 $file" "$file: $why" uf2 $file -o ../out/x.uf2
    refuse "boot2 $file" "$file: $why" boot2 $file -o ../out/x.c
    refuse "espimage $file" "$file: $why" espimage $file -o ../out/x.esp
    compile "a model that is $file" "$file: $why" $file
done
for model in pipe.obj pipe.lim; do
    refuse "render $model" 'is a pipe' render $model --gif ../out/x.gif
done
for command in 'view' 'measure --no-cost' 'compare --no-cost' splitters 'compile --report --max-error 5%'; do
    # shellcheck disable=SC2086 # words
    refuse "$command pipe.obj" 'is a pipe' $command pipe.obj
done
LIMNER_CHECK=pipe.png
export LIMNER_CHECK
refuse "LIMNER_CHECK=pipe.png" 'pipe.png: is a pipe' render good.obj --size 64x48 --write-cameras /dev/null
unset LIMNER_CHECK

# -- Textures, materials, buffers --------------------------------------------------------------------------------------

textured pipe_texture pipe
compile "a texture that is a pipe" 'texture pipe: pipe: is a pipe' pipe_texture.obj
ln -s /dev/zero zero
textured zero_texture zero
compile "a texture that is a device, by a link" 'is a device' zero_texture.obj
compile "and with trusted paths" 'is a device' zero_texture.obj --trust-paths
textured device_texture /dev/zero
compile "a texture that is a device, by its path" "names '/dev/zero', which lies outside" device_texture.obj
compile "also with trusted paths" 'is a device' device_texture.obj --trust-paths
"$work/blank_png" 20000 20000 >huge.png
textured huge_texture huge.png
compile "a PNG of 20000x20000 pixels" '20000x20000 pixels, 16777216 are the most' huge_texture.obj
refuse "hashes of it" '20000x20000 pixels, 16777216 are the most' hashes huge.png --write-hashes ../out/h
printf 'GIF89a\377\377\377\377\200\000\000\000\000\000\377\377\377,\000\000\000\000\377\377\377\377\000\002\002L\001\000;' >huge.gif
textured huge_gif huge.gif
compile "a GIF of 65535x65535 pixels" '65535x65535 pixels' huge_gif.obj
{
    printf 'BM\066\000\000\000\000\000\000\000\066\000\000\000\050\000\000\000\000\000\001\000\000\000\377\377\001\000\030\000'
    head -c 64 /dev/zero
} >huge.bmp
textured huge_bmp huge.bmp
compile "a BMP of 65536x65536 pixels, from the top down" '65536x65536 pixels' huge_bmp.obj
{
    printf '\377\330\377\340\000\020JFIF\000\001\001\000\000\001\000\001\000\000\377\300\000\021\010\377\377\377\377\003\001\042\000\002\021\001\003\021\001'
    head -c 64 /dev/zero
} >huge.jpg
textured huge_jpg huge.jpg
compile "a JPEG of 65535x65535 pixels" '65535x65535 pixels' huge_jpg.obj
truncate -s 70000000 large.png
textured large_texture large.png
compile "a texture of 70 MB" 'more than 67108864 bytes' large_texture.obj

for path in ../outside.mtl "$work/outside.mtl" sub/../../outside.mtl '..\\\\outside.mtl' ./../outside.mtl; do
    materials outside_material "$path"
    compile "mtllib $path" 'outside of its folder; --trust-paths permits that' outside_material.obj
done
for path in ../outside.png "$work/outside.png" '..\\outside.png' ../none.png; do
    textured outside_texture "$path"
    compile "map_Kd $path" 'outside of its folder; --trust-paths permits that' outside_texture.obj
done
for path in ../outside.bin "$work/outside.bin" %2e%2e/outside.bin %2E%2E%2Foutside.bin '..\\outside.bin' sub/../../outside.bin; do
    gltf outside_buffer "$path"
    compile "glTF URI $path" 'outside of its folder; --trust-paths permits that' outside_buffer.gltf
done
ln -s ../outside.bin link.bin
ln -s .. up
for path in link.bin up/outside.bin; do
    gltf linked_buffer $path
    compile "a link that leads elsewhere: $path" 'outside of its folder; --trust-paths permits that' linked_buffer.gltf
done
materials outside ../outside.mtl
for command in render view 'measure --no-cost' 'compare --no-cost' splitters play 'compile --report'; do
    # shellcheck disable=SC2086 # words
    refuse "$command looks at paths" 'outside of its folder|needs|panel' $command outside.obj
done
refuse "a command without a model has no paths to trust" 'trust-paths' hashes --trust-paths good.png

trusted() { # MODEL: its material or buffer is read after all
    accepts compile "$1" --report --trust-paths || return 1
    [ ! -s ../err ] || { cat ../err && return 1; }
}
tap_check "trusted paths: mtllib ../" trusted outside.obj
for path in ../outside.bin link.bin %2e%2e/outside.bin "$work/outside.bin"; do
    gltf trusted_buffer "$path"
    tap_check "trusted paths: glTF URI $path" trusted trusted_buffer.gltf
done
for path in good.bin 'sub/a%20b.bin' ./sub/./a%20b.bin "data:application/octet-stream;base64,$corners"; do
    gltf inner_buffer "$path"
    tap_check "what lies in the folder needs no trust: $path" accepts compile inner_buffer.gltf --report
done
mkdir ../real && cp good.obj ../real && ln -s "$work/real" linked_folder
tap_check "nor does a model in a linked folder" accepts compile linked_folder/good.obj --report
textured fine good.png
tap_check "nor a texture beside its model" accepts compile fine.obj --report
tap_check "when it is named by its whole path" accepts compile "$PWD/fine.obj" --report
"$work/blank_png" 4096 4096 >most.png
textured most_texture most.png
tap_check "a texture of 4096x4096 pixels is read" accepts compile most_texture.obj --report

# -- Sizes and counts --------------------------------------------------------------------------------------------------

yes '0 1 3 0 0 0' | head -n 3000000 >long.cam
refuse "3,000,000 cameras" 'long.cam:100001: more than 100000 cameras' render good.obj --camera long.cam --gif ../out/x.gif
truncate -s 70000000 large.cam
refuse "a camera file of 70 MB" 'more than 67108864 bytes' render good.obj --camera large.cam --gif ../out/x.gif
head -n 100000 long.cam >most.cam
refuse "a film of 7.5 billion pixels" '100000 frames of 1024x1024' render good.obj --camera most.cam --size 1024x1024 \
    --gif ../out/x.gif
{ printf '0 ' && head -c 10000 /dev/zero | tr '\0' ' '; } >line.cam
refuse "a camera line of 10 KB" 'line.cam:1: the line is longer than 4096 bytes' render good.obj --camera line.cam
printf '0 1 3 0 0 0\000 junk\n' >nul.cam
refuse "a NUL byte among cameras" 'nul.cam:1: a NUL byte' render good.obj --camera nul.cam
for number in nan inf 1e400 -1e10; do
    echo "$number 1 3 0 0 0" >number.cam
    refuse "a camera at $number" 'not finite or beyond' render good.obj --camera number.cam --gif ../out/x.gif
done
{ printf '0 ' && head -c 1000 /dev/zero | tr '\0' f; } >line.hashes
refuse "a hash of 1000 digits" 'line.hashes:1: the line is longer than 63 bytes' render good.obj --size 64x48 --check line.hashes

endless_line() { # SOURCE: of a wire log's only line
    "$@" | "$work/main" 10 300 "$limner" decode - --panel st7789 --write-hashes ../out/h 2>../err >/dev/null
    [ $? -eq 1 ] && [ "$(wc -l <../err)" -eq 1 ] && grep -E 'standard input:1: (the line is longer than 16777216 bytes|a NUL byte)$' ../err &&
        [ -z "$(ls ../out)" ]
}
tap_check "a wire log from a pipe, zeros without end" endless_line cat /dev/zero
spaces() { yes '' | tr '\n' ' '; }
tap_check "blanks without end" endless_line spaces
empty_stream() {
    : | "$limner" decode /dev/stdin --panel st7789 2>../err
    [ $? -eq 1 ] && grep 'ends after 0 frames' ../err
}
tap_check "an open pipe by its number is read" empty_stream

ring() { # CORNERS: in one face
    awk -v n="$1" 'BEGIN {
        for (i = 0; i < n; i++) { a = 6.283185307 * i / n; printf "v %.9f %.9f 0\n", 10 * cos(a), 10 * sin(a) }
        printf "f"; for (i = 1; i <= n; i++) printf " %d", i; print "" }'
}
ring 100000 >ring.obj
compile "a face of 100,000 corners" 'face 1 has 100000 corners, 1024 are the most' ring.obj
ring 1024 >small_ring.obj
tap_check "a face of 1024 corners is compiled" accepts compile small_ring.obj --report
{ cat good.obj && printf 'f 1 2 3' && head -c 20000000 /dev/zero | tr '\0' ' '; } >line.obj
compile "an OBJ line of 20 MB" 'a line is longer than 1048576 bytes' line.obj
printf 'v 0 0 0\nv 1\000 0 0\nv 0 1 0\nf 1 2 3\n' >nul.obj
compile "a NUL byte in an OBJ file" 'nul.obj: a NUL byte' nul.obj
truncate -s 300000000 large.obj
compile "a model of 300 MB" 'more than 268435456 bytes' large.obj
for index in 0 4 2147483648 -4 -99999999999; do
    # shellcheck disable=SC2059 # newlines
    printf "${triangle}f 1 2 $index\n" >index.obj
    compile "a corner of index $index" 'index' index.obj
done
printf 'v 0 0 0\nv 1e400 0 0\nv 0 1 0\nf 1 2 3\n' >number.obj
compile "a coordinate of 1e400" "'1e400' is not a decimal number up to 3.4e38" number.obj
{
    printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n'
    printf 'element face 1\nproperty list uint int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n2147483647 0 1 2\n'
} >list.ply
compile "a PLY face that says 2,147,483,647 corners" 'list.ply: face 1 has a list of 2147483647 numbers; 1024 corners are the most' list.ply

for count in 4 300 2147483647 2147483648 4294967295; do
    gltf count good.bin 36 $count
    compile "an accessor of $count corners in 36 bytes" 'count.gltf' count.gltf
done
gltf bytes good.bin 2147483647 100000000
compile "a buffer of 36 bytes that says 2 GB" 'bytes.gltf' bytes.gltf
gltf pipe_buffer pipe
compile "a buffer that is a pipe" 'pipe' pipe_buffer.gltf
deep() { # TEXT: a million times
    printf '{"asset":{"version":"2.0"},"extras":' && yes "$1" | head -n 1000000 | tr -d '\n'
}
deep '[' >deep.gltf
compile "JSON a million lists deep" 'deep.gltf' deep.gltf
deep '{"a":' >deep.gltf
compile "JSON a million objects deep" 'deep.gltf' deep.gltf
{
    printf '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":['
    awk 'BEGIN { for (i = 1; i <= 40; i++) printf "{\"children\":[%d,%d]},", i, i; print "{}]}" }'
} >fan.gltf
compile "nodes that double forty times" 'fan.gltf' fan.gltf
printf '{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[0]}]}' >loop.gltf
compile "nodes in a ring" 'loop.gltf' loop.gltf
# shellcheck disable=SC2059 # newlines
printf "mtllib self.obj\n${triangle}f 1 2 3\n" >self.obj
tap_check "a model that names itself as its materials has none" accepts compile self.obj --report

# -- Cut short ---------------------------------------------------------------------------------------------------------

cut() { # FILE BYTES-LESS PATTERN
    suffix=${1##*.}
    head -c "-$2" "$1" >"cut.$suffix"
    compile "${1##*/} without its last $2 bytes" "$3" "cut.$suffix"
}

printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 2
property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n' >text.ply
tap_check "a whole PLY file is read" accepts compile text.ply --report
cut text.ply 3 'truncated: it ends within face 2 of 2'
cut text.ply 8 'truncated: it ends within face 2 of 2'
cut text.ply 14 'truncated: it ends within face 1 of 2'
cut text.ply 20 'truncated: it ends within vertex 3 of 3'
for order in little big; do
    printf 'ply\nformat binary_%s_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
element face 1\nproperty list uchar int vertex_indices\nend_header\n' $order >$order.ply
done
{ cat good.bin && printf '\003\000\000\000\000\001\000\000\000\002\000\000\000'; } >>little.ply
{
    head -c 12 /dev/zero && printf '\077\200\000\000' && head -c 12 /dev/zero && printf '\077\200\000\000' && head -c 4 /dev/zero
    printf '\003\000\000\000\000\000\000\000\001\000\000\000\002'
} >>big.ply
for order in little big; do
    tap_check "so is one of $order-endian numbers" accepts compile $order.ply --report
    cut $order.ply 1 'truncated: it ends within face 1 of 1'
    cut $order.ply 12 'truncated: it ends within face 1 of 1'
    cut $order.ply 14 'truncated: it ends within vertex 3 of 3'
done
{ head -c 80 /dev/zero && printf '\002\000\000\000' && head -c 12 /dev/zero && cat good.bin && printf '\000\000' &&
    head -c 12 /dev/zero && cat good.bin && printf '\000\000'; } >binary.stl
tap_check "a whole binary STL file is read" accepts compile binary.stl --report
cut binary.stl 1 'truncated: it ends within triangle 2 of 2'
cut binary.stl 51 'truncated: it ends within triangle 1 of 2'
printf 'solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop
 endfacet\nendsolid a\n' >text.stl
tap_check "so is one of text" accepts compile text.stl --report
cut text.stl 6 'truncated: it ends before endsolid'
cut text.stl 40 'cut.stl'
cut good.obj 3 "truncated: its last line is 'f 1 2"
cut good.obj 8 "there are no faces|truncated"
cut inner_buffer.gltf 4 'cut.gltf'
cp "$models/truncated.ply" .
compile "a PLY file cut within its header" "it ends within its header" truncated.ply
cp truncated.ply truncated.bin
compile "also by another name" "it ends within its header" truncated.bin

tap_done
