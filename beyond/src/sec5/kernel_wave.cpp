#include "sec5/kernel_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace lattice {

namespace {

constexpr double notable = 1e-8;  ///< contacts below this part of the peak need no cuts
constexpr double tail = 1e-17;    ///< the grid ends where the wave has fallen to this part

Vector<double> each(Vector<double> d, double (*of)(const PowerContact&, double),
                    const PowerContact& law) {
  for (double& x : d) x = x > 0 ? of(law, x) : 0;
  return d;
}

double force_of(const PowerContact& law, double x) {
  return law.force(-x);
}
double stiffness_of(const PowerContact& law, double x) {
  return law.stiffness(-x);
}

/// A power of half an integer becomes analytic on panels of order 2; others gain from order 3.
QuadraturePanel panel_for(const PowerContact& law, std::size_t nodes) {
  const double twice = 2 * law.exponent;
  return {nodes, std::size_t(twice == std::round(twice) ? 2 : 3)};
}

/// Scales u so that the norm of f = u^alpha is one, and returns f.
Vector<double> normalized(const PowerContact& law, const Vector<double>& weight,
                          Vector<double>& u) {
  Vector<double> f = each(u, force_of, law);
  const double mass = weight.dot(u.cwiseProduct(f)), a = law.exponent;
  u *= std::pow(mass, -1 / (a + 1));
  f *= std::pow(mass, -a / (a + 1));
  return f;
}

/**
Where the quotient $\int f\,(K*f)\,dt/\|f\|_p^2$ is largest, $K*f = Sf^{1/\alpha}$ wherever $f > 0$. So we write $f =
u^\alpha$ with $u \ge 0$ and repeat $u \leftarrow (K*u^\alpha+\mu u)_+$ with the norm kept at one. Since $K$ is not
positive, the step may go down if $\mu$ is too small; it is then refused and repeated with twice the $\mu$. */
Vector<double> ascended(const HalfLine& line, const PowerContact& law, Vector<double> u) {
  constexpr double enough = 1e-7;  // the relative growth with which the ascent ends
  const Vector<double> weight = 2 * line.weight();
  const Vector<double> f = normalized(law, weight, u);
  Vector<double> image = line.convolve(f);
  double quotient = weight.dot(f.cwiseProduct(image)), mu = 1;
  for (int tries = 0; tries < 400 && mu < 1e6; ++tries) {
    Vector<double> trial = (image + mu * u).cwiseMax(0);
    const Vector<double> force = normalized(law, weight, trial), next = line.convolve(force);
    const double higher = weight.dot(force.cwiseProduct(next)), grown = higher - quotient;
    if (!(grown > 0)) {
      mu *= 2;
      continue;
    }
    mu *= 0.8;
    u = trial, image = next, quotient = higher;
    if (grown < enough * higher) break;
  }
  return std::pow(quotient, -law.exponent / (law.exponent - 1)) * image;
}

/**
The zeros are folded into half a shift. Where panels would be too long they are divided. */
std::vector<double> cuts_for(const std::vector<Closed>& contacts, double shift_time,
                             double longest) {
  std::vector<double> folded{shift_time / 2};
  const auto fold = [&](double t) {
    const double rest = std::fmod(t, shift_time);
    folded.push_back(std::min(rest, shift_time - rest));
  };
  for (const Closed& c : contacts) {
    if (c.from > 0) fold(c.from);
    fold(c.to);
  }
  std::sort(folded.begin(), folded.end());
  // Zeros that nearly coincide share a cut
  constexpr double near = 1e-6;
  std::vector<double> cuts{0};
  for (double t : folded) {
    const bool end = t == shift_time / 2;
    if (!end && (t < cuts.back() + near || t > shift_time / 2 - near)) continue;
    const double from = cuts.back();
    const auto parts = std::size_t(std::ceil((t - from) / longest));
    for (std::size_t i = 1; i < parts; ++i)
      cuts.push_back(from + (t - from) * double(i) / double(parts));
    cuts.push_back(t);
    if (end) break;
  }
  return cuts;
}

/// Shift times until the wave has died out; more than there are if it does not on its grid.
std::size_t periods_for(const KernelWave& wave) {
  const double least = tail * wave.d.cwiseAbs().maxCoeff();
  Eigen::Index last = wave.d.size() - 1;
  while (last > 0 && std::abs(wave.d[last]) < least) --last;
  const auto needed = std::size_t(std::ceil(wave.line.t()[last] / wave.shift_time()));
  return needed < wave.line.periods() ? needed + 1 : needed + 1 + needed / 4;
}

/**
Newton's method knows the tail to the digits of the peak only. There one step of the kernel equation
divides errors by a large number, and repeating it gives the tail all its digits. */
void settle_tail(KernelWave& wave) {
  const double top = wave.d.maxCoeff();
  Eigen::Index first = wave.d.size();
  while (first > 0 && std::abs(wave.d[first - 1]) < 1e-4 * top) --first;
  const Eigen::Index rest = wave.d.size() - first;
  for (std::size_t pass = 0; pass < wave.line.periods(); ++pass)
    wave.d.tail(rest) = wave.line.convolve(wave.force()).tail(rest).eval();
}

HalfLine line_for(const KernelWave& wave, double shift_time, const WaveGrid& grid) {
  return {shift_time, cuts_for(wave.closed(notable), shift_time, grid.longest), periods_for(wave),
          panel_for(wave.law, grid.nodes)};
}

}  // namespace

