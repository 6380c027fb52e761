#include "sec34/criteria.hpp"

#include <array>
#include <stdexcept>

namespace lattice {

// Does the packet keep its energy? The means over both halves of the way average out its pulsation
double energy_change(const Track& track, double to) {
  const std::size_t end = track.until(to);
  std::size_t begin = 0;
  while (begin < end && track.centre[begin] < fit_from) ++begin;
  if (end < begin + 6) throw std::runtime_error("no packet passes site 20");
  const std::size_t half = (begin + end) / 2;
  const auto mean = [&](std::size_t from, std::size_t until) {
    double sum = 0;
    for (std::size_t i = from; i < until; ++i) sum += track.energy[i];
    return sum / double(until - from);
  };
  const double first = mean(begin, half), second = mean(half, end);
  return second / first - 1;
}

// The strongest window behind the packet, at least one width clear of it
double residue(const std::vector<double>& e, std::size_t peak) {
  const std::size_t m = packet_half_width;
  double most = 0;
  for (std::size_t n = m; n + 4 * m < peak; ++n) most = std::max(most, window_sum(e, n));
  return most / window_sum(e, peak);
}

// The three conditions on a packet that lasts
Criterion travelling_breather(const Endurance& packet) {
  const Estimate &speed = packet.speed_change, &energy = packet.energy_change;
  return {below("speed_change", {std::abs(speed.value), speed.error}, 0.05),
          below("energy_change", {std::abs(energy.value), energy.error}, 0.1),
          below("residue", packet.residue, 1)};
}

// How compact a packet is, judged on its undisturbed side by the last site in and the first one out
Criterion supported_by(std::size_t sites, const Front& coarse, const Front& fine) {
  const auto amplitude = [&](std::size_t k) {
    return compare(coarse.amplitude(k), fine.amplitude(k));
  };
  return {above("outermost", amplitude(sites / 2), 0.01),
          below("next", amplitude(sites / 2 + 1), 0.01)};
}

// Curves that coincide in a limit, and energy that stays where it was put in
Criterion meet(const Meeting& m) {
  return {below("near", m.near, 0.01), below("near_over_far", quotient(m.near, m.far), 0.5)};
}

Criterion trapped(const Estimate& boundary, const Estimate& packet) {
  return {above("boundary_over_packet", quotient(boundary, packet), 1)};
}

// The lower of two peaks, at the end and around the packet, over the highest wave in between
double prominence(const std::vector<double>& v, std::size_t peak, std::size_t near) {
  const auto height = [&](std::size_t from, std::size_t to) {
    double most = 0;
    for (std::size_t n = from; n < std::min(to, v.size()); ++n)
      most = std::max(most, std::abs(v[n]));
    return most;
  };
  const std::size_t m = packet_half_width, behind = peak > m ? peak - m : 0;
  const double between = height(near + m, behind), packet = height(behind, peak + m + 1);
  return std::min(height(0, near), packet) / between;
}

// Breathers and kinks both occur, in this order of velocities, and leave no gap for a third regime
Criterion transition(const Transition& t) {
  return {above("breathers", exact(double(t.breathers)), 0),
          above("kinks", exact(double(t.kinks)), 0),
          above("order", exact(t.first_kink - t.last_breather), 0),
          below("undecided", exact(t.undecided), 0.05)};
}

// Speed and way of the beads in an impact, at two resolutions
Confinement confinement(const Impact& impact, const ContactAware& rough, const ContactAware& fine) {
  std::array<double, 2> speed{};
  std::array<ImpactRun, 2> run;
  for (std::size_t i : {0, 1})
    run[i] = strike(i ? fine : rough, impact, [&](const State<double>& now, const auto&) {
      for (double v : now.v) speed[i] = std::max(speed[i], std::abs(v) / impact.velocity);
    });
  const Estimate furthest = compare(run[0].reach, run[1].reach);
  return {compare(speed[0], speed[1]), quotient(furthest, exact(impact.velocity * impact.time)),
          compare(run[0].run.energy_drift, run[1].run.energy_drift),
          std::min(run[0].end.t, run[1].end.t) / impact.time, furthest};
}

// The limits leave a thousandth for errors
Criterion no_blowup(const Confinement& c) {
  return {below("speed", c.speed, 1.001), below("way", exact(c.way.value), 1.001),
          below("drift", c.drift, 1e-3), above("lasted", exact(c.lasted), 0.999)};
}

// The forces point backward on both ways, and the time of the return is known
Criterion reversed_packet(const Estimate& apex_time, const Estimate& out, const Estimate& back,
                          const Estimate& return_time) {
  return {above("apex_time", apex_time, 0), below("force_out", out, 0),
          below("force_back", back, 0), below("return_time_error", exact(return_time.error), 10)};
}

// A packet that is held back, but by less than half of what turns another one round
Criterion slowed_packet(bool slows, const Estimate& force, const Estimate& turning_force) {
  const Estimate share = quotient(force, turning_force);
  return {above("slows", exact(slows), 0.5),
          below("force_over_190", {std::abs(share.value), share.error}, 0.5)};
}

// Ensembles that stay together until the return and scatter later
Criterion erratic_packets(const Estimate& early, const Estimate& late) {
  return {below("spread_until_return", early, 0.25), above("spread_late", late, 3)};
}

}  // namespace lattice
