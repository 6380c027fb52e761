#include "sec4/packets.hpp"

#include <Eigen/LU>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

// The sites within `half_width` of `peak`
static Window around(std::size_t peak, std::size_t half_width, std::size_t sites) {
  return {peak > half_width ? peak - half_width : 0, std::min(sites, peak + half_width + 1)};
}

// The site, counted from one, of the largest entry in `range`
static double largest_in(const std::vector<double>& a, Window range) {
  const auto first = a.begin() + std::ptrdiff_t(range.first),
             last = a.begin() + std::ptrdiff_t(range.last);
  return double(std::max_element(first, last) - a.begin() + 1);
}

std::size_t richest(const std::vector<double>& e) {
  double best = 0;
  std::size_t at = 0;
  for (std::size_t n = 0; n < e.size(); ++n)
    if (const double sum = window_sum(e, n, compressed_half_width); sum > best) best = sum, at = n;
  return at;
}

PacketSample packet_sample(double t, const std::vector<double>& e) {
  const std::size_t peak = richest(e);
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

// Power laws of the shares over the last three quarters of the run
Traits traits(const std::vector<PacketSample>& samples) {
  std::vector<double> log_t, share, boundary, t, centre;
  for (const PacketSample& p : samples) {
    if (p.t < samples.back().t / 4) continue;
    log_t.push_back(std::log(p.t)), t.push_back(p.t), centre.push_back(p.centre);
    share.push_back(std::log(p.share)), boundary.push_back(std::log(p.boundary));
  }
  const double speed = fit_line(t, centre).slope;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 100 < t.size(); ++i)
    least = std::min(least, (centre[i + 100] - centre[i]) / 100);
  return {fit_line(log_t, share).slope, fit_line(log_t, boundary).slope, speed,
          least / std::abs(speed)};
}

// The carrier's frequency from the packet, then amplitudes from velocity and acceleration
Envelope envelope(const Chain& chain, const State<double>& state, Window range) {
  const std::vector<double> a = accelerations(chain, state.y);
  double aa = 0, vv = 0;
  for (std::size_t n = range.first; n < range.last; ++n) {
    aa += a[n] * a[n];
    vv += state.v[n] * state.v[n];
  }
  Envelope out{std::sqrt(aa / vv), std::vector<double>(a.size())};
  for (std::size_t n = 0; n < a.size(); ++n)
    out.amplitude[n] = std::hypot(state.v[n], a[n] / out.omega);
  return out;
}

static double misfit(const Sech& f, const std::vector<double>& a, Window range) {
  double sum = 0;
  for (std::size_t n = range.first; n < range.last; ++n)
    sum += std::pow(a[n] - f.at(double(n + 1)), 2);
  return sum / double(range.last - range.first);
}

// One Gauss-Newton step: gather matrix and right-hand side from the derivatives at every site
static Eigen::Vector3d sech_step(const Sech& f, const std::vector<double>& a, Window range) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero(), step;
  for (std::size_t n = range.first; n < range.last; ++n) {
    const double x = (double(n + 1) - f.centre) / f.width, y = f.at(double(n + 1));
    const double bend = y * std::tanh(x) / f.width;
    const Eigen::Vector3d d{y / f.height, bend, bend * x};
    g += d * (a[n] - y);
    m += d * d.transpose();
  }
  // Three equations, solved by Cramer's rule
  for (int k = 0; k < 3; ++k) {
    Eigen::Matrix3d replaced = m;
    replaced.col(k) = g;
    step[k] = replaced.determinant() / m.determinant();
  }
  return step;
}

Sech fit_sech(const std::vector<double>& a, Window range, double width) {
  const double top = largest_in(a, range);
  Sech f{a[std::size_t(top) - 1], top, width, 0};
  double now = misfit(f, a, range);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d step = sech_step(f, a, range);
    double part = 1;
    Sech next = f;
    for (; part > 1e-6; part /= 2) {
      next = {f.height + part * step[0], f.centre + part * step[1], f.width + part * step[2], 0};
      if (next.width > 0 && misfit(next, a, range) < now) break;
    }
    if (part <= 1e-6) break;
    f = next;
    now = misfit(f, a, range);
  }
  f.residual = std::sqrt(now) / f.height;
  return f;
}

// About the centre of energy, unless the envelope has its top elsewhere
Snapshot snapshot(const Chain& chain, const State<double>& state) {
  const auto about = [&](double centre) {
    const Window range = around(std::size_t(centre) - 1, envelope_half_width, chain.sites);
    Snapshot out{state, centre, envelope(chain, state, range), {}};
    out.sech = fit_sech(out.envelope.amplitude, range, 8);
    return out;
  };
  const double centre = packet_sample(state.t, energy_density(chain, state)).centre;
  Snapshot out = about(centre);
  const double top = largest_in(
      out.envelope.amplitude, around(std::size_t(centre) - 1, compressed_half_width, chain.sites));
  return std::abs(top - centre) > double(envelope_half_width) / 2 ? about(top) : out;
}

double tail_amplitude(const Snapshot& shot, int side) {
  double squares = 0;
  for (long k = 40; k <= 80; ++k) {
    const double at =
        shot.envelope.amplitude.at(std::size_t(std::lround(shot.sech.centre) - 1 + side * k));
    squares += at * at;
  }
  return std::sqrt(squares / 41) / shot.sech.height;
}

