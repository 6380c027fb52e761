# Figure x55: when the energy of a modulated phonon localizes, over the prediction of the NLS equation.
width = 85; height = 62
load 'figures/style.gp'
rings = data.'/sec4_precompression_mi/breathers.ecsv'
only(s, a, x) = abs(column("s") - s) < 1e-9 && abs(column("amplitude") - a) < 1e-9 ? x : NaN
set lmargin 8; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set xlabel 'wavelengths on the ring'
set ylabel 'time over the prediction' offset 1,0
set xrange [20:64]
set yrange [0:1.7]
set key bottom left maxrows 4
plot 1 with lines lc rgb grey lw 0.8 notitle, \
     rings using "waves":(only(1, 0.15, column("over_nls"))):"over_nls_error" with yerrorbars ls 3 ps 0.5 title 's = 1', \
     rings using "waves":(only(0, 0.15, column("over_nls"))):"over_nls_error" with yerrorbars ls 1 ps 0.5 title 's = 0', \
     rings using "waves":(only(-1./6, 0.15, column("over_nls"))):"over_nls_error" with yerrorbars ls 2 ps 0.5 title 's = −1/6', \
     rings using "waves":(only(1, 0.075, column("over_nls"))) with points ls 3 pt 6 ps 0.7 title 'half the amplitude', \
     rings using "waves":(only(-1./6, 0.075, column("over_nls"))) with points ls 2 pt 6 ps 0.7 notitle
