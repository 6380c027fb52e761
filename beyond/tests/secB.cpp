// Contacts of any exponent: which static DpS breather is stable, both ends of the exponents, and travelling breathers.

#include "secB/exponents.hpp"
#include "check.hpp"
#include "commands/dps_orbit.hpp"

using namespace lattice;

TEST_CASE("the site-centred breather is unstable and the bond-centred one stable for all exponents",
          "[property][dps][exponents]") {
  const auto rows = scan_exponents({1.09, 1.1, 1.2, 1.35, 1.5, 1.75, 2, 2.5, 3, 3.5, 4});
  double before = 0;
  for (const OfExponent& row : rows) {
    CAPTURE(row.alpha);
    const double margin = row.site.margin.value;
    CHECK(margin > 1e3 * row.site.margin.error);
    CHECK(row.bond.margin.value < -1e3 * row.bond.margin.error);
    CHECK(row.norm_difference.value < -1e3 * row.norm_difference.error);
    CHECK(margin > before);
    before = margin;
    check_close(row.site.rate.value, std::sqrt((1 - 1 / row.alpha - margin) * row.alpha * margin),
                0, 1e-12);
  }
  // At 3/2 these are the numbers of sections 3.2 and 3.3
  check_close(rows[4].site.margin.value, 4.85297661617711e-06, 1e-17);
  check_close(rows[4].bond.margin.value, -4.85326567483309e-06, 1e-17);
  check_close(rows[4].norm_difference.value, -1.331102768e-6, 0, 1e-8);
}

TEST_CASE("both ends of the exponents are what the equation says", "[convergence][exponents]") {
  // Towards one: a Gaussian of the logarithmic equation
  const auto near = breathers_of_exponent(1.12), nearer = breathers_of_exponent(1.06);
  for (Centre centre : both_centres) {
    const double off = near.of(centre).bend.value - 1, less = nearer.of(centre).bend.value - 1;
    CHECK(std::abs(less) < 0.06);
    check_close(less / off, 0.5, 0.06);
  }
  // What pins it falls like exp(-c / (alpha - 1)): local slopes are straight in alpha - 1
  const auto rows = scan_exponents({1.08, 1.1, 1.12});
  const auto slope_of = [&](std::size_t i, auto of) {
    const double a = 1 / (rows[i].alpha - 1), b = 1 / (rows[i + 1].alpha - 1);
    return std::pair(2 / (a + b), std::log(of(rows[i]) / of(rows[i + 1])) / (b - a));
  };
  const auto at_one = [&](auto of) {
    const auto [x0, y0] = slope_of(0, of);
    const auto [x1, y1] = slope_of(1, of);
    return y0 - (y1 - y0) / (x1 - x0) * x0;
  };
  const Estimate c = pinning_exponent();
  check_close(c.value, 6.490174694, 1e-6);
  check_close(at_one([](const auto& r) { return r.site.margin.value; }), c.value, 0.006);
  check_close(at_one([](const auto& r) { return r.norm_difference.value; }), c.value, 0.012);
  CHECK(std::abs(at_one([](const auto& r) { return r.site.norm.value; }) - c.value) > 1);
  // Far from one: two or three sites
  const auto far = breathers_of_exponent(20), farther = breathers_of_exponent(40);
  const auto closer = [](const Estimate& a, const Estimate& b, double limit) {
    CAPTURE(a.value, b.value, limit);
    CHECK(std::abs(b.value - limit) < 0.7 * std::abs(a.value - limit));
    check_close(b.value, limit, 0.05);
  };
  closer(far.site.norm, farther.site.norm, 2.0 / 3);
  closer(far.bond.norm, farther.bond.norm, 0.5);
  closer(far.site.margin, farther.site.margin, 1.0 / 3);
  closer(far.bond.margin, farther.bond.margin, 0);
  closer(far.norm_difference, farther.norm_difference, -0.25);
}

TEST_CASE("travelling breathers of other exponents", "[property][dps][exponents][travelling]") {
  for (double alpha : {1.3, 2.0, 3.0}) {
    CAPTURE(alpha);
    const auto [problem, member] = follow_dps_member(alpha, 0, 1e-12);
    CHECK(problem.alpha == alpha);
    // Half a shift was solved for, with a symmetry; here is a whole one without it
    Field end = member.field;
    problem.flow(end, problem.shift_time);
    for (std::size_t n = 1; n < end.size(); ++n)
      check_close(std::abs(end[n] - member.field[n - 1]) / sup(member.x), 0, 1e-9);
    // The same at another amplitude, by the scaling law
    Field large = member.field;
    for (auto& a : large) a *= 2;
    evolve_dps(Dps{.sites = large.size(), .exponent = alpha}, large,
               problem.shift_time * std::pow(2, 1 - alpha), 1, 1e-13);
    for (std::size_t n = 1; n < end.size(); ++n)
      check_close(std::abs(large[n] - 2.0 * member.field[n - 1]) / sup(member.x), 0, 1e-8);
  }
  // The command takes any shift time
  DpsOrbit command;
  command.alpha = 2, command.time = 3;
  const Table profile = command.profile(command.find());
  Field now;
  for (std::size_t i = 0; i < profile.numbers("n").size(); ++i)
    now.emplace_back(profile.numbers("real")[i], profile.numbers("imag")[i]);
  const Field before = now;
  evolve_dps(Dps{.sites = now.size(), .exponent = 2}, now, 3, 1, 1e-13);
  for (std::size_t n = 1; n < now.size(); ++n)
    check_close(std::abs(now[n] - before[n - 1]), 0, 1e-9);
  CHECK(std::abs(now[now.size() / 2]) > 0.1);
  // Spheres: the member that the chapter finds directly
  const DpsMember direct = dps_member({}, cut_dps_packet(40, 8)),
                  followed = follow_dps_member(1.5, 0, 1e-13).second;
  check_close(followed.norm, direct.norm, 0, 1e-11);
  // The equation that is left out, at an angle where it is not satisfied
  const auto [off, other] = follow_dps_member(2, 0.5, 1e-12);
  check_close(off.residuals(other.x)[0], other.V * std::sin(0.25), 0, 1e-7);
}
