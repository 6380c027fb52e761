#pragma once
/**
# 4.2 An impact on a compressed chain (figures 27 and 28)

In section 3.4 a blow on an uncompressed chain made a packet that travelled away or turned round, and
in soft wells a surface mode. What does precompression change? This part of the chapter of section 4
strikes a chain whose contacts are compressed by $d = 1/2$ and answers two claims: in the hard wells
$s = 1$ a travelling breather forms that has a sech-like envelope and does not turn round
(`pre.impact_s1`); for $s = 0$ and $s = -1/6$ there is a dispersive wave train only
(`pre.impact_other`). Equations and symbols are those of sec4_precompression_mi.cpp, whose program
runs it. */

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"
#include "sec4/compressed_impact.hpp"

namespace compressed {

using namespace lattice;

/**
We need to tell a breather, a wave train, a surface mode and a packet that returns apart. The packet's
share of the energy, the boundary's share and the packet's advance decide; sec4/compressed_impact.hpp gives
the criteria. A blow of $v_0 = 1.87$ on the first bead, Eq. (26), opens contacts near the boundary for
a while, the last time at $t =$ [22](num:sec4_precompression_mi.last_open_s_1) or earlier; after
$t = 40$ the method relies on closed ones. The chain is so long that its last bead has not moved at
all when a run ends.

The three impacts of the article run at two resolutions, and so do two controls without
precompression, whose outcome is known from section 3.4: the packet that returns ($s = 1$) and the
surface mode ($s = -1/6$). Criteria that missed these would be worthless. */
struct Experiment {
  std::string name;
  CompressedImpact launch;
  std::vector<double> times;
  CompressedRun coarse{}, fine{};

