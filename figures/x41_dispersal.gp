# Figure x41: changes of the energy fraction and the mean force of the dispersing state as the step is halved.
width = 85; height = 55
load 'figures/style.gp'
set logscale xy
set format y '10^{%L}'
set xrange [4e-3:0.07]; set yrange [1e-13:1e-2]
set xtics (0.005, 0.01, 0.02, 0.05); set ytics 1e2; unset mytics
set xlabel 'time step  {/:Italic h}' offset 0,0.5; set ylabel 'relative change' offset 1,0
set label 1 'mean force' at 0.01,2e-4
set label 2 'energy on nine sites' at 0.017,2e-11
set label 3 '{/:Italic h}^{ 5}' at 0.019,3e-9
table = data.'/sec2_nonexistence/convergence.ecsv'
plot table using "step":"core" with linespoints ls 1 ps 0.5 notitle, \
     '' using "step":"mean" with linespoints ls 2 ps 0.5 notitle, \
     [0.012:0.06] 0.2*x**5 lc rgb grey dt (4,2) notitle
