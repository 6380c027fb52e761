#include "sec5/two_signs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lattice/numerics/parallel.hpp"
#include "sec5/travelling.hpp"

namespace lattice {
namespace {

constexpr double rounding_of_quotients = 4 * std::numeric_limits<double>::epsilon();
constexpr double hertz_exponent = 1.5;

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

/// The wave at one exponent after another, each from the one before, from which Newton's method needs the fewest steps.
struct Follow {
  KernelWave now;
  WaveGrid grid;

  const KernelWave& operator()(double alpha) {
    return now = newton_wave(now, now.shift_time(), {alpha, 0}, grid);
  }
};

/// kappa of the phase, with `times` the usual tolerance of the flow; nan if the flow does not reach it.
double kappa_of(const KernelWave& w, double times) {
  Chain chain{2 * usual_half_length + 2};
  chain.contact = w.law;
  EventTolerance<double> rule;
  const double twice = 2 * w.law.exponent;
  rule.tolerance *= twice == std::round(twice) ? times : 8 * times;
  // A contact that is hard to land on may need more than that
  for (int tries = 0; tries < 8; ++tries, rule.tolerance *= 8) try {
      const auto map = shifted_map(chain, w.state(usual_half_length), w.shift_time(), rule);
      return phase_kappa(multipliers_of(map));
    } catch (const NewtonFailed&) {
    }
  return std::nan("");
}

}  // namespace

TwoGridWave wave_on_two_grids(std::size_t k, int sign, double alpha, const TwoGrids& grids) {
  const PowerContact law{alpha, 0};
  return {k,
          sign,
          alpha,
          {wave_of_type_one(k, sign, law, grids[0]), wave_of_type_one(k, sign, law, grids[1])}};
}

Estimate TwoSigns::difference() const {
  const auto ratio = [&](std::size_t i) {
    return plus.grids[i].quotient() / minus.grids[i].quotient() - 1;
  };
  const Estimate apart = with_error(ratio(0), ratio(1));
  return {apart.value, std::max(apart.error, rounding_of_quotients)};
}

std::vector<TwoSigns> compare_signs(const std::vector<double>& alphas) {
  std::vector<std::vector<TwoGridWave>> found(2 * alphas.size());
  std::vector<Estimate> kappa(found.size(), {std::nan(""), std::nan("")});
  parallel_for("exponents", found.size(), [&](std::size_t i) {
    const double alpha = alphas[i / 2];
    found[i].push_back(wave_on_two_grids(1, i % 2 ? -1 : 1, alpha, dense_grids));
    const TwoGridWave& w = found[i].front();
    if (alpha >= hertz_exponent)
      kappa[i] = with_error(kappa_of(w.grids[0], 8), kappa_of(w.fine(), 1));
  });
  // Both signs of an exponent side by side
  std::vector<TwoSigns> all;
  for (std::size_t i = 0; i < alphas.size(); ++i)
    all.push_back({alphas[i], found[2 * i].front(), found[2 * i + 1].front(), kappa[2 * i],
                   kappa[2 * i + 1]});
  return all;
}

std::vector<std::size_t> exchanges_among(const std::vector<TwoSigns>& all) {
  std::vector<std::size_t> where;
  const auto clear = [](const Estimate& e) { return std::abs(e.value) > 10 * e.error; };
  for (std::size_t i = all.size() - 1; i-- > 0;) {
    const Estimate low = all[i].difference(), high = all[i + 1].difference();
    if (clear(low) && clear(high) && low.value * high.value < 0) where.push_back(i);
  }
  return where;
}

Estimate exchange_of_quotients(const TwoSigns& low, const TwoSigns& high) {
  const auto zero = [&](std::size_t grid) {
    Follow plus{low.plus.grids[grid], dense_grids[grid]},
        minus{low.minus.grids[grid], dense_grids[grid]};
    return find_sign_change(low.alpha, high.alpha, [&](double alpha) {
      return plus(alpha).quotient() / minus(alpha).quotient() - 1;
    });
  };
  Estimate out = with_error(zero(0), zero(1));
  // A zero is known no better than the rounding of the difference over its slope
  const double slope =
      (high.difference().value - low.difference().value) / (high.alpha - low.alpha);
  out.error += rounding_of_quotients / std::abs(slope);
  return out;
}

Estimate exchange_of_stability(const TwoSigns& low, const TwoSigns& high, int sign) {
  const auto zero = [&](std::size_t grid, double tolerance) {
    Follow wave{(sign > 0 ? low.plus : low.minus).grids[grid], dense_grids[grid]};
    return find_sign_change(low.alpha, high.alpha,
                            [&](double alpha) { return kappa_of(wave(alpha), tolerance); });
  };
  return with_error(zero(0, 8), zero(1, 1));
}

}  // namespace lattice
