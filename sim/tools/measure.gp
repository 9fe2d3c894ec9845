# SPDX-License-Identifier: MIT
#
# gnuplot -c sim/tools/measure.gp CSV CORE...: accuracy against instructions from the CSV of `limner measure`, a
# panel for each processor, as PNG on standard output. The line is the front: beside it, every choice is
# dominated.
set terminal pngcairo size 1000, 420 * ((ARGC - 1 + 1) / 2) font 'sans,10'
set datafile separator ','
set datafile columnheaders
set datafile missing NaN
set logscale y
set xlabel 'thousand instructions a frame'
set ylabel 'pixels of a wrong polygon, %'
set grid
set key off
set format x '%.0f'
set offsets graph 0.08, graph 0.18, 0, 0
title_of(core) = core eq 'm0plus' ? 'Cortex-M0+' : core eq 'm3' ? 'Cortex-M3' : core eq 'm4' ? 'Cortex-M4F' : \
    core eq 'm33' ? 'Cortex-M33' : core eq 'rv32' ? 'RV32IMC' : core
cores = ARG2 . ' ' . ARG3 . ' ' . ARG4 . ' ' . ARG5 . ' ' . ARG6
x(core) = stringcolumn('core') eq core ? column('instructions') / 1000 : NaN
front_x(core) = column('on_front') == 1 ? x(core) : NaN
y(i) = column('wrong_percent') > 0 ? column('wrong_percent') : 1e-5

set multiplot layout (ARGC - 1 + 1) / 2, ARGC > 2 ? 2 : 1
do for [core in cores] {
    set title title_of(core)
    plot ARG1 using (front_x(core)):(y(0)) smooth unique with lines linewidth 2 linecolor rgb '#2060c0', \
        '' using (x(core)):(y(0)) with points pointtype 6 linecolor rgb '#808080', \
        '' using (front_x(core)):(y(0)) with points pointtype 7 linecolor rgb '#2060c0', \
        '' using (x(core)):(y(0)):(stringcolumn('precision')) with labels left offset 1, 0.3 font 'sans,8' noenhanced
}
unset multiplot
