#include "lattice/orbits/breather.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lattice/model/dps.hpp"
#include "lattice/model/precisions.hpp"
#include "lattice/model/quasi_continuum.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

/**
A contact pushes with $k\,(-r)_+^\alpha$. The first harmonic of that is $k\,b$ times the same power of the amplitudes,
$b = \Gamma(\frac\alpha2+1)/[\sqrt\pi\,\Gamma(\frac\alpha2+\frac32)]$, so the profile at $\mu = 1$ is multiplied by the
power $1/(\alpha-1)$ of $2(\omega_b-1)/(k\,b)$, as in Eq. (20). */
static double size_of(const Contact& contact, double omega) {
  if (contact.is<Hertz>()) return 2 * breather_eps(omega);
  const double alpha = contact.exponent(), small = 1e-4;
  const double k = contact.force(-small) / std::pow(small, alpha);
  const double b =
      std::tgamma(alpha / 2 + 1) / (std::sqrt(std::numbers::pi) * std::tgamma(alpha / 2 + 1.5));
  return std::pow(2 * (omega - 1) / (k * b), 1 / (alpha - 1));
}

// The profile of Eq. (20); its sign tells whether the central contact is compressed or stretched
State<double> ansatz(Centre centre, double omega, std::size_t sites, Phase phase,
                     const Contact& contact) {
  const double alpha = contact.exponent();
  if (!(alpha > 1))
    throw std::invalid_argument("a breather needs contacts with an exponent above one");
  const bool spheres = contact.is<Hertz>();
  const double scale = size_of(contact, omega) * (phase == Phase::stretched ? -1 : 1);
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const long n = site_number(i, sites);
    state.y[i] = scale * (spheres ? quasi_continuum(centre, n) : quasi_continuum(centre, n, alpha));
  }
  return state;
}

/// Up to this frequency, that of the article's figure 4, Newton's method starts from the quasi-continuum profile.
static constexpr double direct_up_to = 1.1;

/// Where Newton's method starts. The approximate breather knows the contacts and not the well. If the exponent comes
/// near three both count alike, and the guess is the breather of harmonic wells, followed to the anharmonicity wanted.
static Vector<double> guess_for(const Shooting<double>& problem, const Vector<double>& approximate,
                                const NewtonRule<double>& rule) {
  const auto* quartic = problem.chain.well.get_if<Quartic>();
  const double size = sup<double>(approximate);
  if (!quartic || std::abs(quartic->s) * size * size < 0.1 * (problem.omega - 1))
    return approximate;
  Shooting<double> harmonic = problem;
  harmonic.chain.well = Quartic{0};
  return continue_to(harmonic, newton(harmonic, approximate, rule), problem.chain).x;
}

/// In wells that do not fit the guess the method may end in another family, of large extended motions or of motions with
/// neighbours in phase: those of a breather that move by more than a twentieth of the most oppose each other. Throws
/// NewtonFailed.
static void refuse_other_families(const Shooting<double>& problem, const Orbit<double>& orbit,
                                  double expected) {
  const auto refuse = [&](const std::string& motion) {
    throw NewtonFailed(problem.name() + ": not the breather but a motion " + motion + " is found",
                       orbit.history);
  };
  if (orbit.amplitude > 3 * expected)
    refuse(number_label("of size", orbit.amplitude) + number_label(", far from", expected) + ',');
  const std::vector<double>& y = orbit.start.y;
  const double small = 0.05 * orbit.amplitude;
  for (std::size_t n = 1; n < y.size(); ++n)
    if (std::abs(y[n]) > small && std::abs(y[n - 1]) > small && y[n] * y[n - 1] > 0)
      refuse("with neighbours in phase");
}

// Begin where the quasi-continuum profile is a good guess, and follow the branch from there
Orbit<double> find_breather(const Shooting<double>& problem, Phase phase,
                            const NewtonRule<double>& rule) {
  Shooting<double> nearby = problem;
  nearby.omega = std::min(problem.omega, direct_up_to);
  const State<double> rest = ansatz(nearby.chain, nearby.omega, phase);
  const Vector<double> approximate = nearby.reduce(rest);
  const Orbit<double> start = newton(nearby, guess_for(nearby, approximate, rule), rule);
  refuse_other_families(nearby, start, sup<double>(approximate));
  if (nearby.omega == problem.omega) return start;
  return Branch(nearby, along_omega<double>(problem.chain.contact.exponent()), start, 1, rule)
      .orbit_at(problem.omega);
}

NewtonRule<double> on_the_way() {
  NewtonRule<double> how;
  how.reuse_below = 1e-9;
  return how;
}

// Along one branch until it folds back in frequency
std::vector<Orbit<double>> breathers_at(Shooting<double> problem,
                                        const std::vector<double>& omegas) {
  problem.omega = omegas.front();
  std::vector<Orbit<double>> orbits{find_breather(problem)};
  Branch branch(problem, along_omega<double>(problem.chain.contact.exponent()), orbits.front(), 1,
                on_the_way());
  try {
    for (std::size_t k = 1; k < omegas.size(); ++k) orbits.push_back(branch.orbit_at(omegas[k]));
  } catch (const NoBranch&) {
  }
  return orbits;
}

State<double> resized(const State<double>& state, std::size_t sites) {
  State<double> out(sites);
  const long old = long(state.y.size()), shift = (long(sites) - old) / 2;
  for (long i = 0; i < long(sites); ++i)
    if (i - shift >= 0 && i - shift < old) out.y[std::size_t(i)] = state.y[std::size_t(i - shift)];
  return out;
}

