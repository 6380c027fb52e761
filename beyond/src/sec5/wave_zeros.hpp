#pragma once
/**
# Where one wave takes over from another

Which of two waves of the kernel equation has the larger quotient, and which one keeps its internal phase,
changes with the exponent of the contacts. The exponents at which it does are zeros of a function that
costs one or two waves a value, and they are found by false position. */

#include <cmath>

#include "lattice/numerics/estimate.hpp"
#include "sec5/kernel_wave.hpp"

namespace lattice {

/// The zero of `of` between two places at which its signs differ, to about 1e-7; nan if they do not.
template <class Of>
double find_sign_change(double low, double high, Of of) {
  double at_low = of(low), at_high = of(high), next = low;
  if (!(at_low * at_high < 0)) return std::nan("");
  int stayed = 0;  // the end that stayed the last time
  for (int pass = 0; pass < 30; ++pass) {
    const double before = next;
    next = (low * at_high - high * at_low) / (at_high - at_low);
    if (std::abs(next - before) < 1e-7) break;
    const double value = of(next);
    // An end that stays twice counts half
    if (value * at_low > 0) {
      low = next, at_low = value;
      if (stayed == 1) at_high /= 2;
      stayed = 1;
    } else {
      high = next, at_high = value;
      if (stayed == -1) at_low /= 2;
      stayed = -1;
    }
  }
  return next;
}

/// By how much 1 / (alpha - 1) grows from one exchange to the next.
inline Estimate spacing(const Estimate& larger, const Estimate& smaller) {
  const double a = larger.value - 1, b = smaller.value - 1;
  return {1 / b - 1 / a, larger.error / (a * a) + smaller.error / (b * b)};
}

/**
Newton's method needs the fewest steps from the wave that was found last, at a nearby exponent. */
/// The wave at one exponent after another, each from the one before.
struct Follow {
  KernelWave now;
  WaveGrid grid;

  const KernelWave& operator()(double alpha) {
    return now = newton_wave(now, now.shift_time(), {alpha, 0}, grid);
  }
};

/**
The stability of the internal phase follows from the multipliers of the lattice's flow (travelling.hpp).
Unless $2\alpha$ is an integer the force is not analytic in the root of the time since a contact has
closed, and the flow has to be content with a larger tolerance. */
/// kappa of the phase, with `times` the usual tolerance of the flow; nan if the flow does not reach it.
double kappa_of(const KernelWave& w, double times);

}  // namespace lattice
