# Figure x73: error of turning point and reflection at 1.9 against the step, by two schemes.
load 'figures/style.gp'
table = data.'/sec34_boomeron/convergence.ecsv'
set logscale xy
set format y '10^{%T}'
set xrange [0.02:0.25]
set yrange [1e-9:1e2]
set ytics 1e2
set xtics (0.025, 0.05, 0.1, 0.2)
set xlabel 'time step'
set ylabel 'error (sites, units of time)' offset 1
set arrow from 0.0363, 1e-9 to 0.0363, 1e-3 nohead lc rgb grey lw 1
set key top left samplen 1.6 spacing 0.95
plot table using "step":"time" with linespoints ls 1 title 'reflection, time', \
     '' using "step":"other_time" with linespoints ls 1 dt (3,2) pt 6 title 'other scheme', \
     '' using "step":"site" with linespoints ls 2 dt solid title 'turning point, site', \
     '' using "step":"other_site" with linespoints ls 2 dt (3,2) pt 4 title 'other scheme'
