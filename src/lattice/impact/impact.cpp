#include "lattice/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace lattice {

// The fastest phonon of a chain whose contacts are as stiff as those of the strongest pulse
Impact on_long_chain(Impact impact) {
  const double well = impact.chain.well.stiffness(0.0);
  const double more = impact.chain.contact.exponent() + 1;
  const double pulse =
      0.8 * std::pow(impact.velocity, 2 * (more - 2) / more) / std::pow(0.4 * more, 2 / more);
  const double contact = std::max(impact.chain.contact.stiffness(0.0), pulse);
  const double fastest = (std::sqrt(well + 4 * contact) - std::sqrt(well)) / 2;
  impact.chain = impact.chain.with_sites(100 + std::size_t(1.15 * fastest * impact.time));
  return impact;
}

State<double> struck(std::size_t sites, double velocity) {
  if (sites == 0) throw std::invalid_argument("a chain without sites cannot be struck");
  State<double> state(sites);
  state.v[0] = velocity;
  return state;
}

bool is_quiet(const Impact& impact, const ImpactRun& run) {
  return run.far_end <= impact.far_end * std::abs(impact.velocity);
}

ImpactRun strike(const Method& method, const Impact& impact, const ImpactLook& watch) {
  ImpactRun run{struck(impact.chain.sites, impact.velocity)};
  continue_strike(method, impact, run, impact.time, watch);
  return run;
}

// If the energy is not conserved, a far end that moves says nothing, and the run is broken
static void refuse_moving_end(const Impact& impact, ImpactRun& run) {
  if (is_quiet(impact, run)) return;
  if (run.run.energy_error > largest_energy_error) {
    run.run.escape_time = run.end.t;
    return;
  }
  std::ostringstream text;
  text << "the motion reaches the far end: site " << impact.chain.sites << " has reached the speed "
       << run.far_end << " by t = " << run.end.t
       << " (allowed: " << impact.far_end * std::abs(impact.velocity)
       << "); take more sites or a shorter time";
  throw FarEndReached(text.str());
}

// Look at every sample; the run ends where somebody wants it to, the far end moves, or the packet has passed
void continue_strike(const Method& method, const Impact& impact, ImpactRun& run, double time,
                     const ImpactLook& watch) {
  const bool strongest = impact.packet == WhichPacket::strongest;
  const std::size_t each = impact.denser ? std::size_t(1) << std::max(method.halvings, 0) : 1;
  std::size_t k = 0;
  const auto look = [&](const State<double>& now) {
    run.density = energy_density(impact.chain, now);
    const bool on = watch(now, run.density), first = k++ == 0;
    if (strongest) run.path.add(now.t, run.density);
    if (first) return on;
    for (double y : now.y)
      run.largest_displacement = std::max(run.largest_displacement, std::abs(y));
    run.far_end = std::max(run.far_end, std::abs(now.v.back()));
    if (!strongest)
      if (const auto site = front_packet(run.density)) run.path.add(now.t, run.density, *site);
    const bool passed = impact.until && !run.path.empty() && run.path.back().t == now.t &&
                        run.path.back().centre >= *impact.until;
    return on && is_quiet(impact, run) && ((k - 1) % each != 0 || !passed);
  };
  const Every every = impact.denser ? denser(impact.every) : Every{impact.every};
  run.run = joined(run.run, evolve(method, impact.chain, run.end, time - run.end.t, every, look));
  refuse_moving_end(impact, run);
}

double total(const std::vector<double>& e) {
  return std::accumulate(e.begin(), e.end(), 0.0);
}

double boundary_share(const std::vector<double>& e, std::size_t sites) {
  return std::accumulate(e.begin(), e.begin() + std::ptrdiff_t(std::min(sites, e.size())), 0.0) /
         total(e);
}

std::optional<std::size_t> strongest_site(const std::vector<double>& e, std::size_t sites) {
  if (e.size() <= sites) return {};
  const auto most = std::max_element(e.begin() + std::ptrdiff_t(sites), e.end());
  if (!(*most > 0)) return {};
  return std::size_t(most - e.begin()) + 1;
}

}  // namespace lattice
