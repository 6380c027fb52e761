# Figure x51: how far packets spread whose impacts differ in late digits, and what two steps make of one packet.
width = 85; height = 60
load 'figures/style.gp'
folder = data.'/sec34_boomeron'
within(noise) = abs(column("noise") / noise - 1) < 1e-9 ? column("deviation") : NaN
set logscale y
set format y '10^{%T}'
set xrange [0:2600]
set yrange [1e-10:1e2]
set ytics 100
set xtics 500
set xlabel 'time t'
set ylabel 'standard deviation of X (sites)' offset 1
set key at 2550,3e-5 samplen 1.6 spacing 0.95
plot folder.'/ensemble.ecsv' using "t":(within(1e-4)) with lines ls 1 title 'interval 10^{−4}', \
     '' using "t":(within(1e-6)) with lines ls 2 title '10^{−6}', \
     '' using "t":(within(1e-8)) with lines ls 3 title '10^{−8}', \
     folder.'/steps.ecsv' using "t":"apart" with lines lc rgb grey lw 1 title 'two steps', \
     0.5 with lines lc rgb black lw 0.6 dt (2,3) notitle
