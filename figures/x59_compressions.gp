# Figure x59: centre of the packet after the same impact for four compressions.
width = 85; height = 62
load 'figures/style.gp'
paths = data.'/sec4_precompression_mi/packet_history.ecsv'
only(d, x) = abs(column("d") - d) < 1e-9 && column("s") > 0.5 ? x : NaN
set lmargin 8; set rmargin 3; set bmargin 3.4; set tmargin 0.8
set logscale y
set xlabel 'time t'
set ylabel 'centre of the packet (site)' offset 1,0
set xrange [0:2000]
set yrange [3:3000]
unset key
set label 1 'd = 0.5' at 1350,1450
set label 2 '0.05' at 1500,180
set label 4 '0.02' at 1500,37
set label 5 '0' at 1040,6
plot paths using "t":(only(0.5, column("centre"))) with lines ls 3, \
     paths using "t":(only(0.05, column("centre"))) with lines ls 4, \
     paths using "t":(only(0.02, column("centre"))) with lines ls 1, \
     paths using "t":(only(0, column("centre"))) with lines ls 1 lc rgb grey dt (4,4)
