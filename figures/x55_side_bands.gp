# Figure x55: side bands of a modulated phonon with the NLS equation's, and how late its energy localizes.
width = 170; height = 62
load 'figures/style.gp'
bands = data.'/sec4_precompression_mi/sidebands.ecsv'
weaker = data.'/sec4_precompression_mi/weaker.ecsv'
only(s, x) = abs(column("s") - s) < 1e-9 ? x : NaN
set multiplot layout 1,2 margins char 9,1.5,3.4,0.8 spacing char 10,0
set logscale y
set xlabel 'time × NLS growth rate, σt'
set ylabel 'side band / carrier'
set xrange [0:5.6]
set yrange [0.0006:2]
set format y '10^{%L}'
set key bottom right maxrows 2 samplen 1.6 width -2
set label 1 '(a)' at graph 0.03,0.94
plot bands using "foldings":(only(-1./6, column("by_nls"))) with lines lc rgb grey lw 1 title 'NLS', \
     bands using "foldings":(only(0, column("by_nls"))) with lines lc rgb grey lw 1 notitle, \
     bands using "foldings":(only(1, column("by_nls"))) with lines lc rgb grey lw 1 notitle, \
     bands using "foldings":(only(-1./6, column("sideband"))) with lines ls 2 title 's = −1/6', \
     bands using "foldings":(only(0, column("sideband"))) with lines ls 1 title 's = 0', \
     bands using "foldings":(only(1, column("sideband"))) with lines ls 3 title 's = 1'
set label 1 '(b)'
unset logscale
set format y '%g'
set key top left at graph 0.03,0.86 maxrows 4 width 0
set xzeroaxis lw 0.8 lc rgb grey
set xlabel 'amplitude a of the wave'
set ylabel 'delay of localization (%)'
set xrange [0.06:0.165]
set yrange [-4:20]
plot (x/0.15)**2*14.7 with lines lc rgb grey lw 1 title '∝ a^2', \
     weaker using "amplitude":(only(-1./6, 100*column("late"))):(100*column("late_error")) with yerrorlines ls 2 ps 0.5 title 's = −1/6', \
     weaker using "amplitude":(only(1, 100*column("late"))):(100*column("late_error")) with yerrorlines ls 3 ps 0.6 title 's = 1'
unset multiplot
