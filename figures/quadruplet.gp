# Shared by figures 11 and 12: arguments and moduli of the four multipliers next to +1 against s. The
# caller sets `table` and `side`, the half of the upper panel that is empty.
width = 85; height = 95
load 'figures/style.gp'
set multiplot layout 2,1 margins char 9,1.5,3.2,0.8 spacing char 0,1.2
set xrange [-1:1]
set xtics 0.5
set yrange [-8:8]
set format x ''
set ylabel 'argument (rad) · 10^4' offset 1
set key at graph (side eq 'right' ? 0.99 : 0.60),0.97 right samplen 1.8
set label 1 '(a)' at graph 0.03,0.93
plot table using "s":(1e4*column("argument")) with lines ls 1 title 'pinning pair', \
     table using "s":(-1e4*column("argument")) with lines ls 1 notitle, \
     table using "s":(0*column("s")) with lines ls 2 title 'time translation'
set format x '%g'
set xlabel 'anharmonicity s'
set ylabel 'ln |λ| · 10^4' offset 1
set label 1 '(b)' at graph 0.03,0.93
unset key
plot table using "s":(1e4*column("growth")) with lines ls 1 title 'pinning pair', \
     table using "s":(-1e4*column("growth")) with lines ls 1 notitle, \
     table using "s":(0*column("s")) with lines ls 2 title 'time translation'
unset multiplot
