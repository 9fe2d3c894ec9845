# SPDX-License-Identifier: MIT
#
# All pairs of features on by gcc and off by clang: minutes. tests/features_clang.sh has them the other way round, on
# other scenes. (A seeded eighth of them is in tests/cli/cli_features.sh.)
. tests/tap.sh
. tests/features_on.sh

features_pairs gcc clang all
tap_done
