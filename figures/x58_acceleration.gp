# Figure x58: acceleration of the packet against its place, on the way out (filled) and back (open).
load 'figures/style.gp'
table = data.'/sec34_boomeron/acceleration.ecsv'
on(v, way) = column("s") == 1 && column("way") == way && abs(column("velocity") - v) < 1e-9 ? 1e4 * column("acceleration") : NaN
set xrange [8:40]
set xlabel 'centre X (site)'
set ylabel 'acceleration (10^{−4} sites / time^2)' offset 1
set key bottom right
plot 0 with lines lc rgb black lw 0.6 notitle, \
     table using "centre":(on(1.5, 1)) with linespoints ls 1 title 'v_0 = 1.5, out', \
     '' using "centre":(on(1.9, 1)) with linespoints ls 2 dt solid title '1.9, out', \
     '' using "centre":(on(1.9, 2)) with linespoints ls 2 dt (3,2) lw 0.8 pt 4 title '1.9, back', \
     '' using "centre":(on(2, 1)) with linespoints ls 3 dt solid title '2, out', \
     '' using "centre":(on(2, 2)) with linespoints ls 3 dt (3,2) lw 0.8 pt 8 title '2, back'
