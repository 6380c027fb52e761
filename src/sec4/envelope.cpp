#include "sec4/envelope.hpp"

#include <algorithm>
#include <array>

#include "lattice/diagnostics/observe.hpp"

namespace lattice {

Window around(std::size_t peak, std::size_t half_width, std::size_t sites) {
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

// How far the sech is from the envelope
static double misfit(const Sech& f, const std::vector<double>& a, Window range) {
  double sum = 0;
  for (std::size_t n = range.first; n < range.last; ++n)
    sum += std::pow(a[n] - f.at(double(n + 1)), 2);
  return sum / double(range.last - range.first);
}

static double determinant(const double (&t)[3][3]) {
  return t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) -
         t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
         t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]);
}

// One Gauss-Newton step: gather matrix and right-hand side from the derivatives at every site
static std::array<double, 3> sech_step(const Sech& f, const std::vector<double>& a, Window range) {
  double m[3][3] = {}, g[3] = {};
  for (std::size_t n = range.first; n < range.last; ++n) {
    const double x = (double(n + 1) - f.centre) / f.width, y = f.at(double(n + 1));
    const double bend = y * std::tanh(x) / f.width, d[3] = {y / f.height, bend, bend * x};
    for (int i = 0; i < 3; ++i) {
      g[i] += d[i] * (a[n] - y);
      for (int j = 0; j < 3; ++j) m[i][j] += d[i] * d[j];
    }
  }
  // Three equations, solved by Cramer's rule
  std::array<double, 3> step{};
  for (int k = 0; k < 3; ++k) {
    double replaced[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) replaced[i][j] = j == k ? g[i] : m[i][j];
    step[std::size_t(k)] = determinant(replaced) / determinant(m);
  }
  return step;
}

// Start with the peak of the envelope as height and centre of the soliton
Sech fit_sech(const std::vector<double>& a, Window range, double width) {
  const auto first = a.begin() + std::ptrdiff_t(range.first),
             last = a.begin() + std::ptrdiff_t(range.last);
  const auto top = std::max_element(first, last);
  Sech f{*top, double(top - a.begin() + 1), width, 0};
  double now = misfit(f, a, range);
  // Take each step as far as it lessens the misfit, and stop where it no longer does
  for (int i = 0; i < 100; ++i) {
    const std::array<double, 3> step = sech_step(f, a, range);
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

}  // namespace lattice
