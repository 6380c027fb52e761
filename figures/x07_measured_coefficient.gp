# Figure x07: measured points on the curves of the modulation coefficient.
width = 85; height = 75
load 'figures/style.gp'
folder = data.'/sec4_precompression_mi/'
curves = folder.'instability.ecsv'
points = folder.'measured_coefficient.ecsv'
only(s, x) = abs(column("s") - s) < 1e-9 ? x : NaN
set xlabel 'wavenumber q (1/site)'
set ylabel 'modulation coefficient Φ' offset 1,0
set xrange [0:pi]
set yrange [-1.2:1.1]
set xtics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)
set xzeroaxis lw 0.8 lc rgb grey
set key at graph 0.95,0.985 right samplen 1.2 maxrows 3 width -3
plot curves using "q":(only(-1./6, column("phi"))) with lines ls 2 title 's = −1/6', \
     curves using "q":(only(0, column("phi"))) with lines ls 1 title 's = 0', \
     curves using "q":(only(1, column("phi"))) with lines ls 3 title 's = 1', \
     points using "q":"shift_phi" with points pt 6 ps 0.5 lw 1 lc rgb black title 'frequency', \
     points using "q":"growth_phi" with points pt 7 ps 0.25 lc rgb black title 'growth'
