# SPDX-License-Identifier: MIT
#
# All pairs of features, by gcc and by clang, on other scenes: minutes. (A seeded eighth of them is in tests/cli/cli_features.sh.)
. tests/tap.sh
. tests/features_on.sh

features_pairs gcc clang all
SEED=$((SEED + 8))
features_pairs clang gcc all
tap_done
