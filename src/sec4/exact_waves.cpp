#include "sec4/exact_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/numerics/line_fit.hpp"

namespace lattice {

using Eigen::Index, Eigen::MatrixXcd;
using std::numbers::pi;

double PlaneWave::profile(double theta) const {
  double sum = 0;
  for (std::size_t k = b.size(); k-- > 0;) sum += b[k] * std::sin(double(k + 1) * theta);
  return sum;
}

double PlaneWave::slope(double theta) const {
  double sum = 0;
  for (std::size_t k = b.size(); k-- > 0;)
    sum += double(k + 1) * b[k] * std::cos(double(k + 1) * theta);
  return sum;
}

// One step of Newton's method, with the equation at as many points as there are harmonics; its relative size. The
// amplitude b_1 is given, so the first column belongs to the frequency and the others to b_2, b_3, ...
static double improve(PlaneWave& wave, const Well& well, const Contact& contact) {
  const Index count = Index(wave.b.size());
  Eigen::MatrixXd jacobian(count, count);
  Eigen::VectorXd residual(count);
  for (Index j = 0; j < count; ++j) {
    const double theta = pi * double(j + 1) / double(count + 1);
    const double y = wave.profile(theta), right = wave.relative(theta),
                 left = wave.relative(theta - wave.q);
    double second = 0;
    for (Index i = 0; i < count; ++i) {
      const double k = double(i + 1), here = std::sin(k * theta);
      const double ahead = std::sin(k * (theta + wave.q)), behind = std::sin(k * (theta - wave.q));
      second -= k * k * wave.b[std::size_t(i)] * here;
      jacobian(j, i) = -wave.omega * wave.omega * k * k * here + well.stiffness(y) * here -
                       contact.stiffness(right) * (ahead - here) +
                       contact.stiffness(left) * (here - behind);
    }
    jacobian(j, 0) = 2 * wave.omega * second;
    residual[j] = wave.omega * wave.omega * second - well.force(y) + contact.force(right) -
                  contact.force(left);
  }
  const Eigen::VectorXd step = solve_square<double>(jacobian, residual);
  wave.omega -= step[0];
  for (Index i = 1; i < count; ++i) wave.b[std::size_t(i)] -= step[i];
  return std::abs(step[0]) + step.tail(count - 1).cwiseAbs().maxCoeff() / std::abs(wave.b[0]);
}

// From the phonon on, until the steps are rounding
PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics) {
  PlaneWave wave{q, 0, std::vector<double>(harmonics, 0.0)};
  wave.b[0] = a;
  wave.omega = std::sqrt(well.stiffness(0.0) + 2 * contact.stiffness(0.0) * (1 - std::cos(q)));
  double step = 1, widest = 0;
  for (int i = 0; i < 20 && step > 1e-13; ++i) step = improve(wave, well, contact);
  for (int j = 0; j < 64; ++j) widest = std::max(widest, wave.relative(pi * j / 32));
  if (!(step < 1e-10) || !(widest < contact.opening()))
    throw std::runtime_error("no plane wave of this amplitude with all contacts closed");
  return wave;
}

State<double> on_ring(const PlaneWave& wave, std::size_t sites) {
  State<double> state(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    const double theta = wave.q * double(n + 1);
    state.y[n] = wave.profile(theta);
    state.v[n] = -wave.omega * wave.slope(theta);
  }
  return state;
}

