// Breathers of chains that are none of the article's: other exponents, compressed contacts, beads of different masses.

#include <numbers>
#include <tuple>

#include "commands/multipliers.hpp"
#include "commands/one_breather.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/orbits/breather.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

const std::string breather = "sec32_newton_breathers breather ";
const std::string multipliers = "sec33_floquet multipliers ";
const std::string barriers = "sec32_barrier barrier ";

/// The accelerations of a chain with free ends, linear wells and contacts of the exponent `alpha` under the compression
/// `d`, written once more.
std::vector<double> forces(const std::vector<double>& y, const std::vector<double>& mass,
                           double alpha, double d) {
  const auto push = [&](double r) {
    return std::pow(std::max(d - r, 0.0), alpha) - std::pow(d, alpha);
  };
  std::vector<double> a(y.size());
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double left = n > 0 ? push(y[n] - y[n - 1]) : 0;
    const double right = n + 1 < y.size() ? push(y[n + 1] - y[n]) : 0;
    a[n] = (left - right - y[n]) / mass[n];
  }
  return a;
}

/// Largest difference after one period from the start, relative to the amplitude, with a leapfrog of `steps` steps.
double missed(std::vector<double> y, const std::vector<double>& mass, double alpha, double d,
              double omega, int steps) {
  const std::vector<double> start = y;
  std::vector<double> v(y.size());
  const double h = 2 * std::numbers::pi / omega / steps;
  for (int k = 0; k < steps; ++k) {
    for (std::size_t n = 0; n < y.size(); ++n) y[n] += h / 2 * v[n];
    const auto a = forces(y, mass, alpha, d);
    for (std::size_t n = 0; n < y.size(); ++n) v[n] += h * a[n], y[n] += h / 2 * v[n];
  }
  double miss = 0, size = 0;
  for (std::size_t n = 0; n < y.size(); ++n) {
    miss = std::max({miss, std::abs(y[n] - start[n]), std::abs(v[n])});
    size = std::max(size, std::abs(start[n]));
  }
  return miss / size;
}

/// A breather that must return, the closer the shorter the steps are.
void check_returns(const std::vector<double>& y, const std::vector<double>& mass, double alpha,
                   double d, double omega) {
  const double coarse = missed(y, mass, alpha, d, omega, 1000);
  const double fine = missed(y, mass, alpha, d, omega, 4000);
  CAPTURE(coarse, fine, omega);
  REQUIRE(std::isfinite(fine));
  CHECK(fine < 1e-5);
  CHECK(fine < coarse / 12);
}

/// A hill between two wells, on which no bead rests.
struct Hill {
  double energy(double y) const { return y * y * (y * y / 2 - 1) / 2; }
  double force(double y) const { return y * (1 - y * y); }
  double stiffness(double y) const { return 3 * y * y - 1; }
};

/// Masses 1 and r in turn, one in the middle of an odd number, and `defect` there.
std::vector<double> masses(std::size_t sites, double r, double defect = 1) {
  std::vector<double> mass(sites, 1);
  for (std::size_t n = 0; n < sites; ++n)
    if ((n + sites / 2) % 2 != 0) mass[n] = r;
  mass[sites / 2] = defect;
  return mass;
}

/// The positions that a command prints.
std::vector<double> profile(const std::string& command) {
  return table_of(command + " --profile").numbers("y");
}

OneBreather asked(double omega, const Contact& contact = {}, const std::vector<double>& mass = {}) {
  OneBreather out;
  out.omega_b = omega;
  out.like.contact = contact;
  out.like.sites = mass.size();
  if (!mass.empty()) vary(out.like, mass, {});
  return out;
}

}  // namespace

TEST_CASE("breathers of any exponent return after a period", "[cli][chains]") {
  for (const double alpha : {1.2, 3.0})
    for (const std::string& centre : {std::string("site"), std::string("bond")}) {
      CAPTURE(alpha, centre);
      const auto y = profile(breather + "--contact power --omega 1.2 --centre " + centre +
                             " --alpha " + std::to_string(alpha));
      CHECK(std::abs(y[y.size() / 2]) > 1e3 * std::abs(y.front()));
      check_returns(y, std::vector<double>(y.size(), 1), alpha, 0, 1.2);
    }
  // The power law with the exponent of spheres is that of spheres, bit for bit
  CHECK(rows(breather + "--contact power --alpha 1.5 --omega 1.3") ==
        rows(breather + "--omega 1.3"));
  CHECK(rows(breather + "--contact power --alpha 1.5001 --omega 1.3") !=
        rows(breather + "--omega 1.3"));
}

