# Figure 21: velocities of a softened chain, with the surface mode at the left end and the packet.
load 'figures/style.gp'
table = data.'/sec34_impact/surface_mode_snapshot.ecsv'
set lmargin 8; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set xlabel 'site n'
set ylabel 'velocity dy_n/dt'
set xrange [0:125]
set xzeroaxis lw 0.5 lc rgb grey
plot table using "n":"v" with linespoints ls 1 notitle
