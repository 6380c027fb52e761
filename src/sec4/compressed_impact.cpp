#include "sec4/compressed_impact.hpp"

namespace lattice {

// Where the packet is at one instant, and which share of the energy it holds
PacketSample packet_sample(double t, const std::vector<double>& e) {
  const std::size_t peak = richest(e, packet_reach);
  return {t, energy_centre(e, peak, packet_reach), window_sum(e, peak, packet_reach) / total(e),
          boundary_share(e), participation(e)};
}

// Top and width must lie within the sites of the fit; a packet that is still forming may be rough
Criterion sech_like(const Snapshot& coarse, const Snapshot& fine, bool forming) {
  const auto off = [](const Snapshot& shot) { return std::abs(shot.sech.centre - shot.centre); };
  const double reach = double(envelope_reach);
  Criterion all{below("top", compare(off(coarse), off(fine)), reach),
                below("width", compare(coarse.sech.width, fine.sech.width), reach)};
  if (!forming)
    all.push_back(below("residual", compare(coarse.sech.residual, fine.sech.residual), 0.1));
  return all;
}

// The envelope around the packet's centre and the sech that fits it best
Snapshot snapshot(const Chain& chain, const State<double>& state) {
  const double centre = packet_sample(state.t, energy_density(chain, state)).centre;
  const Range range = around(std::size_t(centre) - 1, envelope_reach, chain.sites);
  Snapshot out{state, centre, envelope(chain, state, range), {}};
  out.sech = fit_sech(out.envelope.amplitude, range, 8);
  return out;
}

// The run of a struck chain, sampled every unit of time
CompressedRun strike_compressed(const CompressedImpact& launch, const Chain& chain,
                                const std::vector<double>& times, CompressedSteps steps) {
  CompressedRun out{struck(chain.sites, launch.velocity)};
  const auto watch = [&](const State<double>& now) {
    if (!out.samples.empty() && now.t == out.samples.back().t) return;
    out.samples.push_back(packet_sample(now.t, energy_density(chain, now)));
    // A contact is open where neighbours move apart by more than the precompression
    for (std::size_t n = 0; n + 1 < chain.sites; ++n)
      if (now.y[n + 1] - now.y[n] > launch.d) out.last_open = now.t;
    for (double t : times)
      if (std::abs(now.t - t) < 1e-6) out.shown.push_back(snapshot(chain, now));
  };
  // Under precompression the contacts settle, and from then on the splitting takes over
  const double first = launch.d > 0 ? std::min(settling_time, launch.time) : launch.time;
  const Splitting late{blanes_moan_6_14(), steps.late};
  const Run run = evolve(ContactAware{steps.early}, chain, out.end, first, 1, watch);
  out.drift = run.energy_drift;
  if (first < launch.time && !run.escaped())
    out.drift += evolve(late, chain, out.end, launch.time - first, 1, watch).energy_drift;
  return out;
}

CompressedRun strike_compressed(const CompressedImpact& launch, const std::vector<double>& times,
                                CompressedSteps steps) {
  return strike_compressed(launch, launch.chain(), times, steps);
}

// A breather keeps its share of the energy and moves on; a train thins out everywhere
Criterion lasting_breather(const Traits& coarse, const Traits& fine) {
  return {above("packet_exponent", fine.with(coarse, &Traits::share_exponent), -1.0 / 6),
          above("steadiness", fine.with(coarse, &Traits::steadiness), 0.5)};
}

Criterion mere_train(const Traits& coarse, const Traits& fine) {
  return {below("packet_exponent", fine.with(coarse, &Traits::share_exponent), -1.0 / 6),
          below("boundary_exponent", fine.with(coarse, &Traits::boundary_exponent), -0.5)};
}

// Without compression a packet may turn back, and a surface mode stay at the struck end
Criterion returning_packet(const Traits& coarse, const Traits& fine) {
  return {below("steadiness", fine.with(coarse, &Traits::steadiness), 0.5)};
}

Criterion lasting_surface_mode(const Traits& coarse, const Traits& fine) {
  return {above("boundary_exponent", fine.with(coarse, &Traits::boundary_exponent), -0.5)};
}

// Power laws of the shares over the last three quarters of the run
Traits traits(const std::vector<PacketSample>& samples) {
  std::vector<double> log_t, share, boundary, t, centre;
  for (const PacketSample& p : samples) {
    if (p.t < samples.back().t / 4) continue;
    log_t.push_back(std::log(p.t));
    share.push_back(std::log(p.share));
    boundary.push_back(std::log(p.boundary));
    t.push_back(p.t);
    centre.push_back(p.centre);
  }
  // The mean speed, and the least advance in any hundred units of time
  const double speed = fit_line(t, centre).slope;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 100 < t.size(); ++i)
    least = std::min(least, (centre[i + 100] - centre[i]) / 100);
  return {samples.back().share,
          fit_line(log_t, share).slope,
          samples.back().boundary,
          fit_line(log_t, boundary).slope,
          speed,
          least / std::abs(speed)};
}

}  // namespace lattice
