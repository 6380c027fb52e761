#include "sec4/packets.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "lattice/diagnostics/path.hpp"
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

// A window's energy is the difference of two sums
static std::size_t richest(const std::vector<double>& e) {
  std::vector<double> before(e.size() + 1, 0.0);
  std::partial_sum(e.begin(), e.end(), before.begin() + 1);
  double best = 0;
  std::size_t at = 0;
  for (std::size_t n = 0; n < e.size(); ++n) {
    const Window range = around(n, compressed_half_width, e.size());
    if (const double sum = before[range.last] - before[range.first]; sum > best) best = sum, at = n;
  }
  return at;
}

PacketSample packet_sample(double t, const std::vector<double>& e) {
  const std::size_t peak = richest(e);
  const Window near = around(peak, compressed_half_width, e.size());
  return {t, energy_centre(e, peak, compressed_half_width),
          window_sum(e, peak, compressed_half_width) / total(e), boundary_share(e),
          participation(
              {e.begin() + std::ptrdiff_t(near.first), e.begin() + std::ptrdiff_t(near.last)})};
}

double mean_sites(const std::vector<PacketSample>& samples, double t, double time) {
  std::vector<double> sites;
  for (const PacketSample& p : samples)
    if (p.t > t + 0.5 - time && p.t < t + 0.5) sites.push_back(p.sites);
  return total(sites) / double(sites.size());
}

// Power laws of the fractions over the rest of the run
Traits traits(const std::vector<PacketSample>& samples, double from) {
  std::vector<double> log_t, t, centre, share, boundary;
  for (const PacketSample& p : samples) {
    if (p.t < samples.back().t * from) continue;
    log_t.push_back(std::log(p.t));
    t.push_back(p.t);
    centre.push_back(p.centre);
    share.push_back(std::log(p.share));
    boundary.push_back(std::log(p.boundary));
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
  for (std::size_t n = range.first; n < range.last; ++n) {
    const double off = a[n] - f.at(double(n + 1));
    sum += off * off;
  }
  return sum / double(range.last - range.first);
}

// One Gauss-Newton step, from the derivatives at every site
static Eigen::Vector3d sech_step(const Sech& f, const std::vector<double>& a, Window range) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  for (std::size_t n = range.first; n < range.last; ++n) {
    const double x = (double(n + 1) - f.centre) / f.width, y = f.at(double(n + 1));
    const double bend = y * std::tanh(x) / f.width;
    const Eigen::Vector3d d{y / f.height, bend, bend * x};
    g += d * (a[n] - y);
    m += d * d.transpose();
  }
  return m.inverse() * g;
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
  const std::vector<double> e = energy_density(chain, state);
  const auto about = [&](double centre) {
    const Window range = around(std::size_t(centre) - 1, envelope_half_width, chain.sites);
    Snapshot out{state, e, centre, envelope(chain, state, range), {}};
    out.sech = fit_sech(out.envelope.amplitude, range, 8);
    return out;
  };
  const double centre = packet_sample(state.t, e).centre;
  Snapshot out = about(centre);
  const double top = largest_in(
      out.envelope.amplitude, around(std::size_t(centre) - 1, compressed_half_width, chain.sites));
  return std::abs(top - centre) > double(envelope_half_width) / 2 ? about(top) : out;
}

// What is left of the wave beside the packet
double tail_amplitude(const Snapshot& shot, int side) {
  double squares = 0;
  for (long k = 40; k <= 80; ++k) {
    const double at =
        shot.envelope.amplitude.at(std::size_t(std::lround(shot.sech.centre) - 1 + side * k));
    squares += at * at;
  }
  return std::sqrt(squares / 41) / shot.sech.height;
}

double train_amplitude(const Snapshot& shot) {
  const auto end = std::lround(shot.sech.centre) - 1 - 30;
  const auto first = shot.envelope.amplitude.begin();
  return *std::max_element(first, first + end) / shot.sech.height;
}

static constexpr double interval = 50;  // between two samples of a pair of runs

static double peak_over_mean(const std::vector<double>& e) {
  return *std::max_element(e.begin(), e.end()) / (total(e) / double(e.size()));
}

// Because the carrier makes the density oscillate
static std::vector<double> averaged_over_five(const std::vector<double>& a) {
  const std::size_t n = a.size();
  std::vector<double> mean(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 5; ++k) mean[i] += a[(i + n + k - 2) % n] / 5;
  return mean;
}

// From the top down to half of its height, on either side, between two sites
double packet_width(const std::vector<double>& density) {
  const std::size_t n = density.size();
  const std::vector<double> mean = averaged_over_five(density);
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

// Round the ring from the top, with the least value met on either way
double second_hump(const std::vector<double>& a) {
  std::vector<double> from_top = averaged_over_five(a);
  std::rotate(from_top.begin(), std::max_element(from_top.begin(), from_top.end()), from_top.end());
  std::vector<double> before = from_top, after = from_top;
  for (std::size_t i = 1; i < before.size(); ++i) before[i] = std::min(before[i - 1], before[i]);
  for (std::size_t i = after.size() - 1; i > 0; --i)
    after[i - 1] = std::min(after[i], after[i - 1]);
  double second = 0;
  for (std::size_t i = 1; i < from_top.size(); ++i)
    if (2 * std::max(before[i], after[i]) < from_top[i]) second = std::max(second, from_top[i]);
  return second / from_top[0];
}

bool is_localized(const std::vector<double>& e) {
  return peak_over_mean(e) > 5 && 2 * participation(e) < double(e.size());
}

RingSample ring_sample(const Chain& ring, const State<double>& state) {
  const std::vector<double> e = energy_density(ring, state);
  return {state.t, packet_width(e), second_hump(e), is_localized(e)};
}

WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state) {
  WatchedRing out;
  evolve(method, ring, state, watched_time, Every{1}, [&](const State<double>& now) {
    out.t.push_back(now.t);
    out.centre.push_back(packet_sample(now.t, energy_density(ring, now)).centre);
  });
  out.end = snapshot(ring, state);
  return out;
}

