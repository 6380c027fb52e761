// The impact on a compressed chain: what is measured by a second formula, a run against a plain one, and the criteria at
// their bounds.

#include <algorithm>

#include "check.hpp"
#include "sec4/compressed_impact.hpp"

namespace compressed_again {

using namespace lattice;

namespace {

std::vector<double> bumps(std::size_t sites) {
  std::vector<double> e(sites);
  for (std::size_t n = 0; n < sites; ++n)
    e[n] = 0.2 + std::sin(0.7 * double(n)) * 0.1 + std::exp(-std::pow((double(n) - 70.3) / 9, 2));
  return e;
}

/// A snapshot whose window and sech are as given; nothing else counts.
Snapshot shot_of(double window, double top, double width, double residual) {
  return {State<double>(1), window, {}, {1, top, width, residual}};
}

Traits with(double share, double boundary, double steadiness) {
  return {1, share, 1, boundary, 1, steadiness};
}

/// The slope of the line of least squares.
double slope(const std::vector<double>& t, const std::vector<double>& x) {
  const double n = double(t.size());
  double st = 0, sx = 0, tt = 0, tx = 0;
  for (std::size_t k = 0; k < t.size(); ++k)
    st += t[k], sx += x[k], tt += t[k] * t[k], tx += t[k] * x[k];
  return (n * tx - st * sx) / (n * tt - st * st);
}

/// A wave whose amplitude is that of `at(n)`, in a compressed chain.
template <class At>
State<double> wave_of(std::size_t sites, At at) {
  const double omega = std::sqrt(1 + 3 * std::sqrt(0.5) * (1 - std::cos(1.9)));
  State<double> state(sites);
  for (std::size_t i = 0; i < sites; ++i) {
    const double n = double(i + 1);
    state.y[i] = at(n) * std::sin(1.9 * n);
    state.v[i] = -omega * at(n) * std::cos(1.9 * n);
  }
  return state;
}

}  // namespace

TEST_CASE("a packet by its densities, site by site", "[unit]") {
  const std::vector<double> e = bumps(150);
  const auto sum = [&](int from, int to) {
    double all = 0;
    for (int n = from; n <= to; ++n) all += e[std::size_t(n)];
    return all;
  };
  int peak = 0;
  for (int n = 20; n < 130; ++n)
    if (sum(n - 20, n + 20) > sum(std::max(peak, 20) - 20, std::max(peak, 20) + 20)) peak = n;
  const int from = peak - 20, to = peak + 20;
  double moment = 0, squares = 0, all_squares = 0;
  for (int n = from; n <= to; ++n) {
    moment += (n + 1) * e[std::size_t(n)];
    squares += std::pow(e[std::size_t(n)], 2);
  }
  for (double x : e) all_squares += x * x;
  const double all = sum(0, 149), inside = sum(from, to);
  const PacketSample at = packet_sample(7, e);
  CHECK(at.t == 7);
  check_close(at.centre, moment / inside, 1e-11);
  check_close(at.share, inside / all, 1e-13);
  check_close(at.boundary, sum(0, 4) / all, 1e-13);
  check_close(at.participation, all * all / all_squares, 1e-10);
  check_close(at.packet_sites, inside * inside / squares, 1e-10);
  CHECK(packet_reach == 20);
  CHECK(envelope_reach == 10);
}

TEST_CASE("a sech, a tail and a breather at both sides of their bounds", "[unit][criteria]") {
  const auto like = [](const Snapshot& x) { return holds(sech_like(x, x)); };
  CHECK(like(shot_of(50, 59.9, 9.9, 0.099)));
  CHECK(like(shot_of(50, 40.1, 9.9, 0.099)));
  for (const Snapshot& x : {shot_of(50, 60.1, 9, 0.09), shot_of(50, 39.9, 9, 0.09),
                            shot_of(50, 50, 10.1, 0.09), shot_of(50, 50, 9, 0.101)})
    CHECK_FALSE(like(x));
  // What two runs do not agree on
  const Snapshot fine = shot_of(50, 58, 8, 0.08);
  for (const Snapshot& coarse :
       {shot_of(50, 55, 8, 0.08), shot_of(50, 58, 5.5, 0.08), shot_of(50, 58, 8, 0.05)})
    CHECK_FALSE(holds(sech_like(coarse, fine)));
  // Tails of three amplitudes, from the 40th to the 80th site
  Snapshot shot{State<double>(1), 150, {1, std::vector<double>(300, 0)}, {0.5, 149.6, 5, 0}};
  for (std::size_t k = 40; k <= 80; ++k) {
    shot.envelope.amplitude[149 - k] = k % 2 ? 0.003 : 0.006;
    shot.envelope.amplitude[149 + k] = 0.001 * double(k);
  }
  double squares = 0;
  for (int k = 40; k <= 80; ++k) squares += 1e-6 * k * k;
  for (std::size_t site : {149 - 39, 149 - 81, 149 + 39, 149 + 81})
    shot.envelope.amplitude[site] = 100;  // not part of a tail
  check_close(tail_amplitude(shot, 1), 2 * std::sqrt(squares / 41), 1e-13);
  check_close(tail_amplitude(shot, -1), 2 * std::sqrt((21 * 36e-6 + 20 * 9e-6) / 41), 1e-14);
  const auto tails = [](double behind, double ahead) {
    Snapshot x{State<double>(1), 150, {1, std::vector<double>(301, behind)}, {1, 150, 5, 0}};
    std::fill(x.envelope.amplitude.begin() + 150, x.envelope.amplitude.end(), ahead);
    return x;
  };
  const auto both = [&](const Snapshot& coarse, const Snapshot& last) {
    return holds(tail_on_both_sides(coarse, last));
  };
  CHECK(both(tails(0.0101, 0.0101), tails(0.0101, 0.0101)));
  CHECK_FALSE(both(tails(0.0099, 0.02), tails(0.0099, 0.02)));
  CHECK_FALSE(both(tails(0.02, 0.0099), tails(0.02, 0.0099)));
  CHECK_FALSE(both(tails(0.035, 0.02), tails(0.02, 0.02)));
  CHECK_FALSE(both(tails(0.02, 0.035), tails(0.02, 0.02)));
  // The lines between breather, train, surface mode and return
  const auto is = [](auto criterion, const Traits& x) { return holds(criterion(x, x)); };
  CHECK(is(lasting_breather, with(-0.166, -1, 0.51)));
  CHECK_FALSE(is(lasting_breather, with(-0.167, -1, 0.51)));
  CHECK_FALSE(is(lasting_breather, with(-0.166, -1, 0.49)));
  CHECK(is(mere_train, with(-0.167, -0.51, 0)));
  CHECK_FALSE(is(mere_train, with(-0.166, -0.51, 0)));
  CHECK_FALSE(is(mere_train, with(-0.167, -0.49, 0)));
  CHECK(is(returning_packet, with(0, 0, 0.49)));
  CHECK_FALSE(is(returning_packet, with(0, 0, 0.51)));
  CHECK(is(lasting_surface_mode, with(-1, -0.49, 0)));
  CHECK_FALSE(is(lasting_surface_mode, with(0, -0.51, 1)));
  check_close(with(0.4, 0, 0).with(with(0.1, 0, 0), &Traits::share_exponent).value, 0.4, 0);
  check_close(with(0.4, 0, 0).with(with(0.1, 0, 0), &Traits::share_exponent).error, 0.3, 1e-15);
}

TEST_CASE("traits are slopes over the last three quarters", "[unit]") {
  // A packet that stands still from 190 to 260, and before the first quarter does what it likes
  std::vector<PacketSample> samples;
  std::vector<double> log_t, share, boundary, t, centre;
  for (int k = 1; k <= 400; ++k) {
    const double at = k, x = 0.6 * at - (k > 190 ? 0.6 * std::min(at - 190, 70.0) : 0);
    samples.push_back({at, k < 100 ? -50 : x, std::pow(at, -0.2) * (1 + 0.1 * std::sin(at)),
                       0.3 / at + 1e-4 * std::cos(at), 1, 1});
    if (k < 100) continue;
    log_t.push_back(std::log(at));
    share.push_back(std::log(samples.back().share));
    boundary.push_back(std::log(samples.back().boundary));
    t.push_back(at);
    centre.push_back(x);
  }
  const Traits seen = traits(samples);
  check_close(seen.share, samples.back().share, 0);
  check_close(seen.boundary, samples.back().boundary, 0);
  check_close(seen.share_exponent, slope(log_t, share), 1e-11);
  check_close(seen.boundary_exponent, slope(log_t, boundary), 1e-11);
  check_close(seen.speed, slope(t, centre), 1e-11);
  check_close(seen.steadiness, 0.6 * 0.3 / slope(t, centre), 1e-11);
  for (PacketSample& p : samples) p.centre *= -1;
  check_close(traits(samples).speed, -slope(t, centre), 1e-11);
  check_close(traits(samples).steadiness, -0.6 / slope(t, centre), 1e-11);
  // The first and the last stretch of a hundred count as well
  for (PacketSample& p : samples) p.centre = p.t + (p.t < 101 ? 9 : 0);
  check_close(traits(samples).steadiness, 0.91 / std::abs(traits(samples).speed), 1e-11);
  for (PacketSample& p : samples)
    p.centre = p.t <= 300 ? p.t : 300 + 0.5 * (p.t - 300) - (p.t > 399 ? 9 : 0);
  const double speed = traits(samples).speed;
  check_close(traits(samples).steadiness, 0.41 / std::abs(speed), 1e-11);
}

TEST_CASE("the window of the fit lies about the energy, or about the top if that is elsewhere",
          "[unit]") {
  const Chain chain{240, Quartic{1}, CompressedHertz{0.5}};
  // Behind the packet a wave that moves the centre of energy by less, or more, than five sites
  for (const auto& [wave, moves] : {std::pair{0.003, false}, {0.0045, true}}) {
    const State<double> state = wave_of(240, [w = wave](double n) {
      return 0.01 / std::cosh((n - 127) / 6) + (n > 95 && n < 117 ? w : 0.0003 * std::sin(n));
    });
    const double energetic = packet_sample(0, energy_density(chain, state)).centre;
    const Snapshot shot = snapshot(chain, state);
    const auto in_window = [&](double c) {
      const auto first = std::size_t(c) - 11;
      return envelope(chain, state, {first, first + 21});
    };
    const std::vector<double> before = in_window(energetic).amplitude;
    const double top = double(std::max_element(before.begin(), before.end()) - before.begin()) + 1;
    CAPTURE(energetic, top, shot.centre);
    CHECK((std::abs(top - energetic) > 5) == moves);
    const double centre = moves ? top : energetic;
    CHECK(shot.centre == centre);
    CHECK(shot.envelope.omega == in_window(centre).omega);
    CHECK(shot.envelope.amplitude == in_window(centre).amplitude);
    CHECK(shot.state.y == state.y);
    const auto first = std::size_t(centre) - 11;
    const Sech f = fit_sech(shot.envelope.amplitude, {first, first + 21}, 8);
    check_close(shot.sech.centre, f.centre, 1e-9);
    check_close(shot.sech.residual, f.residual, 1e-9);
  }
}

TEST_CASE("an impact is a plain run, first with contacts that open and then without", "[unit]") {
  const Impact plain = compressed_impact(0.3, 44);
  CHECK(plain.velocity == 1.87);
  CHECK(plain.time == 44);
  CHECK(plain.sample == 1);
  CHECK(plain.chain.well.as<Quartic>().s == 0.3);
  CHECK(plain.chain.contact.opening() == 0.5);
  const double stiff = std::max(1.5 * std::sqrt(0.5), 0.8 * std::pow(1.87, 0.4));
  CHECK(plain.chain.sites == 100 + std::size_t(1.15 * 44 * (std::sqrt(1 + 4 * stiff) - 1) / 2));
  const CompressedSteps steps;
  CHECK((steps.early == 0.1 && steps.late == 0.4));
  CHECK((steps.halved().early == 0.05 && steps.halved().late == 0.2));
  CHECK((steps.halved(3).early == 0.0125 && steps.halved(3).late == 0.05));
  CHECK(CompressedRun{}.last_open == 0);
  // With a short time, with a long one, and without compression
  struct Case {
    double d, velocity, time;
  };
  for (const Case& c : {Case{0.5, 1.87, 44},
                        {0.5, 1.87, 12},
                        {0.5, 1.87, 40},
                        {0, 1.87, 44},
                        {0.02, 0.5, 45},
                        {0, 0.5, 1}}) {
    CAPTURE(c.d, c.time);
    const Impact impact = compressed_impact(0.3, c.time, c.velocity, c.d);
    const Chain& chain = impact.chain;
    const CompressedRun run = strike_compressed(impact, {11, 44}, {0.2, 0.4});
    State<double> state = struck(chain.sites, c.velocity);
    std::vector<double> t, shown, centres;
    double last_open = 0;
    const auto look = [&](const State<double>& now) {
      if (!t.empty() && now.t == t.back()) return;
      t.push_back(now.t);
      centres.push_back(packet_sample(now.t, energy_density(chain, now)).centre);
      for (std::size_t n = 1; n < now.y.size(); ++n)
        if (now.y[n] > now.y[n - 1] + c.d) last_open = now.t;
      if (std::abs(now.t - 11) < 0.1 || std::abs(now.t - 44) < 0.1)
        shown.push_back(snapshot(chain, now).sech.width);
    };
    const double early = c.d > 0 ? std::min(c.time, 40.0) : c.time;
    evolve(ContactAware{0.2}, chain, state, early, 1, look);
    evolve(Splitting{blanes_moan_6_14(), 0.4}, chain, state, c.time - early, 1, look);
    CHECK(run.samples.size() == t.size());
    CHECK(t.size() == std::size_t(c.time) + 1);
    for (std::size_t k = 0; k < t.size() && k < run.samples.size(); ++k) {
      CHECK(run.samples[k].t == t[k]);
      CHECK(run.samples[k].centre == centres[k]);
    }
    CHECK(run.last_open == last_open);
    CHECK(run.end.y == state.y);
    REQUIRE(run.shown.size() == shown.size());
    for (std::size_t k = 0; k < shown.size(); ++k) CHECK(run.shown[k].sech.width == shown[k]);
  }
}

TEST_CASE("a run ends where a bead leaves", "[unit]") {
  const Impact hard = compressed_impact(-1, 41, 3);
  const CompressedRun gone = strike_compressed(hard, {}, {0.01, 0.4});
  CHECK(gone.run.escaped());
  CHECK(gone.samples.back().t < 5);
  State<double> state = struck(hard.chain.sites, 3);
  const Run plain = evolve(ContactAware{0.01}, hard.chain, state, 40, 1, Unobserved{});
  CHECK(gone.run.steps == plain.steps);
}

TEST_CASE("the breather of a run is named after it, its sech after the time", "[unit][criteria]") {
  const auto run_of = [](double power, double turn, double residual) {
    CompressedRun run;
    for (int k = 1; k <= 600; ++k)
      run.samples.push_back(
          {double(k), k < turn ? double(k) : 2 * turn - k, std::pow(k, power), 0.1 / k, 1, 1});
    for (double t : {290.6, 724.0}) {
      run.shown.push_back(shot_of(50, 52, 5, t < 300 ? 0.05 : residual));
      run.shown.back().state.t = t;
    }
    return run;
  };
  const CompressedRun good = run_of(-0.1, 1e9, 0.05), bad = run_of(-0.3, 500, 0.2);
  CHECK(holds(sech_breather("x", good, good)));
  std::string names;
  for (const Condition& c : sech_breather("x", bad, bad))
    names += c.name + (c.holds() ? "+ " : "- ");
  CHECK(names ==
        "x_packet_exponent- x_steadiness- sech_t_291_top+ sech_t_291_width+ sech_t_291_residual+ "
        "sech_t_724_top+ sech_t_724_width+ sech_t_724_residual- ");
  for (const Condition& c : sech_breather("x", good, bad))
    if (c.name.find("291") == std::string::npos)
      CHECK((c.holds() == (c.name == "sech_t_724_top" || c.name == "sech_t_724_width")));
}

}  // namespace compressed_again
