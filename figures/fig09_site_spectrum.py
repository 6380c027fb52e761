"""Figure 9: the site-centred DpS breather, its spectrum, and its growth rate against frequency."""

import spectra

spectra.main("site", growth=True)
