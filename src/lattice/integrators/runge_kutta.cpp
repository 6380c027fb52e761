#include "lattice/integrators/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lattice {

RungeKutta classical_4() {
  return {
      "classical-4", 4, {{}, {1. / 2}, {0, 1. / 2}, {0, 0, 1}}, {1. / 6, 1. / 3, 1. / 3, 1. / 6}};
}

RungeKutta fehlberg_5() {
  return {"fehlberg-5",
          5,
          {{},
           {1. / 4},
           {3. / 32, 9. / 32},
           {1932. / 2197, -7200. / 2197, 7296. / 2197},
           {439. / 216, -8, 3680. / 513, -845. / 4104},
           {-8. / 27, 2, -3544. / 2565, 1859. / 4104, -11. / 40}},
          {16. / 135, 0, 6656. / 12825, 28561. / 56430, -9. / 50, 2. / 55},
          {1. / 360, 0, -128. / 4275, -2197. / 75240, 1. / 50, 2. / 55}};
}

RungeKutta dormand_prince_5() {
  return {"dormand-prince-5",
          5,
          {{},
           {1. / 5},
           {3. / 40, 9. / 40},
           {44. / 45, -56. / 15, 32. / 9},
           {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
           {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
           {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84}},
          {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84, 0},
          {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40}};
}

// Whether the last stage is the new state already
namespace {
bool ends_on_a_stage(const RungeKutta& m) {
  return m.weights.back() == 0 &&
         std::equal(m.stages.back().begin(), m.stages.back().end(), m.weights.begin());
}
}  // namespace

Nystrom nystrom(const RungeKutta& method) {
  std::vector<std::vector<double>> rows = method.stages;
  std::vector<double> weights = method.weights;
  if (!ends_on_a_stage(method)) {
    rows.push_back(weights);
    weights.push_back(0);
  }
  Nystrom out{method.name, method.order, {}, {}, weights};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // Row i of the table gives the time of the stage, row i of its square the positions
    double time = 0;
    std::vector<double> squared(i, 0);
    for (std::size_t k = 0; k < i; ++k) {
      time += rows[i][k];
      for (std::size_t j = 0; j < k; ++j) squared[j] += rows[i][k] * rows[k][j];
    }
    out.c.push_back(i + 1 == rows.size() ? 1 : time);
    out.a.push_back(squared);
  }
  return out;
}

namespace {

/// One step of a method at a time, with room for its stages.
class Step {
 public:
  Step(const RungeKutta& method, const Rhs& rhs, std::size_t dimension)
      : method_(method),
        rhs_(rhs),
        slopes_(method.stages.size(), std::vector<double>(dimension)),
        next_(dimension) {}

  /// From `x` by `h`; the slope at `x` is taken over from the last step if that ended there.
  const std::vector<double>& take(const std::vector<double>& x, double h) {
    if (!known_) rhs_(0, x.data(), slopes_[0].data());
    known_ = true;
    for (std::size_t i = 1; i < method_.stages.size(); ++i) {
      combine(x, h, method_.stages[i]);
      rhs_(0, next_.data(), slopes_[i].data());
    }
    if (!ends_on_a_stage(method_)) combine(x, h, method_.weights);
    return next_;
  }

  /// The cubic through both ends of the last step from `x`, with the slopes there.
  std::vector<double> between(const std::vector<double>& x, double h, double part) {
    if (!ends_on_a_stage(method_)) {
      slopes_.resize(method_.stages.size() + 1, std::vector<double>(x.size()));
      rhs_(0, next_.data(), slopes_.back().data());
    }
    const double rest = 1 - part;
    std::vector<double> out(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      const double rise = next_[n] - x[n];
      out[n] = rest * x[n] + part * next_[n] +
               part * rest *
                   (rest * (h * slopes_.front()[n] - rise) - part * (h * slopes_.back()[n] - rise));
    }
    return out;
  }

  /// The step is accepted: the next one starts where it ended.
  void accept() {
    known_ = ends_on_a_stage(method_);
    if (known_) std::swap(slopes_.front(), slopes_.back());
  }

  /// The estimated error of the last step from `x`, in units of what is allowed.
  double error(const std::vector<double>& x, double h, const StepControl& control) const {
    double sum = 0, most = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      double e = 0;
      for (std::size_t i = 0; i < method_.stages.size(); ++i) e += method_.error[i] * slopes_[i][n];
      const double size = std::max(std::abs(x[n]), std::abs(next_[n]));
      const double ratio = std::abs(h * e) / (control.absolute + control.relative * size);
      if (!std::isfinite(ratio)) return ratio;
      most = std::max(most, ratio);
      sum += ratio * ratio;
    }
    if (control.norm == ErrorNorm::largest) return most;
    return std::sqrt(control.norm == ErrorNorm::rms ? sum / double(x.size()) : sum);
  }

 private:
  void combine(const std::vector<double>& x, double h, const std::vector<double>& weights) {
    next_ = x;
    for (std::size_t j = 0; j < weights.size(); ++j)
      if (weights[j] != 0)
        for (std::size_t n = 0; n < x.size(); ++n) next_[n] += h * weights[j] * slopes_[j][n];
  }

  // The right-hand side at each stage, and the end of the step
  const RungeKutta& method_;
  const Rhs& rhs_;
  std::vector<std::vector<double>> slopes_;
  std::vector<double> next_;
  bool known_ = false;
};

}  // namespace

// Steps are as long as the error allows, and each sample that lies within one is interpolated
ControlledRun integrate_controlled(
    const RungeKutta& pair, const Rhs& rhs, std::vector<double>& x, double duration,
    std::size_t samples, const StepControl& control,
    const std::function<void(double, const std::vector<double>&)>& observe) {
  Step step(pair, rhs, x.size());
  ControlledRun run;
  observe(0, x);
  double t = 0, h = control.first;
  std::size_t seen = 0;
  bool may_grow = true;
  while (seen < samples) {
    const std::vector<double>& next = step.take(x, h);
    const double error = step.error(x, h, control);
    const double factor = std::clamp(0.9 * std::pow(error, -0.2), 0.2, may_grow ? 10.0 : 1.0);
    may_grow = error <= 1;
    if (!may_grow) {
      ++run.rejected;
      h *= std::isfinite(error) ? factor : 0.2;
      if (h < 1e-12 * duration) throw std::runtime_error("the step has become too small");
      continue;
    }
    ++run.accepted;
    // The samples that lie in this step
    for (double at; seen < samples; ++seen) {
      at = duration * double(seen + 1) / double(samples);
      if (at > t + h) break;
      observe(at, step.between(x, h, (at - t) / h));
    }
    x = next;
    step.accept();
    t += h;
    h *= factor;
  }
  return run;
}

void integrate_fixed(const RungeKutta& method, const Rhs& rhs, std::vector<double>& x,
                     double duration, std::size_t samples, std::size_t steps,
                     const std::function<void(double, const std::vector<double>&)>& observe) {
  Step step(method, rhs, x.size());
  const double h = duration / double(samples * steps);
  observe(0, x);
  for (std::size_t k = 1; k <= samples; ++k) {
    for (std::size_t i = 0; i < steps; ++i) {
      x = step.take(x, h);
      step.accept();
    }
    observe(duration * double(k) / double(samples), x);
  }
}

}  // namespace lattice
