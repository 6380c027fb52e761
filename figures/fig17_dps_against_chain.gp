# Figure 17: displacements of the struck chain and of its DpS approximation at slow time 250.
width = 85; height = 85
load 'figures/style.gp'
table = data.'/sec34_dps_impact/impact_profiles.ecsv'
set multiplot layout 2,1 margins char 8,1.5,3.4,0.6 spacing char 0,1
set xrange [0:105]
set yrange [-1.1:1.1]
set ytics 0.5
set ylabel '10^3 y_n'
set format x ''
set label 1 '(a) chain' at graph 0.03,0.92
plot table using "n":(1e3*column("y_lattice")) with linespoints ls 1 notitle
set format x '%g'
set xlabel 'site n'
set label 1 '(b) DpS approximation'
plot table using "n":(1e3*column("y_dps")) with linespoints ls 2 dt solid notitle
unset multiplot
