// Breathers: that they return, their guess, the length of their chain, other chains, barriers.

#include "lattice/orbits/breather.hpp"

#include <limits>
#include <numbers>

#include "commands/one_barrier.hpp"
#include "commands/one_breather.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/model/potential_names.hpp"
#include "lattice/quadruple/orbits.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/breather_pairs.hpp"
#include "sec3/resolutions.hpp"
#include "support/check.hpp"
#include "support/return_error.hpp"
#include "support/states.hpp"

using namespace lattice;
using namespace report;

namespace {

using Problem = Shooting<double>;

/// Masses 1 and r in turn, one in the middle of an odd number, and `defect` there.
std::vector<double> masses(std::size_t sites, double r, double defect = 1) {
  std::vector<double> mass(sites, 1);
  for (std::size_t n = 0; n < sites; ++n)
    if ((n + sites / 2) % 2 != 0) mass[n] = r;
  mass[sites / 2] = defect;
  return mass;
}

OneBreather asked(double omega, const Contact& contact = {}, const std::vector<double>& mass = {}) {
  OneBreather out;
  out.omega_b = omega;
  out.like.contact = contact;
  out.like.sites = mass.size();
  if (!mass.empty()) vary(out.like, mass, {});
  return out;
}

/// Largest difference after one period from the start, over the amplitude, by a leapfrog of `steps` steps through
/// linear wells and contacts of the exponent `alpha` under the compression `d`, written once more.
double missed(const Fitted& found, double alpha, double d, int steps) {
  const std::vector<double>& start = found.orbit.start.y;
  const std::size_t sites = start.size();
  const Chain& chain = found.problem.chain;
  std::vector<double> y = start, v(sites);
  const auto push = [&](std::size_t n) {  // of bead n - 1 and bead n
    const double r = n == 0 || n == sites ? 0 : y[n] - y[n - 1];
    return std::pow(std::max(d - r, 0.0), alpha) - std::pow(d, alpha);
  };
  const double h = found.orbit.period() / steps;
  for (int k = 0; k < steps; ++k) {
    for (std::size_t n = 0; n < sites; ++n) y[n] += h / 2 * v[n];
    for (std::size_t n = 0; n < sites; ++n)
      v[n] += h * (push(n) - push(n + 1) - y[n]) / chain.mass_of(n);
    for (std::size_t n = 0; n < sites; ++n) y[n] += h / 2 * v[n];
  }
  double miss = 0;
  for (std::size_t n = 0; n < sites; ++n)
    miss = std::max({miss, std::abs(y[n] - start[n]), std::abs(v[n])});
  return miss / found.orbit.amplitude;
}

/// A contact that pushes like `k` times a sphere and stiffens when it is squeezed.
struct Layer {
  double k = 1, exponent = 1.5;
  double opening() const { return 0; }
  static double overlap(double r) { return std::max(-r, 0.0); }
  double energy(double r) const {
    return k * (0.4 * std::pow(overlap(r), 2.5) + std::pow(overlap(r), 3.5));
  }
  double force(double r) const {
    return k * (std::pow(overlap(r), 1.5) + 3.5 * std::pow(overlap(r), 2.5));
  }
  double stiffness(double r) const {
    return k * (1.5 * std::pow(overlap(r), 0.5) + 8.75 * std::pow(overlap(r), 1.5));
  }
};

/// Springs of frequency one that are stiffer on one side, or that lose digits near rest.
struct Toda {
  double energy(double y) const { return std::expm1(-y) + y; }
  double force(double y) const { return std::expm1(-y); }
  double stiffness(double y) const { return std::exp(-y); }
};
struct Naive {
  double energy(double y) const { return (std::exp(y) + std::exp(-y)) / 2 - 1; }
  double force(double y) const { return (std::exp(-y) - std::exp(y)) / 2; }
  double stiffness(double y) const { return std::cosh(y); }
};

}  // namespace

