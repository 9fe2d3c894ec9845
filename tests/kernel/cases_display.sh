# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# `limner play` on the tapped wires: every picture of the table, then what must end well though it ends early or never
# begins.

wires='--dc DC --reset RESET --backlight BACKLIGHT'
st7789="--panel st7789 --spi /dev/spidev0.0 $wires"

# shellcheck disable=SC2086 # lists of options
draw() { # NAME PANEL GLASS PICTURE OPTION...
    name=$1 panel=$2 size=${3%%+*} offset=$(echo "${3#*+}" | tr + ,) picture=$4
    shift 4
    case $picture in
    card) picture='--test-card --frames 1' ;;
    *) picture="$STAGE/demo.lim --camera $STAGE/demo.cam --frames $picture" ;;
    esac
    forget
    limner play --spi /dev/spidev0.0 $wires --panel "$panel" --size "$size" --offset "$offset" --invert --rgb "$@" \
        $picture
    status=$?
    keep "$name"
    return $status
}

draw_all() {
    while read -r name rest; do
        # shellcheck disable=SC2086 # a list
        case $name in '#'*) ;; *) tap_check "draws $name" draw "$name" $rest ;; esac
    done <"$STAGE/pictures"
}

card() { limner play --panel st7789 --test-card --frames 1 "$@"; }

no_such_device() { refuse '^limner: /dev/spidev9\.9: no such device; .*/dev/spidev0\.0' card --spi /dev/spidev9.9 --dc DC; }
no_such_line() { refuse '^limner: NOWHERE: no line of that name on .*wire-tap' card --spi /dev/spidev0.0 --dc NOWHERE; }
not_spi() { refuse '^limner: /dev/null: not an SPI device' card --spi /dev/null --dc DC; }
broken_bus() {
    refuse '^limner: .*/dev/spidev0\.2: .*Input/output error' card --mode 0 --spi /dev/spidev0.2 --dc DC
}

held_by_a_driver() {
    refuse "^limner: /dev/spidev0\.3: no such device: the kernel's driver fb_held has spi0\.3," \
        card --spi /dev/spidev0.3 --dc DC
}
held_device_is_listed() { limner devices | grep -E "^spi +spi0\.3: the kernel's driver fb_held has "; }
# With README's commands, but that spidev is built in.
freed() {
    (cd /sys/bus/spi && echo spi0.3 >drivers/fb_held/unbind && echo spidev >devices/spi0.3/driver_override &&
        echo spi0.3 >drivers/spidev/bind) && oled --spi /dev/spidev0.3 &&
        ! held_device_is_listed && limner devices | grep '^spi  */dev/spidev0\.3: usable'
}
line_of_the_kernel() { refuse '^limner: CS: .* is in use by "spi2 CS0"' card --spi /dev/spidev0.0 --dc CS; }
flag_is_refused() { refuse '^limner: /dev/spidev1\.0: .* refuses SPI_CS_HIGH$' card --spi /dev/spidev1.0 --dc DC --cs-high; }

# notes PATTERN COMMAND...: it succeeds, and says one line that matches.
notes() {
    pattern=$1
    shift
    "$@" 2>said
    status=$?
    cat said
    [ $status = 0 ] && [ "$(wc -l <said)" = 1 ] && grep -qE -- "$pattern" said
}
oled() { limner play --panel ssd1306 --test-card --frames 1 --dc DC "$@"; }
flag_is_left_out() { notes '^limner: note: /dev/spidev1\.0: .* refuses SPI_NO_CS;' oled --spi /dev/spidev1.0 --no-cs; }
level_of_a_line() { notes '^limner: note: /dev/spidev2\.0: its chip select is a GPIO line' oled --spi /dev/spidev2.0 --cs-high; }
idle_option() { notes '^limner: note: --bgr: ssd1306 has no colours; nothing changes$' oled --spi /dev/spidev0.0 --bgr; }
usual_mode() { notes '^limner: note: SPI mode 3, which ' card --spi /dev/spidev0.0 --dc DC; }
level_of_a_controller() { oled --spi /dev/spidev0.0 --cs-high 2>said && [ ! -s said ]; }

line_in_use() {
    gpioset --mode=signal wire-tap 0=1 &
    holder=$!
    until gpioinfo wire-tap | grep -q gpioset; do sleep 0.01; done
    refuse '^limner: DC: .* is in use by "gpioset"' card --spi /dev/spidev0.0 --dc DC
    status=$?
    kill $holder
    wait $holder
    return $status
}

