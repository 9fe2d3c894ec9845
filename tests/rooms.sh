# SPDX-License-Identifier: MIT
#
# What may include what. sim/ and firmware/ have rooms, which the Makefile names from the lowest to the highest: a file
# includes headers of its own room and of lower ones, each as "room/file.h", and no two files need each other. The headers
# of firmware/ outside of its rooms are public: the rooms may use them, but for those that know the whole renderer. Nobody
# else includes what is in a room of firmware/. firmware/ includes nothing but itself, hal/ itself and firmware/, sim/ these
# and boards/common; hal/adapters, which nobody includes but a program, hal/, firmware/ and boards/common, and the headers
# of the libraries that it joins to. No two files have one name, as all are found by their names; programs that stand alone, each in a
# folder of its own, have what names they like.
. tests/tap.sh

# Lines "FILE:LINE:HEADER" of the sources in folders.
includes() { # FOLDER...
    find "$@" -name '*.[ch]' -exec grep -Hno '^# *include "[^"]*"' {} + | sed 's/# *include "//; s/"$//'
}

# The rooms of a folder, lowest first.
rooms_of() { # FOLDER
    case $1 in
    sim) sed -n 's/^rooms *:= //p' Makefile ;;
    firmware) sed -n 's/^firmware_rooms *:= //p' Makefile ;;
    esac
}

arrows_go_down() { # FOLDER
    includes "$1" | awk -F : -v folder="$1" -v rooms="$(rooms_of "$1")" '
        BEGIN { count = split(rooms, name, " "); for (i = 1; i <= count; i++) level[name[i]] = i }
        { split($1, from, "/"); slash = index($3, "/"); to = substr($3, 1, slash - 1) }
        !(from[2] in level) { next }
        slash == 0 && system("test -f \"" folder "/" from[2] "/" $3 "\"") == 0 {
            print $1 ":" $2 ": " $3 " without its room: " from[2] "/" $3; wrong = 1
        }
        level[to] > level[from[2]] { print $1 ":" $2 ": " from[2] " lies below " to ": " $3; wrong = 1 }
        END { exit wrong }'
}

rooms_are_named() { # FOLDER OTHER...
    folder=$1
    shift
    for room in "$folder"/*/; do
        room=$(basename "$room")
        case " $(rooms_of "$folder") $* " in
        *" $room "*) ;;
        *) echo "$folder/$room: no room of the Makefile's list" && return 1 ;;
        esac
    done
}

sim_is_rooms_alone() { ! find sim -maxdepth 1 -name '*.[ch]' | grep .; }

# In firmware/ itself few files know the whole renderer; its headers include at most the lowest room.
renderer_is_on_top() {
    ! includes firmware | grep '^firmware/[a-z]*/' | grep -E ':(limner|ahead|inspect)\.h$' &&
        ! includes firmware/*.h | cut -d : -f 3 | grep / | grep -v '^math/' &&
        ! grep -nE 'struct lim \*|struct lim lim' firmware/*/*.[ch] &&
        [ "$(grep -lE 'struct lim \*' firmware/*.[ch] | wc -l)" -le 8 ]
}

# A header that includes none is one deep.
shallow() { # MOST
    includes firmware | sed 's,^firmware/,,' | awk -F : -v most="$1" '
        $1 ~ /\.h$/ { needed[$1] = needed[$1] " " $3 }
        function depth(header,    list, count, i, below, deepest) {
            if (header in known) return known[header]
            count = split(needed[header], list, " ")
            for (i = 1; i <= count; i++) if ((below = depth(list[i])) > deepest) deepest = below
            return known[header] = deepest + 1
        }
        END {
            for (header in needed) if (depth(header) > most) { print "firmware/" header ": " depth(header) " deep"; wrong = 1 }
            exit wrong
        }'
}

headers_are_shallow() { shallow 6 && ! shallow 5 >/dev/null; }

rooms_are_private() {
    ! includes hal sim boards | grep -E ":($(rooms_of firmware | tr ' ' '|'))/" >"$work/private" ||
        awk -F : '{
            split($1, from, "/")
            if (system("test -f sim/" $3) == 0 && from[1] == "sim") next
            print $1 ":" $2 ": " $3 " is private to firmware/"; wrong = 1
        } END { exit wrong }' "$work/private"
}

# Where a header is found: beside its file, or in a folder that all see.
stays_inside() { # FOLDER LOWER...
    includes "$1" | grep -v '^hal/adapters/' | awk -F : -v folders="$*" '
        BEGIN { count = split(folders, folder, " ") }
        {
            from = $1
            sub(/[^\/]*$/, "", from)
            found = system("test -f \"" from $3 "\"") == 0
            for (i = 1; i <= count && !found; i++) found = system("test -f \"" folder[i] "/" $3 "\"") == 0
            if (!found) { print $1 ":" $2 ": " $3 " is in none of: " folders; wrong = 1 }
        }
        END { exit wrong }'
}

