# SPDX-License-Identifier: MIT
#
# Every OBJ, STL, PLY and glTF of Debian's assimp-testmodels either renders or is refused with one line
# and status 1; none crashes, hangs or takes more than 2 GB (how they are drawn best is not asked, which takes minutes of
# the largest): a quarter of them in each run (tests/part_of.sh). The outcomes are
# tests/models/models.expected;
# `make models-table` writes that anew from `sh tests/models.sh --table`.
. tests/tap.sh
. tests/part_of.sh

folder=/usr/share/assimp/models

# What becomes of one model, as one line: its path, a tab, the outcome.
outcome() { # MODEL, path in the folder
    frames=$work/frames
    mkdir -p "$frames"
    # shellcheck disable=SC3045 # Debian's sh has it
    ulimit -v 2000000
    timeout -k 5 180 "$BUILD/limner" render "$folder/$1" --size 96x96 --method nearest -o "$frames/%03d.png" \
        >/dev/null 2>"$work/errors" </dev/null
    status=$?
    count=$(find "$frames" -type f | wc -l)
    lines=$(wc -l <"$work/errors")
    if [ $status -eq 0 ] && [ "$count" -ge 1 ]; then
        text=rendered
    elif [ $status -eq 1 ] && [ "$lines" -eq 1 ] && [ "$count" -eq 0 ]; then
        text="refused: $(sed "s,^limner: ,,; s,$folder/,,g" "$work/errors")"
    elif [ $status -eq 124 ]; then
        text='BROKEN: took over three minutes'
    else
        text="BROKEN: status $status, $lines lines of error, $count frames"
    fi
    printf '%s\t%s\n' "$1" "$text"
}

all_models() {
    (cd "$folder" && find . -type f | sed 's,^\./,,' | grep -iE '\.(obj|stl|ply|gltf|glb)$' | LC_ALL=C sort)
}

table() { # < MODELS
    xargs -d '\n' -n 1 -P "$(nproc)" sh "$0" --one | LC_ALL=C sort
}

case ${1:-} in
--one)
    outcome "$2"
    exit
    ;;
--table)
    all_models | table
    exit
    ;;
esac

all_models >"$work/all"
part_of 4 "$(cat "$work/all")" >"$work/part"
echo "# SEED=$SEED"
table <"$work/part" >"$work/table"
while IFS='	' read -r model text; do
    expected=$(awk -F '\t' -v model="$model" '$1 == model { print $2 }' tests/models/models.expected)
    printf 'outcome:  %s\nexpected: %s\n' "$text" "${expected:-(not in tests/models/models.expected)}" >"$work/why"
    case $text in
    BROKEN*) tap_fail "$model" "$work/why" ;;
    "$expected") tap_ok "$model: $text" ;;
    *) tap_fail "$model" "$work/why" ;;
    esac
done <"$work/table"
tap_check "every model of that part was tried" sh -c \
    "cut -f 1 '$work/table' >'$work/tried' && LC_ALL=C sort '$work/part' | diff - '$work/tried'"
tap_check "tests/models/models.expected has every model, and no other" sh -c \
    "cut -f 1 tests/models/models.expected | diff - '$work/all'"
tap_done
