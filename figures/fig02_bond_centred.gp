# Figure 02: bond-centred breathers (marks) and their quasi-continuum approximation (lines).
table = data.'/sec32_newton_breathers/bond_profiles.ecsv'
left = -7.5; right = 8.5
low = '-5.5 -11 -11'; high = '5.5 11 11'
load 'figures/profiles.gp'
