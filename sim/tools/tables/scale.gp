# SPDX-License-Identifier: MIT
#
# gnuplot -c sim/tools/tables/scale.gp ROWS: what a frame costs against the size of the scene, from the rows of sim/tools/tables/scale.sh, as PNG on
# standard output.
set terminal pngcairo size 1000, 420 font 'sans,10'
set datafile missing NaN
set logscale xy
set grid
set xlabel 'polygons'
set key left top
of(kind, value) = stringcolumn(2) eq kind ? value : NaN

set multiplot layout 1, 2
set title 'work of a frame'
set ylabel 'nodes, and pieces of polygons, reached'
set yrange [5:*]
plot ARG1 using (of('rooms', $3)):9 with linespoints pointtype 6 linecolor rgb '#20a060' title 'rooms: nodes', \
    '' using (of('rooms', $3)):10 with linespoints pointtype 7 linecolor rgb '#20a060' title 'rooms: pieces', \
    '' using (of('mesh', $3)):9 with linespoints pointtype 6 linecolor rgb '#2060c0' title 'mesh: nodes', \
    '' using (of('mesh', $3)):10 with linespoints pointtype 7 linecolor rgb '#2060c0' title 'mesh: pieces', \
    x with lines dashtype 3 linecolor rgb '#808080' title 'all of them'
set title 'thousand instructions a frame'
set ylabel ''
set yrange [100:*]
plot ARG1 using (of('rooms', $3)):11 with linespoints pointtype 6 linecolor rgb '#20a060' title 'rooms: Cortex-M0+, predicted', \
    '' using (of('rooms', $3)):12 with linespoints pointtype 7 linecolor rgb '#20a060' title 'rooms: Cortex-M4F, counted', \
    '' using (of('mesh', $3)):11 with linespoints pointtype 6 linecolor rgb '#2060c0' title 'mesh: Cortex-M0+, predicted', \
    '' using (of('mesh', $3)):12 with linespoints pointtype 7 linecolor rgb '#2060c0' title 'mesh: Cortex-M4F, counted'
unset multiplot
