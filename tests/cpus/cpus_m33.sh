# SPDX-License-Identifier: MIT
#
# Cortex-M33, in secure state: the fixed-point vectors in every profile, and frames of every kind of scene, each in one of the
# profiles (EVERY_PROFILE=yes: in all); code without the floating-point unit, and small code, draw the same.
. tests/tap.sh
. tests/fixed_on.sh
. tests/cpus/kinds.sh

fixed_on m33
kinds_on m33 m33nofp m33:-Os
tap_done
