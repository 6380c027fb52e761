# Figure 05: moduli of a site-centred breather on 99 sites, and the exponent of their decay.
width = 170; height = 65
load 'figures/style.gp'
table = data.'/sec32_newton_breathers/tail.ecsv'
set multiplot layout 1,2 margins char 9,1.5,3.4,0.8 spacing char 11,0
set xlabel 'site n'
set xrange [-24:24]
set logscale y
set yrange [1e-230:1e10]
set ytics ('10^{−200}' 1e-200, '10^{−100}' 1e-100, '1' 1)
set ylabel '|y_n(0)|' offset 1
set label 1 '(a)' at graph 0.03,0.93
plot table using "n":"size" with linespoints ls 1 notitle
unset logscale y
set xrange [0:24]
set yrange [0:10]
set ytics auto
set ytics 2
set ylabel 'ln(−ln |y_n(0)|)' offset 0.5
set label 1 '(b)'
set key bottom right
plot table using "n":(column("n") < 0 ? NaN : column("double_log")) with points pt 6 ps 0.6 \
       lc rgb vermilion title 'breather', \
     table using "n":(column("n") < 0 ? NaN : column("law")) with lines ls 4 title 'exponent 3/2'
unset multiplot
