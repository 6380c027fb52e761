# Figure 23: velocities of a packet on its plateau, and the waves between it and the struck end.
width = 170; height = 58
load 'figures/style.gp'
table = data.'/sec34_boomeron/turning_profiles.ecsv'
set multiplot layout 1,2
set lmargin 8; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set xlabel 'site n'
set ylabel 'velocity dy_n/dt'
set xrange [0:40]
set yrange [-1.1:1.1]
set ytics 0.5
set xzeroaxis lw 0.5 lc rgb grey
do for [i = 1:2] {
  time = i == 1 ? 238 : 241
  set label 1 sprintf("(%s)  t = %d", i == 1 ? "a" : "b", time) at graph 0.97, graph 0.93 right
  plot table using "n":(column("t") == time ? column("v") : NaN) with linespoints ls 1 notitle
}
unset multiplot
