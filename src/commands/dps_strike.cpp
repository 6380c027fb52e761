#include "commands/dps_strike.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "commands/why_no_speed.hpp"
#include "lattice/numerics/parallel.hpp"

namespace lattice {

/// |A_n| of a far end that has not moved; the struck site has 1.
static constexpr double quiet = 1e-9;

void DpsStrike::parameters(Parameters& p) {
  p.add("tau", tau, "slow time of the run", {1, 1e4});
  p.add("sites", sites, "chain length (default: as long as needed)", {2, 1e5});
  p.add("end", end, "end where the impact is", {{"free", Ends::free}, {"fixed", Ends::fixed}});
  p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres",
        {1.05, 4, "", "at 1 the equation is linear and packets disperse; more than 4 is untested"});
}

// Most fronts are slower than `fastest`; what another one brings to the far end comes back, and the chain was too short
DpsStrike::Found DpsStrike::find() const {
  const double fastest = alpha == 1.5 ? 0.4 : std::max(0.5, 1 / (2 * tau_0(alpha)));
  Found runs;
  for (std::size_t n = sites.value_or(20 + std::size_t(std::ceil(fastest * tau)));; n += n / 2) {
    parallel_for(2, [&](std::size_t k) {
      const double samples = std::ceil(fastest / 0.4 * (k ? 4 : 2) * std::max(tau, 25.0));
      runs[k] =
          follow_dps({n, end, alpha}, dps_impact(n), tau, std::size_t(samples), k ? 1e-11 : 1e-8);
    });
    if (sites || std::max(runs[0].far_end, runs[1].far_end) <= quiet) return runs;
  }
}

/**
The error needs both runs, and both give the same five quantities. A test compares the first of them with
those that the impact chapter measures in a run of its own. */
Table DpsStrike::quantities(const Found& runs) const {
  const auto both = [&](auto of) {
    const bool none = runs[0].path.t.empty() || runs[1].path.t.empty();
    return none ? Estimate{std::nan(""), std::nan("")} : compare(of(runs[0]), of(runs[1]));
  };
  const double to = way_end(runs[1].end.size());
  const Path& path = runs[1].path;
  const std::string lost = why_no_packet(path),
                    still = why_no_speed(path, density(runs[1].end), 10, "norm");
  Answers q;
  q.add("centre", both([](const DpsOutcome& out) { return out.path.centre.back(); }), "site",
        "centre of the norm of the foremost packet at the end of the run, as in Eq. (24)", lost);
  q.add("speed", both([&](const DpsOutcome& out) {
          const auto line = out.path.line(fit_from, to);
          return line ? line->estimate() : Estimate{std::nan(""), std::nan("")};
        }),
        "site per tau",
        "speed of the foremost packet, fitted between site 20 and twenty sites before the far end",
        still);
  q.add("amplitude", both([](const DpsOutcome& out) { return packet_amplitude(out.path); }), "",
        "largest maximum in time of |A_n| of the foremost packet over the last site of its way, or "
        "the last two",
        lost.empty() ? "|A_n| of the packet has no maximum in time on its last two sites" : lost);
  q.add("norm_window", both([](const DpsOutcome& out) { return out.path.energy.back(); }), "",
        "sum of |A_n|^2 over the eleven sites about the packet's peak at the end; 1 in all", lost);
  q.add_small("residual_boundary",
              both([](const DpsOutcome& out) { return boundary_share(density(out.end), 10); }), "",
              "sum of |A_n|^2 over the first ten sites at the end, over that of all sites");
  return q.table;
}

Table DpsStrike::profile(const Found& runs) const {
  Table table{{count("n", "site", "site"), number("real", "real part of A_n at the end"),
               number("imag", "imaginary part of A_n at the end")}};
  const Field& field = runs[1].end;
  for (std::size_t n = 0; n < field.size(); ++n)
    table.add({n + 1, field[n].real(), field[n].imag()});
  return table;
}

}  // namespace lattice
