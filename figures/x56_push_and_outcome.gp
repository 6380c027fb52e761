# Figure x56: largest displacement of bond-centred DpS breathers under noise against its push.
load 'figures/style.gp'
set key top left samplen 0.6
set logscale xy
set xlabel 'push of the noise / threshold'
set ylabel 'largest displacement (sites)' offset 1
table = data.'/sec33_dps_stability/pushes.ecsv'
under(name) = strcol('noise') eq name ? column('farthest') : NaN
set arrow 1 from 1, graph 0 to 1, graph 1 nohead lc rgb grey dt (2,3)
plot [0.015:10] [0.004:20] table using "over_threshold":(under('main')) with points ls 1 pt 6 ps 0.6 title 'main noise', \
     table using "over_threshold":(under('narrow')) with points ls 2 pt 5 ps 0.5 title 'narrow noise', \
     table using "over_threshold":(under('relative')) with points ls 3 pt 8 ps 0.7 title 'relative noise', \
     [0.015:1] asin(x)/pi lc rgb black lw 1 notitle
