#include "sec5/quotient.hpp"

#include <cmath>

#include "lattice/gsl/random.hpp"
#include "lattice/numerics/parallel.hpp"

namespace lattice {

namespace {

Vector<double> forces(const PowerContact& law, Vector<double> u) {
  for (double& x : u) x = x > 0 ? law.force(-x) : 0;
  return u;
}

/// Scales u so that the norm of f = u^alpha is one, and returns f.
Vector<double> normalized(const PowerContact& law, const Vector<double>& weight,
                          Vector<double>& u) {
  Vector<double> f = forces(law, u);
  const double mass = weight.dot(u.cwiseProduct(f)), a = law.exponent;
  u *= std::pow(mass, -1 / (a + 1));
  f *= std::pow(mass, -a / (a + 1));
  return f;
}

}  // namespace

Vector<double> Ascent::wave(const PowerContact& law) const {
  return std::pow(quotient(), -law.exponent / (law.exponent - 1)) * image;
}

bool Ascent::rests(double gain, std::size_t over) const {
  if (quotients.size() <= over) return false;
  const double grown = quotient() - quotients[quotients.size() - 1 - over];
  return grown < gain * double(over) * quotient();
}

Ascent ascend(const Convolution& convolve, const Vector<double>& weight, const PowerContact& law,
              Vector<double> u, double gain, std::size_t most, std::size_t over) {
  Vector<double> f = normalized(law, weight, u);
  Ascent ascent{u, convolve(f), {}};
  ascent.quotients.push_back(weight.dot(f.cwiseProduct(ascent.image)));
  double mu = 1;
  for (std::size_t tries = 0; tries < most && mu < 1e6; ++tries) {
    Vector<double> trial = (ascent.image + mu * ascent.u).cwiseMax(0);
    const Vector<double> force = normalized(law, weight, trial), image = convolve(force);
    const double quotient = weight.dot(force.cwiseProduct(image)),
                 grown = quotient - ascent.quotient();
    // A step that does not go up is refused
    if (!(grown > 0)) {
      mu *= 2;
      continue;
    }
    mu *= 0.8;
    ascent.u = trial, ascent.image = image;
    ascent.quotients.push_back(quotient);
    if (ascent.rests(gain, over)) break;
  }
  return ascent;
}

PlainLine::PlainLine(double shift_time, std::size_t shifts, std::size_t per_shift)
    : per_shift_(per_shift), step_(shift_time / double(per_shift)) {
  t_.resize(Eigen::Index(shifts * per_shift));
  cosine_ = sine_ = t_;
  for (Eigen::Index i = 0; i < t_.size(); ++i) {
    t_[i] = double(i) * step_;
    cosine_[i] = std::cos(t_[i]), sine_[i] = std::sin(t_[i]);
  }
}

Vector<double> PlainLine::convolve(const Vector<double>& f) const {
  const Eigen::Index n = t_.size(), shift = Eigen::Index(per_shift_);
  // Sums of f cos and f sin up to, and without, each point
  Vector<double> c(n + 1), s(n + 1);
  c[0] = s[0] = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    c[i + 1] = c[i] + f[i] * cosine_[i], s[i + 1] = s[i] + f[i] * sine_[i];
  Vector<double> d(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index first = i < shift ? 0 : i - shift, last = i + shift < n ? i + shift + 1 : n;
    const double ahead_c = c[last] - c[i], ahead_s = s[last] - s[i], behind_c = c[i] - c[first],
                 behind_s = s[i] - s[first];
    const double jumps =
        (i + shift < n ? f[i + shift] : 0) - 2 * f[i] + (i < shift ? 0 : f[i - shift]);
    d[i] = step_ * (sine_[i] * (ahead_c - behind_c) - cosine_[i] * (ahead_s - behind_s)) +
           step_ * step_ / 12 * jumps;
  }
  return d;
}

Vector<double> random_start(const PlainLine& line, std::size_t pieces, unsigned long seed) {
  Random random(seed);
  std::vector<double> values(pieces + 1);
  for (double& x : values) x = random.uniform(0, 1);
  Vector<double> u(line.t().size());
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const double place = line.t()[i] / line.length() * double(pieces);
    const auto left = std::size_t(place);
    u[i] = values[left] + (place - double(left)) * (values[left + 1] - values[left]);
  }
  return u;
}

std::vector<Ascent> random_ascents(std::size_t count, double shift_time, std::size_t per_shift,
                                   const PowerContact& law, const StopRule& rule) {
  std::vector<Ascent> all(count);
  parallel_for("ascents", count, [&](std::size_t i) {
    const PlainLine line(shift_time, 12, per_shift);
    const auto convolve = [&](const Vector<double>& f) { return line.convolve(f); };
    all[i] = ascend(convolve, line.weight(), law, random_start(line, 96, i + 1), rule.gain,
                    rule.most, rule.over);
  });
  return all;
}

}  // namespace lattice
