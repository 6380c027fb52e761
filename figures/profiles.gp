# Shared by figures 2 and 3: a breather in the limit of small amplitude, and of two frequencies. The caller sets `table`
# and the ranges: `left` and `right`, and `low` and `high` of the three panels.
width = 170; height = 66
load 'figures/style.gp'
set multiplot layout 1,3 margins char 8,1.5,3.4,3.4 spacing char 9,0
set xrange [left:right]
set xtics 5
set xlabel 'site n'
set key vertical center top at screen 0.5,0.99
do for [k=1:3] {
  name = word('u y_101 y_110', k)
  power = word('2 5 3', k)
  set yrange [word(low, k) + 0:word(high, k) + 0]
  set ylabel '10^'.power.(k == 1 ? ' u_n' : ' y_n(0)') offset 1
  set label 1 (k == 1 ? '(a) DpS, μ = 1' : k == 2 ? '(b) ω_b = 1.01' : '(c) ω_b = 1.1') at graph 0,1.07
  plot table using "n":(10**power*column(name.'_continuum')) with lines ls 1 title 'quasi-continuum', \
       table using "n":(10**power*column(name)) with points pt 6 ps 0.6 lc rgb vermilion title 'breather (Newton)'
  unset key
}
unset multiplot
