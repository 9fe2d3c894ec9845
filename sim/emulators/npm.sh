# SPDX-License-Identifier: MIT
#
# Sees to it that the emulators that come from npm are installed, as package-lock.json has them, and prints the folder
# that has node_modules: sh sim/emulators/npm.sh. It lies outside of the project, named for the versions, so that it is
# there for the next clone as well.
set -eu

here=$(dirname "$0")
version=$(sed -n 's/.*"rp2040js": "\(.*\)".*/\1/p' "$here/package.json")
folder=${XDG_CACHE_HOME:-$HOME/.cache}/limner/rp2040js-$version

fail() {
    printf 'npm: %s\n' "$*" >&2
    exit 1
}

command -v node >/dev/null || fail "node is missing; Debian's package: nodejs"
if [ ! -e "$folder/node_modules/rp2040js/package.json" ]; then
    command -v npm >/dev/null || fail "npm is missing; Debian's package: npm"
    mkdir -p "$(dirname "$folder")"
    work=$(mktemp -d "$folder.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    cp "$here/package.json" "$here/package-lock.json" "$work"
    (cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >&2) ||
        fail "rp2040js $version could not be installed into $folder"
    # Whoever comes second leaves the first one's.
    mv -T "$work" "$folder" 2>/dev/null || [ -e "$folder/node_modules/rp2040js/package.json" ] ||
        fail "$folder: cannot be put in place"
fi
echo "$folder"
