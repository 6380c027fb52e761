# Figure x41: how equal the mean forces are on an uneven ring, against the tolerance of the integration.
width = 85; height = 55
load 'figures/style.gp'
set logscale xy
set format xy '10^{%L}'
set xrange [3e-15:3e-4]; set yrange [3e-14:0.1]
set xtics 1e3; set ytics 1e3; unset mxtics; unset mytics
set xlabel 'tolerance of each step'; set ylabel 'spread of the mean forces'
set label 1 'does not return' at 1e-11,8e-3
set label 2 'uneven ring' at 1e-13,2e-7
set label 3 'walls' at 1e-9,1e-10
table = data.'/sec2_nonexistence/spread.ecsv'
of(name) = strcol('motion') eq name ? column('spread') : NaN
plot table using "tolerance":(of('not_returning')) with linespoints ls 2 ps 0.5 notitle, \
     '' using "tolerance":(of('uneven_ring')) with linespoints ls 1 ps 0.5 notitle, \
     '' using "tolerance":(of('walls')) with linespoints ls 3 ps 0.5 notitle
