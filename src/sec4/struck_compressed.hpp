#pragma once
/**
# 4.2 An impact on a compressed chain (figures 27 and 28)

This part of the chapter of section 4 belongs to the program sec4_precompression_mi.cpp, which has the equations and
tells what is seen. It strikes a chain whose contacts are compressed by $d = 1/2$: in the hard wells $s = 1$ a travelling
breather forms that has a sech-like envelope and does not turn round, and in the end it stands on a tail; for $s = 0$ and
$s = -1/6$ there is a dispersive wave train only. */

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/parallel.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"
#include "sec4/compressed_impact.hpp"

namespace compressed {

using namespace lattice;

/**
We need to tell a breather, a wave train, a surface mode and a packet that returns apart. The packet's
share of the energy, the boundary's share and the packet's advance decide (sec4/compressed_impact.hpp).
An impact $v_0 = 1.87$ on the first bead, Eq. (26), opens contacts near the boundary for a while, the last
time at $t =$ [22](num:sec4_precompression_mi.last_open_s_1) or earlier; after $t = 40$ the method relies
on closed ones. The chain is so long that its last bead has not moved at all when a run ends.

The three impacts of the article run at two resolutions, and so do two controls without
precompression, whose outcome is known from section 3.4: the packet that returns ($s = 1$) and the
surface mode ($s = -1/6$). Numbers that missed these would be worthless. The ten runs are independent, and
the longest takes as long as several of the others, so they are handed to the processors one by one. */
struct Experiment {
  std::string name;
  double s, d;
  Impact impact;
  std::vector<double> times;
  CompressedRun coarse{}, fine{};

  Experiment(std::string called, double s_, double time, std::vector<double> shown, double d_ = 0.5)
      : name(std::move(called)),
        s(s_),
        d(d_),
        impact(compressed_impact(s_, time, 1.87, d_)),
        times(std::move(shown)) {}

