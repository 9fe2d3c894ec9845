# SPDX-License-Identifier: MIT
#
# embed.sh FILE...: a table of these files' texts as C, for sim/export/embedded.h. A line of text is a string, and the
# compiler joins them.
set -e
LC_ALL=C
export LC_ALL
tab=$(printf '\t')
echo '#include "export/embedded.h"'
echo
echo '#include <stddef.h>'
echo
echo 'const struct embedded embedded_files[] = {'
for file; do
    echo "    {\"$file\","
    sed 's/\\/\\\\/g; s/"/\\"/g; s/'"$tab"'/\\t/g; s/??/?\\?/g; s/.*/     "&\\n"/' "$file"
    echo '    },'
done
echo '    {NULL, NULL}};'
