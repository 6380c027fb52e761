#include "sec36/definitions.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

namespace lattice {

void report_experiment(Report& report, const StruckArray& struck, std::size_t watched,
                       const TwoRuns<WatchedRun>& runs) {
  const Scales& scales = struck.scales;
  const auto travelled = [&](const WatchedRun& run) {
    return 10e-3 * mean_speed(run, struck, watched);
  };
  const auto onward = [&](const WatchedRun& run) {
    return run.path.travelled(double(watched), scales.time(10));
  };
  const auto periods = [&](const WatchedRun& run) {
    return 10 / (pulse_of(run.at, scales).period * 1e3);
  };
  report.table("experiment")
      .add({{"small_period", "of a beam alone", exact(2 * std::numbers::pi * scales.tau_c() * 1e3),
             "ms", "exact"},
            {"travelled", "in 10 ms at the speed of the whole way to n = 80", runs.of(travelled),
             "sites"},
            {"onward", "in 10 ms from n = 80 on", runs.of(onward), "sites"},
            {"periods", "in 10 ms", runs.of(periods)}});
}

void report_speeds(Report& report, const StruckArray& struck, std::size_t watched,
                   const TwoRuns<WatchedRun>& runs) {
  Table& speeds = report.table("speeds");
  const auto add = [&](const char* how, int from, int to, const Estimate& speed) {
    speeds.add({{"how", "arrival of the largest force, or slope of X(t)", how},
                {"from", "first site of the way", from, "site"},
                {"to", "its last site", to, "site"},
                {"speed", "speed of the packet", speed, "sites/s"}});
  };
  // From the free end, and from the struck beam
  for (int from : {0, 1}) {
    const auto speed = [&](const WatchedRun& run) {
      return mean_speed(run, struck, watched - std::size_t(from));
    };
    add("arrival", from, int(watched), runs.of(speed));
  }
  struct Stretch {
    int from, to;
  };
  for (const Stretch& way : {Stretch{10, 80}, {20, 40}, {20, 60}, {20, 80}, {20, 100}, {75, 85}}) {
    const auto slope = [&](const WatchedRun& run) {
      return run.path.line(way.from, way.to)->slope / struck.scales.tau_c();
    };
    add("slope", way.from, way.to, runs.of(slope));
  }
}

void report_durations(Report& report, const StruckArray& struck, const TwoRuns<WatchedRun>& runs) {
  Table& durations = report.table("durations");
  for (double above : {0.5, 0.01, 1.5e-3, 1e-3, 5e-4}) {
    const auto duration = [&](const WatchedRun& run) { return duration_above(run, struck, above); };
    durations.add({{"above", "threshold, as a part of the largest force", above},
                   {"duration", "from its first to its last passage", runs.of(duration), "ms"}});
  }
}

Train::Train(std::vector<double> density, double all) {
  const std::size_t front = *front_packet(density), m = packet_half_width;
  packet = participation({density.begin() + std::ptrdiff_t(front - m),
                          density.begin() + std::ptrdiff_t(front + m + 1)});
  density.resize(front - 10);
  sites = participation(density);
  share = total(density) / all;

  // The middle nine tenths of the energy
  std::partial_sum(density.begin(), density.end(), density.begin());
  const auto site = [&](double part) {
    const auto at = std::lower_bound(density.begin(), density.end(), part * density.back());
    return std::size_t(at - density.begin()) + 1;
  };
  first = site(0.05);
  last = site(0.95);
}

void report_wave_train(Report& report, const StruckArray& struck, const TwoSteps& steps) {
  Table& table = report.table("wave_train");
  const auto add = [&](const char* at, const auto& density_of) {
    const TwoRuns<Train> both{{density_of(steps.coarse), struck.energy()},
                              {density_of(steps.fine), struck.energy()}};
    table.add(
        {{"at", "where the packet is", at},
         {"sites", "participation number", both.of([](const Train& t) { return t.sites; }), "site"},
         {"most", "sites that hold the middle nine tenths of the energy",
          both.of([](const Train& t) { return t.last - t.first + 1; }), "site", "exact"},
         {"first", "the first of them", both.of([](const Train& t) { return t.first; }), "site",
          "exact"},
         {"share", "of the energy", both.of([](const Train& t) { return t.share; })},
         {"packet", "participation number of the packet",
          both.of([](const Train& t) { return t.packet; }), "site"}});
  };
  add("half_way", [&](double step) {
    Impact impact = struck.impact({.until = 60});
    impact.until = 50;
    return strike(EventCorrected{step}, impact).density;
  });
  // Until the fifth beam before the defect begins to move
  add("defect", [&](double step) {
    const std::size_t fifth = struck.array.defect - 6;
    const auto at_rest = [&](const State<double>& now, const auto&) { return now.y[fifth] == 0; };
    return strike(EventCorrected{step}, struck.impact({.until = 200}), at_rest).density;
  });
}

// Of the strongest packet, which turns back, or of the foremost one, which passes
static double packet_part(const StruckArray& struck, double ratio, bool back, double step) {
  Impact impact = struck.impact({.ratio = ratio, .sample = 0.2});
  impact.packet = back ? WhichPacket::strongest : WhichPacket::foremost;
  const Path path = strike(EventCorrected{step}, impact).path;
  if (!back) return path.energy_at(120) / path.energy_at(80);
  // The way back, mirrored
  const auto turn = std::max_element(path.centre.begin(), path.centre.end()) - path.centre.begin();
  Path way;
  for (auto k = std::size_t(turn); k < path.t.size(); ++k) {
    way.add(path.t[k], -path.centre[k]);
    way.energy.push_back(path.energy[k]);
  }
  return way.energy_at(-80) / path.energy_at(80);
}

void report_packets(Report& report, const StruckArray& struck, const TwoSteps& steps) {
  const auto row = [&](double ratio) {
    const bool back = ratio > 1.5;
    const double coarse = packet_part(struck, ratio, back, steps.coarse),
                 fine = packet_part(struck, ratio, back, steps.fine);
    return Row{
        {"ratio", "radius of the defect's beads divided by that of the others", ratio},
        {"way", "back at site 80, or passed to site 120", back ? "back" : "passed"},
        {"part", "energy of the packet, over that on its way at site 80", compare(coarse, fine)}};
  };
  report.table("packets").fill(std::array{1.6, 1.1}, row, "packets");
}

}  // namespace lattice
