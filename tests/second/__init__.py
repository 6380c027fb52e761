"""A second, slow and simple computation of the headline numbers about breathers in Hertzian oscillator chains, from
the article and numpy alone: no module, table or constant of the C++ programs is used."""
