# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# What the program of boards/linux says when it cannot draw; all that it holds is free afterwards.
refused_with() { # PATTERN VARIABLE=VALUE...
    pattern=$1
    shift
    refuse "$pattern" env "$@" image.elf && [ "$(gpioinfo wire-tap | grep -c unused)" = 4 ]
}

tap_check "a device that is not there is named with its variable" refused_with \
    '^limner: LIMNER_SPI=/dev/spidev9\.9: no such device; there are .*/dev/spidev0\.0' LIMNER_SPI=/dev/spidev9.9
tap_check "a line that is not there is" refused_with '^limner: LIMNER_DC=NOWHERE: no line of that name' LIMNER_DC=NOWHERE
tap_check "a line that is taken twice is" refused_with \
    '^limner: LIMNER_(DC|RESET)=DC: .* is in use by "limner"' LIMNER_RESET=DC
tap_check "a mode that is none is" refused_with '^limner: LIMNER_MODE=4: an SPI mode is 0 to 3$' LIMNER_MODE=4
tap_check "a wire that the panel wants is" refused_with '^limner: the panel wants a wire .*LIMNER_DC' LIMNER_DC=
tap_check "a bus that fails ends the program" refused_with \
    '^limner: LIMNER_SPI=/dev/spidev0\.2: .*Input/output error$' LIMNER_SPI=/dev/spidev0.2
