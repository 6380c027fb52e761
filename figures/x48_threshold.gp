# Figure x48: the threshold and the energy drift against the step.
load 'figures/style.gp'
steps = data.'/sec33_mobility/threshold_steps.ecsv'
set logscale xy
set format y '10^{%T}'
set key bottom right samplen 1.6
set xrange [0.14:0.42]; set yrange [1e-12:3e-3]
set xtics (0.15, 0.2, 0.3, 0.4)
unset mxtics
set xlabel 'time step  {/:Italic h}'; set ylabel 'fraction' offset 1,0
plot steps using "step":"drift" with linespoints ls 2 title 'energy drift', \
     '' using "step":"lines" with lines ls 1 dt (1,2) title 'three kicks', \
     '' using "step":"shift" with linespoints ls 1 title 'change of  {/:Italic c_c}', \
     '' using "step":"kick" with lines ls 4 title 'energy of the kick'
