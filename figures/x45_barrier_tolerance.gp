# Figure x45: relative error of the barrier at 1.1 against the tolerance of the flow, in two precisions.
width = 85; height = 60
load 'figures/style.gp'
table = data.'/sec32_barrier/tolerances.ecsv'
only(bits, x) = column("bits") == bits ? x : NaN
set logscale xy
set format xy '10^{%T}'
set xrange [3e-17:3e-9]
set yrange [1e-10:30]
set ytics 1e2
set xtics 1e2
set xlabel 'tolerance of the flow'
set ylabel 'relative error' offset 1
set key top left samplen 1.8 spacing 1.0
plot table using "tolerance":(only(53, column("equal_frequency"))) with linespoints ls 2 title 'E_{PN}, 53 bits', \
     table using "tolerance":(only(64, column("equal_frequency"))) with linespoints ls 1 title 'E_{PN}, 64 bits', \
     table using "tolerance":(only(53, column("equal_area"))) with linespoints ls 4 title 'equal area, 53 bits', \
     table using "tolerance":(only(64, column("equal_area"))) with linespoints ls 3 title 'equal area, 64 bits'
