# Figure x40: changes of speed, energy and multipliers of the first chapter as its step is halved.
width = 85; height = 62
load 'figures/style.gp'
set logscale xy
set format y '10^{%L}'
set xrange [6e-4:0.14]
set yrange [2e-7:0.04]
set xtics (0.001, 0.003, 0.01, 0.03, 0.1)
set xlabel 'time step  {/:Italic h}' offset 0,0.5; set ylabel 'change, or distance from +1' offset 1,0
set label 1 'exact pair' at 0.0022,0.009
set label 2 'pinning pair' at 0.0008,8.5e-5
set label 3 'energy' at 0.0009,2e-5
set label 4 'speed' at 0.021,3e-5
set label 5 'fifth multiplier' at 0.0042,5e-7
set label 6 '{/:Italic h}^{ 2}' at 0.07,2e-5
table = data.'/sec1_the_chain/convergence.ecsv'
plot table using "h_breather":"fourth" with linespoints ls 4 notitle, \
     '' using "h_breather":"second" with linespoints ls 3 notitle, \
     '' using "h_breather":"energy" with linespoints ls 1 notitle, \
     '' using "h_impact":"speed" with linespoints ls 2 notitle, \
     '' using "h_breather":"fifth" with linespoints lc rgb purple pt 13 ps 0.4 notitle, \
     [0.02:0.1] 0.01*x**2 lc rgb grey dt (1,2) notitle