static constexpr double interval = 50;  // between two looks at a pair of runs

static double peak_over_mean(const std::vector<double>& e) {
  return *std::max_element(e.begin(), e.end()) / (total(e) / double(e.size()));
}

// Averaged over five sites; from the top down to half of its height, on either side, between two sites
double packet_width(const std::vector<double>& density) {
  const std::size_t n = density.size();
  std::vector<double> mean(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 5; ++k) mean[i] += density[(i + n + k - 2) % n] / 5;
  const auto top = std::size_t(std::max_element(mean.begin(), mean.end()) - mean.begin());
  const double half = mean[top] / 2;
  double width = 0;
  for (std::size_t step : {std::size_t(1), n - 1}) {
    std::size_t k = 0, at = top;
    for (; k < n && mean[at] > half; ++k) at = (at + step) % n;
    if (k == n) return double(n);
    const double inside = mean[(at + n - step) % n];
    width += double(k) - (half - mean[at]) / (inside - mean[at]);
  }
  return std::min(width, double(n));
}

// The two richest windows on the ring that have no site in common
RingSample ring_sample(const Chain& ring, const State<double>& state) {
  const std::vector<double> e = energy_density(ring, state);
  const std::size_t n = e.size(), half_width = envelope_half_width;
  std::vector<double> content(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k <= 2 * half_width; ++k) content[i] += e[(i + n + k - half_width) % n];
  const auto first =
      std::size_t(std::max_element(content.begin(), content.end()) - content.begin());
  double second = 0;
  for (std::size_t k = 2 * half_width + 1; k + 2 * half_width < n; ++k)
    second = std::max(second, content[(first + k) % n]);
  const double peak = *std::max_element(e.begin(), e.end()) * double(n) / total(e);
  const bool gathered = peak > 5 && 2 * participation(e) < double(n);
  return {state.t, peak, second / content[first], gathered, packet_width(e)};
}

WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state) {
  WatchedRing out{std::move(state)};
  const auto look = [&](const State<double>& now) {
    out.density = energy_density(ring, now);
    out.t.push_back(now.t);
    out.centre.push_back(packet_sample(now.t, out.density).centre);
  };
  evolve(method, ring, out.end, 60, 1, look);
  out.shown = snapshot(ring, out.end);
  return out;
}

// The slope of the centre's path is its speed
Formed formed(const WatchedRing& coarse, const WatchedRing& fine) {
  const auto both = [&](auto of) { return compare(of(coarse.density), of(fine.density)); };
  const auto share = [](const std::vector<double>& e) {
    return participation(e) / double(e.size());
  };
  const Line rough = fit_line(coarse.t, coarse.centre), best = fit_line(fine.t, fine.centre);
  return {both(peak_over_mean),
          both(share),
          {best.slope, best.slope_error + std::abs(best.slope - rough.slope)},
          both(packet_width)};
}

// Two steps side by side, as long as they give the same state
RingPair side_by_side(const Chain& ring, const State<double>& start, double step, double longest,
                      double patience) {
  const std::array<Splitting, 2> method{
      {{blanes_moan_6_14(), step}, {blanes_moan_6_14(), step / 2}}};
  std::array<State<double>, 2> state{start, start};
  RingPair out;
  Progress progress("ring", 1);
  while (state[1].t < longest && !(state[1].t > patience * out.gathered.value)) {
    std::array<RingSample, 2> seen;
    for (std::size_t k : {0, 1}) {
      evolve(method[k], ring, state[k], interval, interval);
      seen[k] = ring_sample(ring, state[k]);
    }
    progress.reach(state[1].t / longest);
    out.agree = Estimate{state[1].t, interval};
    if (!(distance(state[0], state[1]) < 0.1)) return out;
    out.samples.push_back(seen);
    if (out.gathered.value > 0 || !seen[0].gathered || !seen[1].gathered) continue;
    out.gathered = {state[1].t, interval};
    for (std::size_t k : {0, 1}) out.packet[k] = watch_packet(method[k], ring, state[k]);
  }
  out.agree = exact(state[1].t);
  return out;
}

// What is read from a pair
Estimate RingPair::width() const {
  Estimate least{std::nan(""), std::nan("")};
  for (const auto& [coarse, fine] : samples)
    if (fine.t >= gathered.value && fine.t <= 1.5 * gathered.value && !(fine.width >= least.value))
      least = compare(coarse.width, fine.width);
  return least;
}

// One pulse on its way round the ring, then two, and in the end two that stand apart
PulseSplits pulse_splits(const RingPair& pair, double round) {
  double since = std::nan(""), alone = 0, split = std::nan(""), apart = std::nan("");
  for (const auto& [coarse, fine] : pair.samples) {
    if (!(fine.t >= pair.gathered.value)) continue;
    const bool one = coarse.second < 0.5 && fine.second < 0.5;
    const bool two = coarse.second >= 0.5 && fine.second >= 0.5;
    if (std::isnan(split)) {
      if (one && std::isnan(since)) since = fine.t;
      if (one) alone = std::max(alone, fine.t - since);
      if (two && alone >= round) split = fine.t;
      if (two) since = std::nan("");
    }
    if (!std::isnan(split) && std::isnan(apart) && two && coarse.gathered && fine.gathered)
      apart = fine.t;
  }
  return {{alone, interval}, {split, interval}, {apart, interval}};
}

}  // namespace lattice
