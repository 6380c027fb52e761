#include "sec5/dps_travelling.hpp"

#include <cmath>
#include <stdexcept>

namespace lattice {

DpsMember dps_member(const DpsTravelling& problem, const Vector<double>& guess) {
  const Solution<double> found = newton(problem.equations(), guess);
  const Field field = problem.expand(found.x);
  double sum = 0;
  for (const auto& a : field) sum += a.imag();
  return {problem.phase, found.x, field, sum, norm(field), energy(field, false, problem.alpha)};
}

Vector<double> cut_dps_packet(double from, std::size_t half_length) {
  const std::size_t sites = std::size_t(from) + 3 * half_length;
  // It moves at about 0.36 sites per unit of tau; the run lasts as if it were 0.34
  const double time = (from + 8) / 0.34;
  double least = 1e300, t0 = 0, x0 = 0, t1 = 0, x1 = 0;
  Field best;
  std::size_t centre = 0;
  follow_dps(Dps{sites}, dps_impact(sites), time, std::size_t(time * 20), 1e-9,
             [&](double tau, const Field& field) {
               const auto d = density(field);
               const auto c = front_packet(d);
               if (!c || energy_centre(d, *c) < from || *c + half_length >= sites) return;
               (t0 == 0 ? t0 : t1) = tau, (x0 == 0 ? x0 : x1) = energy_centre(d, *c);
               const double uneven = std::abs(d[*c + 1] - d[*c - 1]) / d[*c];
               if (uneven < least) least = uneven, best = field, centre = *c;
             });
  if (best.empty() || !(x1 > x0)) throw std::runtime_error("no packet passes the site");
  // A common phase makes the centre imaginary; the amplitude goes with the inverse square of the shift time
  const std::complex<double> turn =
      std::complex<double>(0, -1) * std::abs(best[centre]) / best[centre];
  const double root = (t1 - t0) / (x1 - x0) / DpsTravelling::shift_time, scale = root * root;
  Vector<double> x(2 * Eigen::Index(half_length) + 1);
  for (std::size_t n = 0; n <= half_length; ++n) {
    const auto a = scale * turn * best[centre + n];
    if (n > 0) x[2 * Eigen::Index(n) - 1] = a.real();
    x[2 * Eigen::Index(n)] = a.imag();
  }
  return x;
}

namespace {

/// With `more` sites on either side, at which nothing moves.
Vector<double> widened(const Vector<double>& x, std::size_t more) {
  Vector<double> out = Vector<double>::Zero(x.size() + 2 * Eigen::Index(more));
  out.head(x.size()) = x;
  return out;
}

/// The last two members of a family, and how far they are apart in its parameter.
struct LastTwo {
  Vector<double> x, before{};
  double apart = 0;
};

/// One member `h` further on in the parameter that `problem` has now.
void add_member(DpsTravelling& problem, LastTwo& last, double h) {
  Vector<double> guess = last.x;
  if (last.before.size() > 0) {
    const double w = h / last.apart, ratio = sup(last.x) / sup(last.before);
    guess = std::pow(ratio, w) * ((1 + w) * last.x - w * ratio * last.before);
  }
  problem.size = sup(guess);
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-10;
  rule.reuse_below = 1e-3;
  Vector<double> x = newton(problem.equations(), guess, rule).x;
  last = {std::move(x), std::move(last.x), h};
  while (std::hypot(last.x[last.x.size() - 2], last.x[last.x.size() - 1]) > 1e-14 * sup(last.x)) {
    last.x = widened(last.x, 1), last.before = widened(last.before, 1);
    ++problem.half_length;
  }
}

/// Follows a family while the parameter, which `set` hands to the problem, goes from `at` to `to`.
template <class Set>
void follow(DpsTravelling& problem, LastTwo& last, double at, double to, double step, Set set) {
  last.before.resize(0);
  for (double h = to < at ? -step : step; at != to;) {
    const double next = std::abs(to - at) <= std::abs(h) ? to : at + h;
    try {
      set(problem, next);
      add_member(problem, last, next - at);
      at = next;
      h *= std::abs(h) < step ? 2 : 1;
    } catch (const NewtonFailed&) {
      h /= 2;
      if (std::abs(h) < step / 100) throw;
    }
  }
}

}  // namespace

// The first member, then along the angle, then along the exponent
std::pair<DpsTravelling, DpsMember> follow_dps_member(double alpha, double phase,
                                                      double tolerance) {
  DpsTravelling problem;
  LastTwo last{cut_dps_packet(40, problem.half_length)};
  problem.tolerance = 1e-11;
  add_member(problem, last, 0);
  follow(problem, last, 0, phase, 0.2, [](DpsTravelling& p, double at) { p.phase = at; });
  follow(problem, last, 2, 1 / (alpha - 1), 0.25,
         [](DpsTravelling& p, double b) { p.alpha = 1 + 1 / b; });
  problem.alpha = alpha, problem.tolerance = tolerance;
  return {problem, dps_member(problem, last.x)};
}

std::pair<DpsTravelling, DpsMember> in_wider_window(const DpsTravelling& problem,
                                                    const DpsMember& member, double tolerance) {
  DpsTravelling wide = problem;
  wide.half_length += 2, wide.tolerance = tolerance;
  return {wide, dps_member(wide, widened(member.x, 2))};
}

}  // namespace lattice