TEST_CASE("a breather returns after its period", "[property][periodic]") {
  for (Centre centre : both_centres)
    for (const auto& [omega, s] : {std::pair{1.003, 0.0}, {1.1, -1.0 / 6}, {1.5, 1.0}}) {
      CAPTURE(int(centre), s, omega);
      const auto p = problem_of(centre, omega, s);
      const Orbit<double> o = find_breather(p);
      CHECK(return_error(p, o) < 4e-13);
      CHECK(o.residual() < 2e-13);
    }
}

TEST_CASE("the two phases of a bond-centred breather are half a period apart",
          "[property][periodic]") {
  const auto p = problem_of(Centre::bond, 1.1);
  const auto pressed = find_breather(p), stretched = find_breather(p, Phase::stretched);
  CHECK(pressed.start.y[15] > 0);
  CHECK(stretched.start.y[15] < 0);
  State<double> later = pressed.start;
  flow(p.chain, later, p.period() / 2);
  CHECK(largest_difference(later, stretched.start) < 1e-12 * pressed.amplitude);
  check_close(pressed.energy, stretched.energy, 0, 1e-12);
  check_close(pressed.action_integral, stretched.action_integral, 0, 1e-12);
}

TEST_CASE("breathers of other chains return by another integrator", "[property][chains]") {
  struct Other {
    double omega, alpha, d = 0, r = 1, defect = 1;
    bool at_bond = false;
  };
  for (const Other& o : {Other{1.2, 1.2},
                         {1.2, 1.5, 1e-4, 1, 1, true},
                         {1.2, 1.5, 0, 1.5, 1.2},
                         {1.5, 1.7, 1e-3, 0.9}}) {
    CAPTURE(o.omega, o.alpha, o.d, o.r, o.defect, o.at_bond);
    OneBreather one =
        asked(o.omega, PowerContact{o.alpha, o.d},
              o.r == 1 && o.defect == 1 ? std::vector<double>{} : masses(31, o.r, o.defect));
    if (o.at_bond) one.centre = Centre::bond;
    const Fitted found = one.find();
    const auto& y = found.orbit.start.y;
    if (o.d == 0) CHECK(std::abs(y[y.size() / 2]) > 1e3 * std::abs(y.front()));
    const double coarse = missed(found, o.alpha, o.d, 1000),
                 fine = missed(found, o.alpha, o.d, 4000);
    CAPTURE(coarse, fine);
    CHECK(fine < 1e-5);
    CHECK(fine < coarse / 12);
  }
}

TEST_CASE("contacts of any exponent have breathers of the size that is guessed",
          "[property][orbits]") {
  for (Centre centre : both_centres) {
    const std::size_t sites = sites_of(centre, Length::shortest);
    for (const Contact& contact :
         {Contact(PowerContact{1.2}), Contact(PowerContact{3}), Contact(PowerContact{6}),
          Contact(Layer{}), Contact(Layer{10})}) {
      Problem problem = breather_problem(centre, 1.05, 0, sites);
      problem.chain.contact = contact;
      CAPTURE(contact.exponent());
      const Orbit<double> orbit = find_breather(problem);
      const auto guess = ansatz(centre, 1.05, sites, Phase::compressed, contact);
      check_close(orbit.amplitude / largest(guess), 1, 0.3);
      CHECK(return_error(problem, orbit) < 1e-11);
    }
    // A power that is no root: the guess is that of the article's contacts
    const auto spheres = ansatz(centre, 1.05, sites);
    const auto same = ansatz(centre, 1.05, sites, Phase::compressed, PowerContact{1.5});
    CHECK(largest_difference(spheres, same) < 1e-14 * largest(spheres));
  }
  // With alpha = 2 the envelope is cos^4(x/2)/9, and the first harmonic of the force is 4/(3 pi)
  const auto guess = ansatz(Centre::bond, 1.1, 8, Phase::compressed, PowerContact{2});
  check_close(guess.y[3], 0.15 * M_PI * (1 + std::pow(std::cos(0.5), 4)) / 9, 1e-14);
  CHECK_THROWS_AS(ansatz(Centre::site, 1.05, 21, Phase::compressed, PowerContact{1}),
                  std::invalid_argument);
}

