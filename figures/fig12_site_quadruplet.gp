# Figure 12: the four Floquet multipliers next to +1 of the site-centred breather against s.
table = data.'/sec33_floquet/site_against_s.ecsv'
side = 'left'
load 'figures/quadruplet.gp'