Fitted fit_chain(Centre centre, double omega, const Well& well, std::size_t sites,
                 std::size_t usual, double precision, Phase phase) {
  const std::size_t ample = 2 * usual - usual % 2;
  const Orbit<double> orbit = find_breather(breather_problem(centre, omega, well, ample), phase);
  const std::size_t needed = sites_needed(orbit, precision);
  const std::size_t n = sites ? sites : std::max(needed, usual);
  if (n < needed) throw ShortChain(needed);
  const auto problem = breather_problem(centre, omega, well, n);
  if (omega <= direct_up_to) return {problem, find_breather(problem, phase)};
  // Far up the branch the orbit just found, cut or padded with beads at rest, is the best guess
  return {problem, newton(problem, problem.reduce(resized(orbit.start, n)))};
}

Vector<double> discrete_gradient(const std::vector<double>& y) {
  Vector<double> g = Vector<double>::Zero(Eigen::Index(y.size()));
  for (std::size_t i = 1; i + 1 < y.size(); ++i) g[Eigen::Index(i)] = y[i + 1] - y[i - 1];
  return g;
}

double alignment(const Vector<double>& a, const Vector<double>& b) {
  return std::abs(a.dot(b)) / (a.norm() * b.norm());
}

// The motion that the symmetry of a breather relates to itself has the signs of all positions changed
static bool is_even(const Well& well) {
  for (const double place : {1e-3, 0.05, 0.7}) {
    const double y = place * std::min(1.0, well.rim());
    const double one = well.force(y), other = well.force(-y);
    if (std::abs(one + other) > 1e-6 * std::abs(one)) return false;
  }
  return true;
}

// Contacts in which no overlap is negligible, lest they cut off the tail, and symmetry about a bond or a site
template <class T>
Shooting<T> breather_problem(Centre centre, const T& omega, const Well& well, std::size_t sites) {
  if (sites < 3 || (sites % 2 == 0) != (centre == Centre::bond))
    throw std::invalid_argument(
        "a bond-centred breather needs an even number of sites, at least 4,"
        " and a site-centred one an odd number, at least 3 (got " +
        std::to_string(sites) + ")");
  if (well.stiffness(0.0) != 1)
    throw std::invalid_argument("a breather needs wells with W''(0) = 1");
  if (!is_even(well))
    throw std::invalid_argument(
        "a site- or bond-centred breather needs symmetric wells, W(-y) = W(y)");
  if (loses_digits(well)) throw std::invalid_argument(digits_hint);
  Shooting<T> problem;
  problem.chain = {sites, well, Hertz{.negligible = 0}};
  problem.symmetry = centred(centre, sites);
  problem.omega = omega;
  return problem;
}

// Shorten the chain while the push of its last bead on the missing one would not be felt
std::size_t sites_needed(const Orbit<double>& orbit, double precision, const Contact& contact) {
  const auto& y = orbit.start.y;
  const double omega = orbit.omega, amplitude = orbit.amplitude;
  const double bound = precision * (omega * omega - 1) * amplitude, k = contact.stiffness(0.0);
  const auto weak = [&](std::size_t i) {
    const double edge = std::abs(y[i]);
    return (k > 0 ? k * edge * (edge / amplitude) : contact.force(-edge)) < bound;
  };
  std::size_t cut = 0;
  while (2 * cut + 4 < y.size() && weak(cut + 1) && weak(y.size() - 2 - cut)) ++cut;
  return y.size() - 2 * cut;
}

// The barrier at the same frequency, and at the same action
template <class T>
Barrier<T> barrier(const Shooting<T>& site_problem, const Orbit<T>& site, const Orbit<T>& bond,
                   const NewtonRule<T>& rule) {
  Barrier<T> out;
  out.equal_frequency = site.energy - bond.energy;
  // Change the frequency of the site-centred breather until its action is that of the other
  Shooting<T> shifted = site_problem;
  Orbit<T> moved = site;
  T left = bond.action_integral - site.action_integral, neglected(0);
  const T rounding = std::numeric_limits<T>::epsilon() * magnitude(site.energy);
  for (int i = 0; i == 0 || neglected > rounding; ++i) {
    if (i == 10)
      throw NewtonFailed("no site-centred breather with the bond-centred one's action is found",
                         {});
    const T area_omega = shifted.period() * moved.energy_omega, change = left / area_omega;
    shifted.omega += change;
    moved.x += change * moved.x_omega;
    moved = newton(shifted, moved, rule);
    left = bond.action_integral - moved.action_integral;
    neglected = magnitude(T(left * left / (T(4) * pi<T>() * area_omega)));
  }
  // What is left of the difference in action becomes energy by dE = dA / T_b
  out.equal_action = moved.energy + left / shifted.period() - bond.energy;
  out.omega_site = shifted.omega;
  return out;
}

#define LIST(T)                                                                         \
  template Shooting<T> breather_problem<T>(Centre, const T&, const Well&, std::size_t); \
  template Barrier<T> barrier<T>(const Shooting<T>&, const Orbit<T>&, const Orbit<T>&,  \
                                 const NewtonRule<T>&);
LATTICE_IN_EACH_PRECISION(LIST)
#undef LIST

}  // namespace lattice
