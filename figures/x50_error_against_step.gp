# Figure x50: relative error of the packet's speed, energy and largest density against the step.
load 'figures/style.gp'
table = data.'/sec34_impact/convergence.ecsv'
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xrange [0.01:0.3]
set yrange [1e-14:1e-5]
set ytics 1e2
set xlabel 'time step'
set ylabel 'relative error' offset 1
set key bottom right samplen 1.6 spacing 0.95
plot 1e-3*x**5 with lines lc rgb grey lw 1 notitle, \
     table using "step":"energy" with linespoints ls 2 dt solid title 'energy', \
     '' using "step":"speed" with linespoints ls 1 title 'speed', \
     '' using "step":"peak" with linespoints ls 3 dt solid title 'peak'