  /// A trait of the finer run, with its error from the coarser one.
  Estimate seen(double Traits::*of) const {
    return compare(traits(coarse.samples).*of, traits(fine.samples).*of);
  }
};

/// The impacts of section 4.3 and their controls, each run with two steps.
inline std::vector<Experiment> experiments(bool quick) {
  const double late = quick ? 1500 : 3000, linear = quick ? 1000 : 4399, soft = quick ? 1000 : 1998;
  std::vector<Experiment> all{{"s_1", 1, late, {291, 724, late}},
                              {"s_0", 0, linear, {linear}},
                              {"s_minus_1_6", -1.0 / 6, soft, {soft}},
                              {"uncompressed_s_1", 1, 1000, {}, 0},
                              {"uncompressed_s_minus_1_6", -1.0 / 6, 600, {}, 0}};
  parallel_for("impacts", 2 * all.size(), [&](std::size_t i) {
    Experiment& e = all[i / 2];
    const CompressedSteps steps = i % 2 ? CompressedSteps{}.halved() : CompressedSteps{};
    (i % 2 ? e.fine : e.coarse) = strike_compressed(e.impact, e.times, steps);
  });
  return all;
}

/**
For figures 27 and 28 we tabulate the velocities, their envelope and the sech fitted to it, and the
packet's share of the energy as a function of time, from the time on at which the packet has left the
boundary. */
inline void add_tables(Report& report, const std::vector<Experiment>& all) {
  Table &profiles = report.table("impact_profiles"), &history = report.table("packet_history");
  for (const Experiment& e : all) {
    for (std::size_t k = 0; k < e.fine.shown.size(); ++k) {
      const Snapshot &shown = e.fine.shown[k], &coarse = e.coarse.shown[k];
      for (std::size_t n = 0; n < shown.state.v.size(); ++n) {
        const double v = shown.state.v[n], off = double(n + 1) - shown.sech.centre;
        profiles.add(
            {{"s", "anharmonicity of the well", e.s},
             {"t", "time", shown.state.t},
             {"n", "site", n + 1, "site"},
             {"v", "velocity", Estimate{v, std::abs(v - coarse.state.v[n])}, "",
              "difference of two resolutions, against the largest of the column: ahead of the "
              "front there is only rounding"},
             {"amplitude", "envelope of the velocities", shown.envelope.amplitude[n]},
             {"sech", "fitted envelope, nan beyond 20 sites from its top",
              std::abs(off) < 20 ? shown.sech.at(double(n + 1)) : std::nan("")}});
      }
    }
    // One sample in five is enough
    for (const PacketSample& p : e.fine.samples)
      if (!e.times.empty() && p.t >= 10 && std::fmod(p.t + 1e-6, 5) < 1e-3)
        history.add(
            {{"s", "anharmonicity of the well", e.s},
             {"t", "time", p.t},
             {"centre", "centre of the packet", p.centre, "site"},
             {"share", "share of the energy within 20 sites of the packet", p.share},
             {"boundary", "share of the energy on the first five sites", p.boundary},
             {"participation", "number of sites that share the energy", p.participation, "site"}});
  }
}

/// On how many sites the packet has its energy at time `t`.
inline Estimate sites_of_packet(const Experiment& e, double t) {
  const auto at = [&](const CompressedRun& run) {
    return run.samples.at(std::size_t(t)).packet_sites;
  };
  return compare(at(e.coarse), at(e.fine));
}

/**
A breather keeps its energy and does not return, and at all three times of the article a sech explains its envelope; a
wave train keeps energy neither in a packet nor at the boundary. If a control comes out wrong, the numbers cannot tell
these outcomes apart. Beside the packet without compression, as it turns, this one is much less localized: we count the
sites that share the energy of either. What justifies the method are the drift of the energy, the time of the last open
contact, and the velocity of the last bead. */
inline void report_impacts(Report& report) {
  const std::vector<Experiment> all = experiments(report.quick);
  add_tables(report, all);
  for (const Experiment& e : all) {
    const auto add = [&](const std::string& what, double Traits::*of, const char* unit = "") {
      report.facts.add(what + "_" + e.name, e.seen(of), unit);
    };
    add("packet_exponent", &Traits::share_exponent);
    add("boundary_exponent", &Traits::boundary_exponent);
    add("steadiness", &Traits::steadiness);
    report.facts.add("energy_drift_" + e.name,
                     compare(e.coarse.run.energy_drift, e.fine.run.energy_drift));
    if (!(e.d > 0)) continue;
    add("packet_share", &Traits::share, "share of the energy");
    add("boundary_share", &Traits::boundary, "share of the energy");
    add("speed", &Traits::speed, "site per unit of time");
    report.facts.add("last_open_" + e.name, {e.fine.last_open, 1});
    report.facts.add("sites_" + e.name, exact(double(e.impact.chain.sites)), "site");
    report.facts.add("far_end_" + e.name, exact(e.fine.far_end));
  }

  // The breather's envelope at three times, and the crests of the wave trains
  Estimate widest{}, residual{};
  for (const Experiment& e : all)
    for (std::size_t k = 0; k < e.times.size(); ++k) {
      const Snapshot &coarse = e.coarse.shown[k], &fine = e.fine.shown[k];
      const std::string at = "_t_" + std::to_string(int(e.times[k]));
      const auto add = [&](const std::string& what, double Sech::*of, const char* unit = "") {
        const Estimate both = compare(coarse.sech.*of, fine.sech.*of);
        report.facts.add(what, both, unit);
        return both;
      };
      if (e.s != 1) add("front_width_" + e.name, &Sech::width, "site");
      if (e.s != 1) continue;
      const auto off = [](const Snapshot& shot) {
        return std::abs(shot.sech.centre - shot.centre);
      };
      add("breather_centre" + at, &Sech::centre, "site");
      add("breather_height" + at, &Sech::height);
      widest = larger(widest, compare(off(coarse), off(fine)));
      widest = larger(widest, add("breather_width" + at, &Sech::width, "site"));
      residual = larger(residual, add("breather_residual" + at, &Sech::residual));
    }
  report.facts.add("sech_reach", widest, "site");
  report.facts.add("sech_residual", residual);

  // What the two wave trains keep at the most
  const auto train = [&](double Traits::*of) { return larger(all[1].seen(of), all[2].seen(of)); };
  report.facts.add("trains_packet_exponent", train(&Traits::share_exponent));
  report.facts.add("trains_boundary_exponent", train(&Traits::boundary_exponent));

  // Packets with and without compression, at the times of figures 27 and 23
  const Estimate compressed = sites_of_packet(all[0], 291), free = sites_of_packet(all[3], 238);
  report.facts.add("packet_sites_compressed", compressed, "site");
  report.facts.add("packet_sites_uncompressed", free, "site");
  report.facts.add("packet_sites_ratio", quotient(compressed, free));
  const auto tail = [&](int side) {
    return compare(tail_amplitude(all[0].coarse.shown.back(), side),
                   tail_amplitude(all[0].fine.shown.back(), side));
  };
  report.facts.add("tail_both_sides_behind", tail(-1));
  report.facts.add("tail_both_sides_ahead", tail(1));
}

/**
The subcommand `impact` does the same for one impact of your choice, in wells of any name; the contact, whose
compression is the subject, stays. The named wells all have the phonons of the harmonic one, on which the
length of the chain rests. After other impacts contacts may go on opening for ever, so this one is computed as in
section 3.4: the event-corrected method goes all the way, with steps that are halved until the end states of two
runs agree to `tolerance`. It fails if they do not, or if a bead runs away before the end, because then there is no
packet to report. */
struct CompressedImpact {
  static constexpr Title title{"impact", "one impact: centre, width and energy of the packet"};
  double time = 724, velocity = 1.87, d = 0.5, tolerance = 1e-4;
  Well well = Quartic{1};

