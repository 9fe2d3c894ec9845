# SPDX-License-Identifier: MIT
#
# The Linux port with the generation of libgpiod that is not installed: the tests of test_linux_port, built against a
# header of libgpiod 2 that lies in the user's cache.
. tests/tap.sh

cache=${XDG_CACHE_HOME:-$HOME/.cache}/limner
name="the Linux port works with libgpiod 2"

# Generation 1's gpio_v1.o stays in the library: nothing asks for it.
build() { # FOLDER of the header
    for source in hal/linux/gpio_v2.c tests/fakes/fake_gpiod_v2.c; do
        # shellcheck disable=SC2086 # CC may be several words
        ${CC:-gcc} @"$BUILD/host/flags" -ULIM_GPIOD -DLIM_GPIOD=2 -I"$1" -c -o "$work/$(basename "$source" .c).o" \
            "$source" || return 1
    done
    wrap=$(grep -o '__wrap_[a-z_]*(' tests/fakes/fake_linux.c | sort -u | sed 's/__wrap_\(.*\)(/-Xlinker --wrap=\1/')
    # shellcheck disable=SC2086 # both are words
    ${CC:-gcc} -o "$work/test" "$BUILD/host/tests/unit/hal/test_linux_port.o" "$BUILD/host/tests/fakes/fake_linux.o" "$work/gpio_v2.o" \
        "$work/fake_gpiod_v2.o" "$BUILD/host/liblimner.a" $wrap -lcmocka -lm
}

test_with() { # FOLDER of the header
    build "$1" && CMOCKA_MESSAGE_OUTPUT=TAP "$work/test"
}

header=$(find "$cache" -path '*libgpiod2*/usr/include/gpiod.h' 2>/dev/null | head -n 1)
if grep -q 'LIM_GPIOD=2' "$BUILD/host/flags"; then
    tap_skip "the Linux port works with libgpiod 1" "libgpiod 2 is installed, and only one of them can be"
elif [ -z "$header" ]; then
    tap_skip "$name" "its header is not in $cache; make test SUITES=kernel fetches it"
else
    tap_check "$name" test_with "$(dirname "$header")"
fi
tap_done
