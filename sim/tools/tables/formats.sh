# SPDX-License-Identifier: MIT
#
# What is read of each format: nothing is measured here, the list is the readers'. tests/formats/what_is_read.sh holds it.

"$BUILD/limner" formats --markdown
