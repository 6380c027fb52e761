// The DpS equation with contacts of any exponent: averaging, invariants, static breathers, their
// stability, and what is refused.

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <numbers>

#include "commands/dps_strike.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/spectrum.hpp"
#include "support/check.hpp"
#include "support/dps_run.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

/// The mean of the push (2 cos t)_+^alpha with cos t, which is 1 / tau_0.
double mean_push(double alpha) {
  gsl_integration_workspace* w = gsl_integration_workspace_alloc(1000);
  gsl_function f{[](double t, void* a) {
                   return std::pow(2 * std::cos(t), *static_cast<double*>(a)) * std::cos(t);
                 },
                 &alpha};
  double integral = 0, error = 0;
  const double half = std::numbers::pi / 2;
  gsl_integration_qags(&f, -half, half, 1e-13, 1e-13, 1000, w, &integral, &error);
  gsl_integration_workspace_free(w);
  return integral / (2 * std::numbers::pi);
}

/// A field without symmetry.
Field crooked(std::size_t sites) {
  Field a(sites);
  for (std::size_t n = 0; n < sites; ++n)
    a[n] = {std::sin(1.0 + 1.7 * double(n)), 0.6 * std::cos(0.3 * double(n * n))};
  return a;
}

/// dA/dtau, interleaved.
std::vector<double> slope(const Dps& dps, const Field& a) {
  std::vector<double> out(2 * a.size());
  dps(0, interleaved(a).data(), out.data());
  return out;
}

/// Largest residual of -mu u_n = D_n - D_{n-1} relative to mu |u_n|, written out independently.
template <class T>
double residual(const Stationary<T>& s, double alpha) {
  using std::abs, std::pow;
  const auto pull = [&](std::size_t i) {
    if (i == 0 || i >= s.u.size()) return T(0);
    const T r = s.u[i] - s.u[i - 1], size = pow(T(abs(r)), T(alpha));
    return r < T(0) ? T(-size) : size;
  };
  double worst = 0;
  for (std::size_t i = 0; i < s.u.size(); ++i) {
    if (abs(s.u[i]) < least_exact<T>()) continue;
    const auto rest = static_cast<double>(T(abs(T(1) + (pull(i + 1) - pull(i)) / (s.mu * s.u[i]))));
    if (!(rest <= worst)) worst = rest;
  }
  return worst;
}

}  // namespace

TEST_CASE("tau_0 is the mean of the push, whatever the exponent", "[unit][dps][exponents]") {
  for (double alpha : {1.001, 1.1, 1.5, 2.0, 3.0, 4.0}) {
    CAPTURE(alpha);
    check_close(tau_0(alpha) * mean_push(alpha), 1, 1e-12);
    if (alpha < 1.1) continue;
    const double eps = breather_eps(1.01, alpha);
    check_close(1 + std::pow(eps, alpha - 1) / (2 * tau_0(alpha)), 1.01, 1e-14);
  }
  check_close(tau_0(std::nextafter(1.5, 2)), tau_0(), 0, 1e-14);
}

