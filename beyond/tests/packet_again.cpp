// Packets a second time: what is read off densities and tracks, how a chain is struck, when a packet turns, what pulls
// it and what is taken away from it, each from a second formula in plain loops; and the criteria at both sides of
// their bounds.

#include <functional>

#include "check.hpp"
#include "estimates.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/dps/dps_impact.hpp"
#include "lattice/impact/turning.hpp"
#include "sec34/acceleration.hpp"
#include "sec34/criteria.hpp"
#include "sec34/decorrelation.hpp"
#include "sec34/wake.hpp"

namespace packet_again {

using namespace lattice;

namespace {

using Numbers = std::vector<double>;
const double turn_angle = std::acos(-1.0);

/// Numbers between 0 and 1 without any order.
Numbers dust(std::size_t count, double seed) {
  Numbers x(count);
  for (std::size_t n = 0; n < count; ++n)
    x[n] = std::pow(std::sin(seed + 12.9898 * double(n * n) + 3.7 * double(n)), 2);
  return x;
}

/// The sum of f(n) e_n over the sites within `m` of `peak`.
double near_sum(const Numbers& e, std::size_t peak, int m, std::function<double(int)> f) {
  double sum = 0;
  for (int n = int(peak) - m; n <= int(peak) + m; ++n)
    if (n >= 0 && n < int(e.size())) sum += f(n) * e[std::size_t(n)];
  return sum;
}
double window_again(const Numbers& e, std::size_t peak, int m = 5) {
  return near_sum(e, peak, m, [](int) { return 1.0; });
}
double centre_again(const Numbers& e, std::size_t peak, int m = 5) {
  return near_sum(e, peak, m, [](int n) { return n + 1.0; }) / window_again(e, peak, m);
}
std::size_t top_of(const Numbers& e) {
  std::size_t top = 0;
  for (std::size_t n = 0; n < e.size(); ++n)
    if (e[n] > e[top]) top = n;
  return top;
}

/// The same numbers to ten digits.
void check_all(const Numbers& value, const Numbers& expected, double absolute = 1e-10) {
  REQUIRE(value.size() == expected.size());
  std::size_t worst = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
    if (!(std::abs(value[i] - expected[i]) <= std::abs(value[worst] - expected[worst])) &&
        std::isfinite(value[worst]))
      worst = i;
  CAPTURE(worst);
  check_close(value[worst], expected[worst], absolute);
}

/// Slope of the line through points and its standard error.
Estimate slope_again(const Numbers& t, const Numbers& x) {
  double n = 0, st = 0, sx = 0, stt = 0, stx = 0, rest = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    ++n, st += t[i], sx += x[i], stt += t[i] * t[i], stx += t[i] * x[i];
  const double slope = (n * stx - st * sx) / (n * stt - st * st);
  for (std::size_t i = 0; i < t.size(); ++i)
    rest += std::pow(x[i] - sx / n - slope * (t[i] - st / n), 2);
  return {slope, std::sqrt(rest / (n - 2) / (stt - st * st / n))};
}

}  // namespace

TEST_CASE("windows, centres and the foremost packet by plain sums", "[unit][observe]") {
  for (int k = 0; k < 12; ++k) {
    Numbers e = dust(23, 0.7 * k);
    for (double& x : e) x = x * x * x * x;
    if (k % 3 == 1) std::fill(e.end() - 1 - k / 2, e.end(), 0.0);
    for (int m : {0, 1, 2, 5}) {
      double total = 0;
      for (double x : e) total += x;
      for (double share : {0.01, 0.2, 0.35}) {
        std::optional<std::size_t> first;
        for (std::size_t n = e.size(); n-- > 0 && !first;) {
          bool most = e[n] > 0 && window_again(e, n, m) >= share * total;
          for (int i = int(n) - m; i <= int(n) + m; ++i)
            if (i >= 0 && i < 23 && e[std::size_t(i)] > e[n]) most = false;
          if (most) first = n;
        }
        CHECK(front_packet(e, share, std::size_t(m)) == first);
      }
      for (std::size_t n = 0; n < e.size(); ++n) {
        check_close(window_sum(e, n, std::size_t(m)), window_again(e, n, m), 1e-14);
        if (window_again(e, n, m) > 0)
          check_close(energy_centre(e, n, std::size_t(m)), centre_again(e, n, m), 1e-12);
      }
    }
  }
  // Exactly the share that is asked for is enough, and of two equal sites the first one is taken
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 1) == 3);
  CHECK(front_packet({3, 0, 0, 1}, 0.25, 0) == 3);
  CHECK(front_packet({0, 0, 1, 1, 0}, 0.1, 1) == 2);
  CHECK_FALSE(front_packet({1, 1, 1}, 0.9, 0));
  check_close(participation({1, 2, 0, 4}), 49.0 / 21, 1e-14);
}