TEST_CASE("a path in the exponent ends at the breather of the ansatz", "[property][chains]") {
  for (Centre centre : both_centres) {
    const Shooting<double> spheres = breather_problem(centre, 1.1, 0, sites_of(centre));
    Shooting<double> other = spheres;
    other.chain.contact = PowerContact{1.75};
    const Orbit<double> followed = continue_to(spheres, find_breather(spheres), other.chain);
    const Orbit<double> direct = find_breather(other);
    CHECK(sup<double>(followed.x - direct.x) < 1e-12 * direct.amplitude);
    // Halfway is halfway, in the exponent and in the masses
    Chain heavy = other.chain;
    vary(heavy, std::vector<double>(heavy.sites, 3), {});
    const Chain middle = between(spheres.chain, heavy, 0.5);
    CHECK(middle.contact.exponent() == 1.625);
    CHECK(middle.mass.front() == 2);
  }
  const Shooting<double> problem = breather_problem(Centre::site, 1.1, 0, 31);
  CHECK_THROWS_AS(continue_to(problem, find_breather(problem), Chain{33}), std::invalid_argument);
}

TEST_CASE("a compressed chain has breathers above its band", "[cli][chains]") {
  for (const double d : {1e-4, 1e-3}) {
    const double top = std::sqrt(1 + 6 * std::sqrt(d)), omega = top + 0.12;
    const std::string at = " --precompression " + std::to_string(d) + " --omega ";
    for (const std::string& centre : {std::string("site"), std::string("bond")}) {
      CAPTURE(d, centre);
      const auto y = profile(breather + "--centre " + centre + at + std::to_string(omega));
      check_returns(y, std::vector<double>(y.size(), 1), 1.5, d, std::stod(std::to_string(omega)));
    }
    char band[40];
    std::snprintf(band, sizeof band, "[1, %.6g]", top);
    for (const std::string& command : {breather, multipliers, barriers})
      check_refused(command + at + std::to_string(top - 1e-3), band);
  }
}

TEST_CASE("the linear tail is long enough, and falls at the rate of the band",
          "[property][chains]") {
  OneBreather chosen = asked(1.3, CompressedHertz{1e-3});
  const auto found = chosen.find();
  chosen.sites = found.problem.chain.sites + 20;
  const auto longer = chosen.find();
  // Twenty more sites change nothing, as the wider type sees it
  const auto wide = [](const Fitted& one) {
    return newton(in_precision<Wide>(one.problem), one.orbit, rule<Wide>(0));
  };
  const Orbit<Wide> a = wide(found), b = wide(longer);
  check_close(double(a.energy - b.energy), 0, 1e-15 * double(b.energy));
  check_close(double(a.amplitude - b.amplitude), 0, 1e-15 * double(b.amplitude));
  // A push k y of a last bead is felt: five sites less and the breather is another one
  Shooting<double> shorter = found.problem;
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
  chosen.sites = 9;
  check_line(refusal<UsageError>([&] { chosen.find(); }),
             "--sites: 9 cannot hold this breather's tail");
}

TEST_CASE("bands end at eigenvalues of a ring", "[unit][chains]") {
  for (const double r : {1.0, 0.8, 2.5}) {
    const std::size_t sites = 200;
    Chain chain{sites, Harmonic{}, CompressedHertz{0.02}, Ends::periodic};
    vary(chain, masses(sites, r), {});
    const PhononBands bands(chain);
    const Hessian<double> h = linearise(chain, std::vector<double>(sites));
    Matrix<double> m = Matrix<double>::Zero(sites, sites);
    for (std::size_t i = 0; i < sites; ++i) {
      const std::size_t next = (i + 1) % sites;
      m(Eigen::Index(i), Eigen::Index(i)) = h.diagonal[i] / chain.mass[i];
      m(Eigen::Index(i), Eigen::Index(next)) = h.off[i] / chain.mass[i];
      m(Eigen::Index(next), Eigen::Index(i)) = h.off[i] / chain.mass[next];
    }
    std::vector<double> all;
    for (const auto& z : eigenvalues_of(m)) all.push_back(std::sqrt(z.real()));
    std::sort(all.begin(), all.end());
    check_close(all.front(), bands.edge(false, false), 1e-12);
    check_close(all[sites / 2 - 1], bands.edge(false, true), 1e-12);
    check_close(all[sites / 2], bands.edge(true, true), 1e-12);
    check_close(all.back(), bands.top(), 1e-12);
    CHECK(bands.decay(bands.top() * 1.001) > 0);
    CHECK(bands.decay((bands.top() + bands.edge(true, true)) / 2) == 0);
    CHECK(bands.to_text().find("] and [") ==
          (r == 1 ? std::string::npos : bands.to_text().find(']')));
  }
  const auto on_a_hill = [] { PhononBands(Chain{9, Hill{}, CompressedHertz{0.02}}); };
  check_line(refusal<std::invalid_argument>(on_a_hill), "does not rest stably");
}

