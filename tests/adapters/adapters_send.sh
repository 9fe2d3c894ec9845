# SPDX-License-Identifier: MIT
#
# Adapters over lim_send draw what the simulator draws, on displays behind fakes of TFT_eSPI, LovyanGFX, esp_lcd and LVGL
# (tests/adapters/fakes), which refuse what the libraries, or a display behind them, would not take. Broken on purpose,
# each adapter is found out.
. tests/tap.sh
. tests/adapters/adapters.sh

scene() { # MODEL SIZE [OPTION...]: of render
    model=$1 size=$2
    shift 2
    compile_scene "$model" "$size" && "$limner" render "$model" --size "$size" --frames 3 "$@" --write-hashes "$work/golden" \
        --write-cameras "$work/cameras.h" >"$work/rendered"
}

build_c() { in_c tests/adapters/send_frames.c "$work/send_c.o" && link_frames "$work/send_c" "$work/send_c.o" "$work"/model*.o "$work"/fake_*.o; }

build_cplusplus() { # FLAG...
    in_cplusplus tests/adapters/send_frames.c "$work/send_cc.o" "$@" &&
        link_frames "$work/send_cc" "$work/send_cc.o" "$work"/model*.o "$work"/fake_*.o
}

# shows PROGRAM LIBRARY OPTION...: the frames are those of the simulator
shows() {
    timeout 20 "$work/$1" "$2" $3 >"$work/said" || { cat "$work/said"; return 1; }
    grep -v '^#' "$work/said" | diff - "$work/golden"
}

in_every_way() { # PROGRAM LIBRARY WAY...
    program=$1 library=$2
    shift 2
    for way; do
        shows "$program" "$library" "$way" || { echo "$library $way" && return 1; }
    done
}

refused() { # LIBRARY OPTIONS: the library's error comes back, negative, and the next frame is whole
    shows send_c "$1" "$2" && grep -qx '# refused: -[0-9]*' "$work/said"
}

ways_of() { # LIBRARY
    case $1 in
    esp_lcd) set -- '' 'lines=1' 'at=7,5 lines=11' 'abandon=30 at=1,0' 'lines=400' ;;
    lvgl) set -- '' native 'at=7,5 lines=11' 'native lines=1 at=3,0' 'abandon=3' 'lines=400' ;;
    *) set -- '' swap 'at=7,5' 'swap abandon=30 at=1,9' ;;
    esac
    for way; do echo "$way"; done
}

draws() { # PROGRAM LIBRARY
    ways_of "$2" >"$work/ways"
    while read -r way; do
        in_every_way "$1" "$2" "$way" || return 1
    done <"$work/ways"
}

# Broken, it compiles, and some way shows something else or is complained about.
found_out() { # LIBRARY HEADER EXPRESSION
    break_header "$2" "$3" || { mend_headers && echo "nothing to break" && return 1; }
    build_cplusplus -w
    built=$?
    mend_headers
    [ $built -eq 0 ] && ! draws send_cc "$1"
}

# found_out_if LIBRARY WHAT EXPRESSION: as a test
found_out_if() {
    tap_check "$1 is found out if $2" found_out "$1" "limner_$1.h" "$3"
}

if ! has_cplusplus; then
    tap_skip "adapters" "there is no $CXX"
    tap_done
    exit 0
fi

tap_check "the fakes compile" fakes_compile fake_display fake_esp_lcd fake_lvgl
while read -r model size options; do
    # shellcheck disable=SC2086 # options are words
    tap_check "$model compiles for $size" scene "sim/scenes/$model" "$size" $options
    tap_check "adapters for C do" build_c
    tap_check "and as C++ all do" build_cplusplus
    for library in esp_lcd lvgl tft_espi lovyangfx; do
        tap_check "$library shows $model" draws send_cc "$library"
    done
    for library in esp_lcd lvgl; do
        tap_check "$library in C, too" shows send_c "$library" ''
    done
done <<'SCENES'
rooms.obj 160x128 --camera sim/scenes/rooms.cam
icosahedron.obj 97x31
movers.gltf 128x128 --camera sim/scenes/movers.cam
glass.obj 1x33 --camera sim/scenes/glass.cam
teapot.obj 100x80
SCENES

tap_check "an error of esp_lcd comes back, and the next frame is whole" refused esp_lcd fail=3
tap_check "so it does where it is negative already" refused esp_lcd 'fail=3 espfail'

