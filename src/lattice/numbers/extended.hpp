#pragma once
/**
# Quadruple precision

A few numbers are confirmed with a 113-bit mantissa. Compilers that know `__float128` compute
with it three times as fast as Boost's own type of the same width; both give 34 digits. */

#ifdef LATTICE_FLOAT128
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#include <boost/multiprecision/eigen.hpp>

namespace lattice {

#ifdef LATTICE_FLOAT128
using Quadruple = boost::multiprecision::float128;
#else
using Quadruple = boost::multiprecision::cpp_bin_float_quad;
#endif

}  // namespace lattice
