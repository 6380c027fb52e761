# Figure x65: where a packet turns, and when, for impacts that round to 1.9.
width = 85; height = 60
load 'figures/style.gp'
table = data.'/sec34_boomeron/printed_range.ecsv'
set xrange [1.845:1.955]
set yrange [0:26]
set y2range [0:650]
set ytics nomirror
set y2tics 100
set xlabel 'impact velocity v_0'
set ylabel 'turning point (site)' offset 1
set y2label 'its time' offset -1
set key bottom left
plot table using "velocity":"apex_site" with linespoints ls 1 title 'site', \
     '' using "velocity":"apex_time" axes x1y2 with linespoints ls 2 dt solid lw 0.7 title 'time (right axis)'
