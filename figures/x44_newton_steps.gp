# Figure x44: residual of Newton's method against its steps, for three sets of equations.
load 'figures/style.gp'
table = data.'/sec32_newton_breathers/iterations.ecsv'
set logscale y
set yrange [3e-15:1e9]
set ytics ('10^{−12}' 1e-12, '10^{−8}' 1e-8, '10^{−4}' 1e-4, '1' 1)
set xrange [-0.3:10.3]
set xlabel 'steps of Newton’s method'
set ylabel 'residual / amplitude' offset 1
set key top right samplen 1.8 spacing 1.0
plot table using "steps":"quarter_period" with linespoints ls 1 title 'quarter of the period', \
     table using "steps":"whole_period" with linespoints ls 2 title 'whole period', \
     table using "steps":"without_pinning_mode" with linespoints ls 3 title 'without pinning mode', \
     table using "steps":"singular" with lines lc rgb black dt 3 lw 1.2 title 'least singular value', \
     1.5e-9 with lines lc rgb grey lw 1 title 'article, five steps'
