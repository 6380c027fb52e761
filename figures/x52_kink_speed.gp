# Figure x52: speed of the kink near the struck end and a hundred beads on, and of the pulse that moves beads as far.
load 'figures/style.gp'
set logscale x
set xrange [4.6:70]
set yrange [0.3:2.05]
set xtics (5, 6, 8, 12, 16, 32, 64)
set key bottom right samplen 1.6
set xlabel 'impact velocity  {/:Italic v}_0'
set ylabel 'speed (sites per unit of time)'
table = data.'/sec34_kink/kink_shape.ecsv'
plot table using 'velocity':'pulse_speed' with linespoints ls 4 title 'pulse', \
     '' using 'velocity':'speed_near' with linespoints ls 1 title 'kink, near', \
     '' using 'velocity':'speed_far' with linespoints ls 2 title 'kink, far'
