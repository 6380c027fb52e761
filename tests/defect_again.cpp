// Arrays of cantilevers and a defect in them a second time: what a watched cantilever shows, how the energy is
// divided, what stays, the mode of the defect, and collisions, from plain sums and formulas.

#include <map>

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "sec35/all_scales.hpp"
#include "sec36/defect_mode.hpp"
#include "sec36/trapped_mode.hpp"

namespace defect_again {

using namespace lattice;

namespace {

using Numbers = std::vector<double>;
const double half_turn = std::acos(-1.0);

/// A short array whose packet meets the defect early.
StruckArray short_array(std::size_t sites = 40, std::size_t defect = 14) {
  StruckArray blow;
  blow.array.sites = sites, blow.array.defect = defect;
  blow.velocity = 0.8;
  return blow;
}
double seconds(const StruckArray& blow) {
  return std::sqrt(blow.scales.m / blow.scales.k);
}
double metres(const StruckArray& blow) {
  return std::pow(blow.scales.k / blow.scales.gamma, 2);
}
/// The energy of the impact in units of the chain.
double energy_in(const StruckArray& blow) {
  return std::pow(blow.velocity * seconds(blow) / metres(blow), 2) / 2;
}
double sum_of(const Numbers& e, std::size_t from, std::size_t to) {
  double sum = 0;
  for (std::size_t n = from; n < to; ++n) sum += e[n];
  return sum;
}
/// Push of site n, from one, on the next, without a defect.
double push_on(const State<double>& z, std::size_t n) {
  return std::pow(std::max(0.0, z.y[n - 1] - z.y[n]), 1.5);
}

}  // namespace

TEST_CASE("an array is struck and watched", "[unit][cantilever]") {
  CHECK(StruckArray{}.velocity == 1);
  const StruckArray blow = short_array();
  const double ms = 1e-3 / seconds(blow), newton = blow.scales.k * metres(blow);
  const Impact impact = blow.impact(1.3, 5, 0.7);
  check_close(impact.velocity, blow.velocity * seconds(blow) / metres(blow), 0, 1e-13);
  check_close(impact.time, 5 * ms, 0, 1e-13);
  CHECK(impact.sample == 0.7);
  check_close(impact.chain.mass_of(13), blow.array.mass(1.3) / blow.array.mass(1), 1e-14);

  const WatchedRun run = pass(blow, 9, 16, {0.2, 0.1});
  Numbers t, f, v, y;
  strike(ContactAware{0.2}, blow.impact(1, 16, 0.1), [&](const State<double>& now, const auto&) {
    t.push_back(now.t), f.push_back(push_on(now, 9)), v.push_back(now.v[8]), y.push_back(now.y[8]);
  });
  REQUIRE(t.size() == run.at.t.size());
  for (std::size_t k = 0; k < t.size(); k += 7) {
    check_close(run.at.t[k], t[k], 1e-12);
    check_close(run.at.force[k], f[k], 1e-12);
    CHECK((run.at.v[k] == v[k] && run.at.y[k] == y[k]));
  }
  const auto push = strongest_push(t, f);
  REQUIRE(push);
  const Pulse p = pulse_of(run.at, blow.scales);
  check_close(p.arrival, push->t * seconds(blow), 0, 1e-12);
  check_close(p.force, push->force * newton, 0, 1e-12);
  check_close(p.velocity, largest_modulus(t, v) * metres(blow) / seconds(blow), 0, 1e-12);
  check_close(p.deflection, largest_modulus(t, y) * metres(blow), 0, 1e-12);
  check_close(p.period, push->period * seconds(blow), 0, 1e-12);
  check_close(mean_speed(run, blow, 9), 9 / p.arrival, 0, 1e-12);
  double most = 0;
  for (double x : f) most = std::max(most, x);
  check_close(duration_above(run, blow, 0.3), time_above(t, f, 0.3 * most) * seconds(blow) * 1e3, 0,
              1e-12);
  CHECK(duration_above(run, blow, 0.3) > 0);
  CHECK_THROWS_AS(pulse_of({{0, 1, 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, blow.scales), NoPacket);

  // The strongest push of every contact in each of three times
  const Numbers map = strongest_forces(blow, 1, 9, 3);
  Numbers again(3 * 39, 0);
  const Impact whole = blow.impact(1, 9, 0.1);
  strike(ContactAware{0.1}, whole, [&](const State<double>& now, const auto&) {
    const auto bin = std::min<std::size_t>(2, std::size_t(3 * now.t / whole.time));
    for (std::size_t n = 0; n < 39; ++n)
      again[39 * bin + n] = std::max(again[39 * bin + n], push_on(now, n + 1) * newton);
  });
  REQUIRE(map.size() == again.size());
  double apart = 0;
  for (std::size_t i = 0; i < map.size(); ++i) apart = std::max(apart, std::abs(map[i] - again[i]));
  check_close(apart, 0, 1e-13);
  CHECK(*std::max_element(map.begin() + 78, map.end()) > 0);
}

TEST_CASE("the energy is divided among three parts, and net of what stays behind",
          "[unit][cantilever]") {
  const StruckArray blow = short_array(90);
  Numbers e(90);
  for (std::size_t n = 0; n < 90; ++n) e[n] = 1 + 0.1 * double(n * n % 7);
  const Division d = division_of(blow, e);
  check_close(d.reflected, sum_of(e, 0, 9) / energy_in(blow), 0, 1e-13);
  check_close(d.near, sum_of(e, 9, 18) / energy_in(blow), 0, 1e-13);
  check_close(d.transmitted, sum_of(e, 18, 90) / energy_in(blow), 0, 1e-13);
  CHECK((Division{}.reflected == 0 && Division{}.near == 0 && Division{}.transmitted == 0));
  const Division part{0.5, 0.2, 0.4}, net = part.net({0.3, 0.1, 0.6});
  check_close(part.sum(), 1.1, 1e-15);
  check_close(net.reflected, 0.2 / 0.7, 1e-15);
  check_close(net.near, 0.2 / 0.7, 1e-15);
  check_close(net.transmitted, 0.4 / 0.7, 1e-15);

  // The way there ends when the fifth site before the defect moves
  const ImpactRun way = approach(blow, 0.2);
  std::size_t looks = 0, rest = 0;
  strike(ContactAware{0.2}, blow.impact(1, 200, 1), [&](const State<double>& now, const auto&) {
    ++looks, rest += now.y[8] == 0;
    return now.y[8] == 0;
  });
  CHECK(looks == rest + 1);
  CHECK((way.end.y[8] != 0 && way.end.y[12] == 0));
  check_close(way.end.t,
              blow.impact(1, 200, 1).time / std::ceil(blow.impact(1, 200, 1).time) * double(rest),
              1e-9);
  CHECK_THROWS_AS(approach(blow, 0.2, 0.01), NoPacket);

  // On from there with two looks, ten milliseconds apart
  const double until = 22;
  const ScatteringSetup at(blow, {0.2, 0.1}, until);
  std::array<std::array<Division, 2>, 2> with{}, none{};
  for (std::size_t k : {0U, 1U})
    for (double ratio : {1.2, 1.0}) {
      ImpactRun run = approach(blow, at.steps[k]);
      for (std::size_t later : {0U, 1U}) {
        const double time = until - (later ? 0 : 10);
        go_on(ContactAware{at.steps[k]}, blow.impact(ratio, until, until / seconds(blow) * 1e-3),
              run, time * 1e-3 / seconds(blow));
        (ratio > 1.1 ? with : none)[k][later] = division_of(blow, run.density);
      }
    }
  const Scattering one = scatter(blow, 1.2, at.start[1], 0.1, until);
  check_close(one.earlier.near, with[1][0].near, 0, 1e-10);
  check_close(one.later.near, with[1][1].near, 0, 1e-10);
  check_close(at.without[0].reflected, none[0][1].reflected, 0, 1e-10);
  const Fractions f = fractions(at, 1.2);
  const auto net_of = [&](std::size_t k) {
    const Division &w = with[k][1], &o = none[k][1];
    const double in = 1 - o.reflected;
    return std::array{w.reflected,
                      w.near,
                      w.transmitted,
                      with[k][0].near,
                      (w.reflected - o.reflected) / in,
                      w.near / in,
                      w.transmitted / in};
  };
  const auto x = net_of(0), y = net_of(1);
  const std::array found{f.reflected,     f.near,     f.transmitted,    f.near_earlier,
                         f.net_reflected, f.net_near, f.net_transmitted};
  for (std::size_t k = 0; k < 7; ++k) {
    CAPTURE(k);
    check_close(found[k].value, y[k], 1e-11);
    check_close(found[k].error, std::abs(x[k] - y[k]), 1e-11);
    CHECK(f.named()[k].share.value == found[k].value);
  }
  check_close(f.budget.value, with[1][1].sum() - 1, 1e-11);
  check_close(f.budget.error, std::abs(with[0][1].sum() - 1), 1e-11);

  bounded_by(0.95, false, "least", [](double r) { return almost_total({r, 0}); });
  bounded_by(1, true, "most", [](double r) { return almost_total({r, 0}); });
  bounded_by(0.1, false, "least", [](double r) { return partial({r, 0}); });
  bounded_by(0.9, true, "most", [](double r) { return partial({r, 0}); });
  bounded_by(0.95, false, "least", [](double r) {
    return almost_total(std::vector<Estimate>{{0.97, 0}, {r + 0.01, 0.01}, {0.96, 0}});
  });
  bounded_by(1, true, "most", [](double r) {
    return almost_total(std::vector<Estimate>{{0.97, 0}, {r - 0.01, 0.01}, {0.99, 0}});
  });
  const auto worst = [](const Estimate& a, const Estimate& b) {
    return failing(almost_total(std::vector<Estimate>{a, b}));
  };
  CHECK((worst({0.96, 0}, {0.97, 0.03}) == "least" && worst({0.98, 0}, {0.97, 0.025}) == "least"));
  CHECK((worst({0.99, 0}, {0.98, 0.025}) == "most" && worst({0.97, 0.015}, {0.98, 0.015}).empty()));
  CHECK_FALSE(holds(almost_total(std::vector<Estimate>{})));
}

TEST_CASE("what stays at a defect is watched", "[unit][cantilever]") {
  Stay kept{{75, 80, 100}, {0.4, 0.3, 0.1}, {}};
  kept.before = {0.8, 0.7, 0.6};
  CHECK((kept.at(75) == 0.4 && kept.at(80) == 0.3 && kept.at(75.0000001, &Stay::before) == 0.7));
  check_close(kept.kept(), 0.25, 1e-15);
  check_close(kept.kept(&Stay::before), 0.75, 1e-15);
  CHECK((Stay{}.frequency == 0 && Stay{}.push == 0));
  check_close(frequency_of({{0, 1, 2, 3, 4, 5, 6}, {}, {-1, 1, -1, 1, -1, 3, 1}, {}}),
              4 * half_turn / (4.25 - 0.5), 1e-13);

  StruckArray blow = short_array(100, 14);
  blow.velocity = 0.2;
  const ImpactRun way = approach(blow, 0.4);
  const Stay found = stay(blow, 0.9, way, {0.4, 0.2});
  Numbers t, near, before, density(100, 0), times, speeds;
  double push = 0;
  ImpactRun run = way;
  const double ms = seconds(blow) * 1e3;
  std::size_t looks = 0;
  go_on(ContactAware{0.4}, blow.impact(0.9, 100.2, 0.2), run, 100.2 / ms,
        [&](const State<double>& now, const Numbers& e) {
          const double time = now.t * ms, next = 50 + 0.5 * double(t.size());
          if (time > next - 1e-6)
            t.push_back(next), near.push_back(sum_of(e, 9, 18) / energy_in(blow)),
                before.push_back(sum_of(e, 5, 14) / energy_in(blow));
          if (time >= 70 && time <= 80)
            push = std::max(push, push_on(now, 12) * blow.scales.k * metres(blow));
          if (looks++ % 4 == 0 && time >= 65) {
            times.push_back(now.t), speeds.push_back(now.v[13]);
            for (std::size_t n = 0; n < 100; ++n) density[n] += e[n] / energy_in(blow);
          }
        });
  CHECK(found.t == t);
  CHECK(t.size() == 101);
  REQUIRE(found.near.size() == near.size());
  for (std::size_t k = 0; k < t.size(); k += 10)
    check_close(found.near[k], near[k], 1e-12), check_close(found.before[k], before[k], 1e-12);
  for (std::size_t n = 0; n < 100; n += 3)
    check_close(found.density[n], density[n] / double(times.size()), 1e-12);
  check_close(found.push, push, 0, 1e-12);
  CHECK(push > 0);
  const Numbers up = upward_crossings(times, speeds);
  check_close(found.frequency, 2 * half_turn * double(up.size() - 1) / (up.back() - up.front()),
              1e-11);

  // The mark of what is trapped: kept, above the wake, at most one site off
  const auto made = [](double now, double later, int off) {
    Stay s{{75, 100}, {now, later}, Numbers(30, 0.1)};
    s.density[std::size_t(12 + off)] = 1, s.density[7] = s.density[17] = 2;
    return std::array{s, s};
  };
  const auto wake = made(0.2, 0.1, 0);
  bounded_by(0.95, false, "kept", [&](double x) { return trapped_at(12, made(1, x, 0), wake); });
  bounded_by(0.2, false, "over_wake",
             [&](double x) { return trapped_at(12, made(x, x, 0), wake); });
  for (int off : {-1, 1}) CHECK(failing(trapped_at(12, made(1, 1, off), wake)).empty());
  for (int off : {-4, -2, 2, 4})
    CHECK(failing(trapped_at(12, made(1, 1, off), wake)) == "top_from_defect");
  const auto a = made(1, 0.97, 0), b = made(1, 0.96, 1);
  const Criterion mixed = trapped_at(12, {a[0], b[0]}, wake);
  check_estimate(mixed[0].value, 0.96, 0.01);
  check_estimate(mixed[2].value, 1, 1);
}

TEST_CASE("the mode of a light defect by plain formulas", "[unit][cantilever]") {
  const CantileverArray array;
  const Shooting<double> problem = mode_problem(array, 0.9);
  CHECK((mode_sites == 31 && problem.chain.sites == 31));
  for (std::size_t n = 0; n < 31; ++n)
    check_close(problem.chain.mass_of(n), n == 15 ? array.mu(0.9) : 1, 1e-15);
  for (std::size_t i = 0; i <= 31; ++i)
    check_close(problem.chain.eta_of(i), i == 15 || i == 16 ? std::sqrt(1.8 / 1.9) : 1, 1e-15);
  CHECK(problem.chain.contact.force(-1e-100) > 0);
  const Orbit<double> orbit = mode_of_energy(problem, 2e-4);
  check_close(orbit.energy, 2e-4, 0, 2e-10);
  Shooting<double> there = problem;
  there.omega = orbit.omega;
  check_close(newton(there, orbit.x).energy, 2e-4, 0, 1e-9);
  CHECK(orbit.start.y[15] > 0);
  CHECK_THROWS_AS(mode_of_energy(problem, 1e-40), std::runtime_error);

  Numbers mean(31, 0);
  State<double> now = orbit.start;
  for (int k = 0; k <= 5; ++k) {
    const Numbers e = energy_density(problem.chain, now);
    for (std::size_t n = 0; n < 31; ++n) mean[n] += e[n] / 6;
    evolve(ContactAware{0.05}, problem.chain, now, 2 * half_turn / orbit.omega / 5, 9,
           Unobserved{});
  }
  const Numbers found = mean_density(problem, orbit, 5);
  for (std::size_t n = 0; n < 31; ++n) check_close(found[n], mean[n], 1e-13);
  Stay stay;
  for (int n = 0; n < 200; ++n) stay.density.push_back(1 + 0.1 * (n % 7));
  const Profile shares = profile(array, problem, orbit, stay, 5);
  REQUIRE((shares.run.size() == 9 && shares.mode.size() == 9));
  double apart = 0;
  for (std::size_t n = 0; n < 9; ++n) {
    const double run = stay.density[95 + n] / sum_of(stay.density, 95, 104),
                 mode = mean[11 + n] / sum_of(mean, 11, 20);
    check_close(shares.run[n], run, 1e-13);
    check_close(shares.mode[n], mode, 1e-11);
    apart += std::abs(run - mode);
  }
  check_close(shares.overlap(), 1 - apart / 2, 1e-11);

  const StruckArray blow;
  const Table table = trapped::mode_table(blow, shares, orbit);
  REQUIRE(table.rows.size() == 9);
  CHECK(table.numbers("n")[0] == 96);
  check_close(table.numbers("run")[3], shares.run[3], 1e-15);
  check_close(table.numbers("mode")[3], shares.mode[3], 1e-15);
  check_close(table.numbers("y")[5], orbit.start.y[16] * metres(blow) * 1e6, 0, 1e-12);
  CHECK(table.numbers("n")[8] == 104);
  const auto miss = trapped::misses<double>(there, orbit);
  there.symmetry = site_centred(31);
  const double asymmetry =
      there.shoot(there.reduce(orbit.start), {}, false).miss.cwiseAbs().maxCoeff();
  CHECK(miss[0] < 1e-11);
  CHECK(miss[1] > 0.03 * asymmetry / orbit.amplitude);
  CHECK(miss[1] < 30 * asymmetry / orbit.amplitude);
}

TEST_CASE("two beads collide, and a cradle's ratio", "[unit][cantilever]") {
  const Collision by_energy = collision_by_energy(), run = collide(0.05);
  // The integral of ds / sqrt(1 - s^(5/2)) with 1 - s = u^2
  const double x = std::pow(5 / 8.0, 2 / 5.0);
  double time = 0;
  for (int k = 0; k < 4000; ++k) {
    const double u = (k + 0.5) / 4000, s = 1 - u * u;
    time += 2 * u / std::sqrt(1 - s * s * std::sqrt(s)) / 4000;
  }
  check_close(by_energy.compression, x, 1e-14);
  check_close(by_energy.contact_time, 2 * x * time, 1e-6);
  check_close(run.contact_time, by_energy.contact_time, 1e-4);
  check_close(run.compression, by_energy.compression, 1e-4);
  check_close(cradle_ratio(10, 2, 6, 3), std::pow(0.05, 2.5), 1e-15);
  check_close(cradle(9.81, 2.43), std::pow(0.5 / 9.81, 2.5) * std::pow(2.43 / 0.077e-3, 5), 0,
              1e-12);
}

TEST_CASE("the table of scales and what the drawing needs", "[unit][cantilever]") {
  CHECK(AllScales{}.velocity == 1);
  const Table table = AllScales{.velocity = 2}.table();
  std::map<std::string, double> value;
  const auto names = table.texts("quantity");
  for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = table.numbers("value")[i];
  const CantileverArray array;
  const Scales s = array.scales();
  const Collision hit = collision_by_energy();
  const double V = 2, tau = std::pow(s.m * s.m / (s.gamma * s.gamma * V), 0.2);
  check_close(value.at("impact_velocity"), 2, 0);
  check_close(value.at("contact_time"), hit.contact_time * tau, 0, 1e-12);
  check_close(value.at("max_compression"), hit.compression * std::pow(s.m * V * V / s.gamma, 0.4),
              0, 1e-12);
  check_close(value.at("cradle_lambda_5_2"), cradle(9.81, hit.contact_time), 0, 1e-12);
  const double gamma = 193e9 * std::sqrt(2 * 2.38e-3) / 3 / (1 - 0.46 * 0.46);
  check_close(value.at("gamma_with_beam_modulus"), gamma, 0, 1e-12);
  check_close(value.at("lambda_with_beam_modulus"),
              s.m / s.k * std::pow(gamma * gamma * V / s.m / s.m, 0.4), 0, 1e-12);

  Output output("nowhere", {});
  Report report{output, true};
  report_scales(report, StruckArray{.velocity = 2});
  const auto results = report.results.table.numbers("value");
  REQUIRE(results.size() == 3);
  check_close(results[0], tau * 1e3, 0, 1e-12);
  check_close(results[1], std::sqrt(s.m / s.k) * 1e3, 0, 1e-12);
  check_close(results[2], s.m / s.k / tau / tau, 0, 1e-12);
  Table& drawn = report.table("again");
  CHECK(drawn.rows.empty());
}

}  // namespace defect_again
