# Figure x42: extrapolation of the leapfrog after a contact event, with steps equal in t and in u.
load 'figures/style.gp'
set logscale y
set format y '10^{%T}'
set key bottom left samplen 1.6
set xlabel 'levels of the extrapolation'; set ylabel 'error after one contact event' offset 1,0
set xrange [0.5:8.5]; set yrange [1e-13:1]
set ytics 1e3
unset mytics
table = data.'/secA_integrators/one_segment.ecsv'
plot table using 'levels':'in_t' with linespoints ls 1 title 'steps equal in  {/:Italic t}', \
     '' using 'levels':'in_u' with linespoints ls 2 title 'steps equal in  {/:Italic u}'
