// Periodic orbits beyond the static breathers of a uniform chain: defects, rings, travelling orbits, and
// what Newton's method refuses.

#include "lattice/gsl/random.hpp"
#include "lattice/model/potential_names.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec3/branches.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

using Problem = Shooting<double>;

/// Largest difference of the state after one period, shifted back by `shift` sites on a ring, from
/// the start.
double return_error(const Problem& problem, const Orbit<double>& orbit, std::size_t shift) {
  State<double> end = orbit.start;
  flow(problem.chain, end, orbit.period());
  State<double> back = end;
  const std::size_t n = end.y.size();
  for (std::size_t i = 0; i < n; ++i) {
    back.y[i] = end.y[(i + shift) % n];
    back.v[i] = end.v[(i + shift) % n];
  }
  return largest_difference(back, orbit.start) / orbit.amplitude;
}

}  // namespace

TEST_CASE("a chain with a heavy bead has a breather without mirror symmetry",
          "[property][orbits]") {
  // The bead beside the centre is made heavier step by step: the breather follows.
  Problem problem = breather_problem(Centre::site, 1.1, 0, 21);
  const Orbit<double> plain = find_breather(problem);
  vary(problem.chain, std::vector<double>(21, 1), {});
  problem.symmetry = even_in_time(21);
  const Along<double> mass{"mass", [](const Problem& p) { return p.chain.mass[11]; },
                           [](Problem& p, const double& m) {
                             auto masses = p.chain.mass;
                             masses[11] = m;
                             vary(p.chain, masses, {});
                           },
                           1e-5};
  Branch branch(problem, mass, newton(problem, problem.reduce(plain.start)), 1, {},
                {.first = 1e-3, .least = 1e-7, .most = 0.05});
  for (int k = 0; k < 12; ++k) branch.advance();
  const Problem there = branch.problem();
  const Orbit<double> orbit = newton(there, branch.unknowns());
  CAPTURE(there.chain.mass[11]);
  CHECK(return_error(there, orbit, 0) < 1e-11);
  CHECK(std::abs(orbit.start.y[11] - orbit.start.y[9]) > 1e-2 * orbit.amplitude);
}

TEST_CASE("a wave on a ring travels one site in the time it is asked to", "[property][orbits]") {
  // A wave of wave number 2 pi / 8 and amplitude 0.01; the linear frequency is one.
  const std::size_t sites = 8;
  const double q = 2 * pi<double>() / double(sites);
  Problem problem;
  problem.chain.sites = sites;
  problem.chain.ends = Ends::periodic;
  problem.chain.contact = Hertz{.floor = 0};
  problem.symmetry = travelling(sites, 1, true);
  State<double> guess(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    guess.y[n] = 0.02 * std::cos(q * double(n));
    guess.v[n] = 0.02 * std::sin(q * double(n));
  }
  problem.omega = 2 * pi<double>() / (q / 1.03);  // a period is the time of one shift
  NewtonRule<double> rule;
  rule.rank = 1e-9;
  const Orbit<double> orbit = newton(problem, problem.reduce(guess), rule);
  CHECK(return_error(problem, orbit, 1) < 1e-12);
  CHECK(orbit.amplitude > 1e-3);
  // After eight shifts everything is where it was.
  State<double> end = orbit.start;
  flow(problem.chain, end, 8 * orbit.period());
  CHECK(largest_difference(end, orbit.start) < 1e-11 * orbit.amplitude);
}

TEST_CASE("equations and unknowns of every symmetry fit the chain", "[unit][orbits]") {
  for (const Symmetry& s :
       {even_in_time(7), bond_centred(8), site_centred(7), returning(5), travelling(6, 1, true)}) {
    CAPTURE(s.name);
    for (const Combination& unknown : s.unknowns)
      for (const Term& term : unknown) CHECK(term.index < 2 * s.sites);
    for (const Equation& equation : s.equations) REQUIRE_FALSE(equation.end.empty());
    const std::size_t unknowns = s.unknowns.size() + (s.free_period ? 1 : 0);
    CHECK(s.equations.size() >= unknowns);
  }
}

TEST_CASE("the slopes along a branch are those between its orbits", "[unit][orbits]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto at = [&](double omega) {
      return find_breather(breather_problem(centre, omega, 0.3, centre == Centre::site ? 7 : 8));
    };
    const double h = 1e-4;
    const auto here = at(1.2), faster = at(1.2 + h), slower = at(1.2 - h);
    const Vector<double> between = (faster.x - slower.x) / (2 * h);
    CHECK(sup<double>(between) > 1e-2);
    CHECK(sup<double>(between - here.x_omega) < 1e-5 * sup<double>(between));
    check_close(here.energy_omega, (faster.energy - slower.energy) / (2 * h), 0, 1e-5);
  }
}

