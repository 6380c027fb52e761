#include "sec4/packets.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/line_fit.hpp"

namespace lattice {

// The sites within `half_width` of `peak`
static Window around(std::size_t peak, std::size_t half_width, std::size_t sites) {
  return {peak > half_width ? peak - half_width : 0, std::min(sites, peak + half_width + 1)};
}

// Slide a window along the chain and keep the centre of the one that holds the most energy
std::size_t richest(const std::vector<double>& e, std::size_t half_width) {
  double sum = window_sum(e, 0, half_width), best = sum;
  std::size_t at = 0;
  for (std::size_t n = 1; n < e.size(); ++n) {
    if (n + half_width < e.size()) sum += e[n + half_width];
    if (n > half_width) sum -= e[n - half_width - 1];
    if (sum > best) best = sum, at = n;
  }
  return at;
}

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
  const auto first = a.begin() + std::ptrdiff_t(range.first),
             last = a.begin() + std::ptrdiff_t(range.last);
  const auto top = std::max_element(first, last);
  Sech f{*top, double(top - a.begin() + 1), width, 0};
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
  const Window packet = around(std::size_t(centre) - 1, compressed_half_width, chain.sites);
  const auto a = out.envelope.amplitude.begin();
  const double top =
      double(std::max_element(a + std::ptrdiff_t(packet.first), a + std::ptrdiff_t(packet.last)) -
             a) +
      1;
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

}  // namespace lattice
