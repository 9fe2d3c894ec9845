# SPDX-License-Identifier: MIT
#
# All pairs of features on by clang and off by gcc, each on another scene than tests/features_gcc.sh has it on: minutes.
. tests/tap.sh
. tests/features_on.sh

SEED=$((SEED + 8))
features_pairs clang gcc all
tap_done
