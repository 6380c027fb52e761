# Figure x69: energy of each site before a defect, twice after the packet has been reflected, and without a defect.
load 'figures/style.gp'
set logscale y
set format y '10^{%T}'
set xrange [60:101]
set yrange [1e-6:1]
set key top left samplen 1.6
set xlabel 'site  {/:Italic n}'
set ylabel 'fraction of the energy'
table = data.'/sec36_cantilever_defect/profiles.ecsv'
of(ratio, time) = column('ratio') == ratio && column('t') == time ? column('energy') : NaN
plot table using 'n':(of(1, 75)) with lines lc rgb grey lw 2 title 'no defect, 75 ms', \
     '' using 'n':(of(1.6, 75)) with linespoints ls 1 title '1.6 radii, 75 ms', \
     '' using 'n':(of(1.6, 100)) with linespoints ls 3 title '100 ms'