TEST_CASE("a track is read between its samples", "[unit][observe]") {
  const Track track{
      {0, 2, 4, 6, 8, 10}, {10, 12, 15, 19, 24, 22}, {6, 5, 3, 2, 8, 1}, {1, 4, 5, 2, 7, 3}};
  CHECK(track.until(19) == 4);
  CHECK(track.until(99) == 6);
  CHECK(track.between(12, 23).first == Numbers{2, 4, 6});  // the last one is back too late
  CHECK(track.between(12, 23).second == Numbers{12, 15, 19});
  check_close(track.line(12, 19)->slope, 1.75, 1e-14);
  CHECK_FALSE(track.line(13, 19));
  check_close(track.energy_at(13), 5 - 2.0 / 3, 1e-14);
  check_close(track.energy_at(20), 2 + 6 / 5.0, 1e-14);
  CHECK_THROWS_AS(track.energy_at(9), std::runtime_error);
  CHECK_THROWS_AS(track.energy_at(24), std::runtime_error);
  // Passes 13 at 8/3; 3 later, at 17/3, it is at 15 + 4 * 5/6
  check_close(track.travelled(13, 3), 15 + 10 / 3.0 - 13, 1e-13);
  check_close(track.travelled(12, 8), 22 - 12, 1e-13);
  CHECK_THROWS_AS(track.travelled(13, 7.4), std::runtime_error);
  CHECK_THROWS_AS(track.travelled(9, 2), std::runtime_error);
  CHECK_THROWS_AS(track.travelled(24, 2), std::runtime_error);
  // Peaks through (4, 5, 2), at 15 - 7/8, and through (2, 7, 3), which is beyond what counts
  const double first = 5 + 1 / 8.0, second = 7 + 1 / 72.0;
  check_close(track.largest_peak(0, 99).value, second, 1e-13);
  check_close(track.largest_peak(0, 20).value, first, 1e-13);
  check_close(track.largest_peak(14, 20).value, first, 1e-13);
  check_close(track.largest_peak(14, 20).error, (first - 5) / 3,
              1e-13);  // 1 and 7 beside it: no wider top
  // The wider parabola leaves 3 at the first maximum, and makes 3 + 1/40 of 3 + 1/48 at the second
  const Track pair{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                   {1, 2, 3, 4, 5, 6, 7, 8, 9, 10},
                   {},
                   {0, 2, 3, 2, 0, 1, 2.5, 3, 2, 0}};
  check_estimate(pair.largest_peak(0, 6), 3, 0);
  check_estimate(pair.largest_peak(0, 9), 3 + 1 / 48.0, (1 / 40.0 - 1 / 48.0) / 3);
  CHECK(std::isnan(
      track.largest_peak(14.2, 20).value));  // lies at 14.125, and what follows is its flank
  CHECK(std::isnan(track.largest_peak(12, 13).value));  // only a flank
  CHECK(std::isnan(track.largest_peak(30, 40).value));
  // Over the last site only, from 9 to 10
  check_close(packet_amplitude({{0, 1, 2, 3, 4}, {8, 8.5, 9, 9.5, 10}, {}, {1, 9, 1, 4, 1}}).value,
              2, 1e-14);
  // The last two sites, and no maximum
  check_close(
      packet_amplitude({{0, 1, 2, 3, 4}, {8, 8.5, 9, 9.6, 10.2}, {}, {1, 2, 4, 3, 5}}).value,
      std::sqrt(4 + 1 / 24.0), 1e-14);
  CHECK(std::isnan(packet_amplitude({{0, 1, 2}, {8, 8.5, 9}, {}, {1, 2, 4}}).value));
  Track flat{{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 1, 1, 1}, {2, 2, 2, 2}};
  CHECK(flat.largest_peak(0, 9).value == 2);
}

TEST_CASE("speeds are those from site 20 on", "[unit][observe]") {
  Track track;
  for (int k = 0; k < 13; ++k)
    track.t.push_back(2 * k), track.centre.push_back(17 + 3 * k - 0.1 * k * k),
        track.energy.push_back(3 + std::cos(k)), track.peak.push_back(1);
  Numbers t(track.t.begin() + 2, track.t.end()), x(track.centre.begin() + 2, track.centre.end());
  track.centre[1] = 20, t.insert(t.begin(), 2), x.insert(x.begin(), 20);
  const Estimate speed = slope_again(t, x);
  check_estimate(packet_speed(track), speed.value, speed.error);
  const auto part = [](const Numbers& of, int a, int b) {
    return Numbers(of.begin() + a, of.begin() + b);
  };
  const Estimate a = slope_again(part(t, 0, 6), part(x, 0, 6)),
                 b = slope_again(part(t, 6, 12), part(x, 6, 12));
  check_estimate(speed_change(track), (b.value - a.value) / speed.value,
                 (a.error + b.error) / speed.value);
  CHECK_NOTHROW(speed_change(track, x[5]));
  CHECK_THROWS_AS(speed_change(track, x[4]), std::runtime_error);
  CHECK_THROWS_AS(packet_speed(track, x[1]), std::runtime_error);
  double first = 0, second = 0;
  for (int k = 1; k < 7; ++k)
    first += track.energy[std::size_t(k)], second += track.energy[std::size_t(k + 6)];
  check_close(energy_change(track), second / first - 1, 1e-13);
  first = 0, second = 0;  // of seven, three and four
  for (int k = 1; k < 4; ++k) first += track.energy[std::size_t(k)] / 3;
  for (int k = 4; k < 8; ++k) second += track.energy[std::size_t(k)] / 4;
  check_close(energy_change(track, x[6]), second / first - 1, 1e-13);
  CHECK_NOTHROW(energy_change(track, x[5]));
  CHECK_THROWS_AS(energy_change(track, x[4]), std::runtime_error);
}

TEST_CASE("a train of pushes by hand", "[unit][pulse]") {
  const Numbers t{0, 2, 4, 6, 8, 10, 12, 14, 16}, x{0, 3, 1, 1, 5, 4, -7, -6, -8};
  const std::vector<Top> tops = maxima(t, x);
  REQUIRE(tops.size() == 3);
  // Vertex at -slope / bend in samples, height middle - slope^2 / (2 bend)
  check_close(tops[0].t, 2 + 2 * 0.5 / 5, 1e-14);
  check_close(tops[0].x, 3 + 0.25 / 10, 1e-14);
  check_close(tops[1].t, 8 + 2 * 1.5 / 5, 1e-14);
  check_close(tops[1].x, 5 + 2.25 / 10, 1e-14);
  check_close(tops[2].t, 14 - 2 * 0.5 / 3, 1e-14);
  check_close(largest_modulus(t, x), 7 + 1 / 8.0, 1e-14);  // 4, 7, 6 of the moduli
  CHECK(largest_modulus({0, 1, 2}, {3, 2, 1}) == 0);
  CHECK(maxima({0, 1, 2, 3}, {1, 2, 2, 1}).size() == 1);  // a plateau counts once
  const auto push = strongest_push(t, x);
  REQUIRE(push);
  check_close(push->t, 8.6, 1e-14);
  check_close(push->force, 5.225, 1e-14);
  check_close(push->period, (tops[2].t - tops[0].t) / 2, 1e-14);
  CHECK_FALSE(strongest_push(t, {0, 6, 1, 1, 5, 4, 4, 4.5, 3}));  // the first one
  CHECK_FALSE(strongest_push(t, {0, 3, 1, 1, 5, 4, 4, 6, 3}));    // the last one
  CHECK_FALSE(strongest_push({0, 1, 2, 3, 4}, {0, 1, 0, 2, 0}));
  check_all(upward_crossings({0, 2, 4, 6, 8}, {0, 1, 2, -1, 1}, 1), {2, 8});
  check_all(upward_crossings({0, 2, 4}, {-1, 3, 0}), {0.5});
  // From the upward passage of 1 at 1 to the last downward one at 11
  check_close(time_above({0, 2, 4, 8, 10, 12}, {0, 2, 0, 3, 2, 0}, 1), 10, 1e-14);
  CHECK(time_above({0, 1}, {0, 2}, 1) == 0);
  CHECK(time_above({0, 1}, {2, 0}, 1) == 0);
}

