#include "sec3/breather_like.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <vector>

#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/continuation.hpp"

namespace lattice {

PhononBands::PhononBands(const Chain& chain) : well(chain.well.stiffness(0.0)) {
  const std::size_t n = chain.sites;
  for (std::size_t i : {0, 1}) {
    mass[i] = chain.mass_of(n - 1 - i);
    k[i] = chain.eta_of(n - 1 - i) * chain.contact.stiffness(0.0);
  }
  if (!(edge(false, false) > 0))
    throw std::invalid_argument(
        "small displacements of this chain grow: its rest state is unstable");
}

// The two roots of the dispersion relation, as squares of frequencies
double PhononBands::edge(bool upper, bool at_pi) const {
  const double a = well + k[0] + k[1], one = a / mass[0], other = a / mass[1];
  const double c = at_pi ? k[0] - k[1] : k[0] + k[1];
  const double root = std::hypot((one - other) / 2, c / std::sqrt(mass[0] * mass[1]));
  return std::sqrt((one + other) / 2 + (upper ? root : -root));
}

double PhononBands::decay(double omega) const {
  const double a = well + k[0] + k[1], w = omega * omega, pair = 2 * k[0] * k[1];
  const double both = (a - mass[0] * w) * (a - mass[1] * w) - k[0] * k[0] - k[1] * k[1];
  if (!(pair > 0)) return std::numeric_limits<double>::infinity();
  return std::abs(both) > pair ? std::acosh(std::abs(both) / pair) / 2 : 0;
}

static std::string six_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string PhononBands::to_text() const {
  const auto band = [](double from, double to) {
    const bool point = to - from <= 1e-9 * to;
    return point ? six_digits(to) : "[" + six_digits(from) + ", " + six_digits(to) + "]";
  };
  const double low = edge(false, false), below = edge(false, true), above = edge(true, true);
  if (above - below <= 1e-9 * above) return band(low, top());
  return band(low, below) + " and " + band(above, top());
}

Chain lengthened(const Chain& chain, std::size_t sites) {
  assert_fits(chain, chain.sites);
  if (!chain.variation) return chain.with_sites(sites);
  const auto& [masses, inverse, stiffnesses] = *chain.variation;
  if (chain.sites % 2 != sites % 2)
    throw std::invalid_argument("masses of " + std::to_string(chain.sites) +
                                " beads do not fit a breather of " + std::to_string(sites) +
                                " sites: one is centred on a site, the other on a bond");
  // Beyond its ends the last two beads, and the contacts between them, in turn
  const long shift = (long(sites) - long(chain.sites)) / 2, last = long(chain.sites) - 1;
  const auto at = [&](const std::vector<double>& all, long i, long least) {
    while (i < least) i += 2;
    while (i > last) i -= 2;
    return all[std::size_t(i)];
  };
  std::vector<double> mass, eta;
  for (long i = -shift; i < long(sites) - shift; ++i) mass.push_back(at(masses, i, 0));
  for (long i = -shift; i <= long(sites) - shift; ++i) eta.push_back(at(stiffnesses, i, 1));
  Chain out = chain;
  out.sites = sites;
  vary(out, mass, eta);
  return out;
}

/// Throws std::invalid_argument unless the beads of a chain are symmetric about its middle, its ends free, and its
/// contacts such that the ansatz is known or a path can begin at it.
static void require_room(const Chain& chain) {
  const auto mirrored = [](auto first, auto last) {
    return std::equal(first, last, std::make_reverse_iterator(last));
  };
  if (chain.ends != Ends::free)
    throw std::invalid_argument("a site- or bond-centred breather needs a chain with free ends");
  if (const auto& all = chain.variation;
      all && !(mirrored(all->mass.begin(), all->mass.end()) &&
               mirrored(all->eta.begin() + 1, all->eta.end() - 1)))
    throw std::invalid_argument("masses and stiffnesses must be symmetric about the centre");
  if (chain.contact.is<OwnContact>() && chain.contact.stiffness(0.0) != 0)
    throw std::invalid_argument(
        "a user-defined contact must not be compressed at rest, because the continuation starts "
        "from uncompressed contacts");
}

/// How many sites, on both sides together, the tail needs to fall to a `part` of the amplitude. Throws InBand unless
/// `omega` is so far above the linear waves of a chain that these are few enough.
static double tail_length(const Chain& chain, double omega, double part) {
  constexpr double longest_tail = 400;
  const PhononBands bands(chain);
  const double length = -2 * std::log(part) / bands.decay(omega);
  const bool above = omega > bands.top();
  if (above && length <= longest_tail) return length;
  throw InBand(six_digits(omega) + (above ? " is too close to" : " is not above") +
               " the linear waves of the chain, " + bands.to_text() + " (allowed: above them)");
}

/// The problem of a breather in the wells of a chain, on a chain like that.
static Shooting<double> problem_like(Centre centre, double omega, const Chain& like,
                                     std::size_t sites) {
  Shooting<double> problem = breather_problem(centre, omega, like.well, sites);
  Chain chain = lengthened(like, sites);
  chain.contact = without_cutoff(like.contact);
  problem.chain = chain;
  return problem;
}

/**
Between contacts that are not compressed the ansatz finds a breather of equal beads, whatever their exponent is;
to all others a path leads from there. */
static Orbit<double> find_like(const Shooting<double>& problem, Phase phase) {
  Shooting<double> first = problem;
  first.chain.variation.reset();
  if (!problem.chain.contact.is<OwnContact>())
    first.chain.contact = without_cutoff(PowerContact{problem.chain.contact.exponent()});
  const Orbit<double> orbit = find_breather(first, phase);
  const bool there = !problem.chain.variation && problem.chain.contact.opening() == 0;
  return there ? orbit : continue_to(first, orbit, problem.chain);
}

// The breather on a short chain that holds a thousandth of its tail, then on longer ones until one holds it all
Fitted fit_chain(Centre centre, double omega, const Chain& like, std::size_t sites,
                 std::size_t usual, double precision, Phase phase) {
  const Contact contact = without_cutoff(like.contact);
  if (!like.variation && like.ends == Ends::free && contact.is<Hertz>())
    return fit_chain(centre, omega, like.well, sites, usual, precision, phase);
  Shooting<double> problem = problem_like(centre, omega, like, usual);
  require_room(problem.chain);
  const double tail = tail_length(problem.chain, omega, std::sqrt(precision));
  const auto longer = [&](double by) { return usual + 2 * std::size_t(std::ceil(by / 2)); };
  problem = problem_like(centre, omega, like, longer(tail_length(problem.chain, omega, 1e-3)));
  Orbit<double> orbit = find_like(problem, phase);
  const auto change_length = [&](std::size_t n) {
    problem = problem_like(centre, omega, like, n);
    orbit = newton(problem, problem.reduce(resized(orbit.start, n)));
  };
  std::size_t needed = 0;
  for (std::size_t ample = longer(std::max(double(usual - 1), tail)); needed == 0;
       ample = 2 * ample - ample % 2) {
    if (ample > 1001)
      throw NewtonFailed("the solution found is not a breather: its tail does not decay", {});
    change_length(ample);
    needed = sites_needed(orbit, precision, contact);
    if (needed == ample) needed = 0;
  }
  const std::size_t n = sites ? sites : std::max(needed, usual);
  if (n < needed) throw ShortChain(needed);
  change_length(n);
  return {problem, orbit};
}

}  // namespace lattice