as_nobody() { setpriv --reuid=nobody --regid=nogroup --clear-groups limner play --panel st7789 --test-card "$@"; }
no_right_to_spi() { refuse '^limner: /dev/spidev0\.0: Permission denied; .*udev' as_nobody --spi /dev/spidev0.0 --dc DC; }
no_right_to_lines() {
    chmod 666 /dev/spidev0.0
    refuse '^limner: /dev/gpiochip[0-9]*: Permission denied; .*udev' as_nobody --spi /dev/spidev0.0 --dc DC
    status=$?
    chmod 600 /dev/spidev0.0
    return $status
}

# Ended when so many bytes of record are there: in the middle of a frame, wherever that is.
ended_by() { # SIGNAL NUMBER
    forget
    # shellcheck disable=SC2086 # a list
    limner play $st7789 --invert "$STAGE/demo.lim" --camera "$STAGE/demo.cam" &
    player=$!
    head -c 300000 /dev/wire_tap >began
    kill -s "$1" $player
    wait $player
    status=$?
    keep rest
    cat began rest.wires >"$1.wires"
    echo "status $status"
    [ $status = $((128 + $2)) ] && [ "$(gpioinfo wire-tap | grep -c unused)" = 4 ]
}

# The lines of gpio-sim, as its files show them: a witness that is not ours.
simulated=/sys/kernel/config/gpio-sim/display
simulate_lines() {
    mkdir -p $simulated/bank/line0 $simulated/bank/line1 $simulated/bank/line2
    echo 4 >$simulated/bank/num_lines
    echo simulated >$simulated/bank/label
    echo SIM-RESET >$simulated/bank/line0/name
    echo SIM-BACKLIGHT >$simulated/bank/line1/name
    echo SIM-TEARING >$simulated/bank/line2/name
    echo 1 >$simulated/live
    lines=/sys/devices/platform/$(cat $simulated/dev_name)/$(cat $simulated/bank/chip_name)
}

simulated_levels() { cat "$lines/sim_gpio0/value" "$lines/sim_gpio1/value" | tr -d '\n'; }

seen_by_another() {
    forget
    limner play --panel st7789 --spi /dev/spidev0.0 --dc DC --reset SIM-RESET --backlight SIM-BACKLIGHT \
        "$STAGE/demo.lim" --camera "$STAGE/demo.cam" &
    player=$!
    head -c 300000 /dev/wire_tap >began
    during=$(simulated_levels) owners=$(gpioinfo simulated | grep -c '"limner"')
    kill $player
    wait $player
    echo "levels $during, lines held $owners, then $(gpioinfo simulated | grep -c unused) free"
    [ "$during" = 11 ] && [ "$owners" = 2 ] && [ "$(gpioinfo simulated | grep -c unused)" = 4 ]
}

# Of a panel that never says when, frames are drawn all the same; of one that does, too.
tearing_still() { draw still st7789 240x240+0+0 2 --te SIM-TEARING; }
tearing_moves() {
    while sleep 0.01; do
        echo pull-up >"$lines/sim_gpio2/pull"
        echo pull-down >"$lines/sim_gpio2/pull"
    done &
    pulses=$!
    draw moves st7789 240x240+0+0 2 --te SIM-TEARING
    status=$?
    kill $pulses
    return $status
}

call_port() {
    TEARING_LINE=SIM-TEARING TEARING_PULL=$lines/sim_gpio2/pull CMOCKA_MESSAGE_OUTPUT=STDOUT port_calls
}

devices_are_listed() {
    limner devices
    limner devices | grep -qE '^spi +/dev/spidev0\.0.*: usable' && limner devices | grep -qE '^gpio .*wire-tap'
}

draw_all
tap_check "the devices are listed" devices_are_listed
tap_check "a device that is not there" no_such_device
tap_check "a device that is none" not_spi
tap_check "a line that is not there" no_such_line
tap_check "a line that another program has" line_in_use
tap_check "a line that the kernel has" line_of_the_kernel
tap_check "a device that another driver has" held_by_a_driver
tap_check "it is listed" held_device_is_listed
tap_check "it can be freed" freed
tap_check "a flag that the controller lacks" flag_is_refused
tap_check "one that can be left out" flag_is_left_out
tap_check "chip select that is a GPIO line keeps its level" level_of_a_line
tap_check "an option that changes nothing" idle_option
tap_check "a mode that was not asked for" usual_mode
tap_check "chip select that is the controller's is active high" level_of_a_controller
tap_check "no right to the SPI device" no_right_to_spi
tap_check "no right to the lines" no_right_to_lines
tap_check "a controller that fails" broken_bus
tap_check "ended by SIGTERM" ended_by TERM 15
tap_check "ended by SIGHUP" ended_by HUP 1
simulate_lines
tap_check "gpio-sim shows the levels" seen_by_another
tap_check "a tearing line that stands still" tearing_still
tap_check "a tearing line that moves" tearing_moves
tap_check "calls of the port do what they say" call_port
