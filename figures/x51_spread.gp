# Figure x51: how far packets spread whose impacts differ in late digits.
load 'figures/style.gp'
folder = data.'/sec34_boomeron'
within(noise) = abs(column("noise") / noise - 1) < 1e-9 ? column("deviation") : NaN
set logscale y
set format y '10^{%T}'
set xrange [0:2500]
set yrange [1e-7:1e2]
set ytics 100
set xtics 500
set xlabel 'time t'
set ylabel 'standard deviation of X (sites)' offset 1
set key at 2450,1e-4 samplen 1.6 spacing 0.95
plot folder.'/ensemble.ecsv' using "t":(within(1e-4)) with lines ls 1 title 'interval 10^{−4}', \
     '' using "t":(within(1e-6)) with lines ls 2 title '10^{−6}', \
     3e-7*exp(0.007*x) with lines lc rgb grey lw 1 title 'exp(0.007 t)', \
     0.5 with lines lc rgb black lw 0.6 dt (2,3) notitle
