# SPDX-License-Identifier: MIT
#
# For the scripts of this folder to source: runs the kind of their name. Prints TAP.
# shellcheck shell=sh
: "${BUILD:?is set by the Makefile: run this script through make test}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
kind=${0##*/brought_}
PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 tests/brought/main.py "${kind%.sh}" "$work" # the one that Debian's packages are for
