# SPDX-License-Identifier: MIT
#
# The unit tests under gcc's address and undefined-behaviour sanitizers: no report. sanitize_scenes.sh draws. A run has
# every sixteenth program, others with each commit; SEED=0 to SEED=15 name them, SEED=all has all.
. tests/tap.sh
. tests/with_sanitizers.sh

# The longest tests do a part of their work here.
export TEST_EFFORT=5

programs=$(part_of 16 tests/*/test_*.c tests/*/*/test_*.c | sed "s,.*/\(.*\)\.c$,$build/tests/\1,")
echo "# SEED=$SEED"
# shellcheck disable=SC2086 # names are words
tap_check "everything builds with the sanitizers" sanitized $programs "$build/limner"
for program in $programs; do
    tap_check "$(basename "$program")" "$program"
done
tap_done
