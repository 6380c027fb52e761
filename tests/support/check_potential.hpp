#pragma once
// What every well and every contact must satisfy; ready for new ones.

#include <vector>

#include "lattice/model/contact.hpp"
#include "lattice/model/potential_names.hpp"
#include "lattice/model/well.hpp"
#include "support/check.hpp"

/// Central difference with one Richardson step: error of order h^4.
template <class F>
double derivative(F f, double x) {
  const double h = 1e-3;
  const auto d = [&](double k) { return (f(x + k) - f(x - k)) / (2 * k); };
  return (4 * d(h / 2) - d(h)) / 3;
}

/// Force and stiffness are the derivatives that they claim to be, a bead at rest feels exactly
/// nothing, and higher precision gives the same function with more digits.
template <class Potential>
void check_potential(const Potential& p, const std::vector<double>& at) {
  for (double x : at) {
    CAPTURE(x);
    check_close(p.force(x), -derivative([&](double u) { return p.energy(u); }, x), 1e-9, 1e-9);
    check_close(p.stiffness(x), -derivative([&](double u) { return p.force(u); }, x), 1e-8, 1e-8);
    const auto wide = (long double)x;
    check_close(double(p.energy(wide)), p.energy(x), 1e-15, 1e-14);
    check_close(double(p.force(wide)), p.force(x), 1e-15, 1e-14);
    check_close(double(p.stiffness(wide)), p.stiffness(x), 1e-15, 1e-14);
    // The wide force is the derivative to more digits than double has.
    const long double h = 1e-4L;
    const auto slope = [&](long double k) {
      return (p.energy(wide + k) - p.energy(wide - k)) / (2 * k);
    };
    const long double fine = (4 * slope(h / 2) - slope(h)) / 3;
    check_close(double(p.force(wide) + fine), 0, 2e-13 * (1 + std::abs(p.force(x))));
  }
  CHECK(p.energy(0.0) == 0);
  CHECK(p.force(0.0) == 0);
  CHECK(p.force(0.0L) == 0);
}

/// Up to its rim, if it has one, a well also pulls a bead back from either side; at the rim the force vanishes
/// and the well is unstable.
template <class Onsite>
void check_well(const Onsite& well) {
  check_potential(well, {-1.3, -0.4, -0.1, 0.2, 0.9, 1.7});
  const double rim = lattice::rim_of(well);
  CHECK(rim > 0);
  if (!std::isfinite(rim)) return;
  for (double share : {0.1, 0.5, 0.99}) {
    CHECK(well.force(share * rim) < 0);
    CHECK(well.force(-share * rim) > 0);
  }
  check_close(well.force(rim), 0, 1e-14);
  CHECK(well.stiffness(rim) < 0);
}

/// A contact also never pulls more than its compression, is open beyond `opening`, and begins there with its
/// exponent.
template <class Contact>
void check_contact(const Contact& contact) {
  check_potential(contact, {-1.3, -0.4, -0.1, 0.2, 0.9, 1.7});
  const double d = contact.opening(), open = contact.force(d);
  CHECK(contact.force(d + 0.1) == open);
  CHECK(contact.force(d + 7) == open);
  CHECK(contact.stiffness(d + 0.1) == 0);
  CHECK(contact.force(d - 0.1) > open);
  const double ratio = (contact.force(d - 2e-3) - open) / (contact.force(d - 1e-3) - open);
  check_close(std::log2(ratio), contact.exponent, 1e-9);
}
