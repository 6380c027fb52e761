# Figure x76: error of the NLS ansatz against its amplitude, in two norms.
load 'figures/style.gp'
errors = data.'/sec4_precompression_mi/ansatz_error.ecsv'
set lmargin 8.5; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set logscale xy
set xlabel 'amplitude ε of the ansatz'
set ylabel 'largest error until t = ε^{−2}' offset 1,0
set xrange [0.02:0.25]
set yrange [0.0006:0.4]
set xtics (0.025, 0.05, 0.1, 0.2)
set format y '10^{%L}'
set key top left
plot 0.00657*(x/0.025)**1.5 with lines lc rgb grey title 'slopes 3/2 and 2', \
     0.0012*(x/0.025)**2 with lines lc rgb grey notitle, \
     errors using "eps":"l2" with points ls 1 title 'norm l^2', \
     errors using "eps":"largest" with points ls 2 title 'any bead'
