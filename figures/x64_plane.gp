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
bond(name) = strcol('centre') eq 'bond' ? column(name) : NaN
plot table using (bond("omega")):"s":"fourth" with points pt 5 ps 0.95 lc palette, \
     table using (column("largest") > 1e-3 && column("others") < 1e-3 ? bond("omega") : NaN):"s" \
       with points pt 7 ps 0.35 lc rgb vermilion, \
     table using (column("others") > 1e-3 ? bond("omega") : NaN):"s" with points pt 8 ps 1.1 lc rgb vermilion
