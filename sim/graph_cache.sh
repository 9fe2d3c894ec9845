# SPDX-License-Identifier: MIT
#
# Compiles with gcc's call graph (-fcallgraph-info), which ccache does not keep: sh sim/graph_cache.sh COMPILER
# ARGUMENT... -c -o OBJECT SOURCE. Takes the object and its graph from a folder outside of the project if the same
# compiler has made them of the same preprocessed text with the same flags. Without $CCACHE it only compiles.
set -eu

folder=${XDG_CACHE_HOME:-${HOME:-/nowhere}/.cache}/limner/graphs
if [ -z "${CCACHE:-}" ] || ! mkdir -p "$folder" 2>/dev/null || ! [ -w "$folder" ]; then exec "$@"; fi

# Where headers are and what macros are named is in the text; what is left of the words decides, too.
object='' depends='' words='' last=''
for word; do
    shift
    case $last,$word in
    -o,*) object=$word ;;
    *,-o) ;;
    *) set -- "$@" "$word" ;;
    esac
    case $last,$word in
    -o,* | *,-o | *,-I* | *,-D* | *,-U*) ;;
    *,-MMD) depends=yes ;;
    *) words="$words $word" ;;
    esac
    last=$word
done
stem=${object%.*}

# Files' names go: temporary folders are among them. Lines stay: the graph has them.
text=$(mktemp "$folder/text.XXXXXX")
trap 'rm -f "$text"' EXIT
"$@" ${depends:+-MF "$stem.d" -MT "$object"} -E -o "$text"
key=$({ echo "$words" && "$1" --version && sed 's/^# \([0-9]*\) .*/# \1/' "$text"; } | sha256sum | cut -d ' ' -f 1)

if [ -f "$folder/$key.ci" ]; then
    touch "$folder/$key.o" "$folder/$key.ci"
    cp "$folder/$key.o" "$object"
    cp "$folder/$key.ci" "$stem.ci"
    exit 0
fi
"$@" -o "$object"
# Whole or not at all, the graph last.
for kind in o ci; do
    made=$object
    [ $kind = o ] || made=$stem.ci
    cp "$made" "$text" && mv "$text" "$folder/$key.$kind"
done
# What nobody asked for in two months goes. Another compiler's text may go at the same time.
find "$folder" -type f -mtime +60 -delete 2>/dev/null || true