// Values of a program of its own that follows the breather of harmonic wells in s without a break
TEST_CASE("between steep contacts a hard well has the breather of the harmonic one",
          "[property][chains]") {
  struct {
    Centre centre;
    double omega, s, alpha, amplitude, energy;
  } const rows[] = {{Centre::site, 1.01, 3, 3, 0.0760185322418, 0.00312077634279},
                    {Centre::bond, 1.0301, 8.117, 2.543, 0.0613860022410, 0.00405195871356}};
  for (const auto& [centre, omega, s, alpha, amplitude, energy] : rows) {
    CAPTURE(omega, s, alpha);
    OneBreather one = asked(omega, PowerContact{alpha});
    one.centre = centre, one.well = Quartic{s};
    const Orbit<double> orbit = one.find().orbit;
    check_close(orbit.amplitude, amplitude, 0, 1e-11);
    check_close(orbit.energy, energy, 0, 1e-11);
  }
}

// Values of a program of its own, in 113 bits
TEST_CASE("near omega_b = 1 a breather is found, and all of its sites with their errors",
          "[property][chains]") {
  struct {
    Centre centre;
    double omega, alpha, amplitude;
  } const rows[] = {{Centre::site, 1.01, 3, 0.08744770302678816879},
                    {Centre::site, 1.003, 3, 0.047678746569009171053},
                    {Centre::bond, 1.003, 3, 0.040907607931452184724},
                    {Centre::bond, 1.001, 2.5, 0.0077725859206916417},
                    {Centre::bond, 1.0001, 2.5, 0.0016739364893801590},
                    {Centre::bond, 1.0003, 2.5, 0.0034822133207912221},
                    {Centre::bond, 1.0001, 1.5, 8.8302539615644339219e-9},
                    {Centre::bond, 1.2, 1.5, 0.043145709940452627532}};
  for (const auto& [centre, omega, alpha, amplitude] : rows) {
    CAPTURE(omega, alpha);
    OneBreather one = asked(omega, PowerContact{alpha});
    one.centre = centre;
    const FoundOrbit found = one.find();
    const Table table = one.quantities(found);
    check_close(table.numbers("value")[0], amplitude, table.numbers("error")[0]);
    Estimate most = exact(0);
    for (const Estimate& y : found.y)
      if (std::abs(y.value) > most.value) most = {std::abs(y.value), y.error};
    check_close(most.value, amplitude, most.error);
    CHECK(most.error < 1e-11 * amplitude);
  }
}

TEST_CASE("what has no breather is refused in one line", "[unit][chains]") {
  const auto in = [](const Well& well) {
    return refusal<std::invalid_argument>([&] { breather_problem(Centre::site, 1.1, well, 21); });
  };
  CHECK(in(Toda{}) == "a site- or bond-centred breather needs symmetric wells, W(-y) = W(y)");
  CHECK(in(Naive{}) == digits_hint);
  check_line(in(NoWell{}), "W''(0) = 1");
  for_each_potential<Well>([&](const auto& well) {
    if (well.stiffness(0.0) == 1) CHECK(in(OwnWell(well)) == "");
  });
  CHECK_THROWS_AS(breather_problem(Centre::site, 1.1, 0, 30), std::invalid_argument);
  CHECK_THROWS_AS(breather_problem(Centre::bond, 1.1, 0, 31), std::invalid_argument);
  const auto said = [](const OneBreather& one) { return refusal([&] { one.find(); }); };
  std::vector<double> odd = masses(31, 1);
  odd[3] = 2;
  check_line(said(asked(1.2, {}, odd)), "must be symmetric about the centre");
  check_line(said(asked(1.2, {}, masses(30, 1))), "do not fit a breather");
  OneBreather ring = asked(1.2), shorter = asked(1.3, CompressedHertz{1e-3});
  ring.like.ends = Ends::periodic;
  check_line(said(ring), "free ends");
  shorter.sites = 9;
  check_line(said(shorter), "--sites: 9 are too few for this breather's tail");
  check_line(said(asked(1.2, CompressedHertz{1e-2})), "[1, 1.26491]");
  check_line(said(asked(1.1, CompressedHertz{1e-4}, masses(31, 0.8))), "] and [1.1");
  // Where a path ends there is a history
  const std::string lost = said(asked(1.1, {}, masses(31, 1, 10)));
  CHECK(lost.find("continuation to this chain stops at the fraction") != std::string::npos);
  CHECK(lost.find("relative residuals") != std::string::npos);
}

