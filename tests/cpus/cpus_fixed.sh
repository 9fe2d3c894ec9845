# SPDX-License-Identifier: MIT
#
# The fixed-point vectors on the processors that arm_fixed.sh leaves out. AVR is not among them: the
# vectors pass vertices in RAM, and the renderer reads them from flash there.
. tests/tap.sh
. tests/fixed_on.sh

fixed_on m3 rv32 powerpc
tap_done
