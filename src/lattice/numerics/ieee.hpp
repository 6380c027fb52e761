#pragma once
/**
# IEEE arithmetic, or none

A compiler that may reorder sums, forget infinities or multiply by a reciprocal computes another chain, with errors that
no two resolutions show. CMakeLists.txt refuses such options for what it builds. A user of the installed library
has a command line of their own, so that the headers refuse them too: each includes this one, by itself or
through others. GCC has a macro for each part of `-ffast-math`, Clang for few of them but for the whole.

Many errors are differences between `double` and `long double`. Where these are one type, as on Apple's processors or
with Microsoft's compiler, such an error would always be zero. There the library is refused too. */

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "lattice needs IEEE arithmetic: compile without -ffast-math and its parts"
#endif
#if __LDBL_MANT_DIG__ <= __DBL_MANT_DIG__
#error "lattice needs a long double with more digits than double, from which errors are obtained"
#endif
