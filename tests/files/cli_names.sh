# SPDX-License-Identifier: MIT
#
# Names may hold anything: those of files, which become names in C and in what builds it, and those in files, which are
# shown. Two hundred hostile ones are compiled; escape sequences in models, logs and WADs reach no terminal.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
firmware=$PWD/firmware
cd "$work" || exit 1
compiler=${CC:-gcc}

# -- Names in C ----------------------------------------------------------------------------------------------------------

printf '%s\n' 'v 0 0 0' 'v 4 0 0' 'v 0 4 0' 'v 0 0 4' 'f 1 3 2' 'f 1 2 4' 'f 1 4 3' 'f 2 3 4' >t.obj

# Each a line, with printf's escapes: characters that mean something to C, make, a shell, CMake, HTML or a terminal, alone,
# in front, in the middle and at the end; words of C; what looks like its comments, trigraphs and numbers.
hostile_names() {
    for part in '"' "'" '\\' '?' '??!' '??<' '??=' '*' '#' '%%' '$' '$(x)' '`x`' ';' '&' '<' '>' '|' '(' ')' '{' '}' '[' ']' \
        ',' '+' '-' '=' '~' '^' '!' '@' ':' ' ' '\t' '\n' '\r' '\v' '\f' '\a' '\033[31m' '\177' '\302\233' '\302\240' '\303\257' \
        '\342\200\256' '\342\201\246' '\377' '\360\237\230\200' '.' '_' '__' '//*' '1' '0x' '%%d'; do
        for name in "$part" "${part}b" "a${part}b" "a$part"; do
            printf '%s\n' "$name"
        done
    done
    printf '%s\n' int for while NULL main static_assert lim limits lim_scene LIM_H 123 1e5 0x1F e m EOF u8 L R _Bool asm \
        class namespace linux unix
}

# No file is called /, and a name that a folder has is none.
usable_names() { hostile_names | grep -v '/' | grep -vxF -e . -e .. | sort -u; }

is_c() { # HEADER OR SOURCE...: strictly, with each warning an error
    "$compiler" -std=c11 -pedantic -fsyntax-only $WARNINGS -Wtrigraphs -Wcomment -Werror -I "$firmware" "$@"
}