TEST_CASE("an orbit is refused where its flow is not accurate", "[unit][orbits]") {
  const Problem good = breather_problem(Centre::site, 1.1, 0, 31);
  const Orbit<double> orbit = find_breather(good);
  const auto careless = [&](std::size_t missed, double error) {
    Equations<double> out = good.equations();
    out.evaluate = [=, &good](const Vector<double>& x, const EventTolerance<double>& rule,
                              bool derivative) {
      Evaluation<double> here = good.evaluate(x, rule, derivative);
      here.flow.missed_events += missed;
      here.flow.error += error;
      return here;
    };
    return out;
  };
  CHECK_NOTHROW(newton(careless(0, 0), orbit.x));
  CHECK_THROWS_AS(newton(careless(1, 0), orbit.x), NewtonFailed);
  NewtonRule<double> every;  // ends a step at every event, and still may not miss one that matters
  every.events.floor = 0;
  CHECK_NOTHROW(newton(careless(0, 0), orbit.x, every));
  CHECK_THROWS_AS(newton(careless(1, 0), orbit.x, every), NewtonFailed);
  CHECK_THROWS_AS(newton(careless(0, 1e-9), orbit.x), NewtonFailed);
  // The same by an integrator that is given too few levels and too large a tolerance to hide it.
  NewtonRule<double> coarse;
  coarse.events.levels = 1;
  CHECK_THROWS_AS(newton(good, orbit.x, coarse), NewtonFailed);
}

TEST_CASE("Newton's method takes any residual", "[unit][orbits]") {
  // Where a circle meets a hyperbola, from differences and from a derivative that was computed before
  const auto residual = [](const Vector<double>& x) {
    return Vector<double>{{x[0] * x[0] + x[1] * x[1] - 4, x[0] * x[1] - 1}};
  };
  const Equations<double> equations = by_differences("the crossing", residual, 1e-6);
  const Vector<double> guess{{2, 0.5}};
  const Solution<double> found = newton(equations, guess);
  check_close(found.x[0], std::sqrt(2 + std::sqrt(3.0)), 1e-14);
  check_close(found.x[0] * found.x[1], 1, 1e-14);
  CHECK(found.history.size() < 7);
  const Matrix<double> derivative{{4, 1}, {0.5, 2}};
  const Solution<double> chord = newton(equations, guess, {}, &derivative);
  CHECK(sup<double>(chord.x - found.x) < 1e-13);
  CHECK(chord.evaluation.jacobian == derivative);
  CHECK(refusal<NewtonFailed>([&] {
          newton(equations, Vector<double>{{1, -1}});
        }).find("the crossing: ") == 0);
}

TEST_CASE("damped Newton converges from where the plain one runs away", "[property][orbits]") {
  const Problem problem = breather_problem(Centre::site, 1.1, 0, 21);
  const Orbit<double> orbit = find_breather(problem);
  NewtonRule<double> damped;
  damped.damped = true;
  damped.most_steps = 60;
  std::size_t found = 0;
  for (unsigned long seed = 1; seed <= 4; ++seed) {
    State<double> start = orbit.start;
    start.y = shaken(start.y, 0.5, seed);
    try {
      const Orbit<double> other = newton(problem, problem.reduce(start), damped);
      CHECK(return_error(problem, other, 0) < 1e-11);
      ++found;
    } catch (const NewtonFailed& error) {
      CHECK(error.history.size() > 1);
    }
  }
  CHECK(found >= 2);
}

TEST_CASE("extended precision refines with the derivative of double precision",
          "[convergence][orbits]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const Problem problem = breather_problem(centre, 1.1, 0, centre == Centre::site ? 31 : 32);
    const Orbit<double> orbit = find_breather(problem);
    const auto wide = in_precision<long double>(problem);
    const auto chord = newton(wide, orbit);
    const auto full = newton(wide, orbit.x.cast<long double>().eval());
    CHECK(sup<long double>(chord.x - full.x) < 1e-15L * full.amplitude);
    CHECK(chord.residual() < 1e-15);
    check_close(double(chord.energy_omega), double(full.energy_omega), 0, 1e-9);
  }
}

