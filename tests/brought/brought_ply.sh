# SPDX-License-Identifier: MIT
#
# What people bring, each input drawn as rays have it: tests/brought/kind_ply.py.
. tests/brought/brought.sh
