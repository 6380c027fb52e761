# Figure x05: error against step, and against evaluations for the tangent map.
width = 170; height = 72
load 'figures/style.gp'
set multiplot layout 1,2 margins 0.1,0.98,0.17,0.97 spacing 0.12,0
set logscale xy
set format y '10^{%T}'
orbit = data.'/secA_integrators/error_orbit.ecsv'
tangent = data.'/secA_integrators/error_tangent.ecsv'
set key off
set label 2 'velocity Verlet' at 0.0032,3e-3
set label 3 'splitting, order 4' at 0.0032,5e-6
set label 4 'order 6' at 0.06,1.5e-6
set label 5 'contact-aware' at 0.0032,4e-11
set label 6 '{/:Italic h}^{5/2}' at 0.0028,5e-10
set label 7 '{/:Italic h}^5' at 0.09,1e-9
set xrange [0.0025:0.25]
set xtics (0.003, 0.01, 0.03, 0.1, 0.2)
set label 1 panel('a') at graph 0.03,0.94
set xlabel 'time step  {/:Italic h}'; set ylabel 'error of displacements  {/:Italic y}_n(50)' offset 1,0
plot orbit using 'step':'verlet' with linespoints ls 4 title 'velocity Verlet', \
     '' using 'step':'blanes_moan_4' with linespoints ls 3 title 'splitting, order 4', \
     '' using 'step':'blanes_moan_6' with linespoints ls 1 title 'splitting, order 6', \
     '' using 'step':'contact_aware' with linespoints ls 2 title 'contact-aware', \
     [0.003:0.05] 2e-3*x**2.5 lc rgb grey dt (1,2) title '{/:Italic h}^{5/2}', \
     [0.01:0.2] 1e-2*x**5 lc rgb grey dt (4,2) title '{/:Italic h}^5'
do for [i=2:7] { unset label i }
set key bottom left samplen 1.6
set xrange [3:1e6]
set xtics autofreq
set format x '10^{%T}'
set label 1 panel('b') at graph 0.92,0.94
set xlabel 'force evaluations in one period'; set ylabel 'error of the tangent' offset 1,0
plot tangent using (strcol('method') eq 'verlet' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 4 title 'velocity Verlet', \
     '' using (strcol('method') eq 'blanes-moan-6' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 1 title 'splitting, order 6', \
     '' using (strcol('method') eq 'switch-landing' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 2 title 'switch-landing', \
     [100:1e5] x**-1.5 lc rgb grey dt (1,2) title '{/:Italic h}^{3/2}'
unset multiplot