# What a library's header is called is seen by that no file of ours has its name.
adapters_are_on_top() {
    ! includes firmware hal sim boards | grep -v '^hal/adapters/' | grep -E ':(adapters/|limner_[a-z_]*\.h)' &&
        includes hal/adapters | cut -d : -f 3 | sort -u >"$work/joined" && while read -r header; do
        ours=$(find firmware hal sim boards tests/unit -name "$(basename "$header")")
        case $ours in
        '' | "firmware/$header" | "hal/$header" | "hal/adapters/$header" | "boards/common/$header") ;;
        *) echo "hal/adapters includes $ours" && return 1 ;;
        esac
    done <"$work/joined"
}

# What users copy is short: comments and all; but the ports for Arduino and ESP-IDF, which set up the whole bus.
adapters_are_short() { # MOST MOST-OF-PORTS
    for header in hal/adapters/*.h; do
        case $header in *_arduino.h | *_idf.h) most=$2 ;; *) most=$1 ;; esac
        lines=$(wc -l <"$header")
        [ "$lines" -le "$most" ] || { echo "$header: $lines lines, $most are the most" && return 1; }
    done
}

names_are_unique() {
    ! find firmware hal sim boards/common tests/unit tests/rigs tests/fakes tests/golden tests/extremes -name '*.[ch]' \
        ! -name main.c |
        sed 's,.*/,,' | sort | uniq -d | grep .
}

# A file and its header are one. A scene owns what moves in it, which is made of scenes; the emulated STM32's parts are one
# chip, whose header is not theirs.
known_rings='scene/compiled scene/moving
emulators/stm32_chip emulators/stm32_parts'

# Lines "FILE NEEDED" of a folder.
needs() { # FOLDER
    includes "$1" | awk -F : -v folder="$1/" '{
        from = substr($1, length(folder) + 1)
        sub(/\.[ch]$/, "", from)
        beside = from
        sub(/[^\/]*$/, "", beside)
        to = $3 ~ /\// || system("test -f \"" folder beside $3 "\"") ? $3 : beside $3
        sub(/\.h$/, "", to)
        if (from != to) print from, to
    }' | sort -u
}

no_rings() { # LINES of needs: those that are known are not followed
    printf '%s\n' "$1" | grep -vxF "$known_rings" >"$work/needs"
    tsort "$work/needs" >/dev/null 2>"$work/ring" && return
    sed -n 's/^tsort: \(.*[^:]\)$/\1/p' "$work/ring"
    return 1
}

has_no_rings() { no_rings "$(needs "$1")"; } # FOLDER

rings_are_named() {
    ! no_rings "$(needs sim && echo 'base/error scene/encoding')" >"$work/said" && grep -qx base/error "$work/said" &&
        grep -qx scene/encoding "$work/said"
}

few_files() { # a folder of sources is seen on one page
    find firmware hal boards sim tests -name '*.[ch]' -o -name '*.sh' | sed 's,/[^/]*$,,' | sort | uniq -c |
        awk '$1 > 60 { print $2 ": " $1 " files, 60 are the most"; wrong = 1 } END { exit wrong }'
}

# Stages are linked or not by constants that the compiler folds: what is asked of the preprocessor is what it alone can say.
# Whether a whole file is left out is not counted: a file more is no harm.
few_conditions() {
    find firmware -name '*.[ch]' | while read -r file; do
        awk '
            /^[ \t]*#[ \t]*if/ { if (!depth++) first = FNR; if (!/_H$/) { all++; outer[first]++; own[FNR] = depth == 1; if (inside) bodies++ } }
            /^\{/ { inside = 1 }
            /^\}/ { inside = 0 }
            /^[ \t]*#[ \t]*endif/ { if (!--depth) end = first; last = FNR }
            NF { written = FNR }
            END { print all - (FILENAME ~ /c$/ && last == written && own[end]), bodies + 0 }' "$file"
    done | awk '{ all += $1; bodies += $2 }
        END { print all " #if, " bodies " in functions; 200 and 40 are the most"; exit all > 200 || bodies > 40 }'
}

tap_check "sim/ has the rooms that the Makefile names" rooms_are_named sim emulators export scenes targets tools
tap_check "and no file outside of them" sim_is_rooms_alone
tap_check "so has firmware/" rooms_are_named firmware
tap_check "a room of sim/ includes itself and lower ones" arrows_go_down sim
tap_check "so does a room of firmware/" arrows_go_down firmware
tap_check "no room of firmware/ knows struct lim" renderer_is_on_top
tap_check "nobody else includes what is in a room of firmware/" rooms_are_private
tap_check "no header of firmware/ is more than six deep" headers_are_shallow
tap_check "firmware/ includes itself alone" stays_inside firmware
tap_check "hal/ includes itself and firmware/" stays_inside hal firmware
tap_check "hal/adapters stands on them and boards/common, and nothing on it" adapters_are_on_top
tap_check "its headers have 60 lines at most, two ports 100" adapters_are_short 60 100
tap_check "sim/ includes itself, firmware/, hal/ and boards/common" stays_inside sim firmware hal boards/common
tap_check "no two files of sim/ need each other, nor more in a ring" has_no_rings sim
tap_check "no two files of firmware/ do" has_no_rings firmware
tap_check "those that do are named" rings_are_named
tap_check "no two files have one name" names_are_unique
tap_check "no folder of sources has more than 60" few_files
tap_check "firmware/ asks the preprocessor seldom" few_conditions
tap_done
