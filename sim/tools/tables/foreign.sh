# SPDX-License-Identifier: MIT
#
# What emulated modules show of what others' drivers send: a test draws it, see tests/foreign/README.md.
# shellcheck shell=sh disable=SC2154 # of tables.sh: work
sh tests/foreign.sh --table "$work/table" >&2
cat "$work/table"
