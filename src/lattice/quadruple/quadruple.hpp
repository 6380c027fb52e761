#pragma once
/**
# More digits

Rounding errors of `double` would hide some numbers of the article, such as the smallest energy barriers.
A few of them are therefore confirmed with a mantissa of 113 bits, 34 digits. Compilers that know
`__float128` compute with it three times as fast as with Boost's own type of the same width. */

#ifdef LATTICE_FLOAT128
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#include <boost/multiprecision/eigen.hpp>

#include "lattice/algebra/dense.hpp"

namespace lattice {

/// A mantissa of 113 bits, by the compiler's own type where it has one.
#ifdef LATTICE_FLOAT128
using Quadruple = boost::multiprecision::float128;
#else
using Quadruple = boost::multiprecision::cpp_bin_float_quad;
#endif

}  // namespace lattice
