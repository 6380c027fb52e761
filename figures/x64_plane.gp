# Figure x64: distance of the fourth multiplier from +1 over the plane, bond-centred breathers.
width = 85; height = 62
load 'figures/style.gp'
set logscale cb
set cbrange [1e-5:1]
set format cb '10^{%T}'
set palette defined (0 '#FFFFCC', 0.35 '#A1DAB4', 0.6 '#41B6C4', 0.8 '#2C7FB8', 1 '#081D58')
set xrange [0.97:2.05]; set yrange [-1.12:1.12]
set xlabel 'frequency ω_b'
set ylabel 'anharmonicity s' offset 1
set cblabel 'distance of the fourth from +1' offset 0.5
unset key
table = data.'/sec33_floquet/spectra.ecsv'
# The wells of the grid; at 1.1 there are more
on_grid(s) = abs(4*s - floor(4*s + 0.5)) < 1e-9 || abs(s + 1/6.0) < 1e-9
at(is) = strcol('centre') eq 'bond' && on_grid(column('s')) && is ? column('omega') : NaN
leave(x) = column(x) > 1e-5
plot table using (at(1)):"s":"fourth" with points pt 5 ps 0.62 lc palette, \
     table using (at(leave('largest') && !leave('others'))):"s" with points pt 7 ps 0.3 lc rgb vermilion, \
     table using (at(leave('others'))):"s" with points pt 8 ps 0.9 lc rgb vermilion
