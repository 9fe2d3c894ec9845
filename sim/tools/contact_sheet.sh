#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Draws models as a newcomer's first command would, from two sides, on one sheet to be looked at: upright, lit, not inside
# out, or with a notice that says what to add. sh sim/tools/contact_sheet.sh SHEET.png [MODEL...]; without models those of
# sim/tools/contact_models.txt that this machine has. BUILD is the Makefile's.
set -u
sheet=${1:?SHEET.png}
shift
models=$(cd "$(dirname "$0")" && pwd)/contact_models.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM

# What limner said, without a file's name before it, which is the same in each line.
said() { # MODEL'S-FOLDER/
    sed -e 's/^limner: //' -e 's/^note: //' | while IFS= read -r line; do
        case $line in
        "$1"*:*)
            rest=${line#"$1"}
            rest=${rest#*:}
            [ "$rest" = "${rest# }" ] || line=${rest# }
            ;;
        esac
        printf '%s\n' "$line"
    done
}

draw() { # MODEL: pictures and what was said into a folder of its own
    count=$((count + 1))
    folder=$work/$(printf %03d $count)
    mkdir "$folder"
    "$BUILD/limner" render "$1" --size 160x160 --frames 2 --time-limit 20 -o "$folder/%d.png" 2>"$folder/notes" </dev/null
    { echo "${1##*/}" && said "${1%/*}/" <"$folder/notes"; } >"$folder/said"
    sed '1!s/^/    /' "$folder/said"
}

count=0 missing=0
if [ $# -eq 0 ]; then
    while read -r model; do
        case $model in '' | '#'*) continue ;; esac
        if [ -f "$model" ]; then draw "$model"; else missing=$((missing + 1)); fi
    done <"$models"
else
    for model; do draw "$model"; done
fi
[ $missing -eq 0 ] || echo "contact-sheet: $missing models of $models are not on this machine; it names their packages"
[ $count -gt 0 ] || { echo "contact-sheet: no model is there" >&2; exit 1; }
mkdir -p "$(dirname "$sheet")"
"$BUILD/contact_sheet" "$sheet" "$work"/[0-9]* && echo "contact-sheet: $count models in $sheet"
