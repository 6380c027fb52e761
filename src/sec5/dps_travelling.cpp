#include "sec5/dps_travelling.hpp"

namespace lattice {

DpsMember dps_member(const DpsTravelling& problem, const Vector<double>& guess) {
  const Solution<double> found = solve<DpsTravelling, double>(problem, guess);
  const Field field = problem.expand(found.x);
  double sum = 0;
  for (const auto& a : field) sum += a.imag();
  return {problem.phase,
          found.x,
          field,
          sum,
          norm(field),
          energy(field),
          found.history.back().residual};
}

Vector<double> cut_dps_packet(double from, std::size_t reach) {
  const std::size_t sites = std::size_t(from) + 3 * reach;
  double least = 1e300, t0 = 0, x0 = 0, t1 = 0, x1 = 0;
  Field best;
  std::size_t centre = 0;
  follow_dps(Dps{sites}, dps_impact(sites), (from + 8) / 0.34, std::size_t((from + 8) / 0.34 * 20),
             1e-9, [&](double tau, const Field& field) {
               const auto d = density(field);
               const auto c = front_packet(d);
               if (!c || energy_centre(d, *c) < from || *c + reach >= sites) return;
               (t0 == 0 ? t0 : t1) = tau, (x0 == 0 ? x0 : x1) = energy_centre(d, *c);
               const double miss = std::abs(d[*c + 1] - d[*c - 1]) / d[*c];
               if (miss < least) least = miss, best = field, centre = *c;
             });
  if (best.empty() || !(x1 > x0)) throw std::runtime_error("no packet passes the site");
  /**
  What was cut out is turned and scaled. By the scaling law the amplitude goes with the inverse square of
  the shift time, here the time from site to site of the packet. */
  const std::complex<double> turn =
      std::complex<double>(0, -1) * std::abs(best[centre]) / best[centre];
  const double root = (t1 - t0) / (x1 - x0) / DpsTravelling::shift_time, scale = root * root;
  Vector<double> x(2 * Eigen::Index(reach) + 1);
  for (std::size_t n = 0; n <= reach; ++n) {
    const auto a = scale * turn * best[centre + n];
    if (n > 0) x[2 * Eigen::Index(n) - 1] = a.real();
    x[2 * Eigen::Index(n)] = a.imag();
  }
  return x;
}

}  // namespace lattice
