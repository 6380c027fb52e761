# The speed of the packet against the mass of every other bead.
set datafile separator comma
set datafile columnheaders
set terminal svg size 320,230 font ',10' background rgb 'white'
set output out
set xlabel 'mass of every other bead, in masses of the others'
set ylabel 'speed (sites per unit of time)'
plot data.'/own_chain/speeds.ecsv' using 'mu':'speed':'speed_error' with yerrorlines pt 7 lw 1.5 notitle
