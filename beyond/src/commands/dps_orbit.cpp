#include "commands/dps_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace lattice {

void DpsOrbit::parameters(Parameters& p) {
  p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres",
        {1.05, 4, "", "towards 1 breathers become wide; exponents above 4 are untested"});
  p.add("phase", phase, "phase advance from site to site, in rad", {0, 3});
  p.add("time", time, "shift time: the slow time from site to site (default: 2 pi)", {1e-3, 1e3});
  p.add("profile", as_profile, "print the field at tau = 0 instead of its quantities");
}

// The scaling law: at the shift time T the field is (2 pi / T)^{1/(alpha-1)} times as large
double DpsOrbit::scale() const {
  return std::pow(DpsTravelling::shift_time / time, 1 / (alpha - 1));
}

namespace {

double amplitude(const Field& field) {
  double top = 0;
  for (const auto& a : field) top = std::max(top, std::abs(a));
  return top;
}

/// By how much a member misses itself after a whole shift, of which Newton's method saw one half.
double missed(const DpsOrbit::Member& member) {
  const auto& [problem, found] = member;
  Field end = found.field;
  problem.flow(end, DpsTravelling::shift_time);
  double worst = 0;
  for (std::size_t n = 1; n < end.size(); ++n)
    worst = std::max(worst, std::abs(end[n] - std::polar(1.0, problem.phase) * found.field[n - 1]));
  return worst / amplitude(found.field);
}

/**
As in the chain (one_orbit.cpp) the frame goes along by a site after each shift, and what its last site holds is left
behind. */
double left_behind(const DpsOrbit::Member& member) {
  const auto& [problem, found] = member;
  Field a = found.field;
  double left = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    problem.flow(a, DpsTravelling::shift_time);
    left = std::max(left, std::abs(a.front()));
    std::rotate(a.begin(), a.begin() + 1, a.end());
    a.back() = 0;
  }
  return left / amplitude(found.field);
}

}  // namespace

/**
What misses itself by more than a hundredth of its amplitude is no travelling breather. */
DpsOrbit::Found DpsOrbit::find() const {
  const Member coarse = follow_dps_member(alpha, phase, 1e-12);
  const Found found{coarse, in_wider_window(coarse.first, coarse.second, 1e-13)};
  const double by = missed(found.fine);
  if (by <= 0.01) return found;
  std::ostringstream text;
  text << "with alpha = " << alpha << " the field of phase " << phase << " misses itself by " << by
       << " of its amplitude after a shift time: not a travelling breather (allowed: 0.01; with "
          "phase 0 it is exact)";
  throw std::runtime_error(text.str());
}

/**
Two windows may agree by chance, and both are rounded alike: the power of the scale, the sum of many entries, and what is
left where Newton's method stops, which is no property of the member. */
Table DpsOrbit::quantities(const Found& f) const {
  const double digit = std::numeric_limits<double>::epsilon();
  const auto both = [&](double power, auto of) {
    const double factor = std::pow(scale(), power);
    Estimate out = compare(factor * of(f.coarse), factor * of(f.fine));
    out.error += 4 * digit * (1 + power / (alpha - 1)) * std::abs(out.value);
    return out;
  };
  const auto small = [&](auto of) {
    Estimate out = both(0, of);
    out.error = std::max(out.error, out.value < 1e-12 ? out.value : 16 * digit);
    return out;
  };
  const Estimate residual = small(missed);
  Estimate sum = both(0, [](const Member& m) { return m.second.V / amplitude(m.second.field); });
  for (const auto& a : f.fine.second.field)
    sum.error += 8 * digit * std::abs(a) / amplitude(f.fine.second.field);
  if (residual.value < 1e-12) sum.error += residual.value;
  Answers q;
  q.add("amplitude", both(1, [](const Member& m) { return amplitude(m.second.field); }), "",
        "largest |A_n| at tau = 0");
  q.add("norm", both(2, [](const Member& m) { return m.second.norm; }), "",
        "sum of |A_n|^2, conserved");
  q.add("energy", both(alpha + 1, [](const Member& m) { return m.second.energy; }), "",
        "sum of |A_{n+1} - A_n|^(alpha+1) / (alpha + 1), conserved");
  q.add_small("sum", sum, "relative to amplitude",
              "V: the sum of all A_n, divided by i; conserved");
  q.add_small("tail", small(left_behind), "relative to amplitude",
              "largest |A_n| left behind as the breather crosses the window of " +
                  std::to_string(f.fine.second.field.size()) + " sites");
  q.add_small(
      "residual", residual, "relative to amplitude",
      "difference between the field and itself one shift time later and one site further on");
  return q.table;
}

// The field of the finer member
Table DpsOrbit::profile(const Found& f) const {
  Table table{{count("n", "site", "site"), number("real", "real part of A_n at tau = 0"),
               number("imag", "imaginary part of A_n at tau = 0")}};
  const Field& field = f.fine.second.field;
  for (std::size_t i = 0; i < field.size(); ++i)
    table.add({long(i) - long(f.fine.first.half_length), scale() * field[i].real(),
               scale() * field[i].imag()});
  return table;
}

Table DpsOrbit::table() const {
  const Found f = find();
  return as_profile ? profile(f) : quantities(f);
}

}  // namespace lattice
