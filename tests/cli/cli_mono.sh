# SPDX-License-Identifier: MIT
#
# Black and white panels: outlines in two colours that are told apart on glass, light and tones for their pixels, the same in
# render, in what compile writes and in boards' modules; panels with colours stay as they were.
. tests/tap.sh

limner=$BUILD/limner
model=sim/scenes/hexecontahedron.obj

hashes() { # FILE ARGUMENT...: of two frames
    file=$1
    shift
    "$limner" render "$@" --frames 2 --write-hashes "$work/$file" 2>"$work/$file.said" || { cat "$work/$file.said" && return 1; }
}

# same_outlines COLOURS PANEL: without colours they are these; with others, others.
same_outlines() {
    hashes plain $model --panel "$2" --wireframe && hashes said $model --panel "$2" --wireframe="$1" &&
        cmp "$work/plain" "$work/said" && hashes other $model --panel "$2" --wireframe=FF0000,0000FF &&
        ! cmp -s "$work/plain" "$work/other"
}

module_says() { # PANEL INITIALISER
    "$limner" module --panel "$1" -o "$work/module" && grep -F MODULE_OUTLINES "$work/module.h" &&
        [ "$(sed -n 's/^#define MODULE_OUTLINES //p' "$work/module.h")" = "$2" ]
}

white='{.on = true, .one_colour = true, .colour = 0xFFFF, .background = 0x0000}'
black='{.on = true, .one_colour = true, .colour = 0x0000, .background = 0xFFFF}'
for panel in pcd8544 sh1106 ssd1306 st7567 uc1701; do
    tap_check "$panel: outlines are pixels that are set" same_outlines FFFFFF,000000 $panel
    tap_check "$panel: so a board's module says" module_says $panel "$white"
done
for panel in ls013b7dh03 ls027b7dh01; do
    tap_check "$panel: outlines are black on white" same_outlines 000000,FFFFFF $panel
    tap_check "$panel: so a board's module says" module_says $panel "$black"
done
tap_check "greys and colours are the polygons' own" module_says ssd0323 '{.on = true}'
tap_check "so in colour" module_says st7789:rgb444 '{.on = true}'

coloured_stay() { # a panel of colours has the light of plain memory
    hashes glass $model --panel st7735 --size 96x80 && hashes memory $model --panel memory --size 96x80 && cmp "$work/glass" "$work/memory"
}
tap_check "a panel of colours draws what memory has" coloured_stay

compiled_alike() { # PANEL: what is compiled for a panel is what render draws of the model there
    "$limner" compile $model --panel "$1" -o "$work/scene" --report >"$work/report" && grep -q 'for black and white pixels' "$work/report" &&
        hashes scene "$work/scene.lim" --panel "$1" && hashes model $model --panel "$1" && cmp "$work/scene" "$work/model"
}
for panel in ssd1306 ls013b7dh03; do
    tap_check "$panel: compile --panel and render --panel light alike" compiled_alike $panel
done

panel_size() { "$limner" compile $model --panel "$@" --report | grep -q "^RAM at $size pixels"; }
size=84x48
tap_check "compile --panel takes that panel's size" panel_size pcd8544
size=48x32
tap_check "unless one is said" panel_size pcd8544 --size 48x32

unlit() { # colours as they are
    hashes unlit $model --panel ssd1306 --unlit && "$limner" compile $model --unlit -o "$work/unlit" --report >"$work/report" &&
        hashes compiled "$work/unlit.lim" --panel ssd1306 && cmp "$work/unlit" "$work/compiled"
}
tap_check "--unlit leaves colours as they are there, too" unlit
movers() { # a light that turns with what moves
    hashes turning sim/scenes/movers.gltf --panel ssd1306 --mover-light turning && hashes baked sim/scenes/movers.gltf --panel ssd1306 &&
        ! cmp -s "$work/turning" "$work/baked"
}
tap_check "what moves is lit in each frame, if so asked" movers
tap_check "an unknown panel is refused" sh -c "! '$limner' compile $model --panel none --report 2>'$work/said' &&
    grep -qx 'limner: --panel none: no such panel; there are .*' '$work/said'"
tap_done
