# Figure x53: by how much the DpS packet is too high and too fast, against the impact; filled: arrays that one can build.
load 'figures/style.gp'
set logscale xy
set format x '10^{%T}'
set xrange [6e-4:20]
set yrange [0.01:1.5]
set key bottom right samplen 1.6
set xlabel 'impact λ^{5/2}'
set ylabel 'excess of the DpS equation'
regime = data.'/sec35_scales/dps_regime.ecsv'
arrays = data.'/sec35_scales/arrays.ecsv'
plot 0.8*sqrt(x) lc rgb grey dt (2,2) title 'slope 1/2', \
     regime using 'impact':'deflection' with linespoints ls 1 pt 6 ps 0.5 title 'deflection', \
     '' using 'impact':'speed' with linespoints ls 2 pt 4 ps 0.5 title 'speed', \
     arrays using 'impact':'deflection' with points lc rgb blue pt 7 ps 0.7 title 'arrays', \
     '' using 'impact':'speed' with points lc rgb vermilion pt 5 ps 0.7 notitle