TEST_CASE("how an impact is set up, and when its far end is quiet", "[unit][impact]") {
  const Impact plain;
  CHECK(std::array{plain.velocity, double(plain.chain.sites), plain.time, plain.sample,
                   plain.far_end} == std::array{1.87, 100.0, 600.0, 0.2, 1e-9});
  CHECK(plain.denser);
  const Strike usual;
  CHECK(std::array{usual.velocity, usual.s, usual.time, double(usual.sites)} ==
        std::array{1.9, 1.0, 1000.0, 150.0});
  CHECK(std::array{path_smoothing, path_sampling, parting_distance, comparison_interval,
                   fit_from} == std::array{15.0, 0.2, 0.1, 2.0, 20.0});
  CHECK(std::array{ImpactRun{}.reach, ImpactRun{}.far_end, Outlook{}.apex} ==
        std::array{0.0, 0.0, 0.0});
  for (const auto& [contact, K] : {std::pair<Contact, double>{Hertz{}, 0.8 * std::pow(3, 0.4)},
                                   {CompressedHertz{0.9}, 1.5 * std::sqrt(0.9)}}) {
    const double c = (std::sqrt(1 + 4 * K) - 1) / 2;
    CHECK(endless({K < 1.3 && K > 1 ? 3 : 0.1, {7, Harmonic{}, contact}, 1e6}).chain.sites ==
          100 + std::size_t(1.15e6 * c));
  }
  CHECK(struck(3, 2.5).v == Numbers{2.5, 0, 0});
  CHECK_THROWS_AS(struck(0, 1), std::invalid_argument);

  Impact impact{-2, {5}, 1, 1, 0.25};
  ImpactRun run{State<double>(5)};
  run.end.t = 3;
  run.far_end = 0.5;
  CHECK(is_quiet(impact, run));
  run.far_end = 0.51;
  CHECK_FALSE(is_quiet(impact, run));
  run.run.energy_defect = largest_defect;
  CHECK_THROWS_AS(assert_quiet(impact, run), FarEndReached);
  CHECK(std::isinf(run.run.escape_time));
  run.run.energy_defect = 1.01 * largest_defect;
  assert_quiet(impact, run);
  CHECK(run.run.escape_time == 3);
  CHECK(total({1, 2, 4}) == 7);
  check_close(boundary_share({1, 2, 4}, 2), 3 / 7.0, 1e-15);
  check_close(boundary_share({1, 2, 4, 8, 16, 32}), 31 / 63.0, 1e-15);
  check_close(boundary_share({1, 2, 4}), 1, 1e-15);
  CHECK(strongest_site({9, 0, 3, 5, 4}, 2) == 4);
}

TEST_CASE("a run keeps the packet, and ends where it is told to", "[unit][impact]") {
  const Chain chain{40, Quartic{0.5}};
  for (const auto& [denser, halvings] : {std::pair(true, 0), {true, 1}, {false, 1}}) {
    Impact impact{1.5, chain, 12, 0.5, 1e-9, denser};
    ContactAware stepper{0.25};
    stepper.halvings = halvings;
    Track track;
    Numbers density;
    double reach = 0, end = 0;
    const auto record = [&](const State<double>& now, const Numbers& e) {
      density = e;
      if (now.t == 0) return;
      const std::size_t at = *front_packet(e);
      track.t.push_back(now.t), track.centre.push_back(centre_again(e, at)),
          track.energy.push_back(window_again(e, at)), track.peak.push_back(e[at]);
      for (double y : now.y) reach = std::max(reach, std::abs(y));
      end = std::max(end, std::abs(now.v[39]));
    };
    const ImpactRun run = strike(stepper, impact, record);
    const std::size_t each = denser && halvings ? 2 : 1;
    REQUIRE(run.track.t.size() == 24 * each);
    CHECK(run.run.steps == 48U << halvings);
    for (auto of : {&Track::t, &Track::centre, &Track::energy, &Track::peak})
      check_all(run.track.*of, track.*of, 1e-12);
    CHECK(run.density == density);
    CHECK(run.density == energy_density(chain, run.end));
    CHECK(std::array{run.reach, run.far_end} == std::array{reach, end});
    // In two parts it is the same run
    ImpactRun parts{struck(40, 1.5)};
    go_on(stepper, impact, parts, 5);
    go_on(stepper, impact, parts, 12);
    CHECK(parts.run.steps == run.run.steps);
    check_all(parts.track.centre, run.track.centre, 1e-12);
    // It stops where the packet passes, at instants of the coarser run
    std::size_t k = each == 2 ? 15 : 11;
    impact.until = track.centre[k];
    while (track.centre[k] < *impact.until || (k + 1) % each != 0) ++k;
    CHECK(strike(stepper, impact).end.t == track.t[k]);
    // And where nobody wants more, after the first look or a later one
    impact.until = {};
    for (int looks : {0, 3}) {
      int seen = 0;
      const auto stop = [&](const State<double>&, const Numbers&) { return seen++ < looks; };
      check_close(strike(stepper, impact, stop).end.t, looks * 0.5 / double(each), 1e-14);
    }
  }
  Impact brief{1.5, {4, Quartic{0.5}}, 12, 0.5, 1e-3};
  int looks = 0, loud = 0;
  const auto watch = [&](const State<double>& now, const Numbers&) {
    ++looks, loud += std::abs(now.v[3]) > 1.5e-3;
  };
  CHECK_THROWS_AS(strike(ContactAware{0.25}, brief, watch), FarEndReached);
  CHECK(loud == 1);
  CHECK(looks < 24);
  const auto both = strike_to(1e-6, Impact{1.5, chain, 6});
  CHECK(both.fine.run.steps == 2 * both.coarse.run.steps);
  check_close(both.error, distance(both.coarse.end, both.fine.end), 1e-15);
}

