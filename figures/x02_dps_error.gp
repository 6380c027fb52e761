# Figure x02: relative error of the DpS approximation over the square root of the amplitude.
width = 85; height = 70
load 'figures/style.gp'
errors = data.'/sec31_dps_limit/dps_error.ecsv'
only(start, tau, x) = strcol("start") eq word(names, start+1) && abs(column("tau") - tau) < 1e-9 ? x : NaN
names = 'impact pair displaced'
set xlabel 'square root of the amplitude, ε^{1/2}'
set xrange [0:0.085]
set xtics 0.02
set ylabel 'relative error / ε^{1/2}'
set yrange [0:16]
set key top right maxrows 3
plot for [s = 0:2] errors using (sqrt(column("eps"))):(only(s, 10, column("coefficient"))) with linespoints ls s+1 pt 7 ps 0.5 notitle, \
     for [s = 0:2] errors using (sqrt(column("eps"))):(only(s, 4, column("coefficient"))) with linespoints ls s+1 pt 6 ps 0.5 notitle, \
     for [s = 0:2] errors using (sqrt(column("eps"))):(only(s, 1, column("coefficient"))) with linespoints ls s+1 pt 2 ps 0.5 notitle, \
     for [s = 0:2] keyentry with lines ls s+1 title word(names, s+1), \
     keyentry with points pt 7 ps 0.5 lc rgb black title 'τ ≤ 10', \
     keyentry with points pt 6 ps 0.5 lc rgb black title 'τ ≤ 4', \
     keyentry with points pt 2 ps 0.5 lc rgb black title 'τ ≤ 1'
