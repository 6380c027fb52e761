# Figure x48: V^2 against c^2 with the predicted line, and the threshold and the energy drift against the step.
width = 170; height = 62
load 'figures/style.gp'
set multiplot layout 1,2 margins 0.085,0.985,0.22,0.97 spacing 0.13,0
speeds = data.'/sec33_mobility/speeds_at_maximum.ecsv'
steps = data.'/sec33_mobility/threshold_steps.ecsv'
set key top left samplen 1.6
set xrange [1.8:4.1]; set yrange [-0.7:15]
set xlabel 'square of the kick  {/:Italic c}^2 · 10^{11}'
set ylabel 'square of the speed  {/:Italic V}^2 · 10^{11}' offset 1,0
set label 1 panel('a') at graph 0.92,0.08
stats speeds using (1e11*column("c2")):(1e11*column("predicted")) name 'P' nooutput
predicted(x) = P_intercept + P_slope*x
plot predicted(x) < 0 ? NaN : predicted(x) with lines ls 1 title 'predicted', \
     speeds using (1e11*column("c2")):(1e11*column("coarse")) with points ls 2 pt 4 ps 0.9 title 'chain, largest step', \
     '' using (1e11*column("c2")):(1e11*column("fine")) with points ls 4 pt 7 ps 0.35 title 'chain, fourteen stages'
set logscale xy
set format y '10^{%T}'
set key bottom right
set xrange [0.14:0.42]; set yrange [1e-12:3e-3]
set xtics (0.15, 0.2, 0.3, 0.4)
unset mxtics
set xlabel 'time step  {/:Italic h}'; set ylabel 'fraction' offset 1,0
set label 1 panel('b') at graph 0.03,0.94
plot steps using "step":"drift" with linespoints ls 2 title 'energy drift', \
     '' using "step":"lines" with lines ls 1 dt (1,2) title 'three kicks', \
     '' using "step":"shift" with linespoints ls 1 title 'change of  {/:Italic c_c}', \
     '' using "step":"kick" with lines ls 4 title 'energy of the kick'
unset multiplot
