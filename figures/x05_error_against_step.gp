# Figure x05: error against step, and against evaluations for the tangent map.
width = 170; height = 72
load 'figures/style.gp'
set multiplot layout 1,2 margins 0.1,0.98,0.17,0.97 spacing 0.12,0
set logscale xy
set format y '10^{%T}'
orbit = data.'/secA_integrators/error_orbit.ecsv'
tangent = data.'/secA_integrators/error_tangent.ecsv'
set key bottom left samplen 1 maxrows 3 width -5
set xrange [0.0025:0.25]
set yrange [1e-19:10]
set ytics 1e3
unset mytics
set xtics (0.003, 0.01, 0.03, 0.1, 0.2)
set label 1 '(a)' at graph 0.03,0.94
set xlabel 'time step  {/:Italic h}'; set ylabel 'error of displacements  {/:Italic y_n}(50)' offset 1,0
of(name) = strcol('method') eq name ? column('error') : NaN
plot orbit using 'step':(of('verlet')) with linespoints ls 4 title 'velocity Verlet', \
     '' using 'step':(of('blanes_moan_4')) with linespoints ls 3 title 'order 4', \
     '' using 'step':(of('blanes_moan_6')) with linespoints ls 1 title 'order 6', \
     '' using 'step':(of('two_steps')) with linespoints ls 2 title 'events, 2 steps', \
     '' using 'step':(of('six_steps')) with linespoints ls 2 dt 1 pt 6 ps 0.6 title 'events, 6 steps', \
     [0.003:0.05] 2e-3*x**2.5 lc rgb grey dt (1,2) notitle, \
     [0.01:0.2] 1e-2*x**5 lc rgb grey dt (4,2) notitle
set key bottom left samplen 1.6 maxrows auto width 0
set yrange [1e-16:1]
set xrange [3:1e6]
set xtics autofreq
set format x '10^{%T}'
set label 1 '(b)' at graph 0.92,0.94
set xlabel 'force evaluations  {/:Italic N}  in one period'; set ylabel 'error of the tangent' offset 1,0
plot tangent using (strcol('method') eq 'verlet' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 4 title 'velocity Verlet', \
     '' using (strcol('method') eq 'blanes_moan_6' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 1 title 'splitting, order 6', \
     '' using (strcol('method') eq 'flow' ? column('evaluations') : NaN):'tangent' \
       with linespoints ls 2 title 'flow', \
     [100:1e5] x**-1.5 lc rgb grey dt (1,2) title '{/:Italic N}^{ −3/2}'
unset multiplot
