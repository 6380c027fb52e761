# Figure x08: error against step where all contacts stay closed and where some open.
width = 170; height = 72
load 'figures/style.gp'
table = data.'/sec4_precompression_mi/order.ecsv'
of(kind, name) = strcol("contacts") eq kind && strcol("scheme") eq name ? column("error") : NaN
set multiplot layout 1,2 margins char 10,1.5,3.4,0.8 spacing char 6,0
set logscale xy
set format y '10^{%T}'
set xrange [0.006:0.6]
set yrange [1e-15:10]
set ytics 1e3
unset mytics
set xtics (0.01, 0.03, 0.1, 0.3)
set xlabel 'time step h'
set ylabel 'relative error of the end state'
set key bottom right samplen 1.6
set label 1 '(a)  contacts closed' at graph 0.03,0.94
plot table using "step":(of("closed", "verlet")) with linespoints ls 4 notitle, \
     table using "step":(of("closed", "blanes-moan-4")) with linespoints ls 3 notitle, \
     table using "step":(of("closed", "blanes-moan-6")) with linespoints ls 2 notitle, \
     table using "step":(of("closed", "blanes-moan-6-14")) with linespoints ls 1 notitle, \
     [0.02:0.5] 2e-4*x**6 with lines lc rgb grey dt (4,2) title 'h^6'
set ylabel ''
set key spacing 0.95
set label 1 '(b)  contacts opening'
plot table using "step":(of("opening", "verlet")) with linespoints ls 4 title 'velocity Verlet', \
     table using "step":(of("opening", "blanes-moan-4")) with linespoints ls 3 title 'order 4', \
     table using "step":(of("opening", "blanes-moan-6")) with linespoints ls 2 title 'order 6', \
     table using "step":(of("opening", "blanes-moan-6-14")) with linespoints ls 1 title 'order 6, 14 stages', \
     [0.008:0.05] 3e-5*x**2.5 with lines lc rgb grey dt (1,2) title 'h^{5/2}'
unset multiplot
