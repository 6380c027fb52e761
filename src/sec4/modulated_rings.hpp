#pragma once
/**
# 4.2 The rings of figure 26 and of the other wells

This part of the chapter of section 4 belongs to the program sec4_precompression_mi.cpp, which has the equations and
tells what is seen; here the runs are made. A travelling breather has formed if the energy is concentrated
and its centre moves to the right (sec4/modulation.hpp). The ring with $s = 1$ is the control: there
$\Phi(\pi/4) < 0$, and after the same time it is still uniform. */

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"
#include "sec4/modulation.hpp"

namespace rings {

using namespace lattice;

/**
## The other wells

In linear and hard wells a run goes on until the energy has gathered and half as long again. A breather has formed if the
packet, and not the ring, is narrow and moves to the right. */
struct RingOfWell {
  double s, q;
  RingPair pair{};

  /// What has formed when the energy has gathered.
  Formed packet() const { return formed(pair.packet[0], pair.packet[1]); }
  /// Whether it is a packet of five times the mean density, on a quarter of the ring, that moves to the right.
  bool travels() const {
    if (std::isnan(pair.gathered)) return false;
    const Formed p = packet();
    return p.peak_over_mean.value - p.peak_over_mean.error > 5 &&
           p.width.value + p.width.error < double(ModulatedPhonon{}.sites) / 4 &&
           p.speed.value > p.speed.error;
  }
};

/**
Before, we counted the sites that share the energy of the ring, and tried every fourth wavenumber only. That measure
saw the background: it gives [52.5573](num:sec4_precompression_mi.narrowest_s_0),
[78.2169](num:sec4_precompression_mi.narrowest_s_1) and [24.19](num:sec4_precompression_mi.narrowest_s_minus_1_6) sites, most of
them for $s = 1$, where a narrow packet stands on more background.

In linear wells the width does depend on the wavenumber: `sec4_precompression_mi ring --s 0 --waves 31` finds a packet
no wider than the others, 7.0 sites, where $\Phi$ is a third below its largest value, and up to the inflection it
stays that narrow; at $q = \pi/4$ (`--waves 25`), where the article has its soft wells, it is 26 sites wide. Slower it
is everywhere: of the 37 wavenumbers below the inflection none has gathered before $t = 27800$. */
/// What the wavenumbers of the hard wells have in common: how many make a breather, how wide, and when.
inline void report_band_of(Report& report, const std::string& name,
                           const std::vector<RingOfWell>& band) {
  std::size_t formed = 0;
  Estimate widest, latest;
  for (const RingOfWell& ring : band) {
    if (!ring.travels()) continue;
    ++formed;
    widest = larger(widest, ring.pair.width());
    latest = larger(latest, {ring.pair.gathered, 50});
  }
  report.facts.add("rings_tried" + name, exact(double(band.size())));
  report.facts.add("rings_formed" + name, exact(double(formed)));
  if (formed == 0) return;
  report.facts.add("widest_packet" + name, widest, "site");
  report.facts.add("last_gathered" + name, latest);
}

/**
In the linear well, whose instability is slow, we follow the most unstable wavenumber only, with twice the steps; in
the hard one every unstable wavenumber, because there backscattered waves grow too. */
/// The tables of other wells, beside those of the soft one.
inline void report_ring_tables(Report& report, const RingPair& soft) {
  // The linear well at one wavenumber, for long; the hard one all over its band
  const std::array<double, 2> long_steps{0.8, 0.4}, usual_steps{0.4, 0.2};
  std::vector<RingOfWell> tried{{0, unstable_band({.s = 0}, 1).front()}};
  for (double q : unstable_band({.s = 1}, report.quick ? 8 : 1)) tried.push_back({1, q});
  parallel_for(tried.size(), [&](std::size_t i) {
    RingOfWell& ring = tried[i];
    const double longest = report.quick ? 2000 : i == 0 ? 150000 : 15000;
    ring.pair =
        run_ring_pair({.s = ring.s, .q = ring.q}, longest, i == 0 ? long_steps : usual_steps, 1.5);
  });
  const RingOfWell all[] = {{-1.0 / 6, ModulatedPhonon{}.q, soft}, tried[1], tried[0]};
  const std::string names[] = {"_s_minus_1_6", "_s_1", "_s_0"};

  // The wave from then on, well by well
  Table& table = report.table("ring_courses");
  for (const RingOfWell& ring : all)
    for (std::size_t k = 3; k < ring.pair.samples.size(); k += 4) {
      const auto& [a, b] = ring.pair.samples[k];
      const Estimate peak = compare(a.peak_over_mean, b.peak_over_mean),
                     sites = compare(a.participation, b.participation),
                     second = compare(a.second, b.second);
      // A row that is not known to one per cent is the end of what is known
      const auto unknown = [](const Estimate& e) { return e.error > 0.01 * e.value; };
      if (unknown(peak) || unknown(sites) || unknown(second)) break;
      table.add({{"s", "anharmonicity of the well", ring.s},
                 {"t", "time", b.t},
                 {"peak_over_mean", "largest energy density over the mean", peak},
                 {"participation", "sites that share the energy", sites, "site"},
                 {"second", "energy of the second packet over that of the first", second}});
    }

  // Does each become a breather, and how do they differ?
  Estimate peak = exact(INFINITY), width{}, speed = exact(INFINITY);
  for (std::size_t i = 0; i < 3; ++i) {
    const RingPair& pair = all[i].pair;
    report.facts.add("ring_q" + names[i], exact(all[i].q), "1/site");
    report.facts.add("narrowest" + names[i], pair.narrowest(), "site");
    report.facts.add("highest" + names[i], pair.highest());
    report.facts.add("agree" + names[i], pair.agree);
    if (std::isnan(pair.gathered)) continue;
    report.facts.add("gathered" + names[i], {pair.gathered, 50});
    report.facts.add("packet_width" + names[i], pair.width(), "site");
    const Formed packet = all[i].packet();
    peak = smaller(peak, packet.peak_over_mean);
    width = larger(width, packet.width);
    speed = smaller(speed, packet.speed);
  }
  report_band_of(report, names[1], {tried.begin() + 1, tried.end()});
  report.facts.add("formed_least_peak_over_mean", peak);
  report.facts.add("formed_largest_width", width, "site");
  report.facts.add("formed_least_speed", speed, "site per unit of time");

  // At the same stage of the instability the linear well is later, and its packet wider
  const RingPair &hard = all[1].pair, &linear = all[2].pair;
  const Estimate wider = larger(soft.width(), hard.width());
  const Estimate later{linear.gathered, 50}, earlier{std::max(soft.gathered, hard.gathered), 50};
  report.facts.add("gathers_later_s_0", quotient(later, earlier));
  report.facts.add("width_over_others_s_0", quotient(linear.width(), wider));

  // And the pulse of figure 26 splits
  const double round = ModulatedPhonon{}.round();
  const PulseSplits splits = pulse_splits(soft, round);
  report.facts.add("splitting_round", exact(round));
  report.facts.add("splitting_one_pulse_for", splits.one_pulse_for);
  report.facts.add("splitting_splits_at", splits.splits_at);
  report.facts.add("splitting_apart_at", splits.apart_at);
}

/**
## The run of figure 26

Two runs with different steps tell the error of the state, and a pair of runs side by side when they part: later
statements would be statistical. */
/// The state of figure 26 and its control, and with them the rings in all wells.
inline void report_modulated(Report& report, const ModulatedPhonon& soft) {
  // Two resolutions, and the hard well as the control
  const ModulatedPhonon hard{.s = 1};
  const double time = 6619;
  Modulated runs[4];
  RingPair pair;
  parallel_for(5, [&](std::size_t i) {
    if (i == 0) pair = run_ring_pair(soft, report.quick ? 7000 : 30000, {0.4, 0.2});
    if (i > 0) runs[i - 1] = modulate(i < 3 ? soft : hard, time, i % 2 ? 0.4 : 0.2);
  });
  const Modulated &coarse = runs[0], &fine = runs[1];
  Table& table = report.table("modulated_ring");
  const State<double> start = soft.start();
  for (std::size_t n = 0; n < start.y.size(); ++n) {
    const double y = fine.end.y[n];
    table.add({{"n", "site", n + 1, "site"},
               {"y_start", "displacement at t = 0", start.y[n]},
               {"y", "displacement at t = 6619", Estimate{y, std::abs(y - coarse.end.y[n])}},
               {"amplitude", "envelope of the displacements at t = 6619",
                fine.shown.envelope.amplitude[n] / fine.shown.envelope.omega}});
  }

  // Has a breather formed, what kind of packet is it, and is it the equations that we see?
  const Formed made = formed(coarse, fine), control = formed(runs[2], runs[3]);
  auto& facts = report.facts;
  facts.add("mi_run_peak_over_mean", made.peak_over_mean);
  facts.add("mi_run_share_of_sites", made.share_of_sites);
  facts.add("mi_run_control_peak_over_mean", control.peak_over_mean);
  const Sech &sech_a = coarse.shown.sech, &sech_b = fine.shown.sech;
  facts.add("mi_centre", compare(coarse.centre.back(), fine.centre.back()), "site");
  facts.add("mi_width", compare(sech_a.width, sech_b.width), "site");
  facts.add("mi_sech_residual", compare(sech_a.residual, sech_b.residual));
  facts.add("mi_speed", made.speed, "site per unit of time");
  facts.add("mi_state_error", compare(0.0, distance(coarse.end, fine.end)));
  facts.add("mi_energy_drift", compare(coarse.drift, fine.drift));
  facts.add("mi_agreement_time", pair.agree);
  report_ring_tables(report, pair);
}

/**
Before it splits the pulse of figure 26 lasts for [8.0e2](num:sec4_precompression_mi.splitting_one_pulse_for) units of
time, longer than its way round the ring, which takes [339.55](num:sec4_precompression_mi.splitting_round). The
subcommand `ring` follows one phonon of your choice. */
struct OneRing {
  static constexpr Title title{"ring",
                               "one modulated phonon: when it gathers, how wide its packet is"};
  double s = 0, longest = 60000;
  std::size_t waves = 24;