TEST_CASE("the discrete gradient, its direction, and how many sites a tail needs",
          "[unit][orbits]") {
  const Vector<double> g = discrete_gradient({1, 2, 4, 8, 16});
  CHECK(g == (Vector<double>(5) << 0, 3, 6, 12, 0).finished());
  check_close(alignment(g, -2 * g), 1, 1e-15);
  check_close(alignment(Vector<double>::Unit(5, 1), Vector<double>(g)), 3 / std::sqrt(189.0),
              1e-15);
  // A tail of which the power 3/2 is below the precision times (omega^2 - 1) times the amplitude
  Orbit<double> orbit;
  orbit.omega = 1.5, orbit.amplitude = 0.8;
  const double bound = 1e-6 * 1.25 * 0.8, edge = std::pow(bound, 2.0 / 3);
  const auto needed = [&](std::vector<double> y) {
    orbit.start.y = std::move(y);
    return sites_needed(orbit, 1e-6);
  };
  const double weak = 0.99 * edge, strong = 1.01 * edge;
  CHECK(needed({0, 0, weak, strong, 1, -1, -strong, -weak, 0, 0}) == 6);
  CHECK(needed({0, weak, weak, 1, -1, -strong, -weak, 0}) == 6);  // both ends have to be weak
  CHECK(needed({0, weak, strong, 1, -1, -weak, -weak, 0}) == 6);
  CHECK(needed({0, strong, 1, -1, -strong, 0}) == 6);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0, 0}) == 4);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0}) == 3);
}

TEST_CASE("the linear tail is long enough, and falls at the rate of the band",
          "[property][chains]") {
  OneBreather chosen = asked(1.3, CompressedHertz{1e-3});
  const auto found = chosen.find();
  chosen.sites = found.problem.chain.sites + 20;
  const auto longer = chosen.find();
  // Twenty more sites change nothing, as the wider type sees it
  const auto wide = [](const Fitted& one) {
    return newton(in_precision<Wide>(one.problem), one.orbit, rule<Wide>(Resolution::fine));
  };
  const Orbit<Wide> a = wide(found), b = wide(longer);
  check_close(double(a.energy - b.energy), 0, 1e-15 * double(b.energy));
  check_close(double(a.amplitude - b.amplitude), 0, 1e-15 * double(b.amplitude));
  // A push k y of a last bead is felt: five sites less and the breather is another one
  Problem shorter = found.problem;
  shorter.chain = lengthened(shorter.chain, 11);
  shorter.symmetry = centred(Centre::site, 11);
  const Orbit<double> cut = newton(shorter, shorter.reduce(resized(found.orbit.start, 11)));
  CHECK(std::abs(cut.energy - found.orbit.energy) > 1e-12 * found.orbit.energy);
  // Half a period later the mirror image has the other sign: half the sum has no constant part
  const double rho = PhononBands(found.problem.chain).decay(1.3);
  check_close(std::cosh(rho), 0.69 / (3 * std::sqrt(1e-3)) - 1, 0, 1e-12);
  const auto& y = longer.orbit.start.y;
  const std::size_t middle = y.size() / 2;
  const auto odd = [&](std::size_t n) { return std::abs(y[middle + n] + y[middle - n]); };
  check_close(std::log(odd(8) / odd(9)), rho, 0, 1e-4);
}