  void parameters(Parameters& p) {
    add_holding_well(p, well, "the phonons are others");
    p.add("time", time, "length of the run", {1, 2e4});
    p.add("velocity", velocity, "impact velocity", {1e-6, 100});
    p.add("d", d, "compression of the contacts", {1e-3, 10});
    p.add("tolerance", tolerance, "relative error allowed in the end state", {1e-11, 0.1});
  }
  Table table() const {
    const Impact impact =
        on_long_chain({velocity, {.well = well, .contact = CompressedHertz{d}}, time});
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
    const ImpactRun &coarse = runs.coarse, &fine = runs.fine;
    const PacketSample a = packet_sample(time, coarse.density),
                       b = packet_sample(time, fine.density);
    const Snapshot rough = snapshot(impact.chain, coarse.end),
                   best = snapshot(impact.chain, fine.end);
    const auto width = [](const Snapshot& shot) {
      const double off = std::abs(shot.sech.centre - shot.centre), limit = envelope_half_width;
      return std::max(off, shot.sech.width) < limit ? shot.sech.width : std::nan("");
    };
    // The packet with the most energy, and how far the run can be trusted
    Answers q{"a --time at which one packet stands out"};
    q.add("centre", compare(a.centre, b.centre), "site",
          "energy centre of the packet that holds the most energy, at the end of the run");
    q.add("width", compare(width(rough), width(best)), "site",
          "width w of the sech((n - n_0)/w) that fits the envelope of its velocities",
          "no sech: the top or the width of the one that fits best lies beyond the " +
              std::to_string(2 * envelope_half_width + 1) + " sites of the fit");
    q.add_small(
        "residual", compare(rough.sech.residual, best.sech.residual), "",
        "root mean square of what this sech leaves of the envelope, relative to its height");
    q.add("energy_fraction", compare(a.share, b.share), "",
          "energy within twenty sites of the packet's peak over that of the chain, at the end");
    q.add_small("boundary_energy_fraction", compare(a.boundary, b.boundary), "",
                "energy of the first five sites over that of the chain, at the end");
    q.add_small("energy_drift", compare(coarse.run.energy_drift, fine.run.energy_drift), "",
                "largest change of the chain's energy during the run, relative to it");
    return q.table;
  }
};

}  // namespace compressed