// On an odd number of points derivative and shift are full matrices, exact for every harmonic that the grid can hold.
// With w = (lambda - omega d/dtheta) p as a second unknown the problem becomes linear in lambda
static MatrixXcd linearisation(const PlaneWave& wave, const Well& well, const Contact& contact,
                               double modulation) {
  using namespace std::complex_literals;
  const Index top = Index(wave.b.size()), points = 2 * top + 1;
  MatrixXcd derivative = MatrixXcd::Zero(points, points), shift = derivative;
  for (Index j = 0; j < points; ++j)
    for (Index l = 0; l < points; ++l)
      for (Index k = -top; k <= top; ++k) {
        const double angle = 2 * pi * double((j - l) * k) / double(points);
        const std::complex<double> mode = std::polar(1 / double(points), angle);
        derivative(j, l) += 1i * double(k) * mode;
        shift(j, l) += std::polar(1.0, double(k) * wave.q) * mode;
      }
  Eigen::VectorXcd held(points), bond(points);
  for (Index j = 0; j < points; ++j) {
    const double theta = 2 * pi * double(j) / double(points);
    held[j] = well.stiffness(wave.profile(theta));
    bond[j] = contact.stiffness(wave.relative(theta));
  }
  // Transport on the diagonal; the stiffnesses of well and contacts couple p and w
  const MatrixXcd one = MatrixXcd::Identity(points, points);
  const MatrixXcd difference = std::polar(1.0, modulation) * shift - one;
  MatrixXcd system = MatrixXcd::Zero(2 * points, 2 * points);
  system.topLeftCorner(points, points) = wave.omega * derivative;
  system.topRightCorner(points, points) = one;
  system.bottomLeftCorner(points, points) =
      -MatrixXcd(held.asDiagonal()) - difference.adjoint() * bond.asDiagonal() * difference;
  system.bottomRightCorner(points, points) = wave.omega * derivative;
  return system;
}

// A real matrix of twice the size has the eigenvalues of the complex one and their conjugates
double growth_rate(const PlaneWave& wave, const Well& well, const Contact& contact,
                   double modulation) {
  const MatrixXcd z = linearisation(wave, well, contact, modulation);
  Eigen::MatrixXd all(2 * z.rows(), 2 * z.cols());
  all << z.real(), -z.imag(), z.imag(), z.real();
  double rate = 0;
  for (const std::complex<double>& e : eigenvalues_of(all)) rate = std::max(rate, e.real());
  return rate;
}

double PhaseOfWave::growth(double a, double modulation, std::size_t harmonics) const {
  const Quartic well{s};
  const CompressedHertz contact{d};
  return growth_rate(plane_wave(well, contact, q, a, harmonics), well, contact, modulation);
}

Estimate PhaseOfWave::phi_from_growth(double a) const {
  const auto c = nls();
  return at_zero_amplitude(a, [&](double x) {
    const double fastest = std::sqrt(-c.h() * x * x / (2 * c.curvature));
    return growth(x, fastest) / (x * x / 4) * c.omega * std::abs(c.omega_2);
  });
}

// The largest growth of a slower, an equal and a faster modulation than the NLS equation's fastest one
static double slow_growth(const PhaseOfWave& at, double a, std::size_t harmonics) {
  const auto c = at.nls();
  const double slow = std::sqrt(std::abs(c.h() * a * a / (2 * c.curvature)));
  double growth = 0;
  for (double m : {0.5, 1.0, 1.5}) growth = std::max(growth, at.growth(a, m * slow, harmonics));
  return growth;
}

BandEdges band_edges(double d, double threshold) {
  const double a = 0.005, beside = 0.05;
  // The formulas for Phi at both edges of the band, in soft and in hard wells
  double formula = 0, leftover = 0;
  for (double s = -4; s <= 4; s += 0.25)
    formula = std::max({formula, std::abs(coefficients(0.0, d, s).phi + 1.5 * s),
                        std::abs(coefficients(pi, d, s).phi - 1.5 * (s - threshold))});
  // A little beyond either threshold exact waves grow as the NLS equation says ...
  Estimate apart{};
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, -beside}, {pi, d, threshold + beside}}) {
    const double nls = std::abs(phase.nls().h()) * a * a / 4;
    apart = larger(apart, compare(std::abs(slow_growth(phase, a, 6) / nls - 1),
                                  std::abs(slow_growth(phase, a, 12) / nls - 1)));
  }
  // ... and a little before it they do not grow at all
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, beside}, {pi, d, threshold - beside}})
    leftover = std::max(leftover, slow_growth(phase, a, 12));
  return {compare(0.0, formula), apart, compare(0.0, leftover)};
}

