# SPDX-License-Identifier: MIT
#
# Maps of Freedoom (Debian's package freedoom) as models: no holes, no errors of order, cameras at things, and what the
# commands say of WADs. All 68 maps: tests/levels.sh.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
one=/usr/share/games/doom/freedoom1.wad two=/usr/share/games/doom/freedoom2.wad
cd "$work" || exit 1

lists_maps() { # WAD FIRST COUNT LINES VERTICES SECTORS THINGS
    "$limner" wad "$1" >list && sed -n '1p; 3p' list && [ "$(sed 1,2d list | wc -l)" -eq "$3" ] &&
        [ "$(sed -n 3p list | tr -s ' ')" = "$2 $4 $5 $6 $7" ]
}

# The row of profile fast: holes, those of them that are errors of order, and pixels, of which the profile promises 0.05 %.
has_no_holes() { # MODEL CAMERA OPTION...
    model=$1 camera=$2
    shift 2
    timeout 300 "$limner" measure "$model" --camera "$camera" --precision fast --no-cost -o measured "$@" >said 2>&1 || { cat said; return 1; }
    awk -F , 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
        { print $0; rows++; bad += $column["holes"] + $column["order_errors"]; wrong += $column["wrong_percent"] > 0.05 }
        END { exit rows != 1 || bad || wrong }' measured/measure.csv
}

# What the check before it measured: texels are within a 12th of those of the faces, in the mean, and compared.
has_good_texels() {
    awk -F '|' '/texel error mean/ { getline; getline; print; mean = $3 } /^Texels shown/ { print; pixels = $0 ~ /[0-9][0-9][0-9][0-9] pixels/ }
        END { exit !(mean > 0 && mean < 0.083 && pixels) }' measured/measure.md
}

is_refused() { # REASON COMMAND...
    reason=$1
    shift
    rm -f out.png
    ! "$limner" "$@" >said 2>&1 && cat said && [ "$(cat said)" = "limner: $reason" ] && [ ! -e out.png ]
}

# From the first player's eyes without --camera, as from a file with that camera.
begins_at_the_player() {
    "$limner" render "$one:E1M1" --size 64x64 --frames 1 --write-hashes a >said 2>&1 || { cat said; return 1; }
    printf -- '-5 1.28125 -9.5 -4 1.28125 -9.5\n' >player.cam
    "$limner" render "$one:E1M1" --size 64x64 --camera player.cam --write-hashes b >said 2>&1 && cmp a b
}

# As many different pictures as there are things to look from, which --camera takes all of.
looks_from_things() {
    "$limner" render "$two:MAP07" --size 64x64 --write-hashes some >said 2>&1 || { cat said; return 1; }
    "$limner" render "$two:MAP07" --size 64x64 --camera "$two:MAP07" --write-hashes all >said 2>&1 || { cat said; return 1; }
    wc -l some all && [ "$(wc -l <some)" -eq 16 ] && [ "$(wc -l <all)" -gt 60 ] && [ "$(cut -d ' ' -f 2 some | sort -u | wc -l)" -ge 15 ]
}

names_scenes_by_maps() {
    timeout 300 "$limner" compile "$one:E1M8" "$two:MAP07" --no-textures -o level --report >said 2>&1 || { cat said; return 1; }
    ls level* && [ -e level_E1M8.c ] && [ -e level_MAP07.lim ] && grep -q LEVEL_E1M8 level.h
}

# A report holds the whole WAD, which is Freedoom's 27 MB.
reports_hold_wads() {
    ln -s "$two" map.wad && cp "$two" own.wad &&
        "$limner" report-bug own.wad:MAP07 --size 32x32 --frames 2 -o report.tar >said 2>&1 || { cat said; return 1; }
    tar -tf report.tar && tar -xOf report.tar report.txt | grep -qx 'scene: scene/own.wad:MAP07' && rm own.wad &&
        "$limner" replay report.tar
}

tap_check "freedoom1's maps are listed" lists_maps "$one" E1M1 36 812 819 133 238
tap_check "freedoom2's maps are listed" lists_maps "$two" MAP01 32 1069 1008 198 162
tap_check 'of several WADs the maps of all are listed' eval '"$limner" wad "$one+$two" >list && [ "$(sed 1,2d list | wc -l)" -eq 68 ]'
tap_check 'E1M1 has no holes and no errors of order, at random' has_no_holes "$one:E1M1" random:1
tap_check 'nor has it near its faces' has_no_holes "$one:E1M1" near:2:24
tap_check 'MAP01 has none where its things are' has_no_holes "$two:MAP01" "$two:MAP01" --size 120x120
tap_check 'MAP20, in which lines cross and name other sectors, has none' has_no_holes "$two:MAP20" random:3:16
tap_check 'that is noticed' eval 'grep -q "lines that cross others: 2, LINEDEFS 1647 among them; " said &&
    grep -q "lines that name a sector which is not there: 2, " said'
tap_check 'E3M4, which has more words of polygons than 16 bits count, has none' has_no_holes "$one:E3M4" random:4:16
tap_check 'its texels are as good as those of others' has_good_texels
tap_check 'it has no holes without textures' has_no_holes "$one:E3M4" random:4:16 --no-textures
tap_check 'without --camera the first picture is that of the first player' begins_at_the_player
tap_check 'others are those of things' looks_from_things
tap_check 'scenes are called by their maps' names_scenes_by_maps
tap_check 'with doors that move there are no holes' has_no_holes "$one:E1M1" near:5:16 --doors move
tap_check 'nor with open ones' has_no_holes "$one:E1M1" random:6:16 --doors=open
tap_check 'E1M1 has twelve doors and two lifts' eval '"$limner" compile "$one:E1M1" --doors move --no-textures --report >said && [ "$(grep -c "^  door of sector" said)" -eq 12 ] && [ "$(grep -c "^  lift of sector" said)" -eq 2 ]'
tap_check 'a bug report keeps that doors are open' eval '"$limner" report-bug "$one:E1M1" --doors open --no-textures --camera near:5:4 --size 64x48 -o open.tar && "$limner" replay open.tar'
tap_check 'other doors are refused' is_refused '--doors ajar: no such doors; there are closed, open and move' render "$one:E1M1" --doors ajar -o out.png
tap_check 'a report holds its WAD' reports_hold_wads
tap_check 'a WAD without a map is refused' is_refused \
    "$one: say which map, as $one:MAP01; \`limner wad $one\` lists them" render "$one" -o out.png
tap_check 'so is a map that there is none of' is_refused \
    "$one: there is no map MAP01 in it; \`limner wad\` lists those that are" render "$one:MAP01" -o out.png
echo nothing >nothing.wad
tap_check 'a file that is no WAD' is_refused 'nothing.wad: is no WAD: it begins with neither IWAD nor PWAD' wad nothing.wad
tap_check 'and a missing one' is_refused 'none.wad: No such file or directory' render none.wad:E1M1 -o out.png
tap_check 'pictures spare the WAD' eval 'cp "$two" own.wad && ! "$limner" render own.wad:MAP07 --frames 1 --ids own.wad >said 2>&1 && cat said && cmp "$two" own.wad'
tap_done