Vector<double> KernelWave::force() const {
  return each(d, force_of, law);
}

double KernelWave::action() const {
  return line.integral(d.cwiseMax(0).cwiseProduct(force()));
}

double KernelWave::quotient() const {
  return std::pow(action(), -(law.exponent - 1) / (law.exponent + 1));
}

double KernelWave::component() const {
  return line.respond(force()).component;
}

double KernelWave::residual() const {
  const Vector<double> residual = line.convolve(force()) - d;
  return residual.cwiseAbs().maxCoeff() / d.maxCoeff();
}

/**
The largest value lies between two nodes, where the interval is narrowed down. */
double KernelWave::peak() const {
  Eigen::Index top = 0;
  d.maxCoeff(&top);
  double low = top > 0 ? line.t()[top - 1] : -line.t()[0], high = line.t()[top + 1];
  for (int pass = 0; pass < 60; ++pass) {
    const double third = (high - low) / 3;
    if (line.at(d, low + third) < line.at(d, high - third))
      low += third;
    else
      high -= third;
  }
  return line.at(d, (low + high) / 2);
}

std::vector<Closed> KernelWave::closed(double least) const {
  const double limit = least * d.maxCoeff();
  std::vector<Closed> all;
  Closed now{0, 0, std::max(d[0], 0.0)};
  for (Eigen::Index i = 0; i + 1 < d.size(); ++i) {
    now.most = std::max(now.most, d[i]);
    const bool opens = d[i] > 0;
    if (opens == (d[i + 1] > 0)) continue;
    // A zero between two nodes, by bisection
    double low = line.t()[i], high = line.t()[i + 1];
    for (int pass = 0; pass < 56; ++pass) {
      const double middle = (low + high) / 2;
      ((line.at(d, middle) > 0) == opens ? low : high) = middle;
    }
    if (!opens) {
      now = {low, 0, 0};
      continue;
    }
    now.to = low;
    if (now.most > limit) all.push_back(now);
  }
  // The last one does not open again on the grid
  now.to = double(line.periods()) * shift_time();
  if (d[d.size() - 1] > 0 && now.most > limit) all.push_back(now);
  return all;
}

std::size_t KernelWave::contacts() const {
  const auto half = closed(std::numeric_limits<double>::epsilon());
  return 2 * half.size() - std::size_t(d[0] > 0);
}

double KernelWave::central_velocity() const {
  const auto response = line.respond(force());
  return 2 * response.half_v[0] + std::cos(shift_time() / 2) * response.component;
}

State<double> KernelWave::state(std::size_t half_length) const {
  const auto response = line.respond(force());
  State<double> z(2 * half_length + 2);
  z.v[half_length] = central_velocity();
  for (std::size_t j = 0; j <= half_length && j < response.half.size(); ++j) {
    const bool last = j + 1 == response.half.size();
    const double y = (last ? 0 : response.half[j + 1]) - response.half[j],
                 v = (last ? 0 : response.half_v[j + 1]) - response.half_v[j];
    z.y[half_length + j + 1] = -y, z.v[half_length + j + 1] = v;
    if (j < half_length) z.y[half_length - j - 1] = y, z.v[half_length - j - 1] = v;
  }
  return z;
}

double KernelWave::energy() const {
  const State<double> z = state(line.periods());
  double sum = 0;
  for (std::size_t i = 0; i < z.y.size(); ++i) sum += (z.y[i] * z.y[i] + z.v[i] * z.v[i]) / 2;
  for (std::size_t j = 0; j < line.periods(); ++j)
    sum += 2 * law.energy(-line.at(d, (double(j) + 0.5) * shift_time()));
  return sum;
}