TEST_CASE("the branch of a soft well folds where no breather lies beyond", "[property][orbits]") {
  const auto problem = [](double omega) { return breather_problem(Centre::site, omega, -1.0, 31); };
  const Orbit<double> start = find_breather(problem(1.6));
  const Estimate fold = fold_of(problem(1.6), start);
  CAPTURE(fold.value, fold.error);
  CHECK(fold.error < 1e-5);
  CHECK(find_breather(problem(fold.value - 1e-3)).amplitude > start.amplitude);
  CHECK_THROWS(find_breather(problem(fold.value + 1e-3)));
}

TEST_CASE("a branch follows any parameter of its problem", "[property][orbits]") {
  // Towards a heavier central bead, and back to the same breather by the frequency.
  const Problem problem = breather_problem(Centre::site, 1.1, 0, 21);
  Problem even = problem;
  even.symmetry = even_in_time(21);
  vary(even.chain, std::vector<double>(21, 1), {});
  const auto set = [](Problem& p, const double& m) {
    auto masses = p.chain.mass;
    masses[10] = m;
    vary(p.chain, masses, {});
  };
  const Along<double> mass{"mass", [](const Problem& p) { return p.chain.mass[10]; }, set, 1e-3};
  const Orbit<double> start = newton(even, even.reduce(find_breather(problem).start));
  Branch branch(even, mass, start, 1);
  const Orbit<double> heavy = branch.orbit_at(1.02);
  Problem there = even;
  set(there, 1.02);
  CHECK(return_error(there, heavy, 0) < 1e-12);
  CHECK(std::abs(heavy.energy - start.energy) > 1e-3 * start.energy);
}

namespace {

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

/// The quartic well, but by another name, so that nothing is known of its anharmonicity.
struct Nameless {
  double s;
  double energy(double y) const { return y * y / 2 + s * y * y * y * y / 4; }
  double force(double y) const { return -y - s * y * y * y; }
  double stiffness(double y) const { return 1 + 3 * s * y * y; }
};

}  // namespace

TEST_CASE("a large extended motion is not taken for a breather", "[unit][orbits]") {
  // Newton's method converges to a motion of energy 65.8, with an error of 1e-13
  Problem problem = breather_problem(Centre::site, 1.1, Nameless{5}, 61);
  problem.chain.contact = PowerContact{2.8};
  check_line(refusal<NewtonFailed>([&] { find_breather(problem); }),
             "instead of the breather a motion of size");
  // Nor is one whose middle beads move together
  problem = breather_problem(Centre::site, 1.01, Nameless{3}, 61);
  problem.chain.contact = PowerContact{3};
  const std::string why = refusal<NewtonFailed>([&] { find_breather(problem); });
  CHECK(why.find("in which neighbours are in phase") != std::string::npos);
  // Where the well is known the breather is followed from the harmonic one; by a program of its own
  problem = breather_problem(Centre::site, 1.1, 5, 61);
  problem.chain.contact = PowerContact{2.8};
  check_close(find_breather(problem).energy, 0.0240396465322176, 0, 1e-12);
}

TEST_CASE("an iteration that leaps to violent motions ends", "[unit][orbits]") {
  // Its next flow took minutes, and the one after that for ever
  for (const auto& [alpha, s] : {std::pair(2.5, 3.0), {2.5, 3.1}, {2.5, 2.9}}) {
    Problem problem = breather_problem(Centre::site, 1.1, Nameless{s}, 61);
    problem.chain.contact = PowerContact{alpha};
    CAPTURE(alpha, s);
    const std::string why = refusal<NewtonFailed>([&] { find_breather(problem); });
    CHECK(why.find("it leaps off, from a guess of size 0.2 to") != std::string::npos);
  }
}

TEST_CASE("an orbit that shrinks to rest is none", "[unit][orbits]") {
  // The breather of spheres is a bad guess for other contacts: numbers of size 1e-321 came of it
  Problem problem = breather_problem(Centre::bond, 1.05, 0, 16);
  problem.chain.contact = PowerContact{1.75};
  const State<double> guess = ansatz(Centre::bond, 1.05, 16);
  const auto far = [&] { newton(problem, problem.reduce(guess)); };
  const std::string why = refusal<NewtonFailed>(far);
  CAPTURE(why);
  CHECK(why.find("bond-centred orbit at omega_b = 1.05: it shrinks to rest, from a guess of size "
                 "0.0022 to ") == 0);
  CHECK(why.find("; relative residuals 1.1e-01, ") != std::string::npos);
  CHECK(why.find('\n') == std::string::npos);
  // Rest itself, also with a free period, and as an orbit to start from
  CHECK_THROWS_AS(newton(problem, problem.reduce(State<double>(16))), NewtonFailed);
  Orbit<double> resting = find_breather(problem);
  resting.x.setZero();
  CHECK_THROWS_AS(newton(in_precision<long double>(problem), resting), NewtonFailed);
  problem.symmetry.free_period = true;
  State<double> still(16);
  still.t = 6;
  CHECK_THROWS_AS(newton(problem, problem.reduce(still)), NewtonFailed);
  // Small breathers are breathers
  for (Centre centre : both_centres) {
    const auto small = find_breather(breather_problem(centre, 1.0001, 0, sites_of(centre)));
    CHECK(small.amplitude > 1e-9);
    CHECK(small.amplitude < 2e-8);
  }
}

