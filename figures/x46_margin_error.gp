# Figure x46: error of the margins of both DpS breathers against the length of the chain.
load 'figures/style.gp'
set logscale y
set yrange [1e-25:1e2]
set format y '10^{%T}'
set key top right samplen 1.6
set xlabel 'sites of the chain'
set ylabel 'error of the margin' offset 1
table = data.'/sec33_dps_stability/convergence.ecsv'
site(name) = strcol('centre') eq 'site' ? column(name) : NaN
bond(name) = strcol('centre') eq 'bond' ? column(name) : NaN
plot table using "sites":(site("in_double")) with linespoints ls 1 title 'site, double', \
     table using "sites":(bond("in_double")) with linespoints ls 2 title 'bond, double', \
     table using "sites":(site("in_quadruple")) with linespoints ls 1 dt 3 pt 6 ps 0.6 title 'site, quadruple', \
     table using "sites":(bond("in_quadruple")) with linespoints ls 2 dt 3 pt 4 ps 0.6 title 'bond, quadruple', \
     4.85e-6 lc rgb grey dt (2,3) notitle