// The slope of the centre's path is its speed
Packet packet_of(const TwoRuns<WatchedRing>& runs) {
  const auto of_density = [&](auto of) {
    return runs.of([of](const WatchedRing& run) { return of(run.end.density); });
  };
  const auto share = [](const std::vector<double>& e) {
    return participation(e) / double(e.size());
  };
  const Line rough = fit_line(runs.coarse.t, runs.coarse.centre),
             best = fit_line(runs.fine.t, runs.fine.centre);
  return {of_density(peak_over_mean),
          of_density(share),
          {best.slope, best.slope_error + std::abs(best.slope - rough.slope)},
          of_density(packet_width)};
}

// Stage by stage as `Splitting`; between two steps the stretch of every contact is seen
double WatchedSplitting::advance(const Chain& chain, State<double>& state, Window& window, double h,
                                 std::size_t count) const {
  const std::size_t in_a_step = stage_count(method.scheme, 1) - 1;
  double work = 0;
  for (std::size_t k = 0; k < stage_count(method.scheme, count); ++k) {
    const Stage<double> stage = stage_at<double>(method.scheme, h, count, k);
    kick_drift(chain, state, window, stage.kick, stage.drift);
    work += double(window.last - window.first);
    if ((k + 1) % in_a_step != 0) continue;
    const auto contacts = Eigen::Index(chain.sites - 1);
    const Eigen::Map<const Eigen::ArrayXd> y(state.y.data(), contacts + 1);
    const double most = (y.tail(contacts) - y.head(contacts)).maxCoeff();
    *largest_stretch = std::max(*largest_stretch, most);
    if (chain.ends == Ends::periodic)
      *largest_stretch = std::max(*largest_stretch, state.y.front() - state.y.back());
  }
  return work;
}

// Two steps side by side, as long as they give the same state
RingPair side_by_side(const Chain& ring, const State<double>& start, double step, double longest,
                      double multiple) {
  std::array<double, 2> stretch{};
  const std::array<WatchedSplitting, 2> method{
      {{{blanes_moan_6_14(), step}, &stretch[0]}, {{blanes_moan_6_14(), step / 2}, &stretch[1]}}};
  std::array<State<double>, 2> state{start, start};
  RingPair out;
  Progress progress("ring", 1);
  while (state[1].t < longest && !(state[1].t > multiple * out.localized.value)) {
    std::array<RingSample, 2> seen;
    for (std::size_t k : {0, 1}) {
      evolve(method[k], ring, state[k], interval);
      seen[k] = ring_sample(ring, state[k]);
    }
    progress.reach(state[1].t / longest);
    out.agree = Estimate{state[1].t, interval};
    out.stretch = with_error(stretch[0], stretch[1]);
    if (!(distance(state[0], state[1]) < 0.1)) return out;
    out.samples.push_back(seen);
    if (out.localized.value > 0 || !seen[0].localized || !seen[1].localized) continue;
    out.localized = {state[1].t, interval};
    out.later = {watch_packet(method[0], ring, state[0]), watch_packet(method[1], ring, state[1])};
  }
  out.agree = exact(state[1].t);
  return out;
}

// What is read from a pair
Estimate RingPair::width() const {
  Estimate least = undefined;
  for (const auto& [coarse, fine] : samples)
    if (fine.t >= localized.value && fine.t <= 1.5 * localized.value &&
        !(fine.width >= least.value))
      least = with_error(coarse.width, fine.width);
  return least;
}

// One pulse on its way round the ring, then two
PulseSplits pulse_splits(const RingPair& pair, double round) {
  using Pair = std::array<RingSample, 2>;
  std::vector<Pair> seen;
  for (const Pair& both : pair.samples)
    if (both[1].t >= pair.localized.value && both[1].t <= 2 * pair.localized.value)
      seen.push_back(both);
  if (seen.empty()) return {};
  Estimate largest{0, 0};
  for (const auto& [coarse, fine] : seen)
    if (fine.second > largest.value) largest = with_error(coarse.second, fine.second);
  const auto two = std::ranges::find_if(
      seen, [](const Pair& both) { return std::max(both[0].second, both[1].second) >= 0.5; });
  const double until = two == seen.end() ? seen.back()[1].t : (*two)[1].t;

  // The least of all samples of a way round the ring, and the largest of these
  const auto samples = std::ptrdiff_t(std::ceil(round / interval)) + 1;
  Estimate kept{0, 0};
  for (auto from = seen.begin(); seen.end() - from >= samples; ++from) {
    const auto least = std::min_element(from, from + samples, [](const Pair& a, const Pair& b) {
      return a[1].second < b[1].second;
    });
    if ((*least)[1].second > kept.value) kept = with_error((*least)[0].second, (*least)[1].second);
  }
  return {{until - pair.localized.value, interval}, largest, kept};
}

}  // namespace lattice
