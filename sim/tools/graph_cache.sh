# SPDX-License-Identifier: MIT
#
# Compiles with gcc's call graph (-fcallgraph-info), which ccache does not keep: sh sim/tools/graph_cache.sh COMPILER
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
"$@" ${depends:+-MF "$stem.d" -MT "$object"} -E -o "$stem.text"
key=$({ echo "$words" && "$1" --version && sed 's/^# \([0-9]*\) .*/# \1/' "$stem.text"; } | sha256sum)
kept=$folder/${key%% *}
rm "$stem.text"

# Another compiler may take them away now.
if [ -f "$kept.ci" ] && cp "$kept.o" "$object" 2>/dev/null && cp "$kept.ci" "$stem.ci" 2>/dev/null; then
    touch -c "$kept.o" "$kept.ci" || true
    exit 0
fi
"$@" -o "$object"
# Whole or not at all, the graph last.
cp "$object" "$kept.$$" && mv "$kept.$$" "$kept.o"
cp "$stem.ci" "$kept.$$" && mv "$kept.$$" "$kept.ci"
# What was not used for two months is made anew. Another compiler's files may go at the same time.
find "$folder" -type f -mtime +60 -delete 2>/dev/null || true
