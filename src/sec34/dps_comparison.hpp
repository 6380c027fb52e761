#pragma once
/**
# An impact in the chain and in the DpS equation, compared

What the chapter `sec34_dps_impact` measures on states of the chain (y and v) and of the DpS equation (the amplitudes A). */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/dps/evolve.hpp"
#include "lattice/impact/impact.hpp"
#include "report/program.hpp"

namespace lattice {
using namespace report;

/// The approximation, Eq. (13), at t = 0, from the right-hand side of the DpS equation alone: the largest displacement,
/// and the velocities of the first bead beyond 2 eps, of the second and, largest, of the others.
struct ApproximateStart {
  double place = 0, first = 0, second = 0, others = 0;
};
inline ApproximateStart approximate_start(std::size_t sites, double eps) {
  const std::vector<double> a = interleaved(dps_impact(sites));
  std::vector<double> rate(2 * sites);
  Dps{sites}(0, a.data(), rate.data());
  const auto velocity = [&](std::size_t n) {
    return 2 * eps * (-a[2 * n + 1] + std::sqrt(eps) * rate[2 * n]);
  };
  ApproximateStart out;
  for (std::size_t n = 0; n < sites; ++n)
    out.place = std::max(out.place, std::abs(2 * eps * a[2 * n]));
  for (std::size_t n = 2; n < sites; ++n) out.others = std::max(out.others, std::abs(velocity(n)));
  out.first = velocity(0) - 2 * eps;
  out.second = velocity(1);
  return out;
}
/// Table `start`: this for impacts of several sizes. Table `scales`: the size at which breathers have the frequency
/// 1.01, Eq. (20), and the time of the slow time `tau` there.
inline void report_start(Report& report, std::size_t sites, double tau) {
  const double eps_101 = breather_eps(1.01);
  report.table("scales").add({{"eps", exact(eps_101)}, {"end", exact(tau / std::sqrt(eps_101))}});
  Table& start = report.table("start");
  for (double eps : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const ApproximateStart at = approximate_start(sites, eps);
    const auto of = [eps](double v) { return Estimate(v, 1e-15 * eps); };
    start.add({{"eps", eps},
               {"place", exact(at.place)},
               {"first", of(at.first)},
               {"second", of(at.second)},
               {"others", exact(at.others)}});
  }
}

/// The residue at the boundary during a stretch of time: the largest norm of the first ten sites and, at its end, the
/// norm of the first 40 sites and how many of them share it (participation number).
struct ResidueStretch {
  double tau, first_ten = 0, first_forty = 0, sharing = 0;
};
/// Stretches of the length `every` that end at `from`, `from` + `every` and so on; `tau` and `A` are the samples.
inline std::vector<ResidueStretch> residue_stretches(const std::vector<double>& tau,
                                                     const std::vector<Field>& A, double from,
                                                     double every) {
  std::vector<ResidueStretch> out;
  for (double end = from; end <= tau.back() + 1e-9; end += every) {
    ResidueStretch s{end};
    for (std::size_t k = 0; k < tau.size(); ++k) {
      if (tau[k] < end - every - 1e-9 || tau[k] >= end + 1e-9) continue;
      const std::vector<double> d = density(A[k]);
      s.first_ten = std::max(s.first_ten, std::accumulate(d.begin(), d.begin() + 10, 0.0));
      if (tau[k] <= end - 1e-9) continue;
      s.first_forty = std::accumulate(d.begin(), d.begin() + 40, 0.0);
      s.sharing = participation({d.begin(), d.begin() + 40});
    }
    out.push_back(s);
  }
  return out;
}
/// Up to ten sites behind both packets
inline std::size_t end_of_train(const std::vector<double>& chain, const std::vector<double>& dps) {
  return std::min(*front_packet(chain), *front_packet(dps)) - 10;
}

/// The energies of the sites n - m to n + m
inline double sites_apart(const std::vector<double>& chain, const std::vector<double>& dps,
                          std::size_t m) {
  double apart = 0, largest = 0;
  for (std::size_t n = m; n + m < end_of_train(chain, dps); ++n) {
    const double in_chain = std::sqrt(window_sum(chain, n, m));
    apart = std::max(apart, std::abs(std::sqrt(window_sum(dps, n, m)) - in_chain));
    largest = std::max(largest, in_chain);
  }
  return apart / largest;
}

/// How far the energy densities of the chain and of the approximation differ, up to ten sites behind both packets, at
/// most: roots of all energy, relative; roots at a site or over eleven sites, over the largest one in the chain.
struct TrainDifference {
  double all = 0, site = 0, eleven = 0;
  void add(const std::vector<double>& chain, const std::vector<double>& dps) {
    const auto until = std::ptrdiff_t(end_of_train(chain, dps));
    const auto sum = [&](const auto& e) {
      return std::accumulate(e.begin(), e.begin() + until, 0.0);
    };
    all = std::max(all, std::abs(std::sqrt(sum(dps)) / std::sqrt(sum(chain)) - 1));
    site = std::max(site, sites_apart(chain, dps, 0));
    eleven = std::max(eleven, sites_apart(chain, dps, packet_half_width));
  }
};

/// Of the packet in a snapshot, within five sites of its peak: from crest to trough, and the largest displacement.
struct Amplitude {
  double height = 0, displacement = 0;
};
inline Amplitude amplitude(const State<double>& now, std::size_t peak) {
  const std::size_t m = packet_half_width, from = peak > m ? peak - m : 0,
                    until = std::min(peak + m + 1, now.y.size());
  const auto [trough, crest] = std::minmax_element(now.y.begin() + std::ptrdiff_t(from),
                                                   now.y.begin() + std::ptrdiff_t(until));
  return {*crest - *trough, std::max(*crest, -*trough)};
}
inline Amplitude amplitude(const Chain& chain, const State<double>& now) {
  return amplitude(now, *front_packet(energy_density(chain, now)));
}

/// The heights at these instants, in both models, from these starts.
struct Heights {
  std::vector<double> t{}, chain{}, dps{};
};
inline Heights heights_at(const Chain& chain, State<double> state, Field A, double eps, double from,
                          double to, std::size_t instants, const EventCorrected& method,
                          double dps_tolerance) {
  Heights out;
  evolve(method, chain, state, from, Every{5});
  evolve(method, chain, state, to - state.t, Every{(to - from) / double(instants - 1)},
         [&](const State<double>& now) {
           out.t.push_back(now.t);
           out.chain.push_back(amplitude(chain, now).height);
         });
  // The DpS equation, in its slow time
  const Dps dps{chain.sites};
  const double rate = std::sqrt(eps);
  evolve_dps(dps, A, rate * from, 1, dps_tolerance);
  evolve_dps(dps, A, rate * (to - from), instants - 1, dps_tolerance,
             [&](double tau, const Field& now) {
               const double t = from + tau / rate;
               out.dps.push_back(amplitude(chain, dps_state(now, eps, t)).height);
             });
  return out;
}

}  // namespace lattice