double measured_frequency(const Method& method, const Chain& ring, const PlaneWave& wave,
                          double periods) {
  State<double> state = on_ring(wave, ring.sites);
  const double time = 2 * pi * periods / wave.omega;
  double turned = 0, last = 0;
  evolve(method, ring, state, time, 0.5, [&](const State<double>& now) {
    std::complex<double> sum = 0;  // of y + i v / omega
    for (std::size_t n = 0; n < ring.sites; ++n)
      sum += std::complex<double>(now.y[n], now.v[n] / wave.omega) *
             std::polar(1.0, -wave.q * double(n + 1));
    const double phase = std::arg(sum);
    if (now.t > 0) turned += std::remainder(phase - last, 2 * pi);
    last = phase;
  });
  return -turned / time;
}

// Two steps in time, and two pairs of amplitudes for each
Estimate measured_beta(const Chain& ring, double q, double omega) {
  const auto from = [&](double step) {
    return at_zero_amplitude(0.04, [&](double a) {
      const PlaneWave wave = plane_wave(ring.well, ring.contact, q, a);
      const double nonlinear =
          measured_frequency(Splitting{blanes_moan_6_14(), step}, ring, wave, 60);
      return (nonlinear * nonlinear - omega * omega) / (a * a / 2);
    });
  };
  return compare(from(0.2), from(0.1));
}

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

/// The largest distances of the chain from the ansatz up to t = eps^-2: in l2 of displacements and velocities together,
/// and of any displacement or velocity.
static std::array<double, 2> ansatz_error(double eps, double step, std::size_t looks) {
  const double q = pi / 4, s = -1.0 / 6, time = 1 / (eps * eps);
  const auto nls = coefficients(q, 0.5, s);
  // A whole number of wavelengths; on the far side sech z < 2e-6
  const std::size_t sites = 8 * std::size_t(std::ceil(28 / (eps * 8)));
  const Chain ring{sites, Quartic{s}, CompressedHertz{0.5}, Ends::periodic};
  State<double> state = soliton(nls, q, eps, sites, 0);
  double l2 = 0, largest = 0;
  const auto look = [&](const State<double>& now) {
    const State<double> ansatz = soliton(nls, q, eps, sites, now.t);
    double squares = 0;
    for (std::size_t i = 0; i < sites; ++i) {
      const double y = now.y[i] - ansatz.y[i], v = now.v[i] - ansatz.v[i];
      squares += y * y + v * v;
      largest = std::max({largest, std::abs(y), std::abs(v)});
    }
    l2 = std::max(l2, std::sqrt(squares));
  };
  evolve(Splitting{blanes_moan_6_14(), step}, ring, state, time, time / double(looks), look);
  return {l2, largest};
}

void report_ansatz(Report& report) {
  std::vector<double> sizes;
  for (double eps = 0.2; eps > (report.quick ? 0.04 : 0.02); eps /= 2) sizes.push_back(eps);
  std::array<std::vector<Estimate>, 2> errors;  // in l2, and the largest
  for (auto& e : errors) e.resize(sizes.size());
  parallel_for("error of the ansatz", sizes.size(), [&](std::size_t k) {
    const std::size_t i = sizes.size() - 1 - k;  // the longest first
    const auto coarse = ansatz_error(sizes[i], 0.8, 5000), fine = ansatz_error(sizes[i], 0.4, 8000);
    for (std::size_t of : {0, 1}) errors[of][i] = compare(coarse[of], fine[of]);
  });
  Table& table = report.table("ansatz_error");
  for (std::size_t i = 0; i < sizes.size(); ++i)
    table.add({{"eps", "size of the ansatz", sizes[i]},
               {"l2", "of displacements and velocities together", errors[0][i]},
               {"largest", "of any displacement or velocity", errors[1][i]}});

  // Local orders, the last with the one before it as its error
  const auto order = [&](std::size_t of, std::size_t i) {
    return order_between(sizes[i], errors[of][i], sizes[i + 1], errors[of][i + 1]);
  };
  const std::size_t last = sizes.size() - 2;
  report.facts.add("nls_order", compare(order(0, last - 1), order(0, last)));
  report.facts.add("nls_order_first", order(0, 0));
  report.facts.add("nls_order_largest", compare(order(1, last - 1), order(1, last)));
}

}  // namespace lattice
