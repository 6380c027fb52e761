# Figure 26: displacements on a ring at the start and when a travelling breather has formed.
width = 170; height = 62
load 'figures/style.gp'
table = data.'/sec4_precompression_mi/modulated_ring.ecsv'
set multiplot layout 1,2 margins char 8,2.5,3.4,0.8 spacing char 7,0
set xlabel 'site n'
set ylabel 'displacement y_n' offset 1,0
set xrange [0:201]
set yrange [-0.5:0.5]
set xzeroaxis lw 0.5 lc rgb grey
set label 1 '(a)  t = 0' at graph 0.03,0.94
plot table using "n":"y_start" with linespoints ls 1 lw 0.9 ps 0.2 notitle
set ylabel ''
set label 1 '(b)  t = 6619'
set key at graph 0.99,0.98 right
plot table using "n":"amplitude" with lines ls 2 lw 1 title 'envelope', \
     table using "n":"y" with linespoints ls 1 lw 0.9 ps 0.2 notitle
unset multiplot
