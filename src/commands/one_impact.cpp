#include "commands/one_impact.hpp"

#include <cmath>
#include <string>

#include "report/model_options.hpp"

namespace lattice {

void OneImpact::parameters(Parameters& p) {
  p.add("velocity", impact.velocity, "impact velocity", {1e-6, 100});
  p.add("time", impact.time, "length of the run", {1, 1e5});
  p.add("sites", impact.chain.sites, "chain length (default: as long as needed)", {2, 1e6});
  add_well(p, impact.chain.well);
  add_contact(p, impact.chain.contact);
  p.add("tolerance", tolerance, "relative error allowed in the end state", {1e-11, 0.1});
  p.add("profile", as_profile, "print the final profile n,y,v,e instead");
}

OneImpact::Found OneImpact::find() const {
  Impact whole = complete(impact);
  if (impact.chain.sites > 0) whole.far_end = reached;
  Found found{whole, strike_to(tolerance, whole)};
  const Run& run = found.runs.fine.run;
  if (run.escaped())
    throw Failure("the solution blows up at t = " + std::to_string(run.escape_time) +
                  ": --velocity is beyond the threshold of this well");
  return found;
}

/**
A run of any length must print something, so a quantity that does not exist, such as the speed of a
packet that never came so far, is `nan`. */
Table OneImpact::quantities(const Found& found) const {
  const auto& [whole, runs] = found;
  const double to = double(whole.chain.sites) - 20, undefined = std::nan("");
  const auto both = [&coarse = runs.coarse, &fine = runs.fine](auto of) {
    return compare(of(coarse), of(fine));
  };
  const auto tracked = [&](auto of) {
    return both([&](const ImpactRun& out) { return out.track.t.empty() ? undefined : of(out); });
  };
  Quantities q;
  const auto line = [&](const ImpactRun& out) {
    return out.track.line(fit_from, to).value_or(Line{undefined, undefined, undefined});
  };
  q.add("speed", compare(line(runs.coarse).estimate(), line(runs.fine).estimate()),
        "site per unit of time");
  q.add("centre", tracked([](const ImpactRun& out) { return out.track.centre.back(); }), "site");
  q.add("peak_energy_density", both([&](const ImpactRun& out) {
          const double peak = out.track.largest_peak(fit_from, to);
          return peak > 0 ? peak : undefined;
        }));
  q.add("packet_energy_fraction",
        tracked([](const ImpactRun& out) { return out.track.energy.back() / total(out.density); }));
  q.add("boundary_energy_fraction",
        both([](const ImpactRun& out) { return boundary_share(out.density); }));
  q.add("energy_drift", both([](const ImpactRun& out) { return out.run.energy_drift; }));
  q.add("escaped", both([rim = whole.chain.well.rim()](const ImpactRun& out) {
          return int(out.reach > rim);
        }));
  return q.table;
}

/**
The reader may rather want to see the wave than to measure it: `--profile` prints the state at the
end instead. */
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
