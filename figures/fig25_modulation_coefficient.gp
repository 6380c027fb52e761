# Figure 25: the modulation coefficient against wavenumber for three wells.
width = 85; height = 62
load 'figures/style.gp'
table = data.'/sec4_precompression_mi/instability.ecsv'
set lmargin 8; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set xlabel 'wavenumber q (1/site)'
set ylabel 'modulation coefficient Φ' offset 1,0
set xrange [0:pi]
set yrange [-1.6:0.5]
set xtics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)
set xzeroaxis lw 0.8 lc rgb grey
set key at graph 0.62,0.34 right
set label 1 'unstable' at graph 0.74,0.83
plot table using "q":(only(-1./6, column("phi"))) with lines ls 2 title 's = −1/6', \
     table using "q":(only(0, column("phi"))) with lines ls 1 title 's = 0', \
     table using "q":(only(1, column("phi"))) with lines ls 3 title 's = 1'
