#include "sec4/wave_on_ring.hpp"

#include "sec4/instability.hpp"

namespace lattice {

std::complex<double> fourier(const State<double>& state, double wavenumber, double omega) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < state.y.size(); ++n)
    sum += std::complex<double>(state.y[n], state.v[n] / omega) *
           std::polar(1.0, -wavenumber * double(n + 1));
  return sum;
}

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

}  // namespace lattice
