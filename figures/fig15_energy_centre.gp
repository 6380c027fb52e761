# Figure 15: energy centre of all three breathers after a weak kick.
width = 85; height = 65
load 'figures/style.gp'
table = data.'/sec33_mobility/paths.ecsv'
set xlabel 'time t · 10^{−5}'
set ylabel 'energy centre X (sites)'
set xrange [0:2.85]
set yrange [-3.3:0.7]
set key bottom left
set ytics 1
plot table using (1e-5*column("t")):"X_bond_stretched" with lines ls 1 title 'bond, stretched', \
     table using (1e-5*column("t")):"X_bond_compressed" with lines ls 3 lw 3.5 title 'bond, compressed', \
     table using (1e-5*column("t")):"X_site" with lines ls 2 title 'site'
