# Figure x49: by how much the DpS packet exceeds that of the chain, and the heights of both within an oscillation.
width = 170; height = 62
load 'figures/style.gp'
set multiplot layout 1,2 margins 0.09,0.985,0.22,0.97 spacing 0.12,0
table = data.'/sec34_dps_impact/discrepancy.ecsv'
set logscale xy
set xrange [0.025:0.3]; set yrange [0.0005:0.4]
set xtics (0.03, 0.06, 0.12, 0.25); set ytics (0.001, 0.003, 0.01, 0.03, 0.1, 0.3)
unset mxtics; unset mytics
set key bottom right samplen 1.6
set label 1 '(a)' at graph 0.03,0.94
set xlabel 'root of the size of the impact  ε^{1/2}'; set ylabel 'DpS over chain, less one' offset 1,0
plot table using "root":"amplitude" with linespoints ls 2 dt 1 title 'amplitude', \
     '' using "root":"speed" with linespoints ls 1 title 'speed', \
     '' using "root":"amplitude_same_start" with linespoints ls 2 title 'amplitude, same start', \
     '' using "root":"speed_same_start" with linespoints ls 1 dt (8,4) title 'speed, same start', \
     x lc rgb grey dt (1,2) title 'ε^{1/2}'
unset logscale
heights = data.'/sec34_dps_impact/heights.ecsv'
set xrange [8085:8095]; set yrange [8:15]
set xtics 2 format '%.0f'; set ytics 2 format '%.0f'
set key top right maxrows 1
set label 1 '(b)' at graph 0.03,0.08
set xlabel 'time  {/:Italic t}'; set ylabel 'height · 10^4' offset 1,0
plot heights using "t":(1e4*column("chain")) with lines ls 1 title 'chain', \
     '' using "t":(1e4*column("dps")) with lines ls 2 title 'DpS', \
     9 lc rgb blue dt (1,2) notitle, 13 lc rgb vermilion dt (1,2) notitle
unset multiplot
