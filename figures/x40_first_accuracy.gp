# Figure x40: changes of speed, turning point and energy as the step is halved.
width = 85; height = 58
load 'figures/style.gp'
set logscale xy
set format y '10^{%L}'
set xrange [7e-4:0.12]
set yrange [1e-6:0.02]
set xtics (0.001, 0.003, 0.01, 0.03, 0.1)
set xlabel 'time step  {/:Italic h}' offset 0,0.5; set ylabel 'relative change' offset 1,0
set label 1 'energy of the breather' at 0.0008,3e-3
set label 2 'speed of the packet' at 0.006,6e-6
set label 4 'turning point' at 0.026,3.2e-3
set label 3 '{/:Italic h}^{ 2}' at 0.011,3.5e-3
table = data.'/sec1_the_chain/convergence.ecsv'
of(name) = strcol('number') eq name ? column('change') : NaN
plot table using "h":(of('energy')) with linespoints ls 1 notitle, \
     '' using "h":(of('speed')) with linespoints ls 2 notitle, \
     '' using "h":(of('turn')) with linespoints ls 3 notitle, \
     [0.006:0.03] 12*x**2 lc rgb grey dt (4,2) notitle
