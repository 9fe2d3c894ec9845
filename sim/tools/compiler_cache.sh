# SPDX-License-Identifier: MIT
#
# Prints what goes before a compiler's name so that ccache keeps the objects, in a folder outside of the project that
# serves the next clone as well: sh sim/tools/compiler_cache.sh. Prints nothing where there is no ccache or no such folder.
folder=${XDG_CACHE_HOME:-${HOME:-/nowhere}/.cache}/limner/ccache
command -v ccache >/dev/null && mkdir -p "$folder" 2>/dev/null && [ -w "$folder" ] && echo "env CCACHE_DIR=$folder ccache"
exit 0