  void parameters(Parameters& p) {
    p.add("s", s, "anharmonicity of the well", {-0.5, 10});
    p.add("waves", waves, "wavelengths of the phonon on the ring of 200 sites", {1, 99});
    p.add("longest", longest, "length of the run, unless the energy gathers before", {100, 1e6});
  }
  Table table() const {
    const double q = 2 * std::numbers::pi * double(waves) / 200;
    const RingPair pair = run_ring_pair({.s = s, .q = q}, longest, {0.4, 0.2}, 1.5);
    const Estimate none{std::nan(""), std::nan("")};
    const bool gathered = !std::isnan(pair.gathered);
    const std::string by = "by t = " + short_text(pair.agree.value),
                      why = pair.agree.is_exact ? "the energy has not gathered " + by
                                                : "the runs with two steps part " + by +
                                                      ", before the energy has gathered";
    Answers a{"a shorter --longest"};
    a.add("gathered", gathered ? Estimate{pair.gathered, 50} : none, "",
          "first of the looks, one in 50 units of time, at which a site has five times the mean "
          "energy density and less than half of the sites share the energy",
          why);
    a.add("agree", pair.agree, "", "time up to which the runs with two steps agree");
    a.add(
        "width", gathered ? pair.width() : none, "site",
        "least width of the packet at half height in these looks, until half as long again or the "
        "end",
        why);
    a.add("highest", pair.highest(), "",
          "largest energy density over the mean that any of these looks sees");
    return a.table;
  }
};

}  // namespace rings
