#include "sec4/soliton.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/integrators/integrate.hpp"

namespace lattice {

Soliton::Soliton(const PhaseOfWave& of, std::size_t wavelength, double epsilon)
    : phonon(of),
      eps(epsilon),
      nls(of.nls()),
      sites(wavelength * std::size_t(std::ceil(28 / (epsilon * double(wavelength))))) {}

// 2 eps M sech(z) cos(theta) and its derivative with respect to time
State<double> Soliton::at(double t) const {
  const double height = 2 * eps * std::sqrt(-nls.curvature / nls.h()), c = nls.group_velocity;
  const double frequency = nls.omega - eps * eps * nls.curvature / 2;
  State<double> state(sites);
  state.t = t;
  for (std::size_t i = 0; i < sites; ++i) {
    const double n = double(i) - double(sites) / 2;
    const double z = eps * std::remainder(n - c * t, double(sites));
    const double theta = phonon.q * n - frequency * t, sech = height / std::cosh(z);
    state.y[i] = sech * std::cos(theta);
    state.v[i] = sech * (frequency * std::sin(theta) + c * eps * std::tanh(z) * std::cos(theta));
  }
  return state;
}

// The chain runs, the ansatz is evaluated
AnsatzError ansatz_error(const Soliton& soliton, double tau, double step, std::size_t looks) {
  const double time = tau / (soliton.eps * soliton.eps);
  const Chain ring = soliton.ring();
  State<double> state = soliton.at(0);
  AnsatzError worst;
  const auto look = [&](const State<double>& now) {
    const State<double> ansatz = soliton.at(now.t);
    double squares = 0;
    for (std::size_t i = 0; i < soliton.sites; ++i) {
      const double y = now.y[i] - ansatz.y[i], v = now.v[i] - ansatz.v[i];
      squares += y * y + v * v;
      worst.largest = std::max({worst.largest, std::abs(y), std::abs(v)});
    }
    worst.l2 = std::max(worst.l2, std::sqrt(squares));
  };
  evolve(Splitting{blanes_moan_6_14(), step}, ring, state, time, time / double(looks), look);
  return worst;
}

}  // namespace lattice
