#include "sec4/compressed_impact.hpp"

#include <algorithm>
#include <limits>

#include "lattice/integrators/event_corrected.hpp"

namespace lattice {

// Where the packet is at one instant, and which share of the energy it holds
PacketSample packet_sample(double t, const std::vector<double>& e) {
  const std::size_t peak = richest(e, compressed_half_width);
  const Window near = around(peak, compressed_half_width, e.size());
  const std::vector<double> packet(e.begin() + std::ptrdiff_t(near.first),
                                   e.begin() + std::ptrdiff_t(near.last));
  return {t,
          energy_centre(e, peak, compressed_half_width),
          window_sum(e, peak, compressed_half_width) / total(e),
          boundary_share(e),
          participation(e),
          participation(packet)};
}

// The wave on which the packet stands, well away from its centre
double tail_amplitude(const Snapshot& shot, int side) {
  const std::vector<double>& a = shot.envelope.amplitude;
  double squares = 0;
  for (long k = 40; k <= 80; ++k) {
    const double at = a.at(std::size_t(std::lround(shot.sech.centre) - 1 + side * k));
    squares += at * at;
  }
  return std::sqrt(squares / 41) / shot.sech.height;
}

// The envelope about a site, and the sech that fits it best
static Snapshot snapshot_about(double centre, const Chain& chain, const State<double>& state) {
  const Window range = around(std::size_t(centre) - 1, envelope_half_width, chain.sites);
  Snapshot out{state, centre, envelope(chain, state, range), {}};
  out.sech = fit_sech(out.envelope.amplitude, range, 8);
  return out;
}

// About the centre of energy, unless the envelope has its top elsewhere
Snapshot snapshot(const Chain& chain, const State<double>& state) {
  const double centre = packet_sample(state.t, energy_density(chain, state)).centre;
  Snapshot out = snapshot_about(centre, chain, state);
  const Window packet = around(std::size_t(centre) - 1, compressed_half_width, chain.sites);
  const auto a = out.envelope.amplitude.begin();
  const auto top =
      std::max_element(a + std::ptrdiff_t(packet.first), a + std::ptrdiff_t(packet.last));
  const double site = double(top - a) + 1;
  if (std::abs(site - centre) > double(envelope_half_width) / 2)
    out = snapshot_about(site, chain, state);
  return out;
}

Impact compressed_impact(double s, double time, double velocity, double d) {
  return on_long_chain({velocity, {.well = Quartic{s}, .contact = CompressedHertz{d}}, time, 1});
}

// Under precompression the contacts settle, and from then on the splitting takes over
CompressedRun strike_compressed(const Impact& impact, const std::vector<double>& times,
                                CompressedSteps steps) {
  const Chain& chain = impact.chain;
  const double opening = chain.contact.opening();
  CompressedRun out;
  const auto watch = [&](const State<double>& now, const std::vector<double>& density) {
    if (!out.samples.empty() && now.t == out.samples.back().t) return;
    out.samples.push_back(packet_sample(now.t, density));
    // A contact is open where neighbours move apart by more than the precompression
    for (std::size_t n = 0; n + 1 < chain.sites; ++n)
      if (now.y[n + 1] - now.y[n] > opening) out.last_open = now.t;
    for (double t : times)
      if (std::abs(now.t - t) < 1e-6) out.shown.push_back(snapshot(chain, now));
  };
  out.end = struck(chain.sites, impact.velocity);
  const double first = opening > 0 ? std::min(settling_time, impact.time) : impact.time;
  follow(EventCorrected{steps.early}, impact, out, first, watch);
  if (first < impact.time && !out.run.escaped())
    follow(Splitting{blanes_moan_6_14(), steps.late}, impact, out, impact.time, watch);
  return out;
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
