# Speed and energy of the packet against the mass of every other bead, and the error of the speed against the time step.
# CMakeLists.txt sets data, the folder of the tables, and out, the file of the figure.
set datafile separator comma
set datafile columnheaders
set terminal svg size 680,240 font ',10' background rgb 'white'
set output out
set multiplot layout 1,2
set xlabel 'mass of every other bead, in masses of the others'
set ylabel 'speed (sites per unit of time), fraction'
set key center right
plot data.'/speeds.ecsv' using 'mu':'speed' with linespoints pt 7 title 'speed', \
     '' using 'mu':'fraction' with linespoints pt 6 dt 2 title 'energy in the packet'
set logscale xy
set xlabel 'time step'
set ylabel 'error of the speed from the step'
set format y '10^{%T}'
set key bottom right
plot [0.02:0.25] data.'/convergence.ecsv' using 'step':'error' with linespoints pt 7 notitle, \
     1e-3*x**5 with lines lc rgb 'gray' title '(time step)^5'
