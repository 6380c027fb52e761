#include "sec33/printed_numbers.hpp"

#include "lattice/integrators/runge_kutta.hpp"
#include "lattice/orbits/floquet.hpp"

namespace lattice {

namespace {

// The increment of difference quotients, relative to the amplitude, is the square root of the rounding of one. A shift
// along the chain hardly changes the residual, and is forbidden lest the iteration run away
constexpr double increment = 1.5e-8, no_shift = 1e-4;

FixedStep map_of(const Setting& at, Centre centre, double s) {
  const std::size_t sites = at.sites + (centre == Centre::bond);
  return {breather_problem(centre, Setting::omega_b, s, sites).chain, at.method, at.steps,
          Setting::period};
}

// The state that comes nearest to a breather of the map, from three iterations that begin with the accurate one
State<double> breather_of(const FixedStep& map, Centre centre, double s) {
  const auto problem = breather_problem(centre, Setting::omega_b, s, map.chain.sites);
  return find_breather(map, find_breather(problem, Phase::stretched).start, {3, 0, no_shift}).start;
}

}  // namespace

std::vector<Nystrom> Setting::methods() {
  return {nystrom(verlet()), classical_runge_kutta(), nystrom(fehlberg_5()),
          nystrom(dormand_prince_5()), nystrom(calvo_sanz_serna_4())};
}

void Setting::measure_residual() {
  const FixedStep map = map_of(*this, Centre::site, 0);
  const State<double> guess = ansatz(Centre::site, omega_b, map.chain.sites);
  const MapBreather exact = find_breather(map, guess, {5, 0, no_shift});
  const MapBreather rough = find_breather(map, guess, {5, increment, no_shift});
  residual = exact.residual, variation = exact.variation;
  residual_differences = rough.residual, variation_differences = rough.variation;
}

Shifted Setting::shift_left() const {
  const FixedStep map = map_of(*this, Centre::site, 0);
  const auto guess = ansatz(Centre::site, omega_b, map.chain.sites);
  const State<double> left = find_breather(map, guess, {5, 0, no_shift}).start;
  const State<double> exact =
      find_breather(breather_problem(Centre::site, omega_b, 0, sites), Phase::compressed).start;

  // The direction that the equations feel least, and the slope of the profile along the chain
  Matrix<double> jacobian = derivative(map, exact, sites, 0);
  for (std::size_t n = 0; n < sites; ++n) jacobian(n, n) -= 1;
  const Vector<double> softest = condition_of(jacobian).softest;
  Vector<double> difference(sites), slope(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    difference[n] = left.y[n] - exact.y[n];
    slope[n] = ((n + 1 < sites ? exact.y[n + 1] : 0) - (n > 0 ? exact.y[n - 1] : 0)) / 2;
  }
  const double along = softest.dot(difference);
  return {std::abs(along / softest.dot(slope)), std::abs(along) / difference.norm(),
          find_breather(map, left, {8, 0, 0}).residual};
}

void Setting::measure_breathers() {
  std::array<double, 2> energies{};
  for (std::size_t c : {0U, 1U}) {
    const Centre centre = both_centres[c];
    std::array<double, 3> kappa{}, by_differences{};
    for (std::size_t w : {0U, 1U, 2U}) {
      const double s = double(w) - 1;
      const FixedStep map = map_of(*this, centre, s);
      const State<double> start = breather_of(map, centre, s);
      const std::size_t all = 2 * start.y.size();
      kappa[w] = quadruplet_kappa(derivative(map, start, all, 0));
      by_differences[w] = quadruplet_kappa(derivative(map, start, all, increment));
      if (w == 1) energies[c] = energy(map.chain, start);
    }
    off_circle[c] = 2 * std::sqrt(std::abs(kappa[1]));
    s0[c] = zero_in_wells(kappa);
    s0_differences[c] = zero_in_wells(by_differences);
  }
  barrier = energies[0] - energies[1];
}

// First a kick on either side of the printed threshold, then halvings of the interval between them
void Setting::measure_threshold() {
  const FixedStep map = map_of(*this, Centre::bond, 0);
  const State<double> start = breather_of(map, Centre::bond, 0);
  const auto free_at = [&](double c) { return frees(map, start, c, 20000); };
  double low = 0.88 * printed::threshold, high = 1.12 * printed::threshold;
  if (free_at(low)) {
    freed_at = low;
    return;
  }
  if (!free_at(high)) {
    pinned_at = high;
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const double middle = std::sqrt(low * high);
    (free_at(middle) ? high : low) = middle;
  }
  pinned_at = low, freed_at = high;
}

void Setting::measure_jump() {
  const FixedStep map = map_of(*this, Centre::site, 0);
  const State<double> start = breather_of(map, Centre::site, 0);
  const auto periods = std::size_t(horizons * horizon / period);
  path = path_of(map, kicked(start, printed::weak_kick), periods, 64, [](const Creep& so_far) {
    return so_far.t.back() > horizon && !stays_away(so_far, printed::jump, horizon);
  });
}

// What counts as near
bool is_near(double value, double target, double share) {
  return std::abs(value - target) <= share * std::abs(target);
}

bool is_near_residual(double residual) {
  return std::abs(std::log2(residual / printed::residual)) <= 1;
}

Near near_printed(const Setting& at) {
  return {is_near_residual(at.residual),
          is_near(std::abs(at.barrier), printed::barrier),
          std::abs(at.s0[0] - printed::s0_site) <= 0.03,
          std::abs(at.s0[1] - printed::s0_bond) <= 0.03,
          is_near(at.threshold(), printed::threshold),
          stays_away(at.path, printed::jump, Setting::horizon)};
}

}  // namespace lattice
