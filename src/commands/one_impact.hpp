#pragma once
/**
# One impact with your own parameters

`sec34_impact run --velocity 1.87 --s -0.1667 --time 587` measures a single impact in the way of section 3.4
(sec34_impact.cpp), for any well and, with `--precompression`, for the compressed contacts of section 4. The speed is
fitted on the way out, from site 20 to twenty sites before the far end. Over a long stretch a packet slows down as it
sheds energy, so the value depends on the window. The command fails if a bead runs away, because then there is no packet
to measure, and if the motion reaches the far end, unless you choose the end yourself with `--sites`: then what it sends
back belongs to the run, and `far_end_moved` says whether there is any.

The packet that is measured is the foremost one. In soft wells it is the breather of the article. In hard wells a weak
packet may run ahead of the one that has most of the energy, and `strongest_site` tells where this is; how it
turns round is measured by `sec34_boomeron run`.

In Python this is `lattice.strike`, which also takes chains that no option can describe. */

#include <algorithm>
#include <cmath>
#include <string>

#include "commands/why_no_speed.hpp"
#include "lattice/impact/impact.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

/// The strongest site in both runs. Where two sites are nearly as strong these differ, and it may be that neither is
/// the strongest.
inline void add_strongest(Answers& q, const ImpactRun& coarse, const ImpactRun& fine) {
  const auto a = strongest_site(coarse.density), b = strongest_site(fine.density);
  Estimate e = undefined;
  std::string reason = fine.density.size() > 5 ? "nothing has moved beyond the first five sites"
                                               : "the chain has no site beyond the first five";
  if (a && b) e = with_error(*a, *b);
  if (e.error > e.value) {
    reason =
        "sites " + std::to_string(*a) + " and " + std::to_string(*b) + " are almost equally strong";
    e = undefined;
  }
  q.add("strongest_site", e, "site",
        "site of the largest energy density at the end of the run, apart from the first five sites",
        reason);
}

/// The command: the impact (dimensionless), its two runs, its tables.
struct OneImpact {
  static constexpr Title title{
      "run", "one impact: speed, centre and energies of the foremost packet",
      "A quantity that does not exist is nan; the column reason says why.\nFor s > 0 most of the "
      "energy may lag behind the foremost packet, at strongest_site;\nsec34_boomeron run follows "
      "that packet, which turns back."};
  Impact impact{1.87, {.well = Quartic{}}, 600};
  std::optional<std::size_t> sites{};  ///< otherwise as many as needed
  bool as_profile = false;             ///< whether `table` is the profile
  double tolerance = 1e-4;  ///< on which the end states agree, relative to their largest entry

  void parameters(Parameters& p) {
    p.add("velocity", impact.velocity, "velocity of the impact on the first bead", {1e-6, 100});
    p.add("time", impact.time, "duration of the run", {1, 1e5});
    p.add("sites", sites, "number of sites (default: as many as needed)", {2, 1e6});
    add_well(p, impact.chain.well);
    add_contact(p, impact.chain.contact);
    p.add("tolerance", tolerance, "relative error allowed in the final state", {1e-11, 0.1});
    p.add("profile", as_profile, "print the final profile (columns n, y, v, e) instead");
  }

  struct Found {
    Impact impact;            ///< on a chain that has a length
    Refined<ImpactRun> runs;  ///< that agree to the tolerance
  };
  /// Both runs. Throws RefinementFailed, FarEndReached, and RanAway if a bead runs away.
  Found find() const {
    Impact whole = sites ? impact : on_long_chain(impact);
    if (sites) whole.chain = whole.chain.with_sites(*sites), whole.far_end = may_move;
    return {whole, refined(tolerance,
                           [&](const EventCorrected& method) { return strike(method, whole); })};
  }

  /// Speed, place and energies of the packet, and how far they can be trusted.
  Table quantities(const Found& found) const {
    const auto& [whole, runs] = found;
    const double to = way_end(whole.chain.sites), none = std::nan("");
    const auto both = [&runs = runs](auto of) { return runs.of(of); };
    const auto at_end = [&runs = runs](auto of) { return runs.at_end(of); };
    const auto tracked = [&](auto of) {
      return at_end([&](const ImpactRun& out) { return out.path.empty() ? none : of(out); });
    };
    const Path& path = runs.fine.path;
    const std::string still = why_no_speed(path, runs.fine.density, 5, "energy"),
                      lost = why_no_packet(path);
    Answers q{"a shorter --time or a smaller --tolerance"};
    const auto line = [&](const ImpactRun& out) {
      return out.path.line(fit_from, to).value_or(Line{none, none, none});
    };
    // The foremost packet
    q.add(
        "speed", both([&](const ImpactRun& out) { return line(out).estimate(); }),
        "site per unit of time",
        "speed of the foremost packet, fitted between site 20 and twenty sites before the far end",
        still);
    q.add("centre", tracked([](const ImpactRun& out) { return out.path.back().centre; }), "site",
          "energy centre of the foremost packet at the end of the run, Eq. (24)", lost);
    add_strongest(q, runs.coarse, runs.fine);
    q.add("peak_energy_density",
          both([&](const ImpactRun& out) { return out.path.largest_peak(fit_from, to); }), "",
          "largest maximum in time of the foremost packet's energy density while its centre is on "
          "the stretch over which the speed is fitted",
          still.empty() ? "the energy density has no maximum in time on this stretch" : still);
    q.add("packet_energy_fraction",
          tracked([](const ImpactRun& out) { return out.path.back().energy / total(out.density); }),
          "",
          "energy of the foremost packet (eleven sites) divided by that of the chain, at the end",
          lost);
    // What stays behind, and how far all of it can be trusted
    q.add_small("boundary_energy_fraction",
                at_end([](const ImpactRun& out) { return boundary_share(out.density); }), "",
                "energy of the first five sites divided by that of the chain, at the end");
    q.add_small("energy_drift", both([](const ImpactRun& out) { return out.run.energy_drift; }), "",
                "largest relative change of the chain's energy during the run");
    q.add_small("escaped", both([rim = whole.chain.well.rim()](const ImpactRun& out) {
                  return int(out.largest_displacement > rim);
                }),
                "",
                "1 if any bead ever passed the potential maximum (rim) of its well, otherwise 0");
    q.add_small("far_end_moved",
                both([&](const ImpactRun& out) { return int(!is_quiet(impact, out)); }), "",
                "1 if the last bead has moved, so that these numbers include reflections from that "
                "end, otherwise 0");
    return q.table;
  }

  /// The state at the end, bead by bead.
  Table profile(const Found& found) const {
    const ImpactRun& fine = found.runs.fine;
    Table table{{count("n", "site", "site"), number("y", "displacement"), number("v", "velocity"),
                 number("e", "energy density")}};
    for (std::size_t n = 0; n < fine.density.size(); ++n)
      table.add({n + 1, fine.end.y[n], fine.end.v[n], fine.density[n]});
    return table;
  }
  Table table() const { return as_profile ? profile(find()) : quantities(find()); }
};

}  // namespace lattice
