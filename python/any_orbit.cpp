#include "any_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "commands/multipliers.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/numerics/progress.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/orbits/floquet.hpp"

namespace lattice {
namespace {

using Multiplier = std::complex<double>;

/// The orbit of this symmetry near `guess`, with steps that are halved until they help.
Fitted near_guess(const Chain& chain, Symmetry symmetry, const State<double>& guess, double period,
                  double rank) {
  symmetry.decays = false;  // nothing is known of its tail, if it has one
  Shooting<double> problem{chain, std::move(symmetry), 2 * pi<double>() / period};
  NewtonRule<double> how = rule<double>(0);
  how.damped = true, how.rank = rank;
  Orbit<double> orbit = newton(problem, problem.reduce(guess), how);
  return {std::move(problem), std::move(orbit)};
}

/**
A shift in time is an eigenvector of the monodromy matrix $M$ with eigenvalue one, and the gradient of the energy is one
of its transpose. Vectors that are perpendicular to both are mapped, but for multiples of the shift, among themselves, and
the eigenvalues there are all but those of the phase. */
template <class T>
std::vector<Multiplier> beside_phase(const Chain& chain, const State<T>& start, const T& period,
                                     const EventTolerance<T>& how) {
  const auto n = Eigen::Index(chain.sites);
  const std::vector<T> a = accelerations(chain, start.y);
  Vector<T> shift(2 * n), gradient(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto site = std::size_t(i);
    const T mass(chain.mass_of(site));
    shift[i] = start.v[site], shift[n + i] = a[site];
    gradient[i] = -mass * a[site], gradient[n + i] = mass * start.v[site];
  }
  const Matrix<T> without_shift = perpendicular_to(shift);
  const Vector<T> rest = without_shift.transpose() * gradient;
  const Matrix<T> basis = without_shift * perpendicular_to(rest);
  std::vector<Multiplier> out;
  for (const auto& z :
       eigenvalues_of<T>(basis.transpose() * monodromy(chain, start, period, how) * basis))
    out.emplace_back(double(z.real()), double(z.imag()));
  std::stable_sort(out.begin(), out.end(), [](const Multiplier& x, const Multiplier& y) {
    return std::abs(x - 1.0) < std::abs(y - 1.0);
  });
  return out;
}

/// The multipliers of an orbit that is nowhere at rest: the error of each is its distance from that in less precision.
OrbitMultipliers in_motion(const Fitted& found) {
  NewtonRule<Wide> how = rule<Wide>(0);
  how.rank = 1e-9;
  const Orbit<Wide> wide = newton(in_precision<Wide>(found.problem), found.orbit, how);
  std::vector<Multiplier> coarse = beside_phase(found.problem.chain, found.orbit.start,
                                                found.orbit.period(), rule<double>(0).events);
  OrbitMultipliers out{{{1, 0}, {1, 0}}, exact(1)};
  double most = 1, least = 1, surely = 1;
  for (const Multiplier& z :
       beside_phase(found.problem.chain, wide.start, wide.period(), how.events)) {
    const auto nearest = std::min_element(
        coarse.begin(), coarse.end(),
        [&](const auto& x, const auto& y) { return std::abs(x - z) < std::abs(y - z); });
    const double error =
        std::abs(*nearest - z) + std::numeric_limits<double>::epsilon() * std::abs(z);
    coarse.erase(nearest);
    out.all.emplace_back(z, error);
    most = std::max(most, std::abs(z));
    least = std::max(least, std::abs(z) - error), surely = std::max(surely, std::abs(z) + error);
  }
  out.largest_modulus = {most, std::max(most - least, surely - most)};
  return out;
}

}  // namespace

Fitted orbit_from_rest(const Chain& chain, const State<double>& guess, double period) {
  return near_guess(chain, even_in_time(chain.sites), guess, period, 0);
}

std::vector<Estimate> positions_of(const Fitted& found) {
  const Orbit<Wide> wide = newton(in_precision<Wide>(found.problem), found.orbit, rule<Wide>(0));
  std::vector<Estimate> out;
  for (std::size_t n = 0; n < wide.start.y.size(); ++n)
    out.push_back(compare(found.orbit.start.y[n], double(wide.start.y[n])));
  return out;
}

/// Throws std::invalid_argument if `share` of the amplitude is too much.
static void refuse_beyond(double most, double share, const char* what) {
  if (share < most) return;
  throw std::invalid_argument(
      number_label(std::string("y, v and period: no periodic orbit; ") + what, share) +
      number_label(" of the amplitude (allowed:", most) + ")");
}

// Half a period is enough, and tells more digits, where the orbit begins at rest
OrbitMultipliers multipliers_through(const Chain& chain, const State<double>& start,
                                     double period) {
  State<double> end = start;
  if (!is_accurate(try_flow(chain, end, period), {}))
    throw std::invalid_argument(
        "y, v and period: no periodic orbit; the motion from there cannot be followed");
  refuse_beyond(1e-2, largest_difference(end, start) / largest(start),
                "after one period it misses its start by");
  const auto moves = [](double v) { return v != 0; };
  const bool rests = std::none_of(start.v.begin(), start.v.end(), moves);
  const bool ring = chain.ends == Ends::periodic;
  const Fitted found =
      rests ? orbit_from_rest(chain, start, period)
            : near_guess(chain, travelling(chain.sites, 0, ring), start, period, 1e-9);
  refuse_beyond(1e-3, largest_difference(found.orbit.start, start) / largest(start),
                "the nearest one found begins at a distance of");
  if (!rests) return in_motion(found);
  const Spectrum all = spectrum<Wide>(found.problem, found.orbit);
  return {multipliers_of(all), all.largest_modulus()};
}

}  // namespace lattice
