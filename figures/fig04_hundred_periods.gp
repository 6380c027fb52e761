# Figure 04: the site-centred breather at t = 0 (line) and after a hundred periods (marks).
load 'figures/style.gp'
table = data.'/sec32_newton_breathers/persistence.ecsv'
set lmargin 8; set rmargin 1.5; set bmargin 3.4; set tmargin 0.8
set xrange [-15.5:15.5]
set yrange [-10:12]
set xlabel 'site n'
set ylabel '10^3 y_n'
set key top right
plot table using "n":(1e3*column("y_start")) with lines ls 1 title 't = 0', \
     table using "n":(1e3*column("y_end")) with points pt 6 ps 0.6 lc rgb vermilion title 't = 100 T_b'
