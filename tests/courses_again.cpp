// Runs of modulated rings against plain loops, and what is said of such courses.

#include <algorithm>
#include <numbers>

#include "check.hpp"
#include "sec4/modulation.hpp"

namespace courses_again {

using namespace lattice;
using std::numbers::pi;

namespace {

Splitting by(double step) {
  return {blanes_moan_6_14(), step};
}

/// The largest change of the energy from sample to sample on the way, relative to the start.
double drift_of(const Chain& ring, State<double>& state, double time, double sample, double step) {
  const double start = energy(ring, state);
  double most = 0;
  evolve(by(step), ring, state, time, sample, [&](const State<double>& now) {
    most = std::max(most, std::abs(energy(ring, now) / start - 1));
  });
  return most;
}

/// Passes if `m` is what the last sixty units of time from `state` on show.
void check_packet(const Modulated& m, const Chain& ring, State<double> state, double step) {
  std::vector<double> t, centre;
  evolve(by(step), ring, state, 60, 1, [&](const State<double>& now) {
    t.push_back(now.t);
    centre.push_back(packet_sample(now.t, energy_density(ring, now)).centre);
  });
  CHECK(t.size() == 61);
  CHECK(m.t == t);
  CHECK(m.centre == centre);
  CHECK(m.end.y == state.y);
  CHECK(m.density == energy_density(ring, state));
  CHECK(m.shown.centre == snapshot(ring, state).centre);
  CHECK(m.shown.state.v == state.v);
}

/// A course by a plain loop: until the two runs part, or the time is up.
struct Plain {
  std::vector<std::array<RingSample, 2>> samples{};
  std::array<std::vector<State<double>>, 2> states{};
  double end = 0, gathered = std::nan("");
  bool parted = false;
};
Plain plain_course(const ModulatedPhonon& phonon, double longest, std::array<double, 2> steps,
                   double patience) {
  const Chain ring = phonon.ring();
  State<double> a = phonon.start(), b = phonon.start();
  Plain out;
  while (out.end < longest && !(out.end > patience * out.gathered)) {
    evolve(by(steps[0]), ring, a, 50, 50, Unobserved{});
    evolve(by(steps[1]), ring, b, 50, 50, Unobserved{});
    out.end += 50;
    out.parted = distance(a, b) >= 0.1;
    if (out.parted) break;
    out.samples.push_back({ring_sample(ring, a), ring_sample(ring, b)});
    out.states[0].push_back(a);
    out.states[1].push_back(b);
    const auto& [x, y] = out.samples.back();
    if (std::isnan(out.gathered) && x.gathered && y.gathered) out.gathered = out.end;
  }
  return out;
}

/// A sample with two packets, `second` being the energy of one over that of the other, in both runs.
struct Seen {
  double t, coarse, fine;
  bool coarse_gathered = true, fine_gathered = true;
};
RingCourse course_of(double gathered, const std::vector<Seen>& seen) {
  RingCourse course;
  course.gathered = gathered;
  for (const Seen& x : seen)
    course.samples.push_back({RingSample{x.t, 6, 9, x.coarse, x.coarse_gathered},
                              RingSample{x.t, 6, 9, x.fine, x.fine_gathered}});
  return course;
}

/// For how long one pulse was alone, when it split and when the two were apart.
std::vector<double> told(double gathered, double round, const std::vector<Seen>& seen) {
  std::vector<double> values;
  for (const Condition& c : pulse_splits(course_of(gathered, seen), round)) {
    CHECK(c.value.error == 50);
    CHECK(c.limit == (values.empty() ? round : seen.back().t));
    values.push_back(c.value.value);
  }
  return values;
}

RingCourse narrow_from(double gathered, double width) {
  RingCourse course = course_of(gathered, {{gathered, 0, 0}});
  course.samples[0][0].width = course.samples[0][1].width = width;
  return course;
}

}  // namespace

TEST_CASE("a modulated run is a plain one, looked at closely in the end", "[unit]") {
  const ModulatedPhonon phonon{.s = 1, .q = pi / 2, .a = 0.3, .b = 0.2, .sites = 48};
  for (double time : {62.0, 181.0}) {
    const Modulated m = modulate(phonon, time, 0.8);
    State<double> state = phonon.start(), later;
    const Chain ring = phonon.ring();
    const double wait = drift_of(ring, state, time - 60, 60, 0.8);
    check_packet(m, ring, state, 0.8);
    check_close(m.end.t, time, 1e-9);
    const double close = drift_of(ring, state, 60, 1, 0.8);
    check_close(m.drift, std::max(wait, close), 1e-12);
    CHECK(std::max(wait, close) > 1e-9);
  }
}

TEST_CASE("a course is two plain runs as long as they agree", "[unit]") {
  struct Case {
    ModulatedPhonon phonon;
    double longest;
    std::array<double, 2> steps;
    double patience;
  };
  const auto ring = [](double s, double q, double a, double b) {
    return ModulatedPhonon{s, 0.5, q, a, b, 32};
  };
  const double q = pi / 2;
  int parted = 0, gathered = 0;
  for (const Case& c : {Case{ring(1, q, 0.4, 0.5), 250, {0.6, 0.3}, 1.5},
                        {ring(1, q, 0.4, 0.5), 400, {0.8, 0.4}, 1e9},
                        {ring(1, q, 0.5, 1), 400, {0.6, 0.3}, 1.5},
                        {ring(1, q, 0.404, 1), 200, {0.8, 0.4}, 1.5},
                        {ring(1, q, 0.44, 1), 200, {0.8, 0.4}, 1.5},
                        {ring(1, q, 0.4, 0.5), 300, {0.4, 0.2}, 2}}) {
    const RingCourse course = ring_course(c.phonon, c.longest, c.steps, c.patience);
    const Plain plain = plain_course(c.phonon, c.longest, c.steps, c.patience);
    CAPTURE(c.phonon.a, c.phonon.b, plain.end, plain.gathered, plain.parted);
    parted += plain.parted, gathered += !std::isnan(plain.gathered);
    REQUIRE(course.samples.size() == plain.samples.size());
    for (std::size_t k = 0; k < plain.samples.size(); ++k)
      for (std::size_t i : {0, 1}) {
        CHECK(course.samples[k][i].t == 50 * double(k + 1));
        CHECK(course.samples[k][i].peak_over_mean == plain.samples[k][i].peak_over_mean);
        CHECK(course.samples[k][i].second == plain.samples[k][i].second);
      }
    CHECK(course.agree.value == plain.end);
    CHECK(course.agree.is_exact != plain.parted);
    CHECK(course.agree.error == (plain.parted ? 50 : 0));
    CHECK(std::isnan(course.gathered) == std::isnan(plain.gathered));
    if (std::isnan(plain.gathered)) continue;
    CHECK(course.gathered == plain.gathered);
    for (std::size_t i : {0, 1})
      check_packet(course.packet[i], c.phonon.ring(),
                   plain.states[i][std::size_t(plain.gathered / 50) - 1], c.steps[i]);
  }
  CHECK(parted == 4);
  CHECK(gathered == 3);
  // Without a word of patience it lasts as long as it may
  const ModulatedPhonon early = ring(1, q, 0.4, 0.5);
  CHECK(ring_course(early, 300, {0.4, 0.2}).samples.size() == 6);
}

TEST_CASE("slower and wider by more than is uncertain", "[unit][criteria]") {
  const auto says = [](double time, double width, double soft = 1000, double hard = 900) {
    return holds(
        slower_and_wider(narrow_from(time, width), narrow_from(soft, 8), narrow_from(hard, 9)));
  };
  CHECK(says(1120, 9.1));
  CHECK(says(1120, 9.1, 900, 1000));
  CHECK_FALSE(says(1100, 9.1));  // 50 of either
  CHECK_FALSE(says(1100, 9.1, 900, 1000));
  CHECK_FALSE(says(1120, 8.9));
  const Criterion told =
      slower_and_wider(narrow_from(1500, 18), narrow_from(1000, 12), narrow_from(500, 9));
  check_close(told.at(0).value.value, 1.5, 1e-15);
  check_close(told.at(0).value.error, (50 + 1.5 * 50) / 1000, 1e-15);
  check_close(told.at(1).value.value, 1.5, 1e-15);
}

TEST_CASE("a pulse splits after its way round the ring, step by step", "[unit][criteria]") {
  // Alone from 200 to 400, two at 450; apart as soon as both runs say so
  const std::vector<Seen> plain{{100, 0.1, 0.1},
                                {150, 0.9, 0.9},
                                {200, 0.1, 0.1},
                                {300, 0.2, 0.2},
                                {400, 0.49, 0.49},
                                {450, 0.5, 0.5, false, true},
                                {500, 0.8, 0.8, true, false},
                                {550, 0.3, 0.3},
                                {600, 0.7, 0.7},
                                {650, 0.7, 0.7},
                                {900, 0.1, 0.1}};
  CHECK(told(160, 200, plain) == std::vector<double>{200, 450, 600});
  CHECK(told(200, 200, plain) == std::vector<double>{200, 450, 600});
  CHECK(told(160, 200.5, plain) == std::vector<double>{200, 1800, 1800});
  CHECK(told(100, 200, plain) == std::vector<double>{200, 450, 600});
  CHECK(told(250, 100, plain) == std::vector<double>{100, 450, 600});
  // What only one of the runs sees is neither one pulse nor two
  CHECK(told(0, 100,
             {{100, 0.1, 0.1},
              {200, 0.1, 0.9},
              {250, 0.9, 0.1},
              {300, 0.9, 0.9},
              {350, 0.9, 0.1},
              {400, 0.9, 0.9}}) == std::vector<double>{0, 800, 800});
  CHECK(
      told(0, 100,
           {{100, 0.1, 0.1}, {200, 0.1, 0.1}, {250, 0.9, 0.1}, {300, 0.1, 0.9}, {350, 0.9, 0.9}}) ==
      std::vector<double>{100, 350, 350});
  CHECK(told(0, 100, {{100, 0.5, 0.49}, {150, 0.1, 0.1}, {250, 0.49, 0.5}, {275, 0.9, 0.9}}) ==
        std::vector<double>{0, 550, 550});
  // Two too early: then the pulse must have been alone for as long again
  CHECK(told(0, 150,
             {{100, 0.1, 0.1},
              {200, 0.1, 0.1},
              {250, 0.9, 0.9},
              {300, 0.1, 0.1},
              {400, 0.1, 0.1},
              {450, 0.9, 0.9},
              {500, 0.1, 0.1},
              {700, 0.1, 0.1},
              {750, 0.9, 0.9}}) == std::vector<double>{200, 750, 750});
  // The second and the last interval are not known better than to fifty
  const auto splits = [](double split, double apart, double last) {
    return holds(pulse_splits(course_of(0, {{100, 0.1, 0.1},
                                            {400, 0.1, 0.1},
                                            {split, 0.9, 0.9, false, false},
                                            {apart, 0.9, 0.9},
                                            {last, 0.9, 0.9}}),
                              240));
  };
  CHECK(splits(450, 500, 551));
  CHECK_FALSE(splits(450, 500, 549));
}

}  // namespace courses_again
