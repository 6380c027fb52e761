#pragma once
/**
# Envelopes

Under precompression a packet is a wave, the carrier, with a slowly varying amplitude, its envelope. If the
motion is nearly harmonic with frequency $\omega$, velocity and acceleration are a quarter of a period
apart, and
$$a_n = \sqrt{v_n^2 + (\ddot y_n/\omega)^2}, \qquad
  \omega^2 = \sum \ddot y_n^2 \Big/ \sum v_n^2$$
is the amplitude of the velocity at site $n$, free of the carrier. A soliton of the NLS equation (nls.hpp)
has the envelope $a\,\mathrm{sech}((n-n_0)/w)$, Eq. (38). How far a packet is from that form is seen from
the residual of a least-squares fit. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/measure/observe.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/// A range of sites, first <= n < last.
struct Range {
  std::size_t first = 0, last = 0;
};

/// The sites within `reach` of `peak`.
inline Range around(std::size_t peak, std::size_t reach, std::size_t sites) {
  return {peak > reach ? peak - reach : 0, std::min(sites, peak + reach + 1)};
}

/**
Among phonons the largest single density need not belong to the packet. So we look for the site around
which all sites within `reach` together hold the most energy. */
inline std::size_t richest(const std::vector<double>& e, std::size_t reach) {
  double sum = window_sum(e, 0, reach), best = sum;
  std::size_t at = 0;
  for (std::size_t n = 1; n < e.size(); ++n) {
    if (n + reach < e.size()) sum += e[n + reach];
    if (n > reach) sum -= e[n - reach - 1];
    if (sum > best) best = sum, at = n;
  }
  return at;
}

/**
The frequency of the carrier is that of the packet and not of the waves behind it, so it is taken from the
sites of `range`; with it the amplitude of the velocity is computed everywhere. */
struct Envelope {
  double omega = 0;
  std::vector<double> amplitude{};
};

/// Frequency of the carrier in `range` and amplitudes of all sites.
template <class Onsite, class Contact>
Envelope envelope(const Chain<Onsite, Contact>& chain, const State<double>& state, Range range) {
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

/**
The soliton's form has three parameters: height, centre (sites counted from one) and width. What it does
not explain of an envelope is the `residual`, the root mean square deviation relative to the height. */
struct Sech {
  double height = 0, centre = 0, width = 0, residual = 0;
  double at(double n) const { return height / std::cosh((n - centre) / width); }
};

/// Mean square deviation of `f` from the values in `range`.
inline double misfit(const Sech& f, const std::vector<double>& a, Range range) {
  double sum = 0;
  for (std::size_t n = range.first; n < range.last; ++n)
    sum += std::pow(a[n] - f.at(double(n + 1)), 2);
  return sum / double(range.last - range.first);
}

/**
The three parameters follow by the Gauss–Newton method. With $\nabla f$ the derivatives of the sech $f$
with respect to height, centre and width, its matrix $m$ is the sum of $\nabla f\,\nabla f^T$ over the
sites, its right-hand side $g$ that of $\nabla f\,(a_n - f)$. The matrix has three rows, so Cramer's rule
will do. */
inline double determinant(const double (&t)[3][3]) {
  return t[0][0] * (t[1][1] * t[2][2] - t[1][2] * t[2][1]) -
         t[0][1] * (t[1][0] * t[2][2] - t[1][2] * t[2][0]) +
         t[0][2] * (t[1][0] * t[2][1] - t[1][1] * t[2][0]);
}

inline std::array<double, 3> sech_step(const Sech& f, const std::vector<double>& a, Range range) {
  double m[3][3] = {}, g[3] = {};
  for (std::size_t n = range.first; n < range.last; ++n) {
    const double x = (double(n + 1) - f.centre) / f.width, y = f.at(double(n + 1));
    const double bend = y * std::tanh(x) / f.width, d[3] = {y / f.height, bend, bend * x};
    for (int i = 0; i < 3; ++i) {
      g[i] += d[i] * (a[n] - y);
      for (int j = 0; j < 3; ++j) m[i][j] += d[i] * d[j];
    }
  }
  std::array<double, 3> step{};
  for (int k = 0; k < 3; ++k) {
    double replaced[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) replaced[i][j] = j == k ? g[i] : m[i][j];
    step[std::size_t(k)] = determinant(replaced) / determinant(m);
  }
  return step;
}

/**
`fit_sech` returns the sech that fits the values `a` in `range` best. The iteration starts at their maximum
with the given `width`. A step that does not lessen the misfit is halved; if no part of it does, we have
arrived. */
inline Sech fit_sech(const std::vector<double>& a, Range range, double width) {
  const auto first = a.begin() + std::ptrdiff_t(range.first),
             last = a.begin() + std::ptrdiff_t(range.last);
  const auto top = std::max_element(first, last);
  Sech f{*top, double(top - a.begin() + 1), width, 0};
  double now = misfit(f, a, range);
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
