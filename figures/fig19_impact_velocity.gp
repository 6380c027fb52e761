# Figure 19: peak energy density and speed of the packet against impact velocity, for three wells.
# Marks show every computed velocity in the last 0.05 of the soft curves, before the blow-up.
width = 170; height = 70
load 'figures/style.gp'
table = data.'/sec34_impact/velocity_sweep.ecsv'
ending(s, x) = column("ending") == 1 ? only(s, x) : NaN
before(s, x) = column("ending") == 0 ? only(s, x) : NaN
set multiplot layout 1,2 margins char 8,1.5,3.4,0.8 spacing char 10,0
set xlabel 'impact velocity v_0'
set xrange [0:2.3]
set key top left at graph 0.1,0.97
do for [name in "peak speed"] {
  set ylabel (name eq 'peak' ? 'peak energy density' : 'speed (sites per unit of time)') offset (name eq 'peak' ? 0 : 0.5)
  set label 1 (name eq 'peak' ? '(a)' : '(b)') at graph 0.03,0.94
  plot table using "velocity":(only(0, column(name))) with lines ls 1 title 's = 0', \
       table using "velocity":(before(-1./6, column(name))) with lines ls 2 title 's = −1/6', \
       table using "velocity":(before(-0.7, column(name))) with lines ls 3 title 's = −0.7', \
       table using "velocity":(ending(-1./6, column(name))) with linespoints ls 2 lw 0.7 dt solid ps 0.25 notitle, \
       table using "velocity":(ending(-0.7, column(name))) with linespoints ls 3 lw 0.7 dt solid ps 0.3 notitle
}
unset multiplot