TEST_CASE("a path is smoothed, and its turn is found, by hand", "[unit][turning]") {
  Path path;
  const Numbers c = dust(30, 0.2), e = dust(30, 0.9);
  for (std::size_t i = 0; i < 30; ++i)
    path.t.push_back(3 + 0.5 * double(i)), path.centre.push_back(c[i]), path.energy.push_back(e[i]);
  const Path smoothed =
      smooth(path, 4.3);  // four samples on either side, with the width 5 of the weight
  Numbers t, centre, energies;
  for (std::size_t i = 4; i < 26; ++i) {
    double sum = 0, x = 0, y = 0;
    for (int k = -4; k <= 4; ++k) {
      const double weight = std::pow(std::cos(turn_angle * k / 10), 2);
      const auto at = std::size_t(int(i) + k);
      sum += weight, x += weight * c[at], y += weight * e[at];
    }
    t.push_back(path.t[i]), centre.push_back(x / sum), energies.push_back(y / sum);
  }
  check_all(smoothed.t, t);
  check_all(smoothed.centre, centre);
  check_all(smoothed.energy, energies);
  Path three{{0, 1, 2}, {1, 2, 3}, {1, 1, 1}};
  CHECK(smooth(three, 1).t.size() == 1);
  three.t.pop_back();
  CHECK_THROWS_AS(smooth(three, 1), std::invalid_argument);

  // Vertices: an inner one, one that is no extremum, one just at the bound, a straight line, both ends
  Path way{{0, 2, 4, 6, 8, 10, 12}, {1, 5, 4, 2, 1, 0, 0, -1}, {}};
  way.centre.pop_back();  // what lies behind the last one does not count
  const std::vector<std::array<double, 3>> known{{1, 5 + 2.25 / 10, 2 + 2 * 0.3},
                                                 {2, 4, 4},
                                                 {3, 2, 6},
                                                 {4, 1, 8},
                                                 {5, 0 - 0.125, 11},
                                                 {0, 1, 0},
                                                 {6, 0, 12}};
  for (const auto& [i, site, time] : known) {
    CAPTURE(i);
    check_close(vertex(way, std::size_t(i)).site, site, 1e-14);
    check_close(vertex(way, std::size_t(i)).time, time, 1e-14);
  }
  CHECK_FALSE(Moment{}.found());
  CHECK(std::isnan(Moment{}.site));

  // Out with a stop before site 8 and one beyond it, back by five from 14 at 7, again by three from 4 at 12
  Path trip;
  trip.centre = {1, 7, 6, 9, 8.5, 12, 13, 14, 13.5, 9, 10, 8, 4, 6, 7, 7.01, 3};
  for (std::size_t i = 0; i < trip.centre.size(); ++i) trip.t.push_back(double(i));
  trip.energy = trip.centre;
  const Turn turn = find_turn(trip);
  check_close(turn.stop.time, vertex(trip, 3).time, 1e-14);
  check_close(turn.apex.time, vertex(trip, 7).time, 1e-14);
  check_close(turn.rebound.time, vertex(trip, 12).time, 1e-14);
  trip.centre[15] = 7;  // exactly three sites are not enough
  CHECK_FALSE(find_turn(trip).rebound.found());
  CHECK(find_turn(trip, 5, 2.9).rebound.found());
  trip.centre.resize(10);
  CHECK_FALSE(find_turn(trip).apex.found());  // exactly five neither
  CHECK(find_turn(trip, 4.9).apex.found());
  CHECK(find_turn(trip, 5, 3, 6.9).stop.time == vertex(trip, 1).time);
  CHECK(find_turn(trip, 5, 3, 7).stop.time == vertex(trip, 3).time);
}

TEST_CASE("a turn has the errors of the step and of half the smoothing", "[unit][turning]") {
  const auto made = [](double by) {
    Voyage out;
    for (int i = 0; i < 2000; ++i) {
      const double t = path_sampling * i, wave = 0.3 * std::cos(t / 3) + by * std::sin(t / 17);
      out.path.t.push_back(t), out.path.energy.push_back(1);
      out.path.centre.push_back(1 + std::abs(20 - std::pow((t - 160) / 32, 2)) + wave);
    }
    return out;
  };
  const Voyage a = made(0.1), b = made(0.12);
  const TurnEstimate e = estimate_turn(a, b);
  const auto read = [](const Voyage& v, double width) {
    const Turn t = find_turn(smooth(v.path, width), 5, 3, 8);
    return std::array{t.stop.time, t.stop.site, t.apex.time, t.apex.site, t.rebound.time};
  };
  const auto x = read(a, 15), y = read(b, 15), z = read(b, 7.5);
  const std::array found{e.stop_time, e.stop_site, e.apex_time, e.apex_site, e.return_time};
  for (std::size_t k = 0; k < 5; ++k)
    check_estimate(found[k], y[k], std::abs(x[k] - y[k]) + std::abs(z[k] - y[k]));
  CHECK(e.stop_time.value != e.apex_time.value);
}

TEST_CASE("how long one waits for a packet, and what becomes of it", "[unit][turning]") {
  for (const auto& [v, s, rate, speed] :
       std::vector<std::array<double, 4>>{{0.5, 1, 1, 0.18},
                                          {2, 0.1, std::pow(2, 0.2), 0.36},
                                          {2, 16, std::sqrt(8), 0.36},
                                          {8, 0, std::pow(8, 0.2), 0.4}}) {
    const Patience wait = patience(v, s, 30);
    check_close(wait.interval, 0.8 / rate, 1e-12);
    check_close(wait.time, 300 / speed / rate, 1e-10);
    check_close(wait.tired, 120 / speed / rate, 1e-10);
  }
  // The same with a loop of one's own: means of eight samples
  const auto again = [](double v, double s, double horizon, int halvings) {
    const Patience wait = patience(v, s, horizon);
    const Chain chain{std::size_t(horizon) + 20, Quartic{s}};
    State<double> now = struck(chain.sites, v);
    const double step = wait.interval / 4 / (1 << halvings);
    const auto samples = std::ceil(wait.time / wait.interval - 1e-9);
    const double look = wait.time / samples;
    Outlook out;
    double sum = 0;
    for (int k = 0; k <= samples && out.fate == Fate::undecided; ++k) {
      const Numbers e = energy_density(chain, now);
      sum += centre_again(e, top_of(e));
      if (k % 8 == 7) {
        out.apex = std::max(out.apex, sum / 8);
        if (sum / 8 > horizon) out.fate = Fate::escapes;
        if (sum / 8 < out.apex - 5) out.fate = Fate::turns;
        if (look * k > wait.tired && out.apex < 8) out.fate = Fate::stays;
        sum = 0;
      }
      evolve(ContactAware{step}, chain, now, look, look, Unobserved{});
    }
    return out;
  };
  const std::vector<std::tuple<double, double, double, int, Fate>> cases{
      {1, 0, 9, 0, Fate::escapes},  {1, 0, 9, 1, Fate::escapes},  {3, 20, 12, 0, Fate::stays},
      {1.9, 4, 30, 0, Fate::stays}, {2.2, 1, 20, 0, Fate::turns}, {1, 3, 40, 0, Fate::turns}};
  for (const auto& [v, s, horizon, halvings, fate] : cases) {
    CAPTURE(v, s, horizon);
    const Outlook one = probe(v, s, horizon, halvings), two = again(v, s, horizon, halvings);
    CHECK(one.fate == two.fate);
    CHECK(one.fate == fate);
    check_close(one.apex, two.apex, 1e-6);
  }
}

