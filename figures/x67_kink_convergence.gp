# Figure x67: errors of the kink's speed and length against the step.
load 'figures/style.gp'
set logscale xy
set format y '10^{%T}'
set xrange [0.017:0.19]
set xtics (0.02, 0.04, 0.08, 0.16)
set key bottom right samplen 1.6
set xlabel 'time step  {/:Italic h}'
set ylabel 'relative error'
table = data.'/sec34_kink/kink_convergence.ecsv'
plot table using 'step':'length' with linespoints ls 3 title 'length', \
     '' using 'step':'speed' with linespoints ls 1 title 'speed'
