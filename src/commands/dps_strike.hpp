#pragma once
/**
# The DpS impact with your own parameters

`sec31_dps_limit impact --tau 250` strikes the first site of a DpS chain, $A_1(0) = -i$, and measures
the packet that runs away, in the way of the impact chapter (sec34_dps_impact.cpp): its centre, its speed between site 20
and twenty sites before the far end, its amplitude, its share of the norm within five sites of its peak, and the share left
on the first ten sites. All are dimensionless and hold for every $\epsilon$. The error is the difference from a run with a
thousand times the tolerance and half the samples; the speed also carries the error of the fit. In Python this is
`lattice.dps`.

How fast a front is nobody has proved, and after an impact on a fixed end it is faster. So a chain whose last site
has moved is lengthened and struck again. If you choose the end yourself with `--sites`, what it sends back
belongs to the run. After a long time the motion behind the packet is chaotic: the profile has an error for every site,
and where the two runs differ by half of the largest amplitude, nothing is known and nothing is printed. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "commands/why_no_speed.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

/// The command: its parameters (dimensionless), its two runs, its tables.
struct DpsStrike {
  static constexpr Title title{
      "impact", "impact in the DpS equation: the packet, and the norm left at the struck end"};
  double tau = 250;                    ///< length of the run in slow time
  std::optional<std::size_t> sites{};  ///< otherwise long enough for the packet
  Ends end = Ends::free;               ///< where the impact is: free or fixed
  double alpha = 1.5;                  ///< exponent of the contact force

  void parameters(Parameters& p) {
    p.add("tau", tau, "duration of the run in the slow time tau", {1, 1e4});
    p.add("sites", sites, "number of sites (default: as many as needed)", {2, 1e5});
    p.add("end", end, "boundary condition at the struck end",
          {{"free", Ends::free}, {"fixed", Ends::fixed}});
    p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres",
          {1.05, 4, "",
           "at 1 the equation is linear and packets disperse; exponents above 4 are untested"});
  }
  using Found = std::array<DpsOutcome, 2>;  ///< the coarser and the finer run

  /// Most fronts are slower than `fastest`; where another one has moved the far end the chain was too short. Throws
  /// Failure where the two runs have nothing in common, std::runtime_error if GSL cannot go on.
  Found find() const {
    const double quiet = 1e-9;  // |A_n| of an end that has not moved; the struck site has 1
    const double fastest = alpha == 1.5 ? 0.4 : std::max(0.5, 1 / (2 * tau_0(alpha)));
    Found runs;
    for (std::size_t n = sites.value_or(20 + std::size_t(std::ceil(fastest * tau)));; n += n / 2) {
      parallel_for(2, [&](std::size_t k) {
        const double samples = std::ceil(fastest / 0.4 * (k ? 4 : 2) * std::max(tau, 25.0));
        runs[k] =
            follow_dps({n, end, alpha}, dps_impact(n), tau, std::size_t(samples), k ? 1e-11 : 1e-8);
      });
      if (sites || std::max(runs[0].far_end, runs[1].far_end) <= quiet) break;
    }
    double most = 0, apart = 0;
    for (std::size_t n = 0; n < runs[1].end.size(); ++n) {
      most = std::max(most, std::abs(runs[1].end[n]));
      apart = std::max(apart, std::abs(runs[1].end[n] - runs[0].end[n]));
    }
    if (apart > most / 2)
      throw Failure("the final states of two tolerances differ by " + short_text(apart) +
                    ", the largest amplitude being " + short_text(most) +
                    ": the motion is too erratic for so long a run; take a shorter --tau");
    return runs;
  }

  /// What both runs give. A test compares it with what the impact chapter measures in a run of its own.
  Table quantities(const Found& runs) const {
    const auto both = [&](auto of) {
      const bool none = runs[0].path.empty() || runs[1].path.empty();
      return none ? undefined : with_error(of(runs[0]), of(runs[1]));
    };
    const double to = way_end(runs[1].end.size());
    const Path& path = runs[1].path;
    const std::string lost = why_no_packet(path),
                      still = why_no_speed(path, density(runs[1].end), 10, "norm");
    Answers q;
    q.add("centre", both([](const DpsOutcome& out) { return out.path.back().centre; }), "site",
          "centre of the norm of the foremost packet at the end of the run, as in Eq. (24)", lost);
    q.add(
        "speed", both([&](const DpsOutcome& out) {
          const auto line = out.path.line(fit_from, to);
          return line ? line->estimate() : undefined;
        }),
        "site per tau",
        "speed of the foremost packet, fitted between site 20 and twenty sites before the far end",
        still);
    q.add("amplitude", both([](const DpsOutcome& out) { return packet_amplitude(out.path); }), "",
          "largest maximum in time of |A_n| of the foremost packet, on the last site that it "
          "reaches, or the last two",
          lost.empty() ? "|A_n| of the packet has no maximum in time on its last two sites" : lost);
    q.add("norm_window", both([](const DpsOutcome& out) { return out.path.back().energy; }), "",
          "sum of |A_n|^2 over the eleven sites about the packet's peak at the end; the sum over "
          "all sites is 1",
          lost);
    q.add_small(
        "residual_boundary",
        both([](const DpsOutcome& out) { return boundary_share(density(out.end), 10); }), "",
        "sum of |A_n|^2 over the first ten sites at the end, divided by that over all sites");
    return q.table;
  }

  /// The field at the end, site by site.
  Table profile(const Found& runs) const {
    Table table{{count("n", "site", "site"), number("real", "real part of A_n at the end"),
                 number("imag", "imaginary part of A_n at the end"),
                 number("error", "difference of the two runs, a distance in the complex plane")}};
    const Field &coarse = runs[0].end, &field = runs[1].end;
    for (std::size_t n = 0; n < field.size(); ++n)
      table.add({n + 1, field[n].real(), field[n].imag(),
                 Estimate{std::abs(field[n]), std::abs(field[n] - coarse[n])}.error});
    return table;
  }
  Table table() const { return quantities(find()); }
};

}  // namespace lattice