TEST_CASE("contacts of any exponent have breathers of the size that is guessed",
          "[property][orbits]") {
  for (Centre centre : both_centres) {
    const std::size_t sites = sites_of(centre, Length::shortest);
    for (const Contact& contact :
         {Contact(PowerContact{1.2}), Contact(PowerContact{1.75}), Contact(PowerContact{2}),
          Contact(PowerContact{3}), Contact(PowerContact{6}), Contact(Layer{}),
          Contact(Layer{10})}) {
      Problem problem = breather_problem(centre, 1.05, 0, sites);
      problem.chain.contact = contact;
      CAPTURE(contact.exponent());
      const Orbit<double> orbit = find_breather(problem);
      const auto guess = ansatz(centre, 1.05, sites, Phase::compressed, contact);
      check_close(orbit.amplitude / largest(guess), 1, 0.3);
      CHECK(return_error(problem, orbit, 0) < 1e-11);
    }
    // A power that is no root: the guess is that of the article's contacts
    const auto spheres = ansatz(centre, 1.05, sites);
    const auto same = ansatz(centre, 1.05, sites, Phase::compressed, PowerContact{1.5});
    CHECK(largest_difference(spheres, same) < 1e-14 * largest(spheres));
  }
  CHECK_THROWS_AS(ansatz(Centre::site, 1.05, 21, Phase::compressed, PowerContact{1}),
                  std::invalid_argument);
}

TEST_CASE("breathers need wells of their symmetry, with all digits", "[unit][orbits]") {
  const auto in = [](const Well& well) {
    return refusal<std::invalid_argument>([&] { breather_problem(Centre::site, 1.1, well, 21); });
  };
  CHECK(in(Toda{}) == "a breather with a centre needs wells with W(-y) = W(y)");
  CHECK(in(Naive{}) == digits_hint);
  for_each_potential<Well>([&](const auto& well) {
    if (well.stiffness(0.0) == 1) CHECK(in(OwnWell(well)) == "");
  });
}

TEST_CASE("the discrete gradient, its direction, and how many sites a tail needs",
          "[unit][orbits]") {
  const Vector<double> g = gradient({1, 2, 4, 8, 16});
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
  CHECK(needed({0, weak, strong, 1, -1, -strong, -weak, 0}) == 6);
  CHECK(needed({0, 0, weak, strong, 1, -1, -strong, -weak, 0, 0}) == 6);
  CHECK(needed({0, weak, weak, 1, -1, -strong, -weak, 0}) == 6);  // both ends have to be weak
  CHECK(needed({0, weak, strong, 1, -1, -weak, -weak, 0}) == 6);
  CHECK(needed({0, strong, 1, -1, -strong, 0}) == 6);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0, 0}) == 4);
  CHECK(needed({0, 0, 0, 0, 0, 0, 0}) == 3);
}

TEST_CASE("a breather far up its branch is the same on chains that are shorter or longer",
          "[property][orbits]") {
  const double omega = 1.15;
  REQUIRE(omega > direct_up_to);
  const auto middle = [](const Fitted& f) { return f.orbit.start.y[f.problem.chain.sites / 2]; };
  for (Centre centre : both_centres) {
    const std::size_t odd = centre == Centre::site;
    const auto fitted = [&](std::size_t sites) {
      return fit_chain(centre, omega, Harmonic{}, sites, 16 + odd, 1e-10, Phase::compressed);
    };
    const Fitted usual = fitted(0), longer = fitted(40 + odd);
    CHECK(usual.problem.chain.sites == 16 + odd);
    CHECK(longer.problem.chain.sites == 40 + odd);
    check_close(longer.orbit.energy, usual.orbit.energy, 0, 1e-9);
    check_close(middle(longer), middle(usual), 0, 1e-9);
    CHECK_THROWS_AS(fitted(4 + odd), ShortChain);
  }
}
