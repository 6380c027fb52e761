# Figure x57: what a soft well takes from the packet's energy, against the scaled anharmonicity of the impact.
load 'figures/style.gp'
table = data.'/sec34_impact/velocity_sweep.ecsv'
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xrange [1e-4:1]
set yrange [5e-5:1.5]
set xlabel 'χ = |s| v_0^{3/2}'
set ylabel 'lacking fraction of energy' offset 1
set key top left
plot 0.51*x with lines lc rgb grey lw 1 title 'proportional to χ', \
     table using "chi":(only(-1./6, column("deficit"))) with linespoints ls 2 dt solid lw 0.7 ps 0.25 title 's = −1/6', \
     '' using "chi":(only(-0.7, column("deficit"))) with linespoints ls 3 dt solid lw 0.7 ps 0.3 title 's = −0.7'
