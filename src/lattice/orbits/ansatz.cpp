#include "lattice/orbits/ansatz.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lattice/model/dps.hpp"
#include "lattice/model/quasi_continuum.hpp"

namespace lattice {

/**
A contact pushes with $k\,(-r)_+^\alpha$. The first harmonic of that is $k\,b$ times the same power of the amplitudes,
$b = \Gamma(\frac\alpha2+1)/[\sqrt\pi\,\Gamma(\frac\alpha2+\frac32)]$, so the profile at $\mu = 1$ is multiplied by the
power $1/(\alpha-1)$ of $2(\omega_b-1)/(k\,b)$, as in Eq. (20). */
static double size_of(const Contact& contact, double omega) {
  if (contact.is<Hertz>()) return 2 * breather_eps(omega);
  const double alpha = contact.exponent(), small = 1e-4;
  const double k = contact.force(-small) / std::pow(small, alpha);
  const double b =
      std::tgamma(alpha / 2 + 1) / (std::sqrt(std::numbers::pi) * std::tgamma(alpha / 2 + 1.5));
  return std::pow(2 * (omega - 1) / (k * b), 1 / (alpha - 1));
}

// The profile of Eq. (20); its sign tells whether the central contact is compressed or stretched
State<double> ansatz(Centre centre, double omega, std::size_t sites, Phase phase,
                     const Contact& contact) {
  const double alpha = contact.exponent();
  if (!(alpha > 1))
    throw std::invalid_argument("a breather needs contacts with an exponent above one");
  const bool spheres = contact.is<Hertz>();
  const double scale = size_of(contact, omega) * (phase == Phase::stretched ? -1 : 1);
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const long n = site_number(i, sites);
    state.y[i] = scale * (spheres ? quasi_continuum(centre, n) : quasi_continuum(centre, n, alpha));
  }
  return state;
}

}  // namespace lattice
