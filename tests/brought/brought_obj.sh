# SPDX-License-Identifier: MIT
#
# What people bring, each input drawn as rays have it: tests/brought/kind_obj.py.
. tests/brought/brought.sh