TEST_CASE("chains of two masses and with a defect have breathers around a site", "[cli][chains]") {
  for (const auto& [r, defect, omega] : {std::array{0.8, 1.0, 1.3}, std::array{1.5, 1.0, 1.2},
                                         std::array{1.0, 1.5, 1.2}, std::array{0.9, 1.2, 1.3}}) {
    CAPTURE(r, defect, omega);
    const auto y = profile(breather + "--omega " + std::to_string(omega) + " --mass-ratio " +
                           std::to_string(r) + " --defect-mass " + std::to_string(defect));
    check_returns(y, masses(y.size(), r, defect), 1.5, 0, omega);
    CHECK(std::abs(y[y.size() / 2]) > 1e3 * std::abs(y.front()));
  }
  CHECK(rows(breather + "--mass-ratio 1 --defect-mass 1") == rows(breather));
  // Masses that are all one, told one by one, are those of equal beads
  const auto plain = asked(1.3).find(), same = asked(1.3, {}, masses(31, 1)).find();
  check_close(same.orbit.energy, plain.orbit.energy, 0, 1e-12);
  CHECK(sup<double>(same.orbit.x - plain.orbit.x) < 1e-12 * plain.orbit.amplitude);
  // Compression and masses at once, and another exponent
  const auto all = asked(1.5, PowerContact{1.7, 1e-3}, masses(31, 0.9)).find();
  check_returns(all.orbit.start.y, all.problem.chain.mass, 1.7, 1e-3, 1.5);
}

TEST_CASE("the energy of such a breather is conserved", "[property][chains]") {
  const auto found = asked(1.3, CompressedHertz{1e-4}, masses(31, 0.9)).find();
  State<double> state = found.orbit.start;
  const double before = energy(found.problem.chain, state);
  flow(found.problem.chain, state, 3.3);
  CHECK(largest_difference(state, found.orbit.start) > 0.1 * found.orbit.amplitude);
  check_close(energy(found.problem.chain, state), before, 0, 1e-12);
}

TEST_CASE("multipliers of a chain of two masses come in pairs", "[property][chains]") {
  Multipliers chosen;
  chosen.omega_b = 1.3;
  chosen.like.sites = 23;
  vary(chosen.like, masses(23, 0.8), {});
  const Fitted found = find_chosen(chosen, 1e-17);
  const Spectrum all = chosen.find();
  // All of them from the map of a whole period, which knows nothing of pairs
  const auto z = eigenvalues_of(
      monodromy<double>(found.problem.chain, found.orbit.start, found.orbit.period()));
  REQUIRE(z.size() == 2 * found.problem.chain.sites);
  std::complex<double> product = 1;
  for (const auto& one : z) {
    product *= one;
    const auto near = [&](const std::complex<double>& other) {
      return std::abs(other - 1.0 / one) < 1e-5;
    };
    CHECK(std::any_of(z.begin(), z.end(), near));
  }
  CHECK(std::abs(product - 1.0) < 1e-10);
  for (const auto& [one, error] : multipliers_of(all)) {
    const auto near = [&](const std::complex<double>& other) {
      return std::abs(other - one) < 1e-5 + error;
    };
    CHECK(std::any_of(z.begin(), z.end(), near));
  }
  // Far beads of mass 1 and .8 turn alone
  for (const double mass : {1.0, 0.8}) {
    const double turn = -std::pow(std::sin(pi<double>() / 1.3 / std::sqrt(mass)), 2);
    CHECK(std::count_if(all.pairs.begin(), all.pairs.end(),
                        [&](const Pair& p) { return std::abs(p.kappa - turn) < 1e-9; }) >= 4);
  }
}

