#pragma once
// What all programs have in common is read once, as a precompiled header, and compiled once, in
// tools/once_*.cpp. The library does not need these files: a program without them compiles the same
// functions itself, to the same bits, in three times the time.

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "lattice/measure/depinning.hpp"
#include "lattice/orbits/continuation.hpp"
#include "lattice/orbits/floquet.hpp"
#include "lattice/orbits/travelling.hpp"

namespace lattice {

// The inner loops of the chains that a reader may choose by name.
#define LATTICE_LOOPS(words, T, Onsite, Contact)                                                \
  words void accelerate(const Chain<Onsite, Contact>&, const T*, T*, Window&);                  \
  words double ContactAware::advance(const Chain<Onsite, Contact>&, State<T>&, Window&, double, \
                                     std::size_t, NystromMemory<T>&) const;

#define LATTICE_NAMED_LOOPS(words)                        \
  LATTICE_LOOPS(words, double, Quartic, Hertz)            \
  LATTICE_LOOPS(words, double, Harmonic, Hertz)           \
  LATTICE_LOOPS(words, double, Pendulum, Hertz)           \
  LATTICE_LOOPS(words, double, None, Hertz)               \
  LATTICE_LOOPS(words, double, Quartic, CompressedHertz)  \
  LATTICE_LOOPS(words, double, Harmonic, CompressedHertz) \
  LATTICE_LOOPS(words, double, Pendulum, CompressedHertz) \
  LATTICE_LOOPS(words, double, None, CompressedHertz)     \
  LATTICE_LOOPS(words, double, Quartic, PowerContact)     \
  LATTICE_LOOPS(words, double, Harmonic, PowerContact)    \
  LATTICE_LOOPS(words, double, Pendulum, PowerContact)    \
  LATTICE_LOOPS(words, double, None, PowerContact)

// Flights and orbits of the article's own chain, and of those in wells of any name.
#define LATTICE_FLIGHTS(words, T, Onsite, Contact)                                                 \
  words Flow<T> flow(const Chain<Onsite, Contact>&, State<T>&, T, const Landing<T>&, Tangent<T>*); \
  words Matrix<T> monodromy(const Chain<Onsite, Contact>&, const State<T>&, const T&,              \
                            const Landing<T>&);

#define LATTICE_ORBITS(words, T, Onsite, Contact)                                        \
  words struct Shooting<T, Onsite, Contact>;                                             \
  words Solution<T> solve(const Shooting<T, Onsite, Contact>&, const Vector<T>&,         \
                          const NewtonRule<T>&);                                         \
  words Orbit<T> newton(const Shooting<T, Onsite, Contact>&, const Vector<T>&,           \
                        const NewtonRule<T>&);                                           \
  words Orbit<T> polish(const Shooting<T, Onsite, Contact>&, const Orbit<double>&,       \
                        const NewtonRule<T>&);                                           \
  words Pairs<T> floquet_pairs(const Chain<Onsite, Contact>&, const State<T>&, const T&, \
                               const Landing<T>&);

// Breathers of a family, from its beginning.
#define LATTICE_FAMILY(words, Onsite)                                                       \
  words class Branch<Shooting<double, Onsite, Hertz>>;                                      \
  words Orbit<double> find_breather(const Shooting<double, Onsite, Hertz>&, Phase,          \
                                    const NewtonRule<double>&);                             \
  words FittedIn<Onsite> fit_chain(Centre, double, const Onsite&, std::size_t, std::size_t, \
                                   double, Phase);

// Runs of a chain that is chosen when the program runs.
#define LATTICE_CHOSEN(words)                                                                   \
  words Run evolve_chosen(const ContactAware&, const ChosenChain&, State<double>&, const Pace&, \
                          const Look&);                                                         \
  words std::vector<double> energy_density(const ChosenChain&, const State<double>&);

// What Newton's method and multipliers need of Eigen.
#define LATTICE_DENSE(words, T)                                                \
  words Vector<T> solve_system(const Matrix<T>&, const Vector<T>&, double);    \
  words Vector<T> solve_scaled(Matrix<T>, Vector<T>, const Sizes<T>&, double); \
  words T symplectic_defect(const Matrix<T>&);                                 \
  words Matrix<T> pair_matrix(const Matrix<T>&);                               \
  words Pairs<T> pairs_of(const Matrix<T>&, const Vector<T>&);

// Some tasks occur in double precision only.
#define LATTICE_DOUBLE(words)                                                                   \
  words Pinning pinning_of(const Chain<Harmonic, Hertz>&, Centre, const State<double>&, double, \
                           const Landing<double>&);

LATTICE_NAMED_LOOPS(extern template)
LATTICE_FLIGHTS(extern template, double, Quartic, Hertz)
LATTICE_FLIGHTS(extern template, long double, Quartic, Hertz)
LATTICE_FLIGHTS(extern template, double, Harmonic, Hertz)
LATTICE_ORBITS(extern template, double, Quartic, Hertz)
LATTICE_ORBITS(extern template, long double, Quartic, Hertz)
LATTICE_FAMILY(extern template, Quartic)
LATTICE_FLIGHTS(extern template, double, NamedWell, Hertz)
LATTICE_FLIGHTS(extern template, long double, NamedWell, Hertz)
LATTICE_ORBITS(extern template, double, NamedWell, Hertz)
LATTICE_ORBITS(extern template, long double, NamedWell, Hertz)
LATTICE_FAMILY(extern template, NamedWell)
LATTICE_CHOSEN(extern template)
LATTICE_DENSE(extern template, double)
LATTICE_DOUBLE(extern template)
LATTICE_DENSE(extern template, long double)

}  // namespace lattice
