# Figure x40: changes of speed and energy and multipliers near +1 of the first chapter as its step is halved.
width = 85; height = 62
load 'figures/style.gp'
set logscale xy
set format y '10^{%L}'
set xrange [7e-4:0.07]
set yrange [1e-6:0.06]
set xtics (0.001, 0.003, 0.01, 0.03)
set xlabel 'time step  {/:Italic h}' offset 0,0.5; set ylabel 'change, or distance from +1' offset 1,0
set label 1 'exact pair' at 0.0035,0.0016
set label 2 'pinning pair' at 0.0008,1.1e-4
set label 3 'energy' at 0.0008,4.2e-5
set label 4 'speed' at 0.02,1.6e-4
set label 5 '{/:Italic h}^{ 3/4}' at 0.0035,0.0115
set label 6 '{/:Italic h}^{ 2}' at 0.04,3e-5
table = data.'/sec1_the_chain/convergence.ecsv'
plot table using "h_breather":"fourth" with linespoints ls 4 notitle, \
     '' using "h_breather":"second" with linespoints ls 3 notitle, \
     '' using "h_breather":"energy" with linespoints ls 1 notitle, \
     '' using "h_impact":"speed" with linespoints ls 2 notitle, \
     [0.001:0.03] 0.3*x**0.75 lc rgb grey dt (4,2) notitle, \
     [0.01:0.05] 0.01*x**2 lc rgb grey dt (1,2) notitle
