#include "sec4/nls_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/numerics/line_fit.hpp"
#include "sec4/exact_waves.hpp"

namespace lattice {

using std::numbers::pi;

static bool slow(const PhaseOfWave& at) {
  const double q_c = inflection(contact_series(at.d).v1);
  return at.nls().phi > 0 && std::abs(at.q - pi / 2) >= 1e-9 && std::abs(at.q - q_c) > 0.05;
}

void report_beta(Report& report) {
  std::vector<PhaseOfWave> points;
  for (double s : {-1.0 / 6, 0.0, 1.0})
    for (int k = report.quick ? 4 : 1; k < 24; k += report.quick ? 4 : 1)
      points.push_back({pi * k / 24, 0.5, s});
  const Estimate none{std::nan(""), std::nan("")};
  std::vector<Estimate> beta(points.size()), phi(points.size(), none);
  parallel_for("nonlinear frequency", points.size(), [&](std::size_t i) {
    const PhaseOfWave& at = points[i];
    const Chain ring{48, Quartic{at.s}, CompressedHertz{at.d}, Ends::periodic};
    beta[i] = measured_beta(ring, at.q, at.nls().omega);
    if (slow(at)) phi[i] = at.phi_from_growth(0.04);
  });

  // Both against the formula
  Estimate shift{}, growth{};
  Table& table = report.table("measured_coefficient");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PhaseOfWave& at = points[i];
    const Coefficients<double> nls = at.nls();
    shift = larger(shift, relative_distance(beta[i], nls.beta));
    if (slow(at)) growth = larger(growth, relative_distance(phi[i], nls.phi));
    table.add({{"q", "wavenumber", at.q, "1/site"},
               {"s", "anharmonicity of the well", at.s},
               {"beta", "NLS coefficient from its formula", nls.beta},
               {"measured_beta", "from the measured frequency shift", beta[i], "",
                "two steps and two pairs of amplitudes"},
               {"shift_phi", "modulation coefficient with the measured beta",
                -beta[i].value * nls.omega_2},
               {"growth_phi", "from the growth, nan where stable or out of reach", phi[i], "",
                "two pairs of amplitudes, nan where growth_phi is"}});
  }
  report.facts.add("beta_shift", shift);
  report.facts.add("beta_growth", growth);
  report.facts.add("beta_apart_by_shift", compare(0.0, shift.value + shift.error));

  // At q = pi/2 two waves scatter into two waves of the wavenumber q - pi
  const PhaseOfWave resonant{pi / 2, 0.5, 1};
  report.facts.add("backscattering", at_zero_amplitude(0.04, [&](double a) {
                     return resonant.growth(a, pi) / (std::abs(resonant.nls().h()) * a * a / 4);
                   }));
}

/**
What the ansatz omits, above all the second harmonic, is of size $\epsilon^2$ on $O(1/\epsilon)$ sites, so that the
error in $\ell^2$ should be $(\epsilon^{-1}\,\epsilon^4)^{1/2} = \epsilon^{3/2}$, and that of any bead $\epsilon^2$. */
/// The soliton of Eqs. (35) and (38) at time `t`, 2 eps M sech(z) cos(theta), and its derivative.
static State<double> soliton(const Coefficients<double>& nls, double q, double eps,
                             std::size_t sites, double t) {
  const double height = 2 * eps * std::sqrt(-nls.curvature / nls.h()), c = nls.group_velocity;
  const double frequency = nls.omega - eps * eps * nls.curvature / 2;
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const double n = double(i) - double(sites) / 2;
    const double z = eps * std::remainder(n - c * t, double(sites));
    const double theta = q * n - frequency * t, sech = height / std::cosh(z);
    state.y[i] = sech * std::cos(theta);
    state.v[i] = sech * (frequency * std::sin(theta) + c * eps * std::tanh(z) * std::cos(theta));
  }
  return state;
}

/// Largest distances of the chain from the ansatz up to t = eps^-2: in l2 of displacements and velocities together, and
/// of any displacement or velocity.
struct AnsatzError {
  double l2 = 0, largest = 0;
};
static AnsatzError ansatz_error(double eps, double step, std::size_t looks) {
  const double q = pi / 4, s = -1.0 / 6, time = 1 / (eps * eps);
  const auto nls = coefficients(q, 0.5, s);
  // A whole number of wavelengths; on the far side sech z < 2e-6
  const std::size_t sites = 8 * std::size_t(std::ceil(28 / (eps * 8)));
  const Chain ring{sites, Quartic{s}, CompressedHertz{0.5}, Ends::periodic};
  State<double> state = soliton(nls, q, eps, sites, 0);
  AnsatzError worst;
  const auto look = [&](const State<double>& now) {
    const State<double> ansatz = soliton(nls, q, eps, sites, now.t);
    double squares = 0;
    for (std::size_t i = 0; i < sites; ++i) {
      const double y = now.y[i] - ansatz.y[i], v = now.v[i] - ansatz.v[i];
      squares += y * y + v * v;
      worst.largest = std::max({worst.largest, std::abs(y), std::abs(v)});
    }
    worst.l2 = std::max(worst.l2, std::sqrt(squares));
  };
  evolve(Splitting{blanes_moan_6_14(), step}, ring, state, time, time / double(looks), look);
  return worst;
}

void report_ansatz(Report& report) {
  std::vector<double> sizes;
  for (double eps = 0.2; eps > (report.quick ? 0.04 : 0.02); eps /= 2) sizes.push_back(eps);
  std::vector<Estimate> l2(sizes.size()), largest(sizes.size());
  parallel_for("error of the ansatz", sizes.size(), [&](std::size_t k) {
    const std::size_t i = sizes.size() - 1 - k;  // the longest first
    const AnsatzError coarse = ansatz_error(sizes[i], 0.8, 5000),
                      fine = ansatz_error(sizes[i], 0.4, 8000);
    l2[i] = compare(coarse.l2, fine.l2);
    largest[i] = compare(coarse.largest, fine.largest);
  });
  Table& table = report.table("ansatz_error");
  for (std::size_t i = 0; i < sizes.size(); ++i)
    table.add({{"eps", "size of the ansatz", sizes[i]},
               {"l2", "of displacements and velocities together", l2[i]},
               {"largest", "of any displacement or velocity", largest[i]}});

  // Local orders
  const auto order = [&](const std::vector<Estimate>& error, std::size_t i) {
    return order_between(sizes[i], error[i], sizes[i + 1], error[i + 1]);
  };
  const auto last = [&](const std::vector<Estimate>& error) {
    return compare(order(error, sizes.size() - 3), order(error, sizes.size() - 2));
  };
  report.facts.add("nls_order", last(l2));
  report.facts.add("nls_order_first", order(l2, 0));
  report.facts.add("nls_order_largest", last(largest));
}

}  // namespace lattice