TEST_CASE("two runs part when a look sees them a tenth apart", "[unit][wake]") {
  const Chain chain{20, Quartic{1}};
  for (const auto& [by, late] :
       std::vector<std::pair<double, double>>{{1e-3, 0}, {0.06, 0}, {0.06, 7}, {0.11, 0}}) {
    State<double> a = struck(20, 2), b = struck(20, 2 * (1 + by));
    a.t = b.t = late;
    const double seen = decorrelation_time(ContactAware{0.2}, a, ContactAware{0.1}, b, chain, 41);
    // Looks are 41/21 apart
    double parts = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 21 && std::isinf(parts); ++k) {
      double apart = 0, scale = 0;
      for (std::size_t n = 0; n < 20; ++n) {
        apart = std::max({apart, std::abs(a.y[n] - b.y[n]), std::abs(a.v[n] - b.v[n])});
        scale = std::max({scale, std::abs(b.y[n]), std::abs(b.v[n])});
      }
      if (apart > 0.1 * scale) parts = late + k * 41 / 21.0;
      evolve(ContactAware{0.2}, chain, a, 41 / 21.0, 41 / 21.0, Unobserved{});
      evolve(ContactAware{0.1}, chain, b, 41 / 21.0, 41 / 21.0, Unobserved{});
    }
    CAPTURE(by, late);
    CHECK((seen == parts || std::abs(seen - parts) < 1e-12));
    CHECK(std::isinf(seen) == (by == 1e-3));
  }
  check_estimate(decorrelation_of(100, 104), 104, 6);
  const double never = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : {std::pair(never, 5.0), {5.0, never}})
    CHECK((std::isnan(decorrelation_of(a, b).value) && std::isnan(decorrelation_of(a, b).error)));
}

TEST_CASE("the force on a packet is the slope of its velocities every five units",
          "[unit][force]") {
  // Out to site 27 at 240, rebounds at site 1; from `begin` to `end`
  const auto made = [](double by, double begin, double end) {
    Voyage out;
    for (double t = begin; t < end; t = begin + path_sampling * double(out.path.t.size())) {
      const double x =
          27 - 26 * std::pow((t - 240) / 210, 2) + by * std::cos(t / 11) + by * std::sin(t);
      out.path.t.push_back(t), out.path.centre.push_back(x), out.path.energy.push_back(1);
    }
    return out;
  };
  struct Line {
    Estimate force, bend;
  };
  const auto read = [](const Voyage& v, double width, Stretch stretch) {
    const Path p = smooth(v.path, width);
    const std::size_t apex = top_of(p.centre);
    std::size_t at100 = 0, at220 = 0, at18 = apex, at6;
    while (p.t[at100] < 100) ++at100;
    while (at220 < p.t.size() && p.t[at220] < 220) ++at220;
    while (at18 < p.t.size() && p.centre[at18] > 18) ++at18;
    for (at6 = at18; at6 < p.t.size() && p.centre[at6] > 6;) ++at6;
    const std::size_t first = stretch == Stretch::out       ? at100
                              : stretch == Stretch::between ? at220
                                                            : at18;
    const std::size_t last = stretch == Stretch::out       ? at100 + 600
                             : stretch == Stretch::between ? at18
                                                           : at6;
    Numbers t, x;
    for (std::size_t i = std::max<std::size_t>(first, 25); i + 25 < std::min(last, p.t.size());
         i += 25)
      t.push_back(p.t[i]), x.push_back((p.centre[i + 25] - p.centre[i - 25]) / 10);
    const auto half = std::ptrdiff_t(t.size() / 2);
    const Estimate all = slope_again(t, x),
                   a = slope_again({t.begin(), t.begin() + half}, {x.begin(), x.begin() + half}),
                   b = slope_again({t.begin() + half, t.end()}, {x.begin() + half, x.end()});
    return Line{
        all,
        {(b.value - a.value) / std::abs(all.value), (a.error + b.error) / std::abs(all.value)}};
  };
  const auto test = [&](const Voyage& a, const Voyage& b, Stretch stretch) {
    const Line x = read(a, 15, stretch), y = read(b, 15, stretch), z = read(b, 7.5, stretch);
    const Acceleration f = acceleration_of(a, b, stretch);
    check_estimate(f.mean, y.force.value,
                   std::abs(x.force.value - y.force.value) + y.force.error +
                       std::abs(z.force.value - y.force.value));
    check_estimate(f.bend, y.bend.value, y.bend.error);
  };
  const Voyage a = made(0.2, 0, 460), b = made(0.23, 0, 460);
  for (Stretch stretch : {Stretch::back, Stretch::out, Stretch::between}) test(a, b, stretch);
  // A path that begins late or ends early is used as far as it leads
  test(made(0.2, 90.1, 460), made(0.23, 90.1, 460), Stretch::out);
  test(made(0.2, 0, 190), made(0.23, 0, 190), Stretch::out);
}

