# SPDX-License-Identifier: MIT
#
# `limner play` and `limner devices` from the outside, on a machine that has none of the devices: what is missing, makes
# no sense or contradicts itself ends with one line that names it, status 1 and nothing on standard output.
. tests/tap.sh

limner=$BUILD/limner
model=sim/scenes/icosahedron.obj

refuse() { # NAME PATTERN ARGUMENT...
    tap_name_of_refusal=$1
    shift
    tap_check "$tap_name_of_refusal" is_refused "$@"
}

is_refused() { # PATTERN ARGUMENT...
    pattern=$1
    shift
    timeout 20 "$limner" "$@" >"$work/out" 2>"$work/err" </dev/null
    status=$?
    cat "$work/err"
    [ $status -eq 1 ] || { echo "status $status" && return 1; }
    [ "$(wc -l <"$work/err")" -eq 1 ] || { echo "not one line" && return 1; }
    [ ! -s "$work/out" ] || { echo "something on stdout" && return 1; }
    grep -qE -- "$pattern" "$work/err" || { echo "does not match $pattern" && return 1; }
}

st7789() { # NAME PATTERN ARGUMENT...: with what every call needs
    name=$1 pattern=$2
    shift 2
    refuse "$name" "$pattern" play --panel st7789 --spi /dev/spidev99.0 --dc GPIO25 "$@"
}

# -- What is missing -----------------------------------------------------------------------------------------------------

refuse "a panel is required" '^limner: --panel NAME is missing' play "$model"
refuse "an SPI device is required" '^limner: play: needs --spi DEVICE' play "$model" --panel st7789
refuse "a panel that has D/C requires its line" '^limner: --panel st7789: needs a pin, --dc LINE$' \
    play "$model" --panel st7789 --spi /dev/spidev99.0
st7789 "a scene is required" '^limner: play: needs a model'
st7789 "a value is required" '^limner: --reset: needs a value' "$model" --reset
st7789 "an empty value is none" '^limner: --reset: needs a value' "$model" --reset ''
st7789 "a device that is not there is refused" '^limner: /dev/spidev99.0: no such device' "$model"
st7789 "a scene that is not there is refused before the device" '^limner: nosuch.obj: ' nosuch.obj
st7789 "a camera file that is not there is refused before the device" '^limner: nosuch.cam: ' "$model" --camera nosuch.cam
st7789 "so it is for the test card" '^limner: /dev/spidev99.0: no such device' --test-card
refuse "what is no SPI device is refused" '^limner: /dev/null: not an SPI device$' \
    play --panel st7789 --spi /dev/null --dc GPIO25 --test-card

names_all() {
    "$limner" help >"$work/help"
    panels=$("$limner" play --panel none 2>&1 | sed 's/.*there are //; s/,//g')
    for panel in $panels; do
        grep -qw "$panel" "$work/help" || { echo "$panel is not in limner help" && return 1; }
    done
    [ -n "$panels" ]
}
tap_check "help names each panel" names_all

# -- What makes no sense -------------------------------------------------------------------------------------------------

refuse "an unknown panel is refused" '^limner: --panel hd44780: no such panel; there are .*st7789' play "$model" --panel hd44780
refuse "emulated memory is no display" '^limner: --panel memory: no such panel' play "$model" --panel memory
refuse "so is one that it takes on wider buses alone" '^limner: --panel st7796:rgb444: ' play "$model" --panel st7796:rgb444
refuse "a format that a panel does not take is refused" '^limner: --panel ili9488:rgb565: ' play "$model" --panel ili9488:rgb565
st7789 "glass beyond memory is refused" '^limner: --panel st7789: 241x320 pixels do not fit' "$model" --size 241x320
st7789 "glass that leaves memory is refused" '^limner: --panel st7789: 240x240 pixels at 0,81 leave' "$model" --offset 0,81
for offset in 1 1,2,3 a,b -1,0 1.5,0 ''; do
    st7789 "offset '$offset' is refused" '^limner: --offset' "$model" --offset "$offset"
done
st7789 "a turn by 45 degrees is refused" '^limner: --rotate 45: must be 0, 90, 180 or 270' "$model" --rotate 45
for mode in 4 -1 0.5 x; do
    st7789 "mode '$mode' is refused" '^limner: --mode' "$model" --mode "$mode"
done
for hz in 0 -5 2e9 0.5 nan fast; do
    st7789 "clock '$hz' is refused" '^limner: --hz' "$model" --hz "$hz"
done
for frames in 0 -1 0.5 1e10 x; do
    st7789 "$frames frames are refused" '^limner: --frames' "$model" --frames "$frames"
done
refuse "a mirror is refused where the chip has none" '^limner: --mirror: pcd8544 cannot$' \
    play "$model" --panel pcd8544 --spi /dev/spidev99.0 --dc GPIO25 --mirror
mono="play $model --panel ssd1306 --spi /dev/spidev99.0 --dc GPIO25"
# shellcheck disable=SC2086 # words
{
    refuse "a line to wait for is refused where the chip has none" '^limner: --te: ssd1306 does not tell' $mono --te GPIO23
    refuse "an offset of rows is refused where the driver has none" '^limner: --offset 32,8: .*ssd1306.*32,0' \
        $mono --size 64x48 --offset 32,8
}
st7789 "a select line is refused where the bus selects" '^limner: --select: st7789 is selected by' "$model" --select GPIO22
st7789 "an unknown option is refused" '^limner: --colour: no such option' "$model" --colour
st7789 "render's options are refused" '^limner: --gif: no such option' "$model" --gif

# -- What contradicts itself ---------------------------------------------------------------------------------------------

st7789 "two orders of colours are refused" '^limner: --bgr, --rgb: only one of them' "$model" --bgr --rgb
st7789 "inverted and not is refused" '^limner: --invert, --no-invert: only one of them' "$model" --no-invert --invert
st7789 "no chip select that is high is refused" '^limner: --no-cs, --cs-high: only one of them' "$model" --no-cs --cs-high
st7789 "one line for two pins is refused" '^limner: --dc, --reset: both cannot be GPIO25' "$model" --reset GPIO25
st7789 "a scene and the card are refused" '^limner: --test-card: draws no scene, what is' --test-card "$model"
st7789 "a camera and the card are refused" "what is '--camera'" --test-card --camera x.cam
st7789 "two scenes are refused" 'what is .*icosahedron' "$model" "$model"

# -- devices -------------------------------------------------------------------------------------------------------------

lists_devices() {
    "$limner" devices >"$work/devices" 2>&1 || return 1
    cat "$work/devices"
    ! grep -vE '^(spi|gpio|hid)  *[^ ]' "$work/devices" && grep -q '^spi' "$work/devices" &&
        grep -q '^gpio' "$work/devices"
}

tap_check "devices lists each kind, or says that there is none" lists_devices
refuse "devices takes nothing" "^limner: devices: takes nothing, what is 'all'" devices all
tap_done
