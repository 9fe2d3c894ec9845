# SPDX-License-Identifier: MIT
#
# What people bring, each input drawn as rays have it: tests/brought/kind_foreign.py.
. tests/brought/brought.sh
