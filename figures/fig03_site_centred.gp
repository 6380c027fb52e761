# Figure 03: site-centred breathers (marks) and their quasi-continuum approximation (lines).
width = 170; height = 66
load 'figures/style.gp'
table = data.'/sec32_newton_breathers/site_profiles.ecsv'
set multiplot layout 1,3 margins char 8,1.5,3.4,3.4 spacing char 9,0
set xrange [-7.7:7.7]
set xtics 5
set xlabel 'site n'
set ylabel '10^2 u_n' offset 1
set yrange [-5:6]
set key vertical center top at screen 0.5,0.99
set label 1 '(a) DpS, μ = 1' at graph 0,1.07
plot table using "n":(1e2*column("u_continuum")) with lines ls 1 title 'quasi-continuum', \
     table using "n":(1e2*column("u")) with points pt 6 ps 0.6 lc rgb vermilion \
         title 'breather (Newton)'
unset key
set ylabel '10^5 y_n(0)' offset 1
set yrange [-9:11]
set label 1 '(b) ω_b = 1.01'
plot table using "n":(1e5*column("y_101_continuum")) with lines ls 1 notitle, \
     table using "n":(1e5*column("y_101")) with points pt 6 ps 0.6 lc rgb vermilion notitle
set ylabel '10^3 y_n(0)' offset 1
set yrange [-10.5:12]
set label 1 '(c) ω_b = 1.1'
plot table using "n":(1e3*column("y_110_continuum")) with lines ls 1 notitle, \
     table using "n":(1e3*column("y_110")) with points pt 6 ps 0.6 lc rgb vermilion notitle
unset multiplot