namespace {

/// What an observer sees, kept.
struct Seen {
  State<double> state;
  Numbers density;
  std::size_t peak, shift;
  double gone;
};

std::vector<Seen> kept(const WavesRemoved& impact, double step, double until, std::size_t sites,
                       Path* path = nullptr) {
  std::vector<Seen> all;
  Path way = follow_without(impact, step, until, sites, [&](const Sight& s) {
    all.push_back({s.state, s.density, s.peak, s.shift, s.dissipated});
    return true;
  });
  if (path) *path = way;
  return all;
}

/// The same from a loop of one's own: half of the friction before each step and half after it.
std::vector<Seen> kept_again(const WavesRemoved& b, double step, double until, std::size_t sites) {
  const double look = std::min(0.2, 2 * step);
  const int steps = int(std::ceil(look / step - 1e-9));
  Chain chain{sites, Quartic{b.s}};
  State<double> now = struck(sites, b.velocity);
  double gone = 0;
  std::vector<Seen> all;
  for (int k = 0; look * k < until - look / 2; ++k) {
    const double t = look * k;
    if (b.cut > 0 && std::abs(t - b.cut) < 1e-9) {
      const int at = int(top_of(energy_density(chain, now)));
      State<double> longer(2 * sites);
      for (int n = std::max(0, at - 6); n <= at + 6; ++n)
        longer.y[sites + n] = now.y[n], longer.v[sites + n] = now.v[n];
      now = longer, chain.sites = 2 * sites;
    }
    now.t = t;
    const Numbers e = energy_density(chain, now);
    const std::size_t peak = top_of(e);
    all.push_back({now, e, peak, chain.sites - sites, b.counted ? gone : 0});
    const bool end = b.first_bead && t > 60 - 1e-9;
    const double nu = end ? 0.2 : b.behind > 0 && t > b.cut - 1e-9 ? 0.1 : 0;
    const int beads = end ? 1 : int(peak) - int(b.behind);
    const auto rub = [&] {
      for (int n = 0; n < beads && nu > 0; ++n) {
        const double before = now.v[n];
        now.v[n] *= std::exp(-nu * look / steps / 2);
        gone += (before * before - now.v[n] * now.v[n]) / 2;
      }
    };
    for (int i = 0; i < steps; ++i)
      rub(), evolve(ContactAware{step}, chain, now, look / steps, look / steps, Unobserved{}),
          rub();
  }
  return all;
}

}  // namespace

TEST_CASE("what is taken away from a packet, by a loop of one's own", "[unit][wake]") {
  const WavesRemoved plain;
  CHECK(std::array{plain.s, plain.velocity, plain.cut, double(plain.behind)} ==
        std::array{1.0, 1.9, 0.0, 0.0});
  CHECK_FALSE((plain.first_bead || plain.counted));
  const std::vector<std::tuple<WavesRemoved, double, double>> runs{
      {{}, 0.2, 5},
      {{}, 0.15, 4.1},
      {{.s = 0.5, .behind = 1, .counted = true}, 0.05, 12.15},
      {{.behind = 2, .first_bead = true, .counted = true}, 0.2, 64},
      {{.behind = 3}, 0.2, 30},
      {{.cut = 6, .behind = 2, .counted = true}, 0.1, 15},
      {{.velocity = 1, .cut = 40}, 0.2, 50}};
  for (const auto& [impact, step, until] : runs) {
    CAPTURE(impact.cut, impact.behind, step, until);
    Path path;
    const auto one = kept(impact, step, until, 60, &path),
               two = kept_again(impact, step, until, 60);
    REQUIRE(one.size() == two.size());
    REQUIRE(path.t.size() == one.size());
    for (std::size_t i = 0; i < one.size(); i += i + 5 < one.size() ? 5 : 1) {
      CAPTURE(i);
      check_close(one[i].state.t, two[i].state.t, 1e-12);
      check_close(path.t[i], two[i].state.t, 1e-12);
      check_all(one[i].state.y, two[i].state.y, 1e-9);
      check_all(one[i].density, two[i].density, 1e-9);
      CHECK((one[i].peak == two[i].peak && one[i].shift == two[i].shift));
      check_close(one[i].gone, two[i].gone, 1e-9);
      check_close(path.centre[i], centre_again(two[i].density, two[i].peak) - double(two[i].shift),
                  1e-8);
      check_close(path.energy[i], window_again(two[i].density, two[i].peak), 1e-8);
    }
  }
  // Nobody wants more; and a wave comes to the left end, which counts after a cut only
  int looks = 0;
  follow_without({}, 0.2, 9, 60, [&](const Sight&) { return ++looks < 4; });
  CHECK(looks == 4);
  looks = 0;
  CHECK(follow_without({.cut = 1}, 0.2, 9, 60, [&](const Sight&) {
          return ++looks < 3;
        }).t.size() == 3);
  CHECK_NOTHROW(follow_without({.cut = 3}, 0.2, 2, 6));
  CHECK_THROWS_AS(follow_without({.s = 0, .cut = 3}, 0.2, 20, 6), std::runtime_error);
  CHECK_THROWS_AS(follow_without({.cut = 0.6}, 0.2, 55, 16),
                  std::runtime_error);  // the left one only
}

