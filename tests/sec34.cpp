// What is measured of packets after an impact: energy, height, acceleration.

#include <complex>

#include "commands/one_turn.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/dps_comparison.hpp"
#include "sec34/packet.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

TEST_CASE("the front of a linear wave is no travelling breather", "[property]") {
  const Dps linear{140, Ends::free, 1, 0.5};
  const Path front = follow_dps(linear, dps_impact(140), 100, 2000, 1e-8).path;
  CHECK(front.back().centre > 80);
  CAPTURE(speed_change(front).value, energy_change(front));
  CHECK(std::abs(speed_change(front).value) < 0.05);
  CHECK(energy_change(front) < -0.1);
}

TEST_CASE("the approximation of an impact starts with other velocities", "[unit][dps]") {
  for (double eps : {1e-5, 1e-2}) {
    const ApproximateStart start = approximate_start(20, eps);
    const double change = eps * std::sqrt(eps) / tau_0(1.5);
    check_close(start.first, change, 0, 1e-9);
    check_close(start.second, -change, 0, 1e-9);
    CHECK((start.place == 0 && start.others == 0));
  }
}

TEST_CASE("only what rises above the waves between is visible", "[property]") {
  std::vector<double> v(100, 0.0);
  v[1] = 1, v[50] = 0.2, v[80] = -0.3;
  check_close(prominence(v, 80), 1.5, 1e-14);
  v[50] = -0.4;
  CHECK(prominence(v, 80) < 1);
  v[50] = 0.2, v[1] = 0.1;
  CHECK(prominence(v, 80) < 1);
  // The same impact on linear wells leaves no surface mode, on soft ones it does.
  const auto shot = [](double s) {
    const ImpactRun out =
        strike(EventCorrected{0.1}, on_long_chain({1.87, {.well = Quartic{s}}, 400, 400}));
    return prominence(out.end.v, *front_packet(out.density));
  };
  CHECK(shot(-1.0 / 6) > 1);
  CHECK(shot(0) < 1);
}

TEST_CASE("a packet's energy changes from the mean of one half of its way to that of the other",
          "[unit]") {
  Path path;
  double first = 0, second = 0;  // of seven samples, three and four
  for (int k = 0; k < 7; ++k) {
    path.samples.push_back({double(k), fit_from + k, 3 + std::cos(k), 1});
    (k < 3 ? first : second) += path.back().energy / (k < 3 ? 3 : 4);
  }
  check_close(energy_change(path), second / first - 1, 1e-13);
}

TEST_CASE("a parabola that is fitted to a path has its acceleration", "[unit][boomeron]") {
  Path path, wedge;
  for (int i = 0; i <= 1000; ++i) {
    const double t = path_sampling * i;
    path.add(t, 3 + 0.4 * t - 0.01 * t * t);
    wedge.add(t, std::abs(t - 100));
  }
  const PathFit all = fit_parabola(path, 0, 200), part = fit_parabola(path, 50, 90);
  check_close(all.acceleration, -0.02, 1e-11);
  check_close(part.acceleration, -0.02, 1e-10);
  CHECK(all.deviation < 1e-11);
  // The wedge |u|, u from -1 to 1, has the variance 1/12; its part along P_2 is 5/8 P_2, whose square has the mean 5/64
  check_close(fit_parabola(wedge, 0, 200).deviation, std::sqrt(1.0 / 12 - 5.0 / 64), 2e-3);
}

// In chains of a length of their own; the times of parting are those of an extrapolating integrator elsewhere, which
// looks every two units too
TEST_CASE("two impacts part because they differ, not because of the step", "[property][boomeron]") {
  const struct {
    double velocity, s, time;
    std::size_t sites;
    double when;
  } rows[] = {{1.22, 5.34, 100, 80, 364}, {50, 0.01, 200, 120, 730}};
  for (const auto& [velocity, s, time, sites, when] : rows) {
    CAPTURE(velocity, s);
    const OneTurn one{
        .velocity = velocity, .time = time, .sites = sites, .like = {.well = Quartic{s}}};
    const Table t = one.table();
    check_close(t.numbers("value")[3], when, 1e-9);
    CHECK(t.numbers("error")[3] <= 4.1);
  }
}

TEST_CASE("another integrator finds the same packet", "[property]") {
  const Impact impact{
      .velocity = 0.94, .chain = {90, Quartic{-0.7}}, .time = 600, .denser = false, .until = 62};
  const Path ours = strike(method_for(1e-4, largest_step, 3), impact).path;
  // By GSL, of order eight, sample by sample
  State<double> state = struck(impact.chain.sites, impact.velocity);
  Path other;
  while (other.empty() || other.back().centre < *impact.until) {
    evolve_reference(impact.chain, state, impact.every, 1e-10);
    const std::vector<double> e = energy_density(impact.chain, state);
    if (const auto peak = front_packet(e)) other.add(state.t, e, *peak);
  }
  check_close(packet_speed(other, 60).value, packet_speed(ours, 60).value, 0, 1e-6);
  check_close(other.energy_at(60), ours.energy_at(60), 0, 1e-6);
  check_close(other.largest_peak(20, 60).value, ours.largest_peak(20, 60).value, 0, 1e-6);
}

TEST_CASE("another integrator finds the same turn", "[property][boomeron]") {
  const Impact impact{.velocity = 1.9,
                      .chain = {60, Quartic{1}},
                      .time = 1000,
                      .every = path_sampling,
                      .denser = false,
                      .packet = WhichPacket::strongest};
  const Turn ours = turn_of(strike(EventCorrected{0.0363}, impact).path);
  State<double> state = struck(impact.chain.sites, impact.velocity);
  Path other;
  while (state.t < impact.time) {
    evolve_reference(impact.chain, state, impact.every, 1e-12);
    const std::vector<double> e = energy_density(impact.chain, state);
    const auto strongest = std::max_element(e.begin(), e.end()) - e.begin();
    other.add(state.t, e, std::size_t(strongest));
  }
  const Turn theirs = turn_of(other);
  check_close(theirs.apex.site, ours.apex.site, 2e-7);
  check_close(theirs.rebound.time, ours.rebound.time, 1e-4);
}

TEST_CASE("a free bead in a soft well is the slower the farther it moves", "[unit]") {
  check_close(free_frequency(0, 0.3), 1, 1e-14);
  State<double> bead(1);
  bead.y[0] = 0.9;
  Oscillation seen;
  evolve(EventCorrected{0.01}, Chain{1, Quartic{-0.7}}, bead, 150, Every{0.01},
         [&](const State<double>& now) { seen.add(now.t, now.y[0], now.v[0]); });
  check_close(seen.frequency(), free_frequency(-0.7, 0.9), 0, 1e-4);
  check_close(seen.amplitude(), 0.9, 0, 1e-6);
}
