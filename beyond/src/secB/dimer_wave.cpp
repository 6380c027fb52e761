#include "secB/dimer_wave.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "lattice/algebra/dense.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"

namespace lattice {

namespace {

/// What passes a heavy bead: its velocity, that of the next one, and the force on the light bead between them.
struct PulseRecord {
  std::vector<double> t, here, next, force;
};

/**
Nearly thirty pairs of beads separate the pulse from what it leaves behind. */
PulseRecord watch_pulse(double mass_ratio) {
  constexpr std::size_t pairs = 40, bead = 56;
  Chain chain{2 * pairs, None{}};
  std::vector<double> mass(chain.sites, 1.0);
  for (std::size_t n = 1; n < mass.size(); n += 2) mass[n] = mass_ratio;
  vary(chain, mass, {});
  State<double> state = struck(chain.sites, 1);
  PulseRecord out;
  evolve(EventCorrected{0.01}, chain, state, 120, 0.01, [&](const State<double>& now) {
    out.t.push_back(now.t);
    out.here.push_back(now.v[bead]);
    out.next.push_back(now.v[bead + 2]);
    out.force.push_back(contact_push(chain, now.y.data(), bead + 1));
    return now.v[bead + 8] < 0.1;
  });
  return out;
}

/**
The equations are linear in $G$ but for the power. `mirrored` and `delayed` are the matrices of $G(-t)$ and $G(T-t)$,
and `twice` integrates twice, by Numerov's rule. */
struct Equations {
  Matrix<double> heavy, light;  ///< X from G, and mu Z from G
  Vector<double> moment, sum;   ///< weights of the integrals of t G and of G
};

Equations equations(std::size_t points, std::size_t steps, double h) {
  const auto n = Eigen::Index(points), middle = n / 2, delay = Eigen::Index(steps);
  Matrix<double> twice = Matrix<double>::Zero(n, n), mirrored = twice, delayed = twice;
  const Matrix<double> same = Matrix<double>::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) twice(i, j) = h * h * double(i - j);
    twice(i, i) = h * h / 12;
    mirrored(i, n - 1 - i) = 1;
    const Eigen::Index k = 2 * middle + delay - i;
    if (k < n) delayed(i, k) = 1;
  }
  const Vector<double> t = h * Vector<double>::LinSpaced(n, double(-middle), double(middle));
  return {twice * (mirrored - same), twice * (same - delayed), h * t,
          Vector<double>::Constant(n, h)};
}

}  // namespace

/**
The centre of symmetry is not seen in a run as well as the centroid of the force, from which it has a known distance. */
DimerWave passing_pulse(double mass_ratio, std::size_t steps) {
  const PulseRecord pulse = watch_pulse(mass_ratio);
  const double half = *std::max_element(pulse.here.begin(), pulse.here.end()) / 2;
  const double rise = upward_crossings(pulse.t, pulse.here, half).front();
  const double middle = rise + time_above(pulse.t, pulse.here, half) / 2;
  DimerWave out{mass_ratio, upward_crossings(pulse.t, pulse.next, half).front() - rise, steps};
  // What comes more than two steps of the wave later belongs to the wake
  double sum = 0, moment = 0;
  const auto near = [&](double t) { return std::abs(t - middle) < 2 * out.period; };
  for (std::size_t j = 0; j < pulse.t.size(); ++j)
    if (near(pulse.t[j])) sum += pulse.force[j], moment += pulse.force[j] * pulse.t[j];
  const double centre = moment / sum - out.period / (2 * (1 + mass_ratio));
  // The force on the grid of the wave
  const auto sampled = [&](double t) {
    const double at = (t - pulse.t[0]) / (pulse.t[1] - pulse.t[0]);
    const std::size_t j = std::size_t(at);
    return pulse.force[j] + (at - double(j)) * (pulse.force[j + 1] - pulse.force[j]);
  };
  const long half_width = 3 * long(steps);
  for (long j = -half_width; j <= half_width; ++j) {
    const double t = centre + double(j) * out.period / double(steps);
    out.force.push_back(near(t) ? sampled(t) : 0);
  }
  return out;
}

/**
Newton's method; its last row is the condition that both beads end equally displaced. */
DimerWave dimer_wave(DimerWave wave) {
  const double h = wave.period / double(wave.steps);
  const Equations e = equations(wave.force.size(), wave.steps, h);
  const auto n = Eigen::Index(wave.force.size());
  Vector<double> x(n + 1);
  for (Eigen::Index j = 0; j < n; ++j) x(j) = wave.force[std::size_t(j)];
  x(n) = wave.mass_ratio;
  std::string history;
  for (int k = 0; k < 12; ++k) {
    const Vector<double> G = x.head(n), Z = e.light * G, overlap = e.heavy * G - Z / x(n);
    const Vector<double> touching = overlap.cwiseMax(0.0), root = touching.cwiseSqrt();
    Matrix<double> jacobian = Matrix<double>::Identity(n + 1, n + 1);
    jacobian.topLeftCorner(n, n) -= 1.5 * root.asDiagonal() * (e.heavy - e.light / x(n));
    jacobian.col(n).head(n) = -1.5 * root.cwiseProduct(Z) / (x(n) * x(n));
    jacobian.row(n).head(n) = (2 * x(n) + 2) * e.moment - wave.period * e.sum;
    jacobian(n, n) = 2 * e.moment.dot(G);
    Vector<double> missed(n + 1);
    missed.head(n) = G - touching.cwiseProduct(root);
    missed(n) = jacobian.row(n).head(n).dot(G);
    const Vector<double> step = solve_square<double>(jacobian, -missed);
    x += step;
    const double change = step.cwiseAbs().maxCoeff() / x.head(n).cwiseAbs().maxCoeff();
    history += (k ? ", " : "") + std::to_string(std::log10(change));
    if (!(x(n) > 0) || !std::isfinite(change)) break;
    if (change > 1e-11) continue;
    wave.mass_ratio = x(n);
    wave.force.assign(x.data(), x.data() + n);
    return wave;
  }
  throw std::runtime_error(
      "Newton's method for the solitary wave of a dimer chain does not converge, log10 of its "
      "steps " +
      history);
}

}  // namespace lattice
