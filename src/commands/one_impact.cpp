#include "commands/one_impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "commands/why_no_speed.hpp"
#include "report/model_options.hpp"

namespace lattice {

void OneImpact::parameters(Parameters& p) {
  p.add("velocity", impact.velocity, "impact velocity", {1e-6, 100});
  p.add("time", impact.time, "length of the run", {1, 1e5});
  p.add("sites", sites, "chain length (default: as long as needed)", {2, 1e6});
  add_well(p, impact.chain.well);
  add_contact(p, impact.chain.contact);
  p.add("tolerance", tolerance, "relative error allowed in the end state", {1e-11, 0.1});
  p.add("profile", as_profile, "print the final profile n,y,v,e instead");
}

OneImpact::Found OneImpact::find() const {
  Impact whole = sites ? impact : on_long_chain(impact);
  if (sites) whole.chain.sites = *sites, whole.far_end = may_move;
  return {whole,
          refined(tolerance, [&](const EventCorrected& method) { return strike(method, whole); })};
}

/// The strongest site in both runs; where two sites are nearly as strong these differ.
static void add_strongest(Answers& q, const ImpactRun& coarse, const ImpactRun& fine) {
  const auto a = strongest_site(coarse.density), b = strongest_site(fine.density);
  Estimate e{std::nan(""), std::nan("")};
  std::string reason = fine.density.size() > 5 ? "nothing has moved beyond the first five sites"
                                               : "the chain has no site beyond the first five";
  if (a && b) e = compare(*a, *b);
  if (e.error > e.value) {
    reason = "sites " + std::to_string(*a) + " and " + std::to_string(*b) + " are nearly as strong";
    e = {std::nan(""), std::nan("")};
  }
  q.add("strongest_site", e, "site",
        "site of the largest energy density outside of the first five at the end of the run",
        reason);
}

/**
A quantity that does not exist, such as the speed of a packet that never came so far, is `nan`, with its reason. */
Table OneImpact::quantities(const Found& found) const {
  const auto& [whole, runs] = found;
  const double to = way_end(whole.chain.sites), undefined = std::nan("");
  const auto both = [&coarse = runs.coarse, &fine = runs.fine](auto of) {
    return compare(of(coarse), of(fine));
  };
  // Two runs whose end states differ may agree on a number by chance. The finer one is better by a factor of twenty
  const auto at_end = [&](auto of) {
    Estimate e = both(of);
    e.error = std::max(e.error, std::abs(e.value) * runs.error / 20);
    return e;
  };
  const auto tracked = [&](auto of) {
    return at_end([&](const ImpactRun& out) { return out.path.t.empty() ? undefined : of(out); });
  };
  const Path& path = runs.fine.path;
  const std::string still = why_no_speed(path, runs.fine.density, 5, "energy"),
                    lost = why_no_packet(path);
  Answers q{"a shorter --time or a smaller --tolerance"};
  const auto line = [&](const ImpactRun& out) {
    return out.path.line(fit_from, to).value_or(Line{undefined, undefined, undefined});
  };
  // The foremost packet
  q.add("speed", compare(line(runs.coarse).estimate(), line(runs.fine).estimate()),
        "site per unit of time",
        "speed of the foremost packet, fitted between site 20 and twenty sites before the far end",
        still);
  q.add("centre", tracked([](const ImpactRun& out) { return out.path.centre.back(); }), "site",
        "energy centre of the foremost packet at the end of the run, Eq. (24)", lost);
  add_strongest(q, runs.coarse, runs.fine);
  q.add("peak_energy_density",
        both([&](const ImpactRun& out) { return out.path.largest_peak(fit_from, to); }), "",
        "largest maximum in time of the foremost packet's energy density, of those at which its "
        "centre is on the way on which the speed is fitted",
        still.empty() ? "the energy density has no maximum in time on this way" : still);
  q.add("packet_energy_fraction",
        tracked([](const ImpactRun& out) { return out.path.energy.back() / total(out.density); }),
        "", "energy of the foremost packet (eleven sites) over that of the chain, at the end",
        lost);
  // What stays behind, and how far all of it can be trusted
  q.add_small("boundary_energy_fraction",
              at_end([](const ImpactRun& out) { return boundary_share(out.density); }), "",
              "energy of the first five sites over that of the chain, at the end");
  q.add_small("energy_drift", both([](const ImpactRun& out) { return out.run.energy_drift; }), "",
              "largest change of the chain's energy during the run, relative to it");
  q.add_small("escaped", both([rim = whole.chain.well.rim()](const ImpactRun& out) {
                return int(out.largest_displacement > rim);
              }),
              "", "1 if a bead was beyond the rim of its well at any time, otherwise 0");
  q.add_small("far_end_moved",
              both([&](const ImpactRun& out) { return int(!is_quiet(impact, out)); }), "",
              "1 if the last bead has moved, so that what its end sends back is in these numbers, "
              "otherwise 0");
  return q.table;
}

Table OneImpact::profile(const Found& found) const {
  const ImpactRun& fine = found.runs.fine;
  Table table{{count("n", "site", "site"), number("y", "displacement"), number("v", "velocity"),
               number("e", "energy density")}};
  for (std::size_t n = 0; n < fine.density.size(); ++n)
    table.add({n + 1, fine.end.y[n], fine.end.v[n], fine.density[n]});
  return table;
}

Table OneImpact::table() const {
  const Found found = find();
  return as_profile ? profile(found) : quantities(found);
}

}  // namespace lattice
