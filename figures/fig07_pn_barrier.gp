# Figure 07: energy of the bond-centred breather, barrier at equal frequency and at equal area, and
# the relative barrier, for three wells. Circles: the barrier at equal frequency as predicted from that at
# equal area. Triangles mark the sign changes at equal frequency.
width = 170; height = 75
load 'figures/style.gp'
table = data.'/sec32_barrier/barriers.ecsv'
zeros = data.'/sec32_barrier/sign_changes.ecsv'
set multiplot layout 1,3 margins char 9,1.5,3.4,0.8 spacing char 3,0
set xrange [1:2]
set xtics 0.25
set logscale y
set yrange [1e-20:1e3]
set format y '10^{%T}'
set ytics 1e5
unset mytics
set xlabel 'frequency ω_b'
unset key
set ylabel 'energy, ratio' offset 1
do for [k=1:3] {
  s = k == 1 ? -1./6 : k == 2 ? 0 : 1
  set label 1 (k == 1 ? '(a) s = −1/6' : k == 2 ? '(b) s = 0' : '(c) s = 1') at graph 0.04,0.94
  if (k > 1) { set format y ''; unset ylabel }
  if (k > 2) { set key bottom right at graph 1.0,0.05 samplen 1.4 width -4 spacing 0.9 }
  plot table using "omega":(only(s, column("energy_bond"))) with lines lw 1.6 lc rgb vermilion \
         title 'E_{bc}', \
       table using "omega":(only(s, abs(column("equal_frequency")))) with lines ls 1 dt (8,4) \
         title '|E_{PN}|', \
       table using "omega":(only(s, abs(column("predicted")))) every 3 with points pt 6 ps 0.5 \
         lc rgb black title 'predicted', \
       table using "omega":(only(s, column("relative"))) \
         with lines ls 4 title '|E_{PN}|/E_{bc}', \
       table using "omega":(only(s, abs(column("equal_area")))) with lines ls 3 \
         title '|E_{PN}|, equal area', \
       zeros using "omega":(only(s, 4e-20)) with points pt 9 ps 0.5 \
         lc rgb blue title 'sign change'
}
unset multiplot