TEST_CASE("the slope of a field is the gradient of its energy", "[unit][dps][exponents]") {
  // 2 i tau_0 dA/dtau is minus the gradient with respect to real and imaginary part
  const double h = 1e-5;
  for (double alpha : {1.1, 1.5, 2.0, 3.7})
    for (bool ring : {false, true}) {
      Field a = crooked(7);
      Dps dps{a.size(), ring ? Ends::periodic : Ends::free, alpha};
      CHECK(dps.rate == 1 / (2 * tau_0(alpha)));
      const auto moves = slope(dps, a);
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

TEST_CASE("norm and energy are conserved for any exponent", "[property][dps][exponents]") {
  for (double alpha : {1.05, 1.3, 2.0, 4.0}) {
    CAPTURE(alpha);
    Field field = crooked(12);
    const double n0 = norm(field), e0 = energy(field, false, alpha), other = energy(field);
    evolve_dps(Dps{field.size(), Ends::free, alpha}, field, 5, 1, 1e-11);
    check_close(norm(field), n0, 0, 1e-9);
    check_close(energy(field, false, alpha), e0, 0, 1e-9);
    CHECK(std::abs(energy(field) / other - 1) > 1e-4);
  }
}

TEST_CASE("spheres have the bits of the square root", "[unit][dps][exponents]") {
  const Field a = crooked(9);
  const auto moves = slope(Dps{.sites = a.size(), .exponent = 1.5}, a);
  CHECK(moves == slope(Dps{a.size()}, a));
  const auto pull = [&](std::size_t n) {
    if (n == 0 || n == a.size()) return std::complex<double>(0);
    const auto d = a[n] - a[n - 1];
    const double x = d.real(), y = d.imag(), root = std::sqrt(std::sqrt(x * x + y * y));
    return std::complex<double>(root * x, root * y);
  };
  const double rate = 1 / (2 * tau_0());
  double sum = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const auto ahead = pull(n + 1), behind = pull(n);
    CHECK(moves[2 * n] == rate * (ahead.imag() - behind.imag()));
    CHECK(moves[2 * n + 1] == -rate * (ahead.real() - behind.real()));
    if (n == 0) continue;
    const double d = std::abs(a[n] - a[n - 1]);
    sum += 0.4 * (d * d * std::sqrt(d));
  }
  CHECK(energy(a) == sum);
  // The formulas for the spectrum, as they are for spheres alone
  for (const auto& z : a) {
    const double mu = 1.3 + z.real(), m = std::abs(z.imag());
    CHECK(lambda_squared(mu, m) == (mu - m) * (3 * m - 2 * mu) / 2);
    CHECK(instability_margin(mu, m) == (3 * m - 2 * mu) / 3);
    CHECK(m * secant_stiffness(m, 1.5) == m * std::sqrt(m));
  }
}

TEST_CASE("static breathers of any exponent solve their equation", "[unit][dps][exponents]") {
  for (double alpha : {1.02, 1.05, 1.2, 1.49, 2.0, 2.5, 3.0, 4.0, 10.0})
    for (Centre centre : {Centre::site, Centre::bond}) {
      CAPTURE(alpha, int(centre));
      const std::size_t sites = sites_of(centre, alpha);
      const auto s = stationary<double>(centre, 2, sites, alpha);
      CHECK(residual(s, alpha) < 1e-14 * alpha);
      CHECK(residual(s, alpha + 0.01) > 1e-4);
      check_close(s.contact_sum() / (s.mu * s.norm()), 1, 1e-13);
      const auto wide = stationary<Quadruple>(centre, Quadruple(2), sites, alpha);
      CHECK(residual(wide, alpha) < 1e-31);
      // At another frequency the same profile is found, larger by the scaling law
      const auto one = stationary<double>(centre, 1, sites, alpha);
      const double factor = std::pow(2, 1 / (alpha - 1));
      for (std::size_t i = 0; i < sites; ++i) {
        const auto exact = static_cast<double>(wide.u[i]);
        if (!(std::abs(exact) > 1e-250)) continue;
        check_close(s.u[i], exact, 0, 1e-11);
        check_close(one.u[i] * factor, exact, 0, 1e-11);
      }
    }
  for (double alpha : {1.0, 0.5, -2.0, std::nan("")})
    CHECK_THROWS_AS(stationary<double>(Centre::site, 1, 21, alpha), std::invalid_argument);
}

TEST_CASE("static breathers of any exponent only turn their phase", "[property][dps][exponents]") {
  for (double alpha : {1.2, 2.0, 4.0})
    for (Centre centre : {Centre::site, Centre::bond}) {
      const auto s = stationary<double>(centre, 3, sites_of(centre, alpha), alpha);
      Field field(s.u.begin(), s.u.end());
      const Field start = field;
      evolve_dps(Dps{.sites = field.size(), .exponent = alpha}, field, 2, 1, 1e-13);
      const auto turn = std::polar(1.0, 3 * 2 / (2 * tau_0(alpha)));
      for (std::size_t i = 0; i < field.size(); ++i)
        check_close(std::abs(field[i] - start[i] * turn) / std::abs(start[field.size() / 2]), 0,
                    1e-9);
    }
}

TEST_CASE("the contact matrix gives the full spectrum for any exponent",
          "[property][dps][exponents]") {
  for (double alpha : {1.25, 2.0, 4.0})
    for (Centre centre : {Centre::site, Centre::bond}) {
      CAPTURE(alpha, int(centre));
      const auto s = stationary<double>(centre, 2, sites_of(centre, alpha), alpha);
      const auto spectrum = contact_spectrum(s);
      CHECK(std::abs(spectrum.phase_defect) < 1e-14);
      auto full = full_exponents(s);
      const auto reduced = exponents(spectrum);
      for (std::size_t k = 0; k < reduced.size(); ++k) {
        const std::complex<double> lambda(reduced[k].first, reduced[k].second);
        auto nearest = std::min_element(full.begin(), full.end(), [&](auto a, auto b) {
          return std::abs(a - lambda) < std::abs(b - lambda);
        });
        // The defective zero, and pairs near zero, are off by the root of rounding
        check_close(std::abs(*nearest - lambda), 0, std::abs(lambda) < 1e-3 ? 1e-6 : 1e-9);
        full.erase(nearest);
      }
      // The full matrix alone, in the longer type, has a growing exponent around a site only
      const auto wide = stationary<long double>(centre, 2, sites_of(centre, alpha), alpha);
      long double growth = 0;
      for (const auto& lambda : full_exponents(wide)) growth = std::max(growth, lambda.real());
      CHECK((growth > 1e-7L) == (centre == Centre::site));
      CHECK(eigenvalues_above(contact_roots(s), s.mu / alpha) ==
            (centre == Centre::site ? 2U : 1U));
    }
}

TEST_CASE("a perturbation grows at the rate of its exponent", "[property][dps][exponents]") {
  for (double alpha : {1.8, 3.0}) {
    const PinnedBreather site(
        stationary<double>(Centre::site, 1, sites_of(Centre::site, alpha), alpha));
    check_close(rate_along(site, 1, 1e-7, 4 / site.pair.rate, alpha), site.pair.rate, 0, 1e-4);
  }
}

TEST_CASE("the amplitude of a DpS packet knows what its samples leave", "[unit][dps][exponents]") {
  DpsStrike impact;
  impact.tau = 323.3731837235295, impact.end = Ends::fixed;
  const Table t = impact.quantities(impact.find());
  // From another program with steps of 0.012
  check_close(t.numbers("value")[2], 0.65536189, t.numbers("error")[2]);
  CHECK(t.numbers("error")[2] < 1e-3);
}

TEST_CASE("a DpS chain is long enough for what runs away in it", "[unit][dps][exponents]") {
  // Centres and norms from another program, which has longer chains
  struct Seen {
    double alpha, tau, centre, norm;
  };
  for (const auto& [alpha, tau, centre, norm] : {Seen{2.5, 400, 259.910756, 0.87380056},
                                                 {3.4, 300, 325.957455, 0.91291466},
                                                 {4, 150, 234.235660, 0.92912480}}) {
    DpsStrike impact;
    impact.alpha = alpha, impact.tau = tau, impact.end = Ends::fixed;
    const auto found = impact.find();
    const Table t = impact.quantities(found);
    const auto value = t.numbers("value"), error = t.numbers("error");
    CAPTURE(alpha, found[1].end.size(), value[0], value[3]);
    check_close(value[0], centre, 3 * error[0]);
    check_close(value[3], norm, 3 * error[3] + 1e-8);
    CHECK(found[1].far_end < 1e-9);
  }
  // The chains of the chapters are, and a chosen end belongs to the run
  CHECK(follow_dps(Dps{120}, dps_impact(120), 250, 250, 1e-6).far_end < 1e-9);
  CHECK(follow_dps(Dps{150}, dps_impact(150), 320, 320, 1e-6).far_end < 1e-9);
  DpsStrike chosen;
  chosen.sites = 30;
  CHECK(chosen.find()[1].end.size() == 30);
}

TEST_CASE("commands take an exponent, and refuse what is none", "[cli][exponents]") {
  const std::string profile = "sec32_dps_profiles profile",
                    spectrum = "sec33_dps_stability spectrum", impact = "sec31_dps_limit impact";
  for (const auto& [command, least] :
       {std::pair(profile, "1.05"), {spectrum, "1.05"}, {impact, "1.05"}})
    for (const std::string value : {"1", "0.5", "4.01", "nan", "5/4x"}) {
      const Result r = call(command + " --alpha " + value);
      CAPTURE(command, value, r.errors);
      CHECK(r.code == 2);
      CHECK(r.error_lines() == 1);
      CHECK(r.output.empty());
      check_line(r.errors.substr(0, r.errors.find('\n')), "--alpha: '" + value + "' is not");
      CHECK(r.errors.find(std::string("[") + least + ", 4]") != std::string::npos);
    }
  // Rows of the default, and of 3/2 typed
  const auto rows = [](const std::string& line) {
    std::istringstream text(call(line).output);
    std::string out, row;
    while (std::getline(text, row))
      if (row.rfind('#', 0) != 0) out += row + '\n';
    return out;
  };
  for (const auto& line : {profile, spectrum, impact + " --tau 30"}) {
    CHECK(rows(line).size() > 200);
    CHECK(rows(line) == rows(line + " --alpha 3/2"));
    CHECK(rows(line) != rows(line + " --alpha 1.51"));
  }
}
