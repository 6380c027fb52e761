# One look for all gnuplot figures: 8 pt, Okabe-Ito colours, distinct dashes and marks.
# The caller sets `data` (folder of all tables), `out` (SVG file) and, before it loads this file, the `width` and
# `height` in millimetres if they are not those of one column.
if (!exists("width")) { width = 85; height = 60 }
set encoding utf8
set terminal svg size width*3.7795, height*3.7795 font 'DejaVu Sans,10.7' linewidth 1 \
    background rgb 'white' dashlength 0.7
set output out
set datafile separator comma
set datafile columnheaders
set border 31 lw 0.8
set tics scale 0.6 nomirror
set key samplen 2.2 spacing 1.1 Left reverse
blue = '#0072B2'; vermilion = '#D55E00'; green = '#009E73'; black = '#000000'; grey = '#888888'
set style line 1 lc rgb blue lw 1.6 dt solid pt 7 ps 0.35
set style line 2 lc rgb vermilion lw 1.6 dt (8,4) pt 5 ps 0.35
set style line 3 lc rgb green lw 1.6 dt (2,3) pt 9 ps 0.4
set style line 4 lc rgb black lw 1.6 dt (10,3,2,3) pt 11 ps 0.4
# A number of the rows with this anharmonicity
only(s, x) = abs(column("s") - s) < 1e-9 ? x : NaN
