# Speed and energy of the packet against the mass of every other bead.
set datafile separator comma
set datafile columnheaders
set terminal svg size 340,240 font ',10' background rgb 'white'
set output out
set xlabel 'mass of every other bead, in masses of the others'
set ylabel 'speed (sites per unit of time), fraction'
set xtics 0.05
set key top left
plot data.'/own_chain/speeds.ecsv' using 'mu':'speed' with linespoints pt 7 title 'speed', \
     '' using 'mu':'fraction' with linespoints pt 6 dt 2 title 'energy in the packet'