TEST_CASE("bands end at eigenvalues of a ring", "[unit][chains]") {
  for (const auto& [r, eta] : {std::pair{1.0, 1.0}, {0.8, 1.0}, {2.5, 1.0}, {0.8, 1.3}}) {
    const std::size_t sites = 40;
    Chain chain{sites, Harmonic{}, CompressedHertz{0.02}, Ends::periodic};
    std::vector<double> stiffness(sites + 1, 1);
    for (std::size_t i = 1; i < sites; i += 2) stiffness[i] = eta;
    vary(chain, masses(sites, r), stiffness);
    const PhononBands bands(chain);
    const Hessian h = linearise(chain, std::vector<double>(sites));
    Matrix<double> m = Matrix<double>::Zero(sites, sites);
    for (std::size_t i = 0; i < sites; ++i) {
      const std::size_t next = (i + 1) % sites;
      m(Eigen::Index(i), Eigen::Index(i)) = h.diagonal[i] / chain.mass_of(i);
      m(Eigen::Index(i), Eigen::Index(next)) = h.off[i] / chain.mass_of(i);
      m(Eigen::Index(next), Eigen::Index(i)) = h.off[i] / chain.mass_of(next);
    }
    std::vector<double> all;
    for (const auto& z : eigenvalues_of(m)) all.push_back(std::sqrt(z.real()));
    std::sort(all.begin(), all.end());
    check_close(all.front(), bands.edge(false, false), 1e-12);
    check_close(all[sites / 2 - 1], bands.edge(false, true), 1e-12);
    check_close(all[sites / 2], bands.edge(true, true), 1e-12);
    check_close(all.back(), bands.top(), 1e-12);
    // Above the bands a linear wave grows over two sites as their transfer matrix says
    const double k = 1.5 * std::sqrt(0.02), w = std::pow(1.01 * bands.top(), 2);
    const auto transfer = [&](double m, double before, double after) {
      const double a = 1 + before + after;
      return (Eigen::Matrix2d() << (a - m * w) / after, -before / after, 1, 0).finished();
    };
    const double trace = (transfer(1, k, eta * k) * transfer(r, eta * k, k)).trace();
    check_close(2 * bands.decay(std::sqrt(w)), std::acosh(std::abs(trace) / 2), 0, 1e-12);
    CHECK(bands.decay((bands.top() + bands.edge(true, true)) / 2) == 0);
    CHECK(bands.to_text().find("] and [") ==
          (r == 1 && eta == 1 ? std::string::npos : bands.to_text().find(']')));
  }
  const auto on_a_hill = [] { PhononBands(Chain{9, Hill{}, CompressedHertz{0.02}}); };
  check_line(refusal<std::invalid_argument>(on_a_hill), "its rest state is unstable");
}

namespace {

/// E_site - E_bond with a mantissa of 113 bits: double precision finds both orbits, the wider type adds digits.
Quadruple wide_gap(double omega, double s, double tolerance) {
  Quadruple energy[2];
  for (int k : {0, 1}) {
    const auto problem =
        breather_problem(both_centres[k], omega, s, sites_of(both_centres[k], Length::shortest));
    NewtonRule<Quadruple> how;
    how.events.tolerance = Quadruple(tolerance);
    const auto orbit = newton(in_precision<Quadruple>(problem), find_breather(problem), how);
    CHECK(orbit.residual() < 1e-27);
    CHECK(double(orbit.error) < 20 * tolerance);
    energy[k] = orbit.energy;
  }
  return energy[0] - energy[1];
}

}  // namespace

