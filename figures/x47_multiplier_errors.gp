# Figure x47: errors of the multipliers next to +1, and of kappa, against the tolerance of the flow.
load 'figures/style.gp'
set logscale xy
set format xy '10^{%T}'
unset key
set xrange [3e-14:3e-4]
set yrange [1e-16:0.03]
set label 1 'λ, eigenvalues of M' at 1e-12,4e-4 tc rgb vermilion
set label 2 'κ from these four' at 5e-13,1e-9 tc rgb green
set label 3 'κ, eigenvalue of K' at 4e-9,1e-14 tc rgb blue
set xtics 1e-13,100
set xlabel 'tolerance of the flow'
set ylabel 'error' offset 1
table = data.'/sec33_floquet/tolerances.ecsv'
plot table using "tolerance":"multipliers" with linespoints ls 2, \
     table using "tolerance":"symmetric" with linespoints ls 3, \
     table using "tolerance":"kappa" with linespoints ls 1
