// The DpS equation with contacts of any exponent: averaging, invariants, static and travelling breathers, their
// stability, and what is refused.

#include <gsl/gsl_integration.h>

#include <algorithm>
#include <numbers>

#include "check.hpp"
#include "commands/dps_orbit.hpp"
#include "commands/dps_strike.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/spectrum.hpp"
#include "run.hpp"
#include "sec33/dps_motion.hpp"
#include "secB/exponents.hpp"

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
    evolve_dps(Dps{field.size(), Ends::free, alpha}, field, 5, 1, 1e-11, Unwatched{});
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
    CHECK(m * secant_stiffness(m, 1.5) == three_halves(m));
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
      evolve_dps(Dps{.sites = field.size(), .exponent = alpha}, field, 2, 1, 1e-13, Unwatched{});
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
    check_close(measured_rate(site, 1e-7, {1e-12, 1}), site.pair.rate, 0, 1e-4);
  }
}

TEST_CASE("the site-centred breather is unstable and the bond-centred one stable for all exponents",
          "[property][dps][exponents]") {
  const auto rows = scan_exponents({1.09, 1.1, 1.2, 1.35, 1.5, 1.75, 2, 2.5, 3, 3.5, 4});
  double before = 0;
  for (const OfExponent& row : rows) {
    CAPTURE(row.alpha);
    const double margin = row.site.margin.value;
    CHECK(margin > 1e3 * row.site.margin.error);
    CHECK(row.bond.margin.value < -1e3 * row.bond.margin.error);
    CHECK(row.norm_difference.value < -1e3 * row.norm_difference.error);
    CHECK(margin > before);
    before = margin;
    check_close(row.site.rate.value, std::sqrt((1 - 1 / row.alpha - margin) * row.alpha * margin),
                0, 1e-12);
  }
  for (auto what : {Vanishing::margin_site, Vanishing::margin_bond, Vanishing::norm_difference})
    CHECK(sign_changes(what, rows).empty());
  // At 3/2 these are the numbers of sections 3.2 and 3.3
  check_close(rows[4].site.margin.value, 4.85297661617711e-06, 1e-17);
  check_close(rows[4].bond.margin.value, -4.85326567483309e-06, 1e-17);
  check_close(rows[4].norm_difference.value, -1.331102768e-6, 0, 1e-8);
}

TEST_CASE("a change of sign is found where there is one", "[unit][dps][exponents]") {
  const auto root =
      located([](double x) { return x * x - 2 + 1e-9; }, [](double x) { return x * x - 2; }, 1, 2);
  check_close(root.value, std::numbers::sqrt2, 1e-15);
  CHECK(root.error > 1e-10);
  CHECK(root.error < 1e-9);
  // Rows are bracketed by certain signs only; the halving then runs to the end where nothing changes
  auto rows = scan_exponents({1.9, 2.0, 2.1});
  rows[1].site.margin.error = 1;
  rows[2].site.margin.value *= -1;
  const auto found = sign_changes(Vanishing::margin_site, rows);
  REQUIRE(found.size() == 1);
  CHECK(found[0].value >= 1.9);
  CHECK(found[0].value <= 2.1);
  rows[2].site.margin.error = 1;
  CHECK(sign_changes(Vanishing::margin_site, rows).empty());
}

TEST_CASE("both ends of the exponents are what the equation says", "[convergence][exponents]") {
  // Towards one: a Gaussian of the logarithmic equation
  const auto near = breathers_of_exponent(1.12), nearer = breathers_of_exponent(1.06);
  for (Centre centre : both_centres) {
    const double off = near.of(centre).bend.value - 1, less = nearer.of(centre).bend.value - 1;
    CHECK(std::abs(less) < 0.06);
    check_close(less / off, 0.5, 0.06);
  }
  // What pins it falls like exp(-c / (alpha - 1)): local slopes are straight in alpha - 1
  const auto rows = scan_exponents({1.08, 1.1, 1.12});
  const auto slope_of = [&](std::size_t i, auto of) {
    const double a = 1 / (rows[i].alpha - 1), b = 1 / (rows[i + 1].alpha - 1);
    return std::pair(2 / (a + b), std::log(of(rows[i]) / of(rows[i + 1])) / (b - a));
  };
  const auto at_one = [&](auto of) {
    const auto [x0, y0] = slope_of(0, of);
    const auto [x1, y1] = slope_of(1, of);
    return y0 - (y1 - y0) / (x1 - x0) * x0;
  };
  const Estimate c = pinning_exponent();
  check_close(c.value, 6.490174694, 1e-6);
  check_close(at_one([](const auto& r) { return r.site.margin.value; }), c.value, 0.006);
  check_close(at_one([](const auto& r) { return r.norm_difference.value; }), c.value, 0.012);
  CHECK(std::abs(at_one([](const auto& r) { return r.site.norm.value; }) - c.value) > 1);
  // Far from one: two or three sites
  const auto far = breathers_of_exponent(20), farther = breathers_of_exponent(40);
  const auto closer = [](const Estimate& a, const Estimate& b, double limit) {
    CAPTURE(a.value, b.value, limit);
    CHECK(std::abs(b.value - limit) < 0.7 * std::abs(a.value - limit));
    check_close(b.value, limit, 0.05);
  };
  closer(far.site.norm, farther.site.norm, 2.0 / 3);
  closer(far.bond.norm, farther.bond.norm, 0.5);
  closer(far.site.margin, farther.site.margin, 1.0 / 3);
  closer(far.bond.margin, farther.bond.margin, 0);
  closer(far.norm_difference, farther.norm_difference, -0.25);
}