  /// The criterion `of` on the traits of both runs; its conditions are named after the experiment.
  Criterion judged(Criterion of(const Traits&, const Traits&)) const {
    return named(name, of(traits(coarse.samples), traits(fine.samples)));
  }
};

inline std::vector<Experiment> planned(bool quick) {
  std::vector<Experiment> all = {{"s_1", {1, 3000}, {291, 724, 3000}},
                                 {"s_0", {0, 4399}, {4399}},
                                 {"s_minus_1_6", {-1.0 / 6, 1998}, {1998}},
                                 {"uncompressed_s_1", {1, 1000, 1.87, 0}, {}},
                                 {"uncompressed_s_minus_1_6", {-1.0 / 6, 600, 1.87, 0}, {}}};
  if (!quick) return all;
  all[0] = {"s_1", {1, 1500}, {291, 724, 1500}};
  all[1] = {"s_0", {0, 1000}, {1000}};
  all[2] = {"s_minus_1_6", {-1.0 / 6, 1000}, {1000}};
  return all;
}

/**
The ten runs are independent, and the longest takes as long as several of the others, so they are
handed to the processors one by one. */
inline std::vector<Experiment> experiments(bool quick) {
  std::vector<Experiment> all = planned(quick);
  parallel_for("impacts", 2 * all.size(), [&](std::size_t i) {
    Experiment& e = all[i / 2];
    (i % 2 ? e.fine : e.coarse) = strike_compressed(
        e.launch, e.times, i % 2 ? CompressedSteps{}.halved() : CompressedSteps{});
  });
  return all;
}

/**
The quantities that decide go to the facts, with the difference of the two resolutions. So do those
that justify the method: the drift of the energy, the time of the last open contact, and the velocity
of the last bead, which must not have moved. */
inline void add_traits(Quantities& facts, const Experiment& e) {
  const Traits coarse = traits(e.coarse.samples), fine = traits(e.fine.samples);
  const auto add = [&](const std::string& what, double Traits::*member, const char* unit = "") {
    facts.add(what + "_" + e.name, compare(coarse.*member, fine.*member), unit);
  };
  add("packet_exponent", &Traits::share_exponent);
  add("boundary_exponent", &Traits::boundary_exponent);
  add("steadiness", &Traits::steadiness);
  facts.add("energy_drift_" + e.name, compare(e.coarse.drift, e.fine.drift));
  if (!(e.launch.d > 0)) return;
  add("packet_share", &Traits::share, "share of the energy");
  add("boundary_share", &Traits::boundary, "share of the energy");
  add("speed", &Traits::speed, "site per unit of time");
  facts.add("last_open_" + e.name, {e.fine.last_open, 1});
  facts.add("sites_" + e.name, exact(double(e.launch.sites())), "site");
  facts.add("far_end_" + e.name, exact(std::abs(e.fine.end.v.back())));
}

/**
For figures 27 and 28 we tabulate the velocities, their envelope and the sech fitted to it, and the
packet's share of the energy as a function of time.

![Velocities at three times after an impact, s = 1.](fig:27)
![Wave trains for s = 0 and s = -1/6, and the packet's share of the energy.](fig:28) */
inline Table impact_profiles(const std::vector<Experiment>& all) {
  Table table{{number("s", "anharmonicity of the well"), number("t", "time"),
               count("n", "site", "site"), number("v", "velocity"),
               number("v_error",
                      "difference of two resolutions, against the largest of the column: ahead of "
                      "the front there is only rounding"),
               number("amplitude", "envelope of the velocities"),
               number("sech", "fitted envelope, nan beyond 20 sites from its top")}};
  for (const Experiment& e : all)
    for (std::size_t k = 0; k < e.fine.shown.size(); ++k) {
      const Snapshot &shown = e.fine.shown[k], &coarse = e.coarse.shown[k];
      for (std::size_t n = 0; n < shown.state.v.size(); ++n) {
        const double v = shown.state.v[n], off = double(n + 1) - shown.sech.centre;
        table.add({e.launch.s, shown.state.t, std::int64_t(n + 1), v,
                   std::abs(v - coarse.state.v[n]), shown.envelope.amplitude[n],
                   std::abs(off) < 20 ? shown.sech.at(double(n + 1)) : std::nan("")});
      }
    }
  return table;
}

/**
For the history one sample in five is enough, from the time on at which the packet has left the
boundary. */
inline Table packet_history(const std::vector<Experiment>& all) {
  Table table{{number("s", "anharmonicity of the well"), number("t", "time"),
               number("centre", "centre of the packet", "site"),
               number("share", "share of the energy within 20 sites of the packet"),
               number("boundary", "share of the energy on the first five sites"),
               number("participation", "number of sites that share the energy", "site")}};
  for (const Experiment& e : all)
    for (const PacketSample& p : e.fine.samples)
      if (!e.times.empty() && p.t >= 10 && std::fmod(p.t + 1e-6, 5) < 1e-3)
        table.add({e.launch.s, p.t, p.centre, p.share, p.boundary, p.participation});
  return table;
}

/**
Whether the envelope is sech-like we ask at the three times of the article. At $t = 291$, when
according to the article the breather is forming, only its top and its width are judged
(compressed_impact.hpp). */
inline Criterion report_pulse(Report& report, const Experiment& e) {
  Criterion pulse;
  for (std::size_t k = 0; k < e.times.size(); ++k) {
    const Snapshot &coarse = e.coarse.shown[k], &fine = e.fine.shown[k];
    const std::string at = "_t_" + std::to_string(int(e.times[k]));
    append(pulse, named("sech" + at, sech_like(coarse, fine, k == 0)));
    const auto add = [&](const std::string& what, double Sech::*member, const char* unit = "") {
      report.facts.add("breather_" + what + at, compare(coarse.sech.*member, fine.sech.*member),
                       unit);
    };
    add("centre", &Sech::centre, "site");
    add("width", &Sech::width, "site");
    add("height", &Sech::height);
    add("residual", &Sech::residual);
  }
  return pulse;
}

/**
Now the two claims can be decided. A breather has to keep its energy and must not return, and its envelope
is to be explained by a sech; a wave train keeps energy neither in a packet nor at the boundary. If a control
comes out wrong, neither claim holds, because the conditions could then not tell these outcomes apart. */
inline void report_impacts(Report& report) {
  const std::vector<Experiment> all = experiments(report.quick);
  for (const Experiment& e : all) add_traits(report.facts, e);
  report.output.add("impact_profiles", impact_profiles(all));
  report.output.add("packet_history", packet_history(all));
  const Criterion pulse = report_pulse(report, all[0]);
  for (std::size_t i : {1, 2}) {
    const Sech &coarse = all[i].coarse.shown[0].sech, &fine = all[i].fine.shown[0].sech;
    report.facts.add("front_width_" + all[i].name, compare(coarse.width, fine.width), "site");
  }
  Criterion controls = all[3].judged(returning_packet);
  append(controls, all[4].judged(lasting_surface_mode));
  Criterion made = all[0].judged(lasting_breather), trains = all[1].judged(mere_train);
  append(made, pulse);
  append(made, controls);
  append(trains, all[2].judged(mere_train));
  append(trains, controls);
  judge(report, "pre.impact_s1", made);
  judge(report, "pre.impact_other", trains);
}

/**
The subcommand `impact` does the same for one blow of your choice, in wells of any name; the contact, whose
compression is the subject, stays. The named wells all have the phonons of the harmonic one, on which the
length of the chain rests. It fails if a bead escapes from a soft well before the end, because then there is
no packet to report. */
struct OneImpact {
  static constexpr Title title{"impact", "one impact: centre, width and energy of the packet"};
  CompressedImpact launch{};
  Well well = Quartic{1};

  void parameters(Parameters& p) {
    add_holding_well(p, well, "the phonons are others");
    p.add("time", launch.time, "length of the run", {1, 2e4});
    p.add("velocity", launch.velocity, "impact velocity", {1e-6, 100});
    p.add("d", launch.d, "compression of the contacts", {1e-3, 10});
  }
  Table table() const;
};

inline Table OneImpact::table() const {
  const Chain chain{launch.sites(), well, CompressedHertz{launch.d}};
  const CompressedRun coarse = strike_compressed(launch, chain, {launch.time}, {});
  const CompressedRun fine =
      strike_compressed(launch, chain, {launch.time}, CompressedSteps{}.halved());
  if (fine.shown.empty() || coarse.shown.empty())
    throw Failure("the solution blows up: --velocity is beyond the threshold of this well");
  const PacketSample &a = coarse.samples.back(), &b = fine.samples.back();
  Quantities q;
  q.add("centre", compare(a.centre, b.centre), "site");
  q.add("width", compare(coarse.shown[0].sech.width, fine.shown[0].sech.width), "site");
  q.add("residual", compare(coarse.shown[0].sech.residual, fine.shown[0].sech.residual));
  q.add("energy_fraction", compare(a.share, b.share));
  q.add("boundary_energy_fraction", compare(a.boundary, b.boundary));
  q.add("energy_drift", compare(coarse.drift, fine.drift));
  return q.table;
}

}  // namespace compressed
