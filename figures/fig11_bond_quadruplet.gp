# Figure 11: the four Floquet multipliers next to +1 of the bond-centred breather against s.
table = data.'/sec33_floquet/bond_against_s.ecsv'
side = 'right'
load 'figures/quadruplet.gp'