TEST_CASE("a barrier is the difference of two energies", "[cli][chains]") {
  for (const std::string& chain : {std::string("--contact power --alpha 2 --omega 1.2"),
                                   std::string("--precompression 1e-3 --omega 1.35")}) {
    CAPTURE(chain);
    const Result site = call(breather + chain + " --centre site");
    const Result bond = call(breather + chain + " --centre bond");
    const double gap = quantity(site, "energy") - quantity(bond, "energy");
    const double error = quantity(site, "energy", "error") + quantity(bond, "energy", "error") +
                         1e-15 * quantity(site, "energy");
    const Result both = call(barriers + chain);
    check_close(quantity(both, "equal_frequency"), gap, error);
    CHECK(error < 1e-2 * std::abs(gap));
    CHECK(quantity(both, "equal_frequency", "error") < 1e-6 * std::abs(gap));
  }
}

// Values of a program of its own that follows the breather of harmonic wells in s without a break
TEST_CASE("between steep contacts a hard well has the breather of the harmonic one",
          "[cli][chains]") {
  const std::vector<std::tuple<std::string, double, double>> all{
      {"--centre bond --omega 1.001 --s 5 --alpha 2.9", 0.0150951177668, 0.000229875300978},
      {"--centre site --omega 1.001 --s 5 --alpha 2.9", 0.0190915021178, 0.000192056354810},
      {"--centre site --omega 1.01 --s 3 --alpha 3", 0.0760185322418, 0.00312077634279},
      {"--centre bond --omega 1.0301 --s 8.117 --alpha 2.543", 0.0613860022410, 0.00405195871356}};
  for (const auto& [chain, amplitude, energy] : all) {
    CAPTURE(chain);
    const Result r = call(breather + "--contact power " + chain);
    check_close(quantity(r, "amplitude"), amplitude, 0, 1e-11);
    check_close(quantity(r, "energy"), energy, 0, 1e-11);
  }
  // Near omega_b = 1 the phase of an orbit is rounded by more than its energy
  const Result weak = call(barriers + "--omega 1.00024 --well harmonic");
  check_close(quantity(weak, "equal_frequency"), 4.20579818087e-21,
              quantity(weak, "equal_frequency", "error"));
}

TEST_CASE("what has no breather is refused in one line", "[cli][chains]") {
  for (const std::string& command : {breather, multipliers}) {
    check_refused(command + "--contact power --alpha 1", "allowed range [1.2, 3]");
    check_refused(command + "--contact power --alpha 3.5", "allowed range [1.2, 3]");
    check_refused(command + "--alpha 1.8", "--alpha: 'hertz' has no parameter alpha");
    check_refused(command + "--precompression 0.01 --omega 1.2", "[1, 1.26491]");
    check_refused(command + "--mass-ratio 0.8", "--omega: 1.1 is not above the linear waves");
    check_refused(command + "--mass-ratio 0.8 --precompression 1e-4 --omega 1.1", "] and [1.1");
    check_refused(command + "--mass-ratio 0", "allowed range [0.1, 10]");
    check_refused(command + "--mass-ratio 0.8 --centre bond", "--mass-ratio: such beads are not");
    check_refused(command + "--defect-mass 2 --centre bond", "--defect-mass: such beads are not");
    check_refused(command + "--precompression 1e-3 --omega 1.3 --sites 15", "--sites: 15");
    check_refused(command + "--well none --precompression 0.1", "there is no breather");
  }
  // A chain of one's own
  const auto said = [](const OneBreather& one) {
    return refusal<std::invalid_argument>([&] { one.find(); });
  };
  std::vector<double> odd = masses(31, 1);
  odd[3] = 2;
  check_line(said(asked(1.2, {}, odd)), "must be symmetric about the centre");
  check_line(said(asked(1.2, {}, masses(30, 1))), "another centre");
  OneBreather ring = asked(1.2);
  ring.like.ends = Ends::periodic;
  check_line(said(ring), "free ends");
  // Where a path ends there is a history
  const Result lost = call(breather + "--defect-mass 10");
  CAPTURE(lost.errors);
  CHECK(lost.code == 1);
  CHECK(lost.error_lines() == 1);
  CHECK(lost.errors.find("the path to this chain ends after") != std::string::npos);
  CHECK(lost.errors.find("relative residuals") != std::string::npos);
}