TEST_CASE("late fates, budgets and gauges are read off what is seen", "[unit][wake]") {
  const LateFate none;
  CHECK((none.late == Late::goes_on && none.furthest == 0 && none.when == 0));
  for (const auto& [impact, step, until, fate] :
       std::vector<std::tuple<WavesRemoved, double, double, Late>>{
           {{.s = 1, .velocity = 2.2}, 0.2, 320, Late::returns},
           {{.s = 2, .velocity = 1}, 0.2, 320, Late::caught},
           {{.s = 0, .velocity = 0.1}, 0.2, 320, Late::goes_on},
           {{.s = 0, .velocity = 0.02}, 0.2, 320, Late::caught},
           {{.s = 0, .velocity = 0.04}, 0.2, 200, Late::caught},
           {{.velocity = 1, .cut = 10}, 0.05, 50, Late::goes_on},
           {{.s = 20, .velocity = 3}, 0.2, 50, Late::goes_on}}) {
    CAPTURE(impact.s, impact.velocity);
    LateFate out;
    double sum = 0, mean = 0, late = std::nan(""), begin = 0;
    const int width = int(std::lround(15 / std::min(0.2, 2 * step)));
    const auto all = kept(impact, step, until, 150);
    std::size_t used = 0;
    for (const Seen& s : all) {
      if (used % width == 0) sum = 0, begin = s.state.t;
      sum += centre_again(s.density, s.peak) - double(s.shift);
      if (++used % width != 0) continue;
      mean = sum / width;
      if (mean > out.furthest) out.furthest = mean, out.when = (begin + s.state.t) / 2;
      if (std::isnan(late) && s.state.t > 0.9 * until) late = mean;
      if (mean < out.furthest - 5) {
        out.late = Late::returns;
        break;
      }
    }
    if (out.late != Late::returns && std::abs(mean - late) < 1) out.late = Late::caught;
    Path way;
    const LateFate found = late_fate(impact, step, until, 150, &way);
    CHECK(found.late == fate);
    CHECK(out.late == fate);
    check_close(found.furthest, out.furthest, 1e-8);
    check_close(found.when, out.when, 1e-9);
    CHECK(way.t.size() == used);
  }

  for (const auto& [s, from, to] :
       std::vector<std::array<double, 3>>{{0.7, 60, 96}, {0.7, 74, 111.2}}) {
    const WavesRemoved impact{.s = s, .behind = 6, .counted = true};
    std::array<double, 4> begin{}, end{}, change{};
    std::array<double, 3> force{};
    double begins = 0, ends = 0, looks = 0;
    for (const Seen& now : kept(impact, 0.2, to, 150)) {
      const double t = now.state.t;
      const Numbers &e = now.density, &y = now.state.y;
      if (t < from - 1e-6) continue;
      std::array<double, 4> parts{window_again(e, now.peak), 0, 0, now.gone};
      for (int n = 0; n < int(now.peak) - 5; ++n) parts[n + 15 < int(now.peak) ? 2 : 1] += e[n];
      const bool early = t<from + 16 - 1e-6, last = t> to - 16 - 1e-6;
      begins += early, ends += last, ++looks;
      for (int k = 0; k < 4; ++k) begin[k] += early * parts[k], end[k] += last * parts[k];
      const std::size_t p = now.peak;
      force[0] += std::pow(std::max(0.0, y[p - 6] - y[p - 5]), 1.5);
      force[1] += std::pow(std::max(0.0, y[p + 5] - y[p + 6]), 1.5);
      for (std::size_t n = p - 5; n <= p + 5; ++n) force[2] += y[n] + s * std::pow(y[n], 3);
    }
    REQUIRE(begins == ends);
    const Budget b = budget({.s = s, .behind = 6}, 0.2, from, to);
    for (int k = 0; k < 4; ++k) change[k] = (end[k] - begin[k]) / begins;
    check_all({b.packet, b.near, b.far, b.friction}, {change[0], change[1], change[2], change[3]},
              1e-9);
    check_all({b.push_behind, b.push_ahead, b.wells},
              {force[0] / looks, force[1] / looks, force[2] / looks}, 1e-9);
  }

  for (const auto& [s, v] : std::vector<std::array<double, 2>>{{1, 1.9}, {-1.2, 0.7}}) {
    const auto rows = gauge({.s = s, .velocity = v}, 0.2, 41);
    REQUIRE(rows.size() == 2);
    const auto all = kept({.s = s, .velocity = v}, 0.2, 41, 150);
    for (int row : {0, 1}) {
      double count = 0, site = 0, energies = 0, squares = 0, last = 0;
      Numbers zeros;
      for (int k = 100 * row + (row > 0); k <= 100 * (row + 1); ++k) {
        const auto pattern = [&](const Seen& now) {
          return near_sum(now.state.y, now.peak, 5, [](int n) { return n % 2 ? -1 : 1; });
        };
        const double x = pattern(all[k]);
        if (k > 0) last = pattern(all[k - 1]);
        if (last < 0 && x >= 0) zeros.push_back(0.2 * (k - 1) + 0.2 * last / (last - x));
        Numbers v2 = all[k].state.v;
        for (double& w : v2) w *= w;
        ++count, site += centre_again(all[k].density, all[k].peak),
            energies += window_again(all[k].density, all[k].peak),
            squares += window_again(v2, all[k].peak);
      }
      const Inside& in = rows[row];
      check_all({in.t, in.site, in.energy}, {10.0 + 20 * row, site / count, energies / count},
                1e-9);
      CAPTURE(s, v, row, zeros.size());
      REQUIRE(zeros.size() > 1);
      const double period = (zeros.back() - zeros.front()) / double(zeros.size() - 1);
      check_close(in.omega, 2 * turn_angle / period, 1e-9);
      check_close(in.area, squares / count * period, 1e-9);
    }
  }
}

