// The DpS equation with contacts of any exponent: averaging, invariants, and what an impact leaves.

#include <algorithm>
#include <numbers>

#include "commands/dps_strike.hpp"
#include "lattice/dps/evolve.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

namespace {

/// A field without symmetry.
Field crooked(std::size_t sites) {
  Field a(sites);
  for (std::size_t n = 0; n < sites; ++n)
    a[n] = {std::sin(1.0 + 1.7 * double(n)), 0.6 * std::cos(0.3 * double(n * n))};
  return a;
}

}  // namespace

TEST_CASE("tau_0 is the mean of the push, whatever the exponent", "[unit][dps][exponents]") {
  for (double alpha : {1.001, 1.1, 1.5, 4.0}) {
    CAPTURE(alpha);
    // The mean of the push (2 cos t)_+^alpha with cos t is 1 / tau_0
    const int n = 100000;
    double mean = 0;
    for (int k = 0; k < n; ++k) {
      const double c = std::cos(std::numbers::pi * ((k + 0.5) / n - 0.5));
      mean += std::pow(2 * c, alpha) * c / (2 * n);
    }
    check_close(tau_0(alpha) * mean, 1, 1e-12);
    if (alpha < 1.1) continue;
    const double eps = breather_eps(1.01, alpha);
    check_close(1 + std::pow(eps, alpha - 1) / (2 * tau_0(alpha)), 1.01, 1e-14);
  }
  check_close(tau_0(std::nextafter(1.5, 2)), tau_0(), 0, 1e-14);
}

TEST_CASE("the slope of a field is the gradient of its energy", "[unit][dps][exponents]") {
  // 2 i tau_0 dA/dtau is minus the gradient with respect to real and imaginary part
  const double h = 1e-5;
  for (double alpha : {1.1, 1.5, 3.7})
    for (bool ring : {false, true}) {
      const Field a = crooked(7);
      const Dps dps{a.size(), ring ? Ends::periodic : Ends::free, alpha};
      CHECK(dps.rate == 1 / (2 * tau_0(alpha)));
      std::vector<double> moves(2 * a.size());
      dps(0, interleaved(a).data(), moves.data());
      for (std::size_t i = 0; i < 2 * a.size(); ++i) {
        const std::complex<double> unit = i % 2 ? std::complex<double>(0, h) : h;
        const auto shifted = [&](double sign) {
          Field b = a;
          b[i / 2] += sign * unit;
          return energy(b, ring, alpha);
        };
        const double gradient = (shifted(1) - shifted(-1)) / (2 * h);
        check_close(i % 2 ? moves[i - 1] : -moves[i + 1], -dps.rate * gradient, 1e-9);
      }
    }
}

TEST_CASE("a DpS chain is long enough for what runs away in it, and its amplitude is known",
          "[unit][dps][exponents]") {
  // Centres, amplitudes and norms from another program, which has longer chains and steps of 0.012
  const auto found = [](double alpha, double tau) {
    DpsStrike impact;
    impact.alpha = alpha, impact.tau = tau, impact.end = Ends::fixed;
    const auto runs = impact.find();
    CHECK(runs[1].far_end < 1e-9);
    return impact.quantities(runs);
  };
  struct Seen {
    double alpha, tau, centre, norm;
  };
  for (const auto& [alpha, tau, centre, norm] :
       {Seen{2.5, 400, 259.910756, 0.87380056}, {4, 150, 234.235660, 0.92912480}}) {
    const Table t = found(alpha, tau);
    const auto value = t.numbers("value"), error = t.numbers("error");
    CAPTURE(alpha, value[0], value[3]);
    check_close(value[0], centre, 3 * error[0]);
    check_close(value[3], norm, 3 * error[3] + 1e-8);
  }
  const Table spheres = found(1.5, 323.3731837235295);
  const double error = spheres.numbers("error")[2];
  check_close(spheres.numbers("value")[2], 0.65536189, error);
  CHECK(error < 1e-3);
  // The chains of the chapters are, and a chosen length belongs to the run
  CHECK(follow_dps(Dps{120}, dps_impact(120), 250, 250, 1e-6).far_end < 1e-9);
  CHECK(follow_dps(Dps{150}, dps_impact(150), 320, 320, 1e-6).far_end < 1e-9);
  DpsStrike chosen;
  chosen.sites = 30;
  CHECK(chosen.find()[1].end.size() == 30);
}
