# Figure x14: breathers between a site and the next bond: parameter, energy and stability against
# their centre, at omega_b = 1.1 (left, family in s) and in the linear well (right, family in omega_b).
width = 170; height = 120
load 'figures/style.gp'
set multiplot layout 3,2 margins char 9,1.5,3.2,0.8 spacing char 11,1.0
set xrange [0:0.5]
set xtics 0.1
unset key
files = 'between_in_s between_in_omega'
letters = 'a b c d e f'
do for [row=1:3] {
  do for [k=1:2] {
    table = data.'/sec33_between/'.word(files, k).'.ecsv'
    set format x (row == 3 ? '%g' : '')
    set xlabel (row == 3 ? 'centre Q (sites)' : '')
    set label 1 '('.word(letters, 2*(row - 1) + k).') '.(k == 1 ? 'ω_b = 1.1' : 's = 0') \
        at graph (row == 3 || (row == 1 && k == 2) ? 0.36 : 0.03),(row == 3 && k == 1 ? 0.12 : 0.88)
    if (row == 1) {
      set ylabel (k == 1 ? '(s − s_0^s) · 10^7' : '(ω_b − ω_0^s) · 10^4') offset 1
      plot table using "centre":((k == 1 ? 1e7 : 1e4)*column("offset")) with linespoints ls 1 ps 0.5
    }
    if (row == 2) {
      set ylabel 'share of the energy' offset 1
      plot table using "centre":"share" with linespoints ls 3 ps 0.6
    }
    if (row == 3) {
      set ylabel (k == 1 ? 'κ · 10^{14}' : 'κ · 10^{11}') offset 1
      plot table using "centre":((k == 1 ? 1e14 : 1e11)*column("kappa")) with linespoints ls 2 ps 0.5
    }
  }
}
unset multiplot
