# SPDX-License-Identifier: MIT
#
# The fixed-point vectors on emulated Cortex-M0 and Cortex-M4 give what they give on the host. (The
# Cortex-M0+ runs the M0's instructions; QEMU's M0 refuses any other.)
. tests/tap.sh
. tests/fixed_on.sh

fixed_on microbit m4
tap_done
