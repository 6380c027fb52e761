#include "sec4/impact_tables.hpp"

#include <cmath>
#include <utility>

namespace lattice {

void StruckChain::record(const Strike& of, const Chain& chain, const State<double>& now,
                         const std::vector<double>& e) {
  if (!samples.empty() && now.t == samples.back().t) return;
  samples.push_back(packet_sample(now.t, e));
  for (std::size_t n = 0; n + 1 < now.y.size(); ++n)
    if (now.y[n + 1] - now.y[n] > of.compression) last_open = now.t;
  for (double t : of.shown)
    if (std::abs(now.t - t) < 1e-6) {
      shown.push_back(snapshot(chain, now));
      density.push_back(e);
    }
}
void StruckChain::check(const Strike& of) const {
  const bool closes = of.closed < of.time;
  if (run.run.escaped()) throw Failure("a bead escapes");
  if (run.run.energy_drift > (closes ? 1e-8 : 1e-6)) throw Failure("energy is lost");
  if (closes && last_open > of.closed) throw Failure("a contact opens late");
}

static void report_profiles(Report& report, std::span<const Struck> compressed) {
  Table &profiles = report.table("impact_profiles"), &history = report.table("packet_history");
  for (const auto& [of, runs] : compressed) {
    // Velocities and the sech, at the times of the figures
    for (std::size_t k = 0; k < of.shown.size(); ++k) {
      const Snapshot &shown = runs.fine.shown[k], &coarse = runs.coarse.shown[k];
      for (std::size_t n = 0; n < shown.state.v.size(); ++n) {
        const double site = double(n + 1), v = shown.state.v[n];
        const bool near = std::abs(site - shown.sech.centre) < 20;
        profiles.add(
            {{"s", "anharmonicity of the well", of.s},
             {"t", "time", shown.state.t},
             {"n", "site", n + 1, "site"},
             {"v", "velocity", Estimate{v, std::abs(v - coarse.state.v[n])}, "",
              "difference of two resolutions, against the largest of the column: ahead of the "
              "front there is only rounding"},
             {"sech", "fitted envelope; nan beyond 20 sites from its centre",
              near ? shown.sech.at(site) : std::nan("")}});
      }
    }
    // The packet's fraction once it has left the boundary; one sample in five is enough
    for (const PacketSample& p : runs.fine.samples)
      if (p.t >= 10 && std::fmod(p.t + 1e-6, 5) < 1e-3)
        history.add({{"s", "anharmonicity of the well", of.s},
                     {"t", "time", p.t},
                     {"share", "fraction of the energy within 20 sites of the packet", p.share}});
  }
}

// A trait over the last three quarters of a run; the error includes what the last half would give
template <class Of>
static Estimate later(const TwoRuns<StruckChain>& runs, Of of) {
  const auto from = [&](double part) {
    return compare(of(traits(runs.coarse.samples, part)), of(traits(runs.fine.samples, part)));
  };
  return compare(from(0.5), from(0.25));
}
static Estimate boundary_exponent(const TwoRuns<StruckChain>& runs) {
  return later(runs, [](const Traits& its) { return its.boundary_exponent; });
}
static Estimate steadiness(const TwoRuns<StruckChain>& runs) {
  return later(runs, [](const Traits& its) { return its.steadiness; });
}

static void report_exponents(Report& report, std::span<const Struck> compressed) {
  // Power laws in time, for packets of three widths
  Table& table = report.table("impacts");
  const char* how =
      "two resolutions and two stretches of the run, against the largest, known to 5 per cent";
  for (const auto& [of, runs] : compressed)
    table.add({{"s", "anharmonicity of the well", of.s},
               {"share_exponent", "exponent in time of the packet's fraction of the energy",
                later(runs, [](const Traits& its) { return its.share_exponent; }), "", how},
               {"narrow_exponent", "the same of a packet of 21 sites",
                later(runs, [](const Traits& its) { return its.narrow_exponent; }), "", how},
               {"wide_exponent", "the same of a packet of 81 sites",
                later(runs, [](const Traits& its) { return its.wide_exponent; }), "", how},
               {"boundary_exponent", "exponent of the fraction of the first five sites",
                boundary_exponent(runs), "", how},
               {"steadiness", "least advance in 100 units of time over the mean one",
                steadiness(runs), "", how}});
}

// Fractions of the energy, and how they fall
void report_trains(Report& report, std::span<const Struck> compressed) {
  report_profiles(report, compressed);
  report_exponents(report, compressed);
}

void report_linear_train(Report& report, const Struck& weak) {
  const char* how =
      "two resolutions and two stretches of the run, against the largest, known to 20 per cent";
  report.table("linear_train")
      .add({{"share_exponent", "exponent in time of the packet's fraction of the energy",
             later(weak.runs, [](const Traits& its) { return its.share_exponent; }), "", how},
            {"narrow_exponent", "the same of a packet of 21 sites",
             later(weak.runs, [](const Traits& its) { return its.narrow_exponent; }), "", how}});
}

void report_splitting(Report& report, const RingPair& pair, double round) {
  const PulseSplits splits = pulse_splits(pair, round);
  const char* how = "difference of two resolutions; nan in a quick run";
  report.table("splitting")
      .add({{"round", "time in which a phonon goes round the ring", exact(round), "", "exact"},
            {"one_pulse_for", "from localization until a second pulse is half as high",
             splits.one_pulse_for, "",
             "interval of the samples, known to 7 per cent; nan in a quick run"},
            {"second", "largest height of a second pulse over the first", splits.second, "", how},
            {"kept", "the largest that persists once round the ring", splits.kept, "", how},
            {"of_figure", "largest height of a second maximum of the displacements' envelope",
             splits.of_figure, "", how},
            {"in_windows", "largest energy of a second range of 21 sites over the first",
             splits.in_windows, "", how},
            {"in_windows_localized", "the same while the energy is localized",
             splits.in_windows_localized, "", how}});
}

void report_uncompressed(Report& report, const Struck& turns, const Struck& surface) {
  report.table("uncompressed")
      .add({{"steadiness", "for s = 1, least advance in 100 units of time over the mean one",
             steadiness(turns.runs), "",
             "two resolutions and two stretches of the run, known to 41 per cent"},
            {"boundary_exponent", "for s = -1/6, exponent of the fraction of the first five sites",
             boundary_exponent(surface.runs), "",
             "two resolutions and two stretches of the run, known to 77 per cent"}});
}

// The sech that fits the breather, and the waves around it
static void report_envelope(Report& report, const Struck& hard) {
  const auto& [coarse, fine] = hard.runs;
  Table& fits = report.table("envelope_fits");
  for (std::size_t k = 0; k < hard.of.shown.size(); ++k) {
    const TwoRuns<Snapshot> shot{coarse.shown[k], fine.shown[k]};
    fits.add(
        {{"t", "time", hard.of.shown[k]},
         {"reach", "larger one of its width and the distance of its top from the 21 sites' middle",
          shot.of([](const Snapshot& at) { return at.reach(); }), "site"},
         {"residual", "root mean square misfit of the sech over its height",
          shot.of([](const Snapshot& at) { return at.sech.residual; })},
         {"residual_15", "the same of a sech fitted to 15 sites",
          shot.of([](const Snapshot& at) { return sech_within(at, 7).residual; })},
         {"residual_31", "the same of a sech fitted to 31 sites",
          shot.of([](const Snapshot& at) { return sech_within(at, 15).residual; })},
         {"relative", "misfit over the root mean square of the envelope on the 21 sites",
          shot.of([](const Snapshot& at) {
            return at.sech.residual * at.sech.height / rms_of_fit(at);
          })},
         {"train", "highest wave more than 30 sites behind it over its height",
          shot.of([](const Snapshot& at) { return train_amplitude(at); })}});
  }

  // The tail around it at the end
  Table& tails = report.table("tails");
  const TwoRuns<Snapshot> end{coarse.shown.back(), fine.shown.back()};
  for (const auto& [near, far] : {std::pair{40, 80}, {30, 60}, {60, 120}}) {
    const auto tail = [&](int side) {
      return compare(tail_amplitude(end.coarse, side, near, far),
                     tail_amplitude(end.fine, side, near, far));
    };
    tails.add({{"near", "from so many sites from its centre", near, "site"},
               {"far", "to so many", far, "site"},
               {"behind", "root mean square of the envelope behind it over its height", tail(-1)},
               {"ahead", "the same ahead of it", tail(1)}});
  }
}

// Packets with and without compression, at the times of figures 27 and 23
static void report_widths(Report& report, const Struck& breather, const Struck& uncompressed) {
  Table& sites = report.table("packet_sites");
  for (const Struck& one : {breather, uncompressed})
    for (std::size_t k = 0; k < one.of.shown.size(); ++k) {
      const TwoRuns<std::vector<double>> density{one.runs.coarse.density[k],
                                                 one.runs.fine.density[k]};
      sites.add({{"compression", "of the contacts, d", one.of.compression},
                 {"t", "time", one.of.shown[k]},
                 {"sites", "participation number of the packet, within 20 sites",
                  density.of([](const auto& e) { return packet_participation(e, 20); }), "site"},
                 {"narrow", "the same within 10 sites",
                  density.of([](const auto& e) { return packet_participation(e, 10); }), "site"},
                 {"width", "width of its energy density at half height", density.of(packet_width),
                  "site"}});
    }
}

void report_breather(Report& report, const Struck& breather, const Struck& uncompressed) {
  report_envelope(report, breather);
  report_widths(report, breather, uncompressed);
}

}  // namespace lattice