found_out_if tft_espi "it sends numbers" 's/setSwapBytes(false)/setSwapBytes(true)/'
found_out_if tft_espi "it keeps the order that the sketch has set" '/display->tft->setSwapBytes(.*);/d'
found_out_if tft_espi "it leaves the sketch another order" 's/setSwapBytes(swaps)/setSwapBytes(false)/'
found_out_if tft_espi "it leaves the bus taken" 's/display->tft->endWrite()/(void)0/'
found_out_if tft_espi "it does not take the bus" 's/display->tft->startWrite();//'
found_out_if tft_espi "its window is a line too large" 's/w_px, h_px);/w_px, h_px + 1);/'
found_out_if tft_espi "it knows no size of the display" 's/> display->tft->width()/> 9999/'
for library in tft_espi lovyangfx; do
    found_out_if $library "it does not see that pixels were left out" 's/if (at_px != display->sent_px || n_px == 0) return.*//'
    found_out_if $library "it takes lines of no pixels" 's/ || n_px == 0//'
    found_out_if $library "it keeps the bus for a frame that it refused" 's/ || at_px != display->sent_px || n_px == 0) limner/) limner/'
done
found_out_if esp_lcd "it does not see that pixels were left out" 's/if ((at_px && at_px.*//'
found_out_if esp_lcd "it takes lines of no pixels" 's/ || !n_px//'
found_out_if tft_espi "it forgets where the picture is" 's/setAddrWindow(display->x_px/setAddrWindow(0/'
found_out_if lovyangfx "it sends numbers" 's/lgfx::swap565_t \*/lgfx::rgb565_t */'
found_out_if lovyangfx "it asks for the sketch's order" 's/reinterpret_cast<const lgfx::swap565_t \*>(pixels)/pixels/'
found_out_if lovyangfx "it leaves the bus taken after a frame that was abandoned" 's/^    if (at_px == 0 .*limner_lovyangfx_end(display);//'
found_out_if lovyangfx "it relies on windows that are cut" 's/> display->gfx->height())/> 9999)/; s/> display->gfx->width()/> 9999/'
found_out_if esp_lcd "it does not wait for what is on its way" 's/xSemaphoreTake(to->arrived, portMAX_DELAY);//; s/to->begin_px = to->begin_px.*/to->begin_px = 0;/'
found_out_if esp_lcd "it has one block" 's/to->begin_px = to->begin_px.*/;/'
found_out_if esp_lcd "its window ends a column too early" 's/x0 + w_px, y1/x0 + w_px - 1, y1/'
found_out_if esp_lcd "it sends full blocks alone" 's/ && y_px + 1 < to->memory->h_px//'
found_out_if esp_lcd "it waits for its callback and has none" 's/err = esp_lcd_panel_io_register.*/err = 0;/'
found_out_if esp_lcd "it tells errors as they are" 's/    return err > 0 ? -err : err;/    return err;/'
found_out_if esp_lcd "it turns the sign of ESP_FAIL" 's/    return err > 0 ? -err : err;/    return -err;/'
found_out_if lvgl "it does not swap for LVGL's own order" 's/\[i ^ swap\]/[i]/'
found_out_if lvgl "it does not wait for what lies below" 's/for (; on->draw_task_head;/for (; false;/'
found_out_if lvgl "it waits where nothing is below" 's/for (; on->draw_task_head; lv_draw_dispatch())/for (int i = 0; !i++ || on->draw_task_head; lv_draw_dispatch())/'
found_out_if lvgl "it waits and does not dispatch" 's/on->draw_task_head; lv_draw_dispatch())/on->draw_task_head;)/'
found_out_if lvgl "it waits twice for one request" 's/lv_draw_dispatch_wait_for_request();/& &/'
found_out_if lvgl "it forgets where the stripe begins" 's/y - on->buf_area.y1/y/'
found_out_if lvgl "it paints beyond the right edge" 's/LV_MIN(to->cut.x2 + 1 - x0, n_px)/(int32_t)n_px/'
found_out_if lvgl "it paints beyond the left edge" 's/LV_MAX(to->cut.x1 - x0, 0)/0/'
found_out_if lvgl "it leaves out a line too many" 's/y <= to->cut.y2 ?/y < to->cut.y2 ?/'
found_out_if lvgl "it tells that a frame was cut" 's/ && err != LIMNER_LVGL_ENOUGH//'
found_out_if lvgl "it takes any format" 's/is_16 ? to->frame() : LIM_ERR_TARGET/to->frame()/'
tap_done
