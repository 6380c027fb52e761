// Travelling breathers a second time: the first guess from a record of an impact, the problems and their unknowns, members of
// a family, frames that go along, and multipliers by hand.

#include "sec5/travelling.hpp"

#include "check.hpp"

namespace travelling_again {

using namespace lattice;

namespace {

using Numbers = std::vector<double>;
const double turn = 2 * std::acos(-1.0);

/// Squares of y + y' and v - v' at mirror sites over the squares of all four.
double asymmetry_again(const State<double>& z, std::size_t c, std::size_t width) {
  double odd = 0, all = 0;
  for (std::size_t j = 1; j <= width; ++j) {
    odd += std::pow(z.y[c + j] + z.y[c - j], 2) + std::pow(z.v[c + j] - z.v[c - j], 2);
    for (std::size_t n : {c - j, c + j}) all += z.y[n] * z.y[n] + z.v[n] * z.v[n];
  }
  return odd / all;
}

}  // namespace

TEST_CASE("the symmetry of a packet and its front half", "[unit][travelling]") {
  State<double> z(9);
  z.y = {9, 8, 0.3, -0.5, 0.7, 0.4, -0.2, 0.6, 0.1},
  z.v = {7, 6, 0.2, 0.8, -0.3, 0.5, 0.9, -0.7, 0.35};
  check_close(asymmetry(z, 4, 2), asymmetry_again(z, 4, 2), 1e-15);
  check_close(asymmetry(z, 4), asymmetry_again(z, 4, 3), 1e-15);
  check_close(asymmetry(z, 5, 1), asymmetry_again(z, 5, 1), 1e-15);
  Vector<double> expected(7);
  expected << 0.4, -0.2, 0.6, -0.3, 0.5, 0.9, -0.7;
  CHECK(front_half(z, 4, 3) == expected);
}

TEST_CASE("a guess is cut where the packet is most symmetrical", "[unit][travelling]") {
  const double velocity = 0.8, from = 9, to = 13;
  const std::size_t reach = 4, sites = 21;
  for (int sign : {1, -1}) {
    State<double> state = struck(sites, velocity), before = state;
    double least = 1e9;
    Vector<double> best;
    bool on = true;
    evolve(ContactAware{0.1}, Chain{sites}, state, TimeGrid{100, 1000, 1},
           [&](const State<double>& now) {
             const Numbers e = energy_density(Chain{sites}, now);
             const auto c = front_packet(e);
             if (!c || !on) return;
             double sum = 0, moment = 0;
             for (std::size_t n = *c - std::min<std::size_t>(*c, 5); n < std::min(sites, *c + 6);
                  ++n)
               sum += e[n], moment += double(n + 1) * e[n];
             const double a = before.y[*c], b = now.y[*c];
             if (moment / sum > from && (a < 0) != (b < 0) && sign * now.v[*c] > 0) {
               State<double> z(sites);
               for (std::size_t n = 0; n < sites; ++n)
                 z.y[n] = (before.y[n] * b - now.y[n] * a) / (b - a),
                 z.v[n] = (before.v[n] * b - now.v[n] * a) / (b - a);
               const double miss = asymmetry_again(z, *c, 3);
               if (miss < least) {
                 least = miss, best = Vector<double>(9);
                 for (std::size_t j = 0; j <= 4; ++j) {
                   best[Eigen::Index(4 + j)] = z.v[*c + j];
                   if (j > 0) best[Eigen::Index(j) - 1] = z.y[*c + j];
                 }
               }
             }
             before = now;
             // The run ends with the first sample at the last site
             on = moment / sum < to;
           });
    const Vector<double> cut = cut_packet(velocity, from, to, sign, reach);
    REQUIRE(cut.size() == 9);
    for (Eigen::Index i = 0; i < 9; ++i) check_close(cut[i], best[i], 1e-12);
    CHECK(sign * cut[4] > 0);
  }
  CHECK_THROWS_AS(cut_packet(velocity, 60, 13, 1, reach), std::runtime_error);
}

TEST_CASE("the problems of travelling breathers and their unknowns", "[unit][travelling]") {
  const Shooting<double> problem = travelling_problem(5.0, 0.3, 4), usual = travelling_problem(5.0),
                         third = type_one<double>(3, 4), free = with_free_time(problem);
  CHECK((problem.chain.sites == 10 && usual.chain.sites == 18 && third.chain.sites == 10));
  check_close(problem.omega, turn / 5, 1e-15);
  check_close(third.omega, 1.0 / 3, 1e-15);
  check_close(problem.chain.well.force(0.5), Well(Quartic{0.3}).force(0.5), 0);
  check_close(usual.chain.well.force(0.5), Well(Quartic{0}).force(0.5), 0);
  check_close(third.chain.well.force(0.5), Well(Quartic{0}).force(0.5), 0);
  CHECK(problem.chain.contact.force(-1e-100) > 0);
  const Vector<double> x = Vector<double>::LinSpaced(9, -0.4, 0.4), all = with_time(x, 7.0);
  CHECK((all.head(9) == x && all[9] == 7 && all.size() == 10));
  // With a free time there is one equation more, the first one
  const Vector<double> most = free.shoot(with_time(x, 5.0), {}, false).miss,
                       less = problem.shoot(x, {}, false).miss;
  REQUIRE((most.size() == 10 && less.size() == 9));
  for (Eigen::Index i = 0; i < 9; ++i) check_close(most[i + 1], less[i], 1e-13);
  Orbit<double> orbit;
  orbit.omega = 0.5, orbit.amplitude = 2, orbit.start = State<double>(6);
  orbit.start.v = {1, 2, 4, 8, 16, 32};
  check_close(shift_time(orbit), 2 * turn, 1e-14);
  CHECK((central_velocity(orbit) == 4 && velocity_sum(orbit) == 31.5));
  State<double> longer = embed(orbit.start, 9, 2);
  CHECK(longer.v == Numbers{0, 0, 1, 2, 4, 8, 16, 32, 0});
  longer.y = longer.v;
  move_on(longer, 3);
  CHECK(longer.y == Numbers{2, 4, 8, 16, 32, 0, 0, 0, 0});
  CHECK(longer.v == longer.y);
}

TEST_CASE("members of a family at equal steps, and an energy found twice", "[unit][travelling]") {
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-11;
  CHECK((Staircase::first == 5 && Staircase::first_velocity == 0.0174));
  Staircase stairs(1, 6, rule);
  const Orbit<double> fifth = stairs.orbit(), third = stairs.reach(3);
  CHECK(fifth.start.y.size() == 14);
  check_close(shift_time(fifth), 5 * turn, 1e-12);
  check_close(shift_time(third), 3 * turn, 1e-12);
  CHECK(central_velocity(third) > 0);
  CHECK(&stairs.reach(3) == &stairs.orbit());
  const double to = 3 * turn - 0.5;
  const auto members = follow_family(third, to, 0.2, rule);
  REQUIRE(members.size() == 4);
  const auto problem = [&](double time) { return with_free_time(travelling_problem(time, 0, 6)); };
  for (std::size_t i = 0; i < 4; ++i) {
    const double time = 3 * turn - 0.5 * double(i) / 3;
    check_close(shift_time(members[i]), time, 1e-12);
    // All equations but the first
    const Vector<double> miss = problem(time).shoot(with_time(members[i].x, time), {}, false).miss;
    CHECK(sup<double>(miss.tail(13)) < 1e-8 * members[i].amplitude);
  }
  // An exact multiple of the step takes no step more
  CHECK(follow_family(third, 3 * turn - 0.5, 0.25, rule).size() == 3);
  CHECK(follow_family(third, 3 * turn + 0.3, 0.2, rule).size() == 3);
  Orbit<double> shaken = fifth;
  shaken.x *= 1 + 1e-7;
  NewtonRule<double> coarse;
  coarse.events.tolerance = 8 * coarse.events.tolerance;
  const Estimate energy = energy_of_type_one(5, fifth);
  CHECK(energy.value == fifth.energy);
  check_close(energy.error,
              std::abs(polish(type_one<double>(5, 6), shaken, coarse).energy - fifth.energy), 0,
              1e-6);
}

TEST_CASE("the flow over a shift and its multipliers", "[unit][travelling]") {
  Chain chain{4};
  State<double> start(4);
  start.y = {0.3, -0.1, 0.2, -0.25}, start.v = {0.1, -0.2, 0.3, 0.05};
  const Matrix<double> map = shifted_map(chain, start, 1.7);
  const auto after = [&](std::size_t k, double change) {
    State<double> z = start;
    (k < 4 ? z.y[k] : z.v[k - 4]) += change;
    flow(chain, z, 1.7);
    return z;
  };
  for (std::size_t k = 0; k < 8; ++k) {
    const State<double> more = after(k, 1e-5), less = after(k, -1e-5);
    for (std::size_t n = 0; n < 4; ++n) {
      const bool last = n == 3;
      check_close(map(Eigen::Index(n), Eigen::Index(k)),
                  last ? 0 : (more.y[n + 1] - less.y[n + 1]) / 2e-5, 1e-7);
      check_close(map(Eigen::Index(4 + n), Eigen::Index(k)),
                  last ? 0 : (more.v[n + 1] - less.v[n + 1]) / 2e-5, 1e-7);
    }
  }
  Matrix<double> diagonal = Matrix<double>::Zero(3, 3);
  diagonal.diagonal() << 0.5, -2, 1.5;
  const auto all = multipliers_of(diagonal);
  for (std::size_t i = 0; i < 3; ++i)
    check_close(all[i].real(), std::array{-2.0, 1.5, 0.5}[i], 1e-14);
  // The four next to +1: 1 +- i/2, 1.25 and 0.75; (z - 1)^2 / z = -1/4 / z and so on
  const double kappa = (-0.25 * 2 / 1.25 + 0.0625 / 1.25 + 0.0625 / 0.75) / 8;
  check_close(
      phase_kappa<double>({{3, 0}, {1, 0.5}, {0.4, 0}, {1.25, 0}, {1, -0.5}, {0.75, 0}, {-1, 0}}),
      kappa, 1e-15);
}

}  // namespace travelling_again
