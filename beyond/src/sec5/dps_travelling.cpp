#include "sec5/dps_travelling.hpp"

#include <cmath>
#include <stdexcept>

namespace lattice {

DpsMember dps_member(const DpsTravelling& problem, const Vector<double>& guess) {
  const Solution<double> found = newton(problem.equations(), guess);
  const Field field = problem.expand(found.x);
  double sum = 0;
  for (const auto& a : field) sum += a.imag();
  return {found.x, field, sum, norm(field)};
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

}  // namespace lattice
