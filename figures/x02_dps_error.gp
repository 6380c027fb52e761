# Figure x02: error of the DpS approximation against its size, and the local order.
width = 170; height = 75
load 'figures/style.gp'
errors = data.'/sec31_dps_limit/dps_error.ecsv'
orders = data.'/sec31_dps_limit/dps_order.ecsv'
only(start, tau, x) = column("start") == start && abs(column("tau") - tau) < 1e-9 ? x : NaN
set multiplot layout 1,2 margins char 10,1.5,3.4,0.8 spacing char 10,0
set logscale x
set format x '10^{%L}'
set xlabel 'size ε'
set xrange [5e-7:2e-2]
set logscale y
set format y '10^{%L}'
set ylabel 'largest deviation of y_n'
set yrange [1e-10:1e-1]
set key bottom right spacing 0.95
set label 1 '(a)' at graph 0.03,0.94
plot errors using "eps":(only(0, 10, column("error"))) with points ls 1 pt 7 ps 0.5 title 'impact, τ ≤ 10', \
     errors using "eps":(only(0, 4, column("error"))) with points ls 2 pt 5 ps 0.5 title 'impact, τ ≤ 4', \
     errors using "eps":(only(0, 1, column("error"))) with points ls 3 pt 9 ps 0.6 title 'impact, τ ≤ 1', \
     errors using "eps":(only(1, 10, column("error"))) with points ls 4 pt 6 ps 0.6 title 'pair, τ ≤ 10', \
     [1e-6:1e-2] 60*x**1.5 lc rgb grey lw 1 title 'slope 3/2'
unset logscale y
set format y '%.2f'
set ylabel 'local order'
set yrange [1.36:1.52]
set label 1 '(b)' at graph 0.93,0.94
set key bottom left spacing 1.1
set arrow 1 from graph 0, first 1.5 to graph 1, first 1.5 nohead lc rgb grey lw 1
plot orders using "eps":(only(0, 10, column("order"))) with linespoints ls 1 ps 0.5 title 'impact, τ ≤ 10', \
     orders using "eps":(only(0, 4, column("order"))) with linespoints ls 2 ps 0.5 title 'impact, τ ≤ 4', \
     orders using "eps":(only(0, 1, column("order"))) with linespoints ls 3 ps 0.6 title 'impact, τ ≤ 1', \
     orders using "eps":(only(1, 10, column("order"))) with linespoints ls 4 pt 6 ps 0.6 title 'pair, τ ≤ 10'
unset multiplot
