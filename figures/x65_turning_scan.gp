# Figure x65: where a packet turns, and when, for impacts that round to 1.9.
load 'figures/style.gp'
table = data.'/sec34_boomeron/turns.ecsv'
set xrange [1.845:1.955]
set yrange [0:26]
set y2range [0:650]
set ytics nomirror
set y2tics 100
set xlabel 'impact velocity v_0'
set ylabel 'turning point (site)' offset 1
set y2label 'its time' offset -1
set key bottom left
of(name) = column("s") == 1 && abs(column("velocity") - 1.9) < 0.051 ? column(name) : NaN
plot table using "velocity":(of("apex_site")) smooth unique with linespoints ls 1 title 'site', \
     '' using "velocity":(of("apex_time")) smooth unique axes x1y2 with linespoints ls 2 dt solid lw 0.7 title 'time (right axis)'
