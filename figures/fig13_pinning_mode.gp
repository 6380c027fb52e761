# Figure 13: pinning mode and discrete gradient, both of length one, of both breathers.
width = 170; height = 62
load 'figures/style.gp'
set multiplot layout 1,2 margins char 8,1.5,3.4,0.8 spacing char 8,0
set xrange [-8:8]
set yrange [-1.1:0.75]
set xlabel 'site n'
set ylabel 'displacement (unit norm)' offset 1
set key bottom center horizontal
do for [name in "bond site"] {
  table = data.'/sec33_floquet/mode_'.name.'.ecsv'
  set label 1 (name eq 'bond' ? '(a) bond-centred' : '(b) site-centred') at graph 0.03,0.93
  plot table using "n":"mode" with linespoints ls 1 ps 0.5 title 'pinning mode', \
       table using "n":"gradient" with linespoints ls 2 ps 0.75 pt 4 title 'discrete gradient'
}
unset multiplot
