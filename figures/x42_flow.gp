# Figure x42: extrapolation in t and in u, and the error of whole runs against their work.
width = 170; height = 68
load 'figures/style.gp'
set multiplot layout 1,2 margins 0.1,0.98,0.18,0.97 spacing 0.12,0
segment = data.'/secA_integrators/one_segment.ecsv'
orbit = data.'/secA_integrators/error_orbit.ecsv'
of(name) = strcol('method') eq name && strcol('contacts') eq 'open' ? column('error') : NaN
set logscale y
set format y '10^{%T}'
set key bottom left samplen 1.6
set label 1 panel('a') at graph 0.92,0.94
set xlabel 'levels of the extrapolation'; set ylabel 'error after one contact event' offset 1,0
set xrange [0.5:8.5]; set yrange [1e-13:1]
plot segment using 'levels':'in_t' with linespoints ls 1 title 'steps equal in  {/:Italic t}', \
     '' using 'levels':'in_u' with linespoints ls 2 title 'steps equal in  {/:Italic u}'
set logscale x
set format x '10^{%T}'
set key maxrows 2 width -4
set xrange [100:1e5]; set yrange [1e-17:1]
set ytics 1e3
unset mytics
set xlabel 'force evaluations for each bead'; set ylabel 'error of displacements  {/:Italic y_n}(50)' offset 1,0
set label 1 panel('b') at graph 0.92,0.94
plot orbit using 'evaluations':(of('blanes_moan_6')) with linespoints ls 1 title 'order 6', \
     '' using 'evaluations':(of('two_steps')) with linespoints ls 2 title 'events, 2 steps', \
     '' using 'evaluations':(of('six_steps')) with linespoints ls 3 title 'events, 6 steps', \
     '' using 'evaluations':(of('flow')) with linespoints ls 4 title 'flow'
unset multiplot
