#!/bin/sh
# SPDX-License-Identifier: MIT
#
# What `limner compile -o NAME` and `limner export` say without --report: ten lines, whose figures are those of the model
# file, of the files that were written and of the long report.
. tests/tap.sh

limner=$PWD/$BUILD/limner
rooms=$PWD/sim/scenes/rooms.obj
generate=$PWD/$BUILD/generate_scale
cd "$work" || exit 1

compiles() { "$limner" compile "$@" >said 2>notes || { cat notes && return 1; }; } # ARGUMENT...
says() { grep -qE -- "$1" said || { cat said && return 1; }; }

ten_lines() {
    compiles "$rooms" --size 96x64 -o scene && [ "$(wc -l <said)" -le 10 ] || { cat said && return 1; }
    faces=$(grep -c '^f ' "$rooms")
    says "^  model +$faces faces, drawn as [1-9][0-9]* polygons\$" && says '^  drawn +nearest first, by a BSP tree; precision fast$' &&
        says '^  RAM .* at 96x64 pixels; ' && says '^  wrote scene\.h, scene\.c and scene\.lim$' && ls scene.h scene.c scene.lim &&
        ! says '^  note '
}

# The same figures as in the report, which stands there as it did.
figure() { sed -n "s/^ *$1  *\([0-9.]*\).*/\1/p" "$2" | head -n 1; } # LABEL FILE

figures_agree() {
    "$limner" compile "$rooms" --size 96x64 -o scene --report >report 2>notes && [ "$(wc -l <report)" -gt 30 ] || return 1
    for pair in 'flash:in all' 'RAM:working memory, bytes' 'wrong pixels:wrong pixels, predicted' 'instructions:instructions a frame' \
        'model:faces in the model'; do
        [ -n "$(figure "${pair%%:*}" said)" ] && [ "$(figure "${pair%%:*}" said)" = "$(figure "${pair#*:}" report)" ] ||
            { echo "$pair" && cat said && return 1; }
    done
}

# What it names as the next thing to do is done.
next_works() {
    sed -n 's/^  next  *limner \(render .*\) shows it$/\1/p' said >next && [ -s next ] &&
        (read -r words && eval "\"$limner\" $words --size 32x32") <next >drawn 2>&1 && [ -s scene.gif ]
}

moving_models_are_told() { # objects are in no .lim file
    compiles "$OLDPWD/sim/scenes/movers.gltf" -o moved && says '; [1-9][0-9]* objects? move' &&
        says 'limner render .*movers\.gltf --gif moved\.gif'
}

approximate_is_told() {
    mkdir -p scenes && "$generate" mesh 5000 scenes && compiles scenes/mesh5000.obj --method mesh -o dense && says '^  note .*approximate'
}

export_is_short() {
    "$limner" export "$rooms" --for plain --size 96x64 -o folder >said 2>notes && [ "$(wc -l <said)" -le 12 ] && says '^  flash ' ||
        { cat said notes && return 1; }
    "$limner" export "$rooms" --for plain --size 96x64 -o folder --report >said 2>notes && says '^  nodes  *[0-9]'
}

two_models() {
    compiles "$rooms" "$OLDPWD/sim/scenes/teapot.obj" --size 96x64 -o level && says '^level_rooms$' && says '^level_teapot$' &&
        [ "$(grep -c '^  wrote ' said)" -eq 1 ]
}

tap_check "what is compiled is told in ten lines" ten_lines
tap_check "its figures are those of the report, which --report prints" figures_agree
tap_check "the command that it names next works" next_works
tap_check "what moves is told, and drawn from the model" moving_models_are_told
tap_check "an approximate order is told" approximate_is_told
tap_check "an export is told as briefly" export_is_short
tap_check "each of two models is told, and their files once" two_models
tap_done
