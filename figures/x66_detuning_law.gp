# Figure x66: what a defect transmits, against its detuning over the frequency shift of the packet, for three impacts.
load 'figures/style.gp'
set xrange [0:1.7]
set yrange [0:1]
set key top right samplen 0.5
set xlabel '|detuning of the defect| / frequency shift'
set ylabel 'transmitted fraction'
table = data.'/sec36_cantilever_defect/impacts.ecsv'
heavy(v) = column('velocity') == v && column('ratio') > 1 ? column('transmitted') : NaN
light(v) = column('velocity') == v && column('ratio') < 1 ? column('transmitted') : NaN
plot table using (abs(column('scaled'))):(heavy(0.5)) with points lc rgb blue pt 7 ps 0.6 title '0.5 m/s, heavy', \
     '' using (abs(column('scaled'))):(light(0.5)) with points lc rgb blue pt 6 ps 0.6 title 'light', \
     '' using (abs(column('scaled'))):(heavy(1)) with points lc rgb vermilion pt 5 ps 0.6 title '1 m/s, heavy', \
     '' using (abs(column('scaled'))):(light(1)) with points lc rgb vermilion pt 4 ps 0.6 title 'light', \
     '' using (abs(column('scaled'))):(heavy(2)) with points lc rgb black pt 9 ps 0.6 title '2 m/s, heavy', \
     '' using (abs(column('scaled'))):(light(2)) with points lc rgb black pt 8 ps 0.6 title 'light'