TEST_CASE("what is said of packets holds up to its bounds and not beyond", "[unit][criteria]") {
  const Numbers e = dust(40, 0.4);
  double most = 0;
  for (int n = 5; n <= 9; ++n) most = std::max(most, window_again(e, std::size_t(n)));
  check_close(residue(e, 30), most / window_again(e, 30) > 0 ? [&] {
    for (int n = 5; n < 10; ++n) most = std::max(most, window_again(e, std::size_t(n)));
    return most / window_again(e, 30);
  }() : 0, 1e-13);
  CHECK(residue(e, 25) == 0);  // nothing is so far behind
  CHECK(residue(e, 26) > 0);
  // The front: the largest ahead of the peak, up to nine sites, and behind its window, up to ten
  Front front;
  Numbers ahead(10, 0);
  double behind = 0;
  for (const auto& [seed, peak] :
       std::vector<std::pair<double, std::size_t>>{{1.2, 18}, {2.1, 34}, {0.6, 8}}) {
    Numbers f = dust(40, seed);
    f[peak] = 2;
    front.add(f, peak);
    for (std::size_t k = 0; k < 10 && peak + k < 40; ++k)
      ahead[k] = std::max(ahead[k], f[peak + k]);
    for (std::size_t k = 6; k <= 15 && k <= peak; ++k) behind = std::max(behind, f[peak - k]);
  }
  for (std::size_t k = 0; k < 10; ++k)
    check_close(front.amplitude(k), std::sqrt(ahead[k] / 2), 1e-14);
  check_close(front.tail(), std::sqrt(behind / 2), 1e-14);
  CHECK_THROWS_AS(front.amplitude(10), std::out_of_range);
  CHECK(front.width() == 19);
  Front narrow, wide;
  narrow.add({0, 1, 1.1e-4, 0.9e-4, 1, 0}, 1), wide.add({0, 1, 1.2e-4, 0.8e-4}, 1);
  CHECK(narrow.width() == 3);
  Front one;
  one.add({0, 1, 0.9e-4, 1, 1}, 1);
  CHECK(one.width() == 1);
  CHECK(failing(supported_by(3, narrow, narrow)).empty());
  CHECK(failing(supported_by(1, narrow, narrow)) == "next");
  CHECK(failing(supported_by(5, narrow, narrow)) == "outermost next");
  check_estimate(supported_by(3, wide, narrow)[0].value, std::sqrt(1.1e-4),
                 std::sqrt(1.2e-4) - std::sqrt(1.1e-4));
  // The lower of both ends over what is highest in between
  Numbers v(40, 0.1);
  v[3] = -2, v[10] = 0.5, v[30] = -3, v[9] = v[24] = 9;
  check_close(prominence(v, 30, 4), 2 / 9.0, 1e-14);
  v[9] = 0.1, v[24] = 0.4;
  check_close(prominence(v, 30), 4, 1e-14);
  v[24] = 0.1, v[25] = v[35] = v[36] = v[3] = 8;
  check_close(prominence(v, 30), 8 / 0.5, 1e-14);
  v[25] = v[35] = 0, v[36] = 8, v[5] = 9;
  check_close(prominence(v, 30), 3 / 0.5, 1e-14);

  const auto both = [](auto make, double bound, bool below, const std::string& name) {
    CAPTURE(bound, name);
    CHECK(failing(make(bound * (below ? 0.99 : 1.01))).empty());
    CHECK(failing(make(bound * (below ? 1.01 : 0.99))) == name);
  };
  for (double sign : {1.0, -1.0}) {
    both(
        [&](double x) {
          return travelling_breather({{sign * x, 1e-6}, {0, 1e-3}, {0.5, 0}});
        },
        0.05, true, "speed_change");
    both(
        [&](double x) {
          return travelling_breather({{0, 1e-3}, {sign * x, 1e-6}, {0.5, 0}});
        },
        0.1, true, "energy_change");
  }
  both(
      [](double x) {
        return travelling_breather({{0, 0}, {0, 0}, {x, 1e-6}});
      },
      1, true, "residue");
  both([](double x) { return meet({{x, 1e-6}, {1, 0}}); }, 0.01, true, "near");
  both([](double x) { return meet({{0.005 * x, 1e-7}, {0.01, 0}}); }, 1, true, "near_over_far");
  both([](double x) { return trapped({x, 1e-6}, {1, 0}); }, 1, false, "boundary_over_packet");
  both([](double x) { return transition({1, 1, 1, 2, x}); }, 0.05, true, "undecided");
  both([](double x) { return transition({1, 1, 1, x, 0}); }, 1, false, "order");
  CHECK(failing(transition({0, 0, 1, 2, 0})) == "breathers kinks");
  const auto confined = [](int which) {
    return [which](double x) {
      Confinement c{{0.9, 0}, {0.9, 0.5}, {0, 0}, 1, {9, 0}};
      (which == 0   ? c.speed.value
       : which == 1 ? c.way.value
       : which == 2 ? c.drift.value
                    : c.lasted) = x;
      return no_blowup(c);
    };
  };
  for (int which : {0, 1}) {
    CHECK(failing(confined(which)(1.0005)).empty());
    CHECK(failing(confined(which)(1.0015)) == (which ? "way" : "speed"));
  }
  both(confined(2), 1e-3, true, "drift");
  CHECK(failing(confined(3)(0.9995)).empty());
  CHECK(failing(confined(3)(0.9985)) == "lasted");
  const Estimate pull{-1, 0.1};
  both(
      [&](double x) {
        return reversed_packet({x - 0.9, 0.1}, pull, pull, {9, 1});
      },
      1, false, "apex_time");
  both(
      [&](double x) {
        return reversed_packet({9, 1}, {x - 1.1, 0.1}, pull, {9, 1});
      },
      1, true, "force_out");
  both(
      [&](double x) {
        return reversed_packet({9, 1}, pull, {x - 1.1, 0.1}, {9, 1});
      },
      1, true, "force_back");
  both(
      [&](double x) {
        return reversed_packet({9, 1}, pull, pull, {99, x});
      },
      10, true, "return_time_error");
  for (double sign : {1.0, -1.0})
    both(
        [&](double x) {
          return slowed_packet(true, {sign * x, 0}, {-2, 0});
        },
        1, true, "force_over_190");
  CHECK(failing(slowed_packet(false, {-1, 0}, {-3, 0})) == "slows");
  check_estimate(slowed_packet(true, {-1, 0.1}, {-4, 0.2})[1].value, 0.25,
                 0.1 / 4 + 0.25 * 0.2 / 4);
  both(
      [](double x) {
        return erratic_packets({x, 1e-6}, {9, 1});
      },
      0.25, true, "spread_until_return");
  both([](double x) { return erratic_packets({0.1, 0}, {x, 1e-6}); }, 3, false, "spread_late");
  // The largest fall of all pairs beyond both errors; never less than -1
  const Criterion fall = rises({{-3, 0.1}, {2, 0.1}, {-1, 0.3}, {4, 0.2}});
  check_close(fall[0].value.value, 3 - 1 - 0.4, 1e-14);
  check_estimate(fall[1].value, 4 / 3.0, (0.2 + 4 / 3.0 * 0.1) / 3);
  CHECK(rises({{1, 0}, {5, 0}})[0].value.value == -1);
  both([](double x) { return rises({{1, 0.05}, {-x, 0.05}}); }, 1.105, false, "last_over_first");
  CHECK(failing(rises({{1, 0}, {1.6, 0.05}, {1.5, 0.04}, {3, 0}})) == "largest_fall");
  CHECK(failing(rises({{1, 0}, {1.6, 0.05}, {1.5, 0.06}, {3, 0}})).empty());
}

TEST_CASE("how fast and how far the beads of an impact come", "[unit][criteria]") {
  const Impact impact{1.5, {20, Quartic{0.5}}, 8, 0.5, may_move, false};
  std::array<double, 2> speed{}, way{}, drift{};
  for (std::size_t i : {0U, 1U}) {
    const ImpactRun run =
        strike(ContactAware{i ? 0.1 : 0.25}, impact, [&](const State<double>& now, const auto&) {
          for (double v : now.v) speed[i] = std::max(speed[i], std::abs(v) / 1.5);
          for (double y : now.y) way[i] = std::max(way[i], std::abs(y));
        });
    drift[i] = run.run.energy_drift;
  }
  const Confinement c = confinement(impact, ContactAware{0.25}, ContactAware{0.1});
  check_close(c.speed.value, speed[1], 1e-14);
  check_close(c.furthest.value, way[1], 1e-14);
  check_close(c.furthest.error, std::abs(way[0] - way[1]), 1e-14);
  check_close(c.way.value, way[1] / 12, 1e-14);
  check_close(c.way.error, std::abs(way[0] - way[1]) / 12, 1e-14);
  check_close(c.drift.value, drift[1], 0, 1e-12);
  CHECK(c.lasted == 1);
  // A bead leaves a soft well: the run that ends first counts
  const Impact soft{2.5, {20, Quartic{-1.0 / 6}}, 40, 0.5, may_move, false};
  const double ends = strike(ContactAware{0.25}, soft).end.t,
               other = strike(ContactAware{0.02}, soft).end.t;
  for (const auto& [a, b] : {std::pair(0.25, 0.02), {0.02, 0.25}})
    check_close(confinement(soft, ContactAware{a}, ContactAware{b}).lasted,
                std::min(ends, other) / 40, 1e-14);
}

}  // namespace packet_again