TEST_CASE("travelling breathers of other exponents", "[property][dps][exponents][travelling]") {
  for (double alpha : {1.3, 2.0, 3.0}) {
    CAPTURE(alpha);
    const auto [problem, member] = follow_dps_member(alpha, 0, 1e-12);
    CHECK(problem.alpha == alpha);
    // Half a shift was solved for, with a symmetry; here is a whole one without it
    Field end = member.field;
    problem.flow(end, problem.shift_time);
    for (std::size_t n = 1; n < end.size(); ++n)
      check_close(std::abs(end[n] - member.field[n - 1]) / sup(member.x), 0, 1e-9);
    // The same at another amplitude, by the scaling law
    Field large = member.field;
    for (auto& a : large) a *= 2;
    evolve_dps(Dps{.sites = large.size(), .exponent = alpha}, large,
               problem.shift_time * std::pow(2, 1 - alpha), 1, 1e-13, Unwatched{});
    for (std::size_t n = 1; n < end.size(); ++n)
      check_close(std::abs(large[n] - 2.0 * member.field[n - 1]) / sup(member.x), 0, 1e-8);
  }
  // The command takes any shift time
  DpsOrbit command;
  command.alpha = 2, command.time = 3;
  const Table profile = command.profile(command.find());
  Field now;
  for (std::size_t i = 0; i < profile.numbers("n").size(); ++i)
    now.emplace_back(profile.numbers("real")[i], profile.numbers("imag")[i]);
  const Field before = now;
  evolve_dps(Dps{.sites = now.size(), .exponent = 2}, now, 3, 1, 1e-13, Unwatched{});
  for (std::size_t n = 1; n < now.size(); ++n)
    check_close(std::abs(now[n] - before[n - 1]), 0, 1e-9);
  CHECK(std::abs(now[now.size() / 2]) > 0.1);
  // Spheres: the member that the chapter finds directly
  const DpsMember direct = dps_member({}, cut_dps_packet(40, 8)),
                  followed = follow_dps_member(1.5, 0, 1e-13).second;
  check_close(followed.norm, direct.norm, 0, 1e-11);
  // The equation that is left out, at an angle where it is not satisfied
  const auto [off, other] = follow_dps_member(2, 0.5, 1e-12);
  check_close(off.misses(other.x)[0], other.V * std::sin(0.25), 0, 1e-7);
}

TEST_CASE("the amplitude of a DpS packet knows what its samples leave", "[dps][exponents]") {
  DpsStrike impact;
  impact.tau = 323.3731837235295, impact.end = Ends::fixed;
  const Table t = impact.quantities(impact.find());
  // From another program with steps of 0.012
  check_close(t.numbers("value")[2], 0.65536189, t.numbers("error")[2]);
  CHECK(t.numbers("error")[2] < 1e-3);
}

TEST_CASE("a DpS chain is long enough for what runs away in it", "[dps][exponents]") {
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
  CHECK(follow_dps(Dps{120}, dps_impact(120), 250, 250, 1e-6, Unwatched{}).far_end < 1e-9);
  CHECK(follow_dps(Dps{150}, dps_impact(150), 320, 320, 1e-6, Unwatched{}).far_end < 1e-9);
  DpsStrike chosen;
  chosen.sites = 30;
  CHECK(chosen.find()[1].end.size() == 30);
}

TEST_CASE("commands take an exponent, and refuse what is none", "[cli][exponents]") {
  const std::string profile = "sec32_dps_profiles profile",
                    spectrum = "sec33_dps_stability spectrum", impact = "sec31_dps_limit impact",
                    orbit = "sec5_travelling_packets orbit";
  for (const auto& [command, least] :
       {std::pair(profile, "1.05"), {spectrum, "1.05"}, {impact, "1.05"}, {orbit, "1.05"}})
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
