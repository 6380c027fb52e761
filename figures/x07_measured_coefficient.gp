# Figure x07: measured points on the curves of the modulation coefficient, and growth rates.
width = 170; height = 75
load 'figures/style.gp'
folder = data.'/sec4_precompression_mi/'
curves = folder.'instability.ecsv'
points = folder.'measured_coefficient.ecsv'
growth = folder.'growth.ecsv'
runs = folder.'growth_runs.ecsv'
only(s, x) = abs(column("s") - s) < 1e-9 ? x : NaN
at(a, x) = abs(column("a") - a) < 1e-9 ? x : NaN
set multiplot layout 1,2 margins char 8,1.5,3.4,0.8 spacing char 10,0
set xlabel 'wavenumber q (1/site)'
set ylabel 'modulation coefficient Φ' offset 1,0
set xrange [0:pi]
set yrange [-1.2:1.1]
set xtics ('0' 0, 'π/4' pi/4, 'π/2' pi/2, '3π/4' 3*pi/4, 'π' pi)
set xzeroaxis lw 0.8 lc rgb grey
set key at graph 0.95,0.985 right samplen 1.2 maxrows 3 width -3
set label 1 '(a)' at graph 0.03,0.94
plot curves using "q":(only(-1./6, column("phi"))) with lines ls 2 title 's = −1/6', \
     curves using "q":(only(0, column("phi"))) with lines ls 1 title 's = 0', \
     curves using "q":(only(1, column("phi"))) with lines ls 3 title 's = 1', \
     points using "q":"shift_phi" with points pt 6 ps 0.5 lw 1 lc rgb black title 'frequency', \
     points using "q":"growth_phi" with points pt 7 ps 0.25 lc rgb black title 'growth'
set xlabel 'modulation Q (1/site)'
set ylabel 'growth rate over |A|^2' offset 1,0
set xrange [0:0.16]
set yrange [0:0.4]
set xtics 0.05
set label 1 '(b)'
set key at graph 0.99,0.985 right maxrows auto width 0
plot growth using "modulation":(at(0.15, column("nls"))) with lines ls 1 title 'NLS', \
     growth using "modulation":(at(0.05, column("nls"))) with lines ls 1 notitle, \
     growth using "modulation":(at(0.15, column("growth"))) with points pt 6 ps 0.4 lw 1 lc rgb vermilion \
       title 'chain, a = 0.15', \
     growth using "modulation":(at(0.05, column("growth"))) with points pt 4 ps 0.4 lw 1 lc rgb green \
       title 'chain, a = 0.05', \
     runs using "modulation":"growth" with points pt 2 ps 0.8 lw 1.5 lc rgb black title 'run, a = 0.15'
unset multiplot
