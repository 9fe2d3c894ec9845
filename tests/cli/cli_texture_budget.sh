# SPDX-License-Identifier: MIT
#
# --texture-budget KB: textures keep to it in whatever a command makes of a model, the geometry stays, what was done is told, and
# what no sizes keep becomes colours.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
demo=$(cd "$BUILD/scenes/textured" && pwd)
cp -R "$demo" "$work/demo"
cd "$work" || exit 1
model=demo/textured.obj camera=demo/textured.cam

compiled() { # NAME OPTION...
    name=$1
    shift
    mkdir -p "$(dirname "$name")"
    timeout 120 "$limner" compile "$model" --path "$camera" -o "$name" --report "$@" >"$name.report" 2>"$name.said" || { cat "$name.said" && return 1; }
}

bytes_of() { # NAME: of textures, as the report has them
    awk '/^    of these textures/ { print $4 }' "$1.report"
}

arrays_b() { # NAME: the same, counted in the C source: numbers of texels and colours, 8 bytes a texture
    awk '/_(texels|palettes|textures)\[/ { what = $0 } what ~ /_texels\[/ && /^    [0-9]/ { sum += gsub(/,/, "") }
        what ~ /_palettes\[/ { sum += 2 * gsub(/LIM_MEMORY_COLOUR\(/, "") } what ~ /_textures\[/ && /^    \{/ { sum += 8 * gsub(/\{/, "") }
        /^};/ { what = "" } END { print sum }' "$1.c"
}

keeps() { # KB
    compiled "at$1" --texture-budget "$1" || return 1
    echo "$1 KB: $(bytes_of "at$1") bytes reported, $(arrays_b "at$1") in the source"
    [ "$(bytes_of "at$1")" -eq "$(arrays_b "at$1")" ] && [ "$(arrays_b "at$1")" -le $(($1 * 1000)) ] && [ "$(arrays_b "at$1")" -gt $(($1 * 600)) ]
}

is_told() { # NAME
    grep 'note: ' "$1.report"
    pictures=$(grep -c '^newmtl' demo/textured.mtl)
    grep -q '^  note: textures for 60.0 KB, before [0-9.]* KB: smaller [0-9]*, shown as another [0-9]*, as a colour [0-9]*; texels seen are off by' "$1.report" &&
        [ "$(grep -c 'note: texture .*: shown as ' "$1.report")" -ge 1 ] && [ "$(grep -c 'note: texture .*: shown as ' "$1.report")" -le "$pictures" ]
}

is_summed_up() {
    "$limner" render "$model" --camera "$camera" --size 48x48 --texture-budget 60 --write-hashes some 2>said || { cat said; return 1; }
    cat said
    [ "$(grep -c 'note: textures for 60.0 KB' said)" -eq 1 ] && ! grep -q 'shown as [0-9]' said
}

same_bytes() { # FOLDER FOLDER
    for kind in c h lim; do
        cmp "$1/scene.$kind" "$2/scene.$kind" || return 1
    done
}

hashes() { # FILE OPTION...
    file=$1
    shift
    timeout 120 "$limner" render "$model" --camera "$camera" --size 64x48 --write-hashes "$file" "$@" 2>said || { cat said; return 1; }
}

orders_agree() {
    hashes near --tree bsp --texture-budget 12 && hashes far --tree bsp --texture-budget 12 --method painter && cmp near far && hashes plain && ! cmp -s near plain
}

file_agrees() {
    "$limner" compile "$model" -o own --report --texture-budget 40 >own.report 2>said && "$limner" render own.lim --camera "$camera" --size 64x48 --write-hashes file 2>said &&
        hashes model --texture-budget 40 && cmp file model
}

measured() { # FOLDER OPTION...
    folder=$1
    shift
    timeout 120 "$limner" measure "$model" --camera "$camera" --path "$camera" --size 96x96 --no-cost -o "$folder" "$@" >said 2>&1 || { cat said; return 1; }
}

column() { # FOLDER NAME
    awk -F , -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } { print $at[name] }' "$1/measure.csv"
}

# Which faces are where has nothing to do with textures.
measures_the_same() {
    measured before && measured after --texture-budget 40 || return 1
    column before textures_b && column after textures_b
    column before holes >a && column after holes >b && cmp a b && column after textures_b | awk '{ bad += !($1 > 0 && $1 <= 40000) } END { exit bad || NR != 4 }' &&
        grep -q "^Textures take $(column after textures_b | head -n 1) bytes" after/measure.md
}

texels_are_near() {
    awk -F '|' '/texel error mean/ { getline; while (getline && NF > 3) { print; rows++; bad += !($3 > 0 && $3 < 0.3) } exit }
        END { exit rows != 4 || bad }' after/measure.md
}

exports() {
    "$limner" export "$model" --path "$camera" --for plain -o folder --texture-budget 40 >said 2>&1 && "$limner" export "$model" --path "$camera" --for plain -o all >said 2>&1 ||
        { cat said; return 1; }
    wc -c folder/*.c | tail -n 1 && wc -c all/*.c | tail -n 1 && [ "$(cat folder/*.c | wc -c)" -lt $(($(cat all/*.c | wc -c) - 50000)) ]
}

reports() {
    timeout 200 "$limner" report "$model" --path "$camera" --size 64x64 --texture-budget 40 --time-limit 5 -o page.html >said 2>&1 || { cat said; return 1; }
    grep -o 'Textures take [0-9,&#;a-z]* bytes' page.html
}

says() { # TEXT COMMAND...
    text=$1
    shift
    ! "$limner" "$@" 2>said && cat said && [ "$(wc -l <said)" -eq 1 ] && grep -q "$text" said && ! ls never* 2>/dev/null
}

# What no sizes keep becomes colours: all of it, or as much as must.
colours_keep_to_any() {
    compiled at0 --texture-budget 0 && grep 'note: textures for' at0.report && grep -q 'LIM_HAS_TEXTURE 0' at0.h &&
        compiled at1.5 --texture-budget 1.5 && grep 'note: textures for' at1.5.report && grep -q ', as a colour a face [1-9]' at1.5.report &&
        arrays_b at1.5 && [ "$(arrays_b at1.5)" -le 1500 ] && [ "$(arrays_b at1.5)" -gt 0 ]
}

for kb in 90 60 25; do
    tap_check "textures keep to $kb KB" keeps $kb
done
tap_check 'the report tells what became of them, a line a texture at most' is_told at60
tap_check 'other commands sum it up' is_summed_up
tap_check 'twice the same gives the same bytes' eval 'compiled once/scene --texture-budget 60 && compiled again/scene --texture-budget 60 && same_bytes once again'
tap_check 'a budget that is kept anyhow changes nothing' eval 'compiled whole/scene && compiled roomy/scene --texture-budget 1000 && same_bytes whole roomy && ! grep "textures for" roomy/scene.report'
tap_check 'orders paint the same, and not what they do without it' orders_agree
tap_check 'a .lim file shows what the model shows' file_agrees
tap_check 'measure has it as a column, and finds no hole that was not there' measures_the_same
tap_check 'texels are as near to those of the model as before' texels_are_near
tap_check 'what is exported is smaller' exports
tap_check 'the page says how much it is' reports
tap_check 'sampled cameras do where there is no path' eval '"$limner" compile "$model" --texture-budget 30 -o sampled --report >sampled.report 2>said && [ "$(arrays_b sampled)" -le 30000 ]'
tap_check 'a model without textures takes none' eval '"$limner" compile tests.obj --texture-budget 0 -o none >/dev/null 2>&1 || { printf "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" >tests.obj; "$limner" compile tests.obj --texture-budget 0 -o none >/dev/null; }'
tap_check 'colours keep to what no size keeps' colours_keep_to_any
for bad in much -1 70000 nan 10KB ''; do
    tap_check "refused: '$bad'" says '^limner: --texture-budget' compile "$model" --texture-budget="$bad" -o never
done
tap_check 'refused: no number at all' says '^limner: --texture-budget' render "$model" -o never.png --texture-budget
tap_check 'the help of what reads models has it' eval 'for command in compile render view measure export report worst walk; do "$limner" $command --help all | grep -q -- "--texture-budget KB" || exit 1; done'
tap_done
