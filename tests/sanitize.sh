# SPDX-License-Identifier: MIT
#
# The unit tests under gcc's address and undefined-behaviour sanitizers: no report. sanitize_scenes.sh draws.
. tests/tap.sh
. tests/with_sanitizers.sh

# The longest tests do a part of their work here.
export TEST_EFFORT=5

tap_check "everything builds with the sanitizers" sanitized test-programs "$build/limner"
for program in "$build"/tests/test_*; do
    [ -x "$program" ] || continue
    tap_check "$(basename "$program")" "$program"
done
tap_done
