#pragma once
/**
# Shooting by leapfrog

Far from any orbit the flights that Newton's method asks for are wild, and to land on every contact that
opens or closes (landing.hpp) costs much for nothing. A search is better served by leapfrog steps of fixed
length $h$,
$$y \leftarrow y + \tfrac h2 v,\qquad v \leftarrow v + h\,a(y),\qquad y \leftarrow y + \tfrac h2 v,$$
with $a(y)$ the accelerations, and by the exact derivative of these steps. Orbits of this map at frequency
$\omega$ have a relative error of the order $(\omega h)^2/24$; what a search finds is a guess for the
exact flow. The averaging argument of section 2 carries over to the map: on an orbit the kicks of each bead
add up to zero over a period, as the integral of the force does. */

#include <cstddef>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// A problem in the sense of newton.hpp. Unknowns and equations are measured in units of the fixed number
/// `scale`, so that a search whose orbit shrinks to nothing ends there, at rest.
template <class Onsite, class Contact>
struct LeapfrogShooting : Shooting<double, Onsite, Contact> {
  double scale = 1;
  int steps = 128;  ///< per period; a multiple of the symmetry's parts

  Sizes<double> sizes(const Vector<double>& x, bool) const {
    const auto rows = Eigen::Index(this->symmetry.equations.size());
    return {Vector<double>::Constant(x.size(), scale), Vector<double>::Constant(rows, scale)};
  }
  Shot<double> shoot(const Vector<double>& x, const Landing<double>& rule,
                     bool with_jacobian = true) const;
  /// Advances a state and its tangent, if there is one, by `count` steps and shows each to `watch(z)`.
  template <class Watch>
  void fly(State<double>& z, Tangent<double>* tangent, int count, Watch watch) const;
};

/**
The derivative of a drift is the drift itself; that of a kick is the linearisation (chain.hpp) about the
positions at which the kick is given. */
template <class Onsite, class Contact>
void kick_tangent(const Chain<Onsite, Contact>& chain, const std::vector<double>& y, double h,
                  Tangent<double>& tangent) {
  const Hessian<double> bend = linearise(chain, y);
  const std::size_t sites = chain.sites, columns = tangent.columns;
  const bool ring = chain.ends == Ends::periodic;
  for (std::size_t n = 0; n < sites; ++n) {
    const double push = -h * lightness<double>(chain, n);
    const std::size_t before = n > 0 ? n - 1 : sites - 1, after = n + 1 < sites ? n + 1 : 0;
    double* row = tangent.row(sites + n);
    add_scaled(row, tangent.row(n), push * bend.diagonal[n], columns);
    if (n > 0 || ring) add_scaled(row, tangent.row(before), push * bend.off[before], columns);
    if (after > 0 || ring) add_scaled(row, tangent.row(after), push * bend.off[n], columns);
  }
}

/**
Since both are cheap here, the tangent simply follows its orbit step by step. */
template <class Onsite, class Contact>
template <class Watch>
void LeapfrogShooting<Onsite, Contact>::fly(State<double>& z, Tangent<double>* tangent, int count,
                                            Watch watch) const {
  const std::size_t sites = this->chain.sites;
  const double h = this->period() / steps;
  const auto drift = [&](double by) {
    add_scaled(z.y.data(), z.v.data(), by, sites);
    if (tangent) add_scaled(tangent->row(0), tangent->row(sites), by, sites * tangent->columns);
  };
  for (int k = 0; k < count; ++k) {
    drift(h / 2);
    const std::vector<double> a = accelerations(this->chain, z.y);
    add_scaled(z.v.data(), a.data(), h, sites);
    if (tangent) kick_tangent(this->chain, z.y, h, *tangent);
    drift(h / 2);
    watch(z);
  }
}

/**
A shot differs from that of shooting.hpp only in the flight: residuals and derivatives follow from the
lists of the symmetry as they do there. */
template <class Onsite, class Contact>
Shot<double> LeapfrogShooting<Onsite, Contact>::shoot(const Vector<double>& x,
                                                      const Landing<double>&,
                                                      bool with_jacobian) const {
  const Symmetry& symmetry = this->symmetry;
  const State<double> start = this->unfold(x);
  State<double> z = start;
  const Tangent<double> first = tangent_of<double>(symmetry.unknowns, this->chain.sites);
  Tangent<double> tangent = first;
  fly(z, with_jacobian ? &tangent : nullptr, steps / symmetry.parts, [](const State<double>&) {});
  Shot<double> shot;
  shot.miss = this->residuals(start, z);
  if (with_jacobian) shot.jacobian = Matrix<double>::Zero(shot.miss.size(), x.size());
  for (Eigen::Index i = 0; with_jacobian && i < shot.miss.size(); ++i)
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const Equation& equation = symmetry.equations[std::size_t(i)];
      for (const Term& t : equation.end)
        shot.jacobian(i, k) += t.sign * tangent(t.index, std::size_t(k));
      for (const Term& t : equation.start)
        shot.jacobian(i, k) += t.sign * first(t.index, std::size_t(k));
    }
  return shot;
}

}  // namespace lattice