TEST_CASE("barriers agree with an independent computation", "[published][periodic]") {
  // By another implementation of Newton's method in quadruple precision
  const struct {
    double omega, s, expected;
  } rows[] = {{1.1, 0, 1.62422471641e-11},
              {1.01, 0, 2.704657e-15},
              {2.0, 0, -2.15054e-6},
              {1.1, 0.2, -7.6413e-12}};
  for (const auto& [omega, s, expected] : rows) {
    CAPTURE(omega, s);
    const auto ps = problem_of(Centre::site, omega, s), pb = problem_of(Centre::bond, omega, s);
    const auto site = find_breather(ps), bond = find_breather(pb);
    const auto gap = barrier(ps, site, bond);
    check_close(gap.equal_frequency, expected, 0, 1e-5);
    auto moved = ps;
    moved.omega = gap.omega_site;
    check_close(newton(moved, site.x).action_integral, bond.action_integral, 0, 1e-10);
  }
}

TEST_CASE("the barrier at 1.1 with mantissas of 53, 64 and 113 bits", "[published][periodic]") {
  static_assert(std::numeric_limits<Quadruple>::digits == 113);
  const double gap(wide_gap(1.1, 0, 1e-27));
  check_close(gap, 1.62422471640638e-11, 0, 1e-14);
  // The difference of the narrower types is within their errors, and these are small
  BreatherPair pair{.s = 0, .omega = 1.1};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(pair.problem(k));
  measure_in<double>(pair);
  check_close(pair.equal_frequency.value, gap, pair.equal_frequency.error);
  CHECK(pair.equal_frequency.error < 2e-5 * gap);
  measure_in<Wide>(pair);
  check_close(pair.equal_frequency.value, gap, pair.equal_frequency.error);
  CHECK(pair.equal_frequency.error < 1e-8 * gap);
}

TEST_CASE("barriers of other wells and contacts", "[property][chains]") {
  const auto found = [](const ChosenBreather& one) {
    OneBarrier command;
    static_cast<ChosenBreather&>(command) = one;
    return command.find();
  };
  // At equal area, by breathers whose frequency a program of its own changed until the areas were equal
  struct {
    double omega, s, alpha, gap, known;
  } const cases[] = {{2, 10, 1.5, 0.0588436529162, 1e-12},
                     {1.0035344741615633, 0, 2.8123385152184204, -2.86308885458e-08, 1e-18}};
  for (const auto& [omega, s, alpha, gap, known] : cases) {
    OneBreather one = asked(omega);
    if (alpha != 1.5) one = asked(omega, PowerContact{alpha});
    one.well = Quartic{s};
    CAPTURE(omega, s, alpha);
    const Estimate area = found(one).equal_action;
    check_close(area.value, gap, known + area.error);
    CHECK(area.error < 1e-7 * std::abs(gap));
  }
  // Near omega_b = 1 the phase of an orbit is rounded by more than its energy
  const Estimate weak = found(asked(1.00024)).equal_frequency;
  check_close(weak.value, 4.20579818087e-21, weak.error);
}

TEST_CASE("a zero of the barrier does not depend on the pairs around it",
          "[convergence][periodic]") {
  const auto zero = [](double from, double to) {
    BreatherPair pairs[] = {{0, from}, {0, to}};
    for (BreatherPair& r : pairs) {
      for (int k : {0, 1}) r.orbit[k] = find_breather(problem_of(both_centres[k], r.omega));
      measure_in<Wide>(r);
    }
    return frequency_of_zero(pairs[0], pairs[1]);
  };
  const Estimate a = zero(1.05, 1.075), b = zero(1.06, 1.065);
  CAPTURE(a.value, a.error, b.value, b.error);
  CHECK(std::abs(a.value - b.value) <= a.error + b.error);
  CHECK(a.error < 1e-8);
}
