# Figure x54: errors of what is measured at a defect, against the step.
load 'figures/style.gp'
set logscale xy
set format y '10^{%T}'
set ytics 1e-10, 100, 1; unset mytics
set xrange [0.09:0.57]
set yrange [1e-11:1]
set xtics ('1/10' 0.1, '1/5' 0.2, '1/4' 0.25, '1/3' 0.3333, '1/2' 0.5)
set key top left samplen 1.6
set xlabel 'time step  {/:Italic h}  (units of τ_c)'
set ylabel 'relative error'
table = data.'/sec36_cantilever_defect/convergence.ecsv'
plot table using 'step':'near' with linespoints ls 3 title 'kept at 0.925 radii', \
     '' using 'step':'reflected' with linespoints ls 1 title 'reflected at 1.1 radii', \
     2e-4*x**4 lc rgb grey dt (2,2) title 'slope 4'