# The files lie in a folder of their own; whatever they are called, a program includes the header by that name.
compiles_as() { # NAME
    rm -rf c && mkdir c || return 1
    "$limner" compile t.obj -o "c/$1" >/dev/null 2>said || { cat said && return 1; }
    [ "$(find c -type f -printf x)" = xxx ] || return 1
    for source in c/*.c c/.*.c; do
        [ ! -f "$source" ] || is_c -x c "./$source" || return 1
    done
    for header in c/*.h c/.*.h; do
        [ -f "$header" ] || continue
        printf '#include "%s"\nint main(void)\n{\n    return 0;\n}\n' "${header#c/}" >c/use
        is_c -x c c/use || return 1
    done
}

compiles_by_any_name() {
    usable_names >names
    [ "$(wc -l <names)" -ge 200 ] || { wc -l names && return 1; }
    wrong=0
    while IFS= read -r escaped; do
        # The dot keeps newlines at the end.
        # shellcheck disable=SC2059 # the name is the format
        name=$(printf -- "$escaped"; echo .)
        compiles_as "${name%.}" >out 2>&1 || { wrong=$((wrong + 1)) && echo "$escaped" && cat out; }
    done <names
    [ $wrong -eq 0 ]
}
tap_check "scenes of two hundred hostile names are C" compiles_by_any_name

tells_the_name() {
    rm -rf c && mkdir c
    "$limner" compile t.obj -o 'c/a"b' 2>&1 >/dev/null | grep -qx "limner: note: c/a\"b: files are called c/a_b: C cannot name the other" &&
        [ "$(ls c | tr '\n' ' ')" = "a_b.c a_b.h a_b.lim " ]
}
tap_check "a name that C cannot have is told" tells_the_name

refuses_headers_of_the_renderer() {
    rm -rf c && mkdir c
    for name in config limner; do
        "$limner" compile t.obj -o "c/$name" >out 2>said && return 1
        grep -qx "limner: -o 'c/$name': the renderer has a header of that name; another one helps" said || { cat said && return 1; }
    done
    [ -z "$(ls c)" ]
}
tap_check "headers that a scene includes are refused as its name" refuses_headers_of_the_renderer

sets_have_names_of_models() {
    rm -rf c && mkdir c
    cp t.obj 'x"y.obj'
    "$limner" compile t.obj 'x"y.obj' -o c/set >out 2>&1 && is_c -x c c/set_x_y.c c/set_t.c
}
tap_check "so are models of a set mapped" sets_have_names_of_models

# -- Names that are shown ------------------------------------------------------------------------------------------------

# ESC, an OSC with BEL, CSI of C1, a carriage return, text that runs the other way, no UTF-8.
nasty=$(printf 'A\033[31mB\033]0;own\007C\302\233mD\rE\342\200\256F\342\201\246G\177H\377I')

# Whether a terminal may have the file.
can_be_shown() { # FILE...
    iconv -f UTF-8 -t UTF-8 "$@" >/dev/null || { echo "no UTF-8" && return 1; }
    ! LC_ALL=C grep -naP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xa8-\xae]|\xe2\x81[\xa6-\xaf]' "$@" | cat -v | grep .
}

shows() { # COMMAND...: all that it says
    "$limner" "$@" >out 2>said </dev/null
    cat out said | grep -q 'A.*B.*D' || { echo "the name is not in it: $*" && cat -v out said && return 1; }
    can_be_shown out said || { echo "$*" && return 1; }
}

cp t.obj "$nasty.obj"
printf 'mtllib m.mtl\nusemtl a\n' | cat - t.obj >named.obj
sed 's/^f .*/f 1\/1 2\/1 3\/1/; s/^v 0 0 0$/v 0 0 0\nvt 0 0/' named.obj >textured.obj
printf 'newmtl a\nmap_Kd %s.png\n' "$nasty" >m.mtl
while read -r arguments; do
    # shellcheck disable=SC2086 # words
    tap_check "a file's name is shown so that it is harmless: $arguments" eval shows "$arguments"
done <<'LIST'
render "$nasty.obj" --size 64x48 --ids "$nasty.obj"
render "$nasty.missing" --size 64x48
render t.obj --size 64x48 --camera "$nasty"
render textured.obj --size 64x48
compile "$nasty.obj" --report
compile t.obj -o "$nasty"
splitters "$nasty.obj"
measure "$nasty.obj" --no-cost --precision fast --size 64x48
compare "$nasty.obj" --no-cost --frames 1 --size 64x48
export "$nasty.obj" --for plain -o "$nasty"
report-bug "$nasty.obj" --size 64x48 -o "$nasty.tar"
report-bug t.obj --size 64x48 -o "$nasty.tar"
replay "$nasty.tar"
wad "$nasty.wad"
decode "$nasty.log" --panel st7735
"$nasty"
render t.obj "--$nasty"
LIST

# A trace whose other lines are the firmware's own words.
printf 'spi 4001300c\npin select bsrr 40020018 4\npin dc bsrr 40020018 6\npin led bsrr 40020818 1\n' >m.map
printf '%s\nlast\n' "$nasty" >x.log
tap_check "a log is passed on so" shows decode x.log --qemu m.map --panel st7735

# Objects that move have names.
moving_model() { # NAME as JSON has it
    cat <<GLTF
{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"scale":[40,40,40]},{"mesh":0,"name":"$1"}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],"samplers":[{"input":2,"output":3}]}],
"buffers":[{"uri":"points.bin","byteLength":104}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":8},{"buffer":0,"byteOffset":80,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},
{"bufferView":3,"componentType":5126,"count":2,"type":"VEC3"}]}
GLTF
}
{
    printf '\0\0\0\0\0\0\0\0\0\0\0\0''\0\0\200\077\0\0\0\0\0\0\0\0''\0\0\0\0\0\0\200\077\0\0\0\0''\0\0\0\0\0\0\0\0\0\0\200\077'
    printf '\0\0\2\0\1\0''\0\0\1\0\3\0''\0\0\3\0\2\0''\1\0\2\0\3\0'
    printf '\0\0\0\0\0\0\200\077''\0\0\100\100\0\0\0\0\0\0\0\0''\0\0\200\100\0\0\0\0\0\0\0\0'
} >points.bin
moving_model 'A\u001b[31mB\u0007C\u009bmD\rE\u202eF\u2066G\u007fH*/I' >moving.gltf

tap_check "so are names of nodes in a report" shows compile moving.gltf --report

is_c_with_movers() {
    rm -rf c && mkdir c && "$limner" compile moving.gltf -o c/moving >/dev/null 2>said || { cat said && return 1; }
    can_be_shown c/moving.h && is_c -Wbidi-chars=any,ucn -x c c/*.c
}
tap_check "and in C, where they end no comment" is_c_with_movers

is_a_page() {
    "$limner" report moving.gltf --size 64x48 --precision fast -o page.html >/dev/null 2>said || { cat said && return 1; }
    sed 's/base64,[^"]*//g' page.html >page && can_be_shown page
}
tap_check "and in a page" is_a_page

tap_done
