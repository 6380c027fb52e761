# Figure 06: amplitude and energy of both families against frequency, in a linear well.
width = 170; height = 65
load 'figures/style.gp'
table = data.'/sec32_newton_breathers/branches.ecsv'
set multiplot layout 1,2 margins char 8,1.5,3.4,0.8 spacing char 10,0
set xrange [1:2]
set xlabel 'frequency ω_b'
set key top left at graph 0.1,0.97
set ylabel 'largest |y_n(0)|' offset 1
set label 1 '(a)' at graph 0.03,0.93
plot table using "omega":"amplitude_bond" with lines ls 1 title 'bond-centred', \
     table using "omega":"amplitude_site" with lines ls 2 title 'site-centred'
set ylabel 'energy' offset 1
set label 1 '(b)'
plot table using "omega":"energy_bond" with lines ls 1 title 'bond-centred', \
     table using "omega":"energy_site" with lines ls 2 title 'site-centred'
unset multiplot