/**
The Hessenberg matrix of the method is made triangular by rotations, step by step, so that the residual is
known without a solution. */
Vector<double> solve_linearized(const HalfLine& line, const Vector<double>& stiffness,
                                const Vector<double>& right, double enough) {
  constexpr std::size_t most = 200;
  const double whole = right.norm();
  std::vector<Vector<double>> basis{right / whole};
  std::vector<std::vector<double>> columns;
  std::vector<double> cosine, sine, rest{whole};
  while (std::abs(rest.back()) > enough * whole) {
    const std::size_t k = columns.size();
    if (k == most) throw std::runtime_error("the linearised kernel equation could not be solved");
    Vector<double> w = basis[k] - line.convolve(stiffness.cwiseProduct(basis[k]));
    std::vector<double> h(k + 1);
    for (std::size_t j = 0; j <= k; ++j) {
      h[j] = w.dot(basis[j]);
      w -= h[j] * basis[j];
    }
    // The rotations so far, and a new one
    for (std::size_t j = 0; j < k; ++j) {
      const double a = h[j], b = h[j + 1];
      h[j] = cosine[j] * a + sine[j] * b, h[j + 1] = cosine[j] * b - sine[j] * a;
    }
    const double length = w.norm(), size = std::hypot(h[k], length);
    cosine.push_back(h[k] / size), sine.push_back(length / size), h[k] = size;
    const double before = rest.back();
    rest.back() = cosine[k] * before, rest.push_back(-sine[k] * before);
    columns.push_back(h), basis.push_back(w / length);
  }
  std::vector<double> share(columns.size());
  Vector<double> x = Vector<double>::Zero(right.size());
  for (std::size_t j = columns.size(); j-- > 0;) {
    share[j] = rest[j];
    for (std::size_t i = j + 1; i < columns.size(); ++i) share[j] -= columns[i][j] * share[i];
    share[j] /= columns[j][j];
    x += share[j] * basis[j];
  }
  return x;
}

/**
On given panels Newton's method is carried to its end; then the panels are cut anew. It has converged when
the new ones are as good as the old, or no better than those before, because they are few. */
KernelWave newton_wave(const KernelWave& guess, double shift_time, const PowerContact& law,
                       const WaveGrid& grid) {
  constexpr double far = 1e3, fair = 1e-4, near = 1e-7, exact = 4e-15, rough = 1e-5;
  double before = far;
  KernelWave wave = guess;
  wave.law = law;
  for (int pass = 0; pass < 30; ++pass) {
    const HalfLine line = line_for(wave, shift_time, grid);
    wave = {law, line, wave.line.onto(line, wave.d)};
    double first = 0;
    for (int step = 0; step < 4; ++step) {
      const Vector<double> residual = line.convolve(wave.force()) - wave.d;
      const double size = residual.cwiseAbs().maxCoeff() / wave.d.maxCoeff();
      if (step == 0) first = size;
      if (!(size < far)) pass = 30;
      if (!(size > exact && size < far)) break;
      wave.d += solve_linearized(line, each(wave.d, stiffness_of, law), residual, rough);
    }
    settle_tail(wave);
    const bool settled = first < near || (first < fair && first > before / 4);
    if (settled && periods_for(wave) <= line.periods()) return wave;
    before = first;
  }
  throw std::runtime_error("Newton's method for the kernel equation does not converge at T = " +
                           std::to_string(shift_time) +
                           ", alpha = " + std::to_string(law.exponent));
}

KernelWave wave_of_type_one(std::size_t k, int sign, const PowerContact& law,
                            const WaveGrid& grid) {
  // An even start: pulses under an envelope
  const double shift_time = 2 * std::numbers::pi * double(k);
  const auto periods = std::size_t(6 + 1 / (law.exponent - 1));
  HalfLine line(shift_time, cuts_for({}, shift_time, 0.4), periods, QuadraturePanel(10, 2));
  const double middle = (k % 2 ? -sign : sign) > 0 ? 1 : -1,
               frequency = 1 / (1 - 1 / (4 * double(k)));
  Vector<double> u(line.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const double t = line.t()[i], x = t / shift_time;
    u[i] = std::max(0.0, middle * std::cos(frequency * t)) * std::exp(-3 * x * x / law.exponent);
  }
  KernelWave wave = newton_wave({law, line, ascended(line, law, u)}, shift_time, law, grid);
  if (wave.central_velocity() * sign < 0)
    throw std::runtime_error("the iteration has led to the wave of the other sign");
  return wave;
}

KernelWave wave_of_type_two(KernelWave start, double to, double step, const WaveGrid& grid) {
  KernelWave before = start;
  const double direction = to < start.shift_time() ? -step : step;
  // In steps until V changes its sign, then by secants
  do {
    before = start;
    start = newton_wave(start, start.shift_time() + direction, start.law, grid);
    if ((to - start.shift_time()) * direction < 0)
      throw std::runtime_error("no type II wave up to this shift time");
  } while (before.component() * start.component() > 0);
  for (int pass = 0; pass < 12; ++pass) {
    const double a = before.component(), b = start.component();
    if (std::abs(b) < 1e-14 * start.d.maxCoeff() || a == b) break;
    const double next =
        start.shift_time() - b * (start.shift_time() - before.shift_time()) / (b - a);
    before = start;
    start = newton_wave(start, next, start.law, grid);
  }
  return start;
}

}  // namespace lattice
