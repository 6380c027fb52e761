"""Figure 8: the bond-centred DpS breather and its spectrum for two frequencies."""

import spectra

spectra.main("bond", growth=False)
