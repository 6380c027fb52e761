# Figure 03: site-centred breathers (marks) and their quasi-continuum approximation (lines).
table = data.'/sec32_newton_breathers/site_profiles.ecsv'
left = -7.7; right = 7.7
low = '-5 -9 -10.5'; high = '6 11 12'
load 'figures/profiles.gp'
