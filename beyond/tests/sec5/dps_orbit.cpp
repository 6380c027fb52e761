// Travelling breathers of the DpS equation for contacts of any exponent.

#include "commands/dps_orbit.hpp"
#include "support/check.hpp"

using namespace lattice;

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
