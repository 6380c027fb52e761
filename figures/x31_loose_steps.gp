# Figure x31: the amplitude of the DpS packet against the growth of the norm that should be conserved.
width = 85; height = 68
load 'figures/style.gp'
table = data.'/sec34_dps_impact/loose_steps.ecsv'
set logscale x
set format x '10^{%T}'
set xrange [1e-5:2]
set yrange [9:14.2]
set xlabel 'growth of the norm until  {/:Italic τ} = 250'
set ylabel 'amplitude of the packet (10^{-4})' offset 1,0
set key at graph 0.03,0.62 left top samplen 1.2 maxrows auto
of(method, norm, column) = strcol('method') eq method && strcol('norm') eq norm ? column : NaN
dp = 'dormand-prince-5'; rkf = 'fehlberg-5'
set arrow 1 from graph 0, first 12.5 to graph 1, first 12.5 nohead lc rgb grey dt (4,3)
set arrow 2 from graph 0, first 13.5 to graph 1, first 13.5 nohead lc rgb grey dt (4,3)
plot table using (of(dp, 'rms', column('growth'))):(1e4*column('amplitude')) \
       with points pt 7 ps 0.5 lc rgb blue title 'mean square', \
     '' using (of(dp, 'two', column('growth'))):(1e4*column('amplitude')) \
       with points pt 5 ps 0.45 lc rgb vermilion title 'sum of squares', \
     '' using (of(dp, 'largest', column('growth'))):(1e4*column('amplitude')) \
       with points pt 9 ps 0.55 lc rgb green title 'largest component', \
     '' using (of(rkf, 'rms', column('growth'))):(1e4*column('amplitude')) \
       with points pt 6 ps 0.5 lc rgb blue title 'the same, Fehlberg', \
     '' using (of(rkf, 'two', column('growth'))):(1e4*column('amplitude')) \
       with points pt 4 ps 0.45 lc rgb vermilion notitle, \
     '' using (of(rkf, 'largest', column('growth'))):(1e4*column('amplitude')) \
       with points pt 8 ps 0.55 lc rgb green notitle
