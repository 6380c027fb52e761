// Packets from site to site a second time: what is measured, by plain loops over all samples; which packet it is; members
// of the families between which a packet lies.

#include "sec5/packet_members.hpp"

#include <numbers>

#include "check.hpp"
#include "lattice/impact/impact.hpp"
#include "sec5/travelling.hpp"

namespace members_again {

using namespace lattice;

namespace {

constexpr double turn = 2 * std::numbers::pi;
using Numbers = std::vector<double>;
using Samples = std::vector<State<double>>;

/// The packet that is the strongest at every sample, between two beads that count from one.
Traveller seen_again(const Chain& chain, const Samples& samples, std::size_t from, std::size_t to) {
  Samples at;  // the states at the passages, turned back by the time
  std::vector<std::size_t> beads;
  double logs = 0, width = 0, count = 0, before = 0;
  std::size_t next = 0, peak = 0;
  for (std::size_t i = 0; i < samples.size() && (next == 0 || next < to); ++i) {
    const Numbers e = energy_density(chain, samples[i]);
    // It moves on by two sites at most, also after the first sample, at which it is at the first site or has just passed
    const auto first = e.begin() + (next == 0 ? 0 : std::ptrdiff_t(peak) - 1);
    peak = std::size_t(std::max_element(first, next == 0 ? e.end() : first + 4) - e.begin());
    if (next == 0 && peak + 1 < from) continue;
    if (next == 0) peak = from - 1;
    double sum = 0, squares = 0, moment = 0;
    for (std::size_t n = peak - 3; n <= peak + 3; ++n)
      sum += e[n], squares += e[n] * e[n], moment += double(n) * e[n];
    const double centre = moment / sum;
    if (next == 0) next = std::size_t(std::ceil(centre));
    for (; next < to && before > 0 && centre >= double(next); ++next) {
      const double late = (centre - double(next)) / (centre - before);
      State<double> z = samples[i];
      z.t = late * samples[i - 1].t + (1 - late) * samples[i].t;
      for (std::size_t n = 0; n < z.y.size(); ++n) {
        std::complex<double> mean = 0;
        for (std::size_t k : {i - 1, i})
          mean += (k == i ? 1 - late : late) * std::polar(1.0, samples[k].t) *
                  std::complex<double>(samples[k].y[n], samples[k].v[n]);
        z.y[n] = mean.real(), z.v[n] = mean.imag();
      }
      at.push_back(z), beads.push_back(next);
    }
    before = centre;
    if (!at.empty() && next < to) logs += std::log(sum), width += sum * sum / squares, ++count;
  }
  double phase = 0;
  for (std::size_t k = 1; k < at.size(); ++k) {
    std::complex<double> both = 0;
    for (int j = -3; j <= 3; ++j) {
      const auto a = std::size_t(int(beads[k - 1]) + j), b = std::size_t(int(beads[k]) + j);
      both += std::complex<double>(at[k - 1].y[a], at[k - 1].v[a]) *
              std::complex<double>(at[k].y[b], -at[k].v[b]);
    }
    phase += std::arg(both) / double(at.size() - 1);
  }
  return {(at.back().t - at.front().t) / double(at.size() - 1), phase, std::exp(logs / count),
          width / count};
}

/// A packet on its way from index `start`, with a phase from site to site; small, so that the contacts have little energy.
Samples packet(std::size_t sites, double start, double speed, double phase, double every) {
  Samples out;
  for (double t = 0; start + speed * t < double(sites) - 4; t += every) {
    State<double> now(sites);
    now.t = t;
    for (std::size_t n = 0; n < sites; ++n) {
      const double x = double(n) - start - speed * t;
      const auto z = std::polar(1e-3 * (1 + 0.1 * std::cos(t)) * std::exp(-0.4 * x * x - 0.02 * x),
                                -t - phase * double(n));
      now.y[n] = z.real(), now.v[n] = z.imag();
    }
    out.push_back(now);
  }
  return out;
}

/// What a watch says of samples; nothing if the packet has not passed.
std::string watch(const Chain& chain, const Samples& samples, std::size_t from, std::size_t to,
                  std::size_t which, Traveller& out, std::size_t& looks) {
  return refusal([&] {
    TravellerWatch watch(chain, from, to, which);
    looks = 0;
    for (const State<double>& now : samples)
      if (++looks, !watch.look(now)) break;
    out = watch.traveller();
  });
}

void same(const Traveller& value, const Traveller& expected, double relative) {
  check_close(value.shift_time, expected.shift_time, 0, relative);
  check_close(value.phase, expected.phase, relative);
  check_close(value.energy, expected.energy, 0, relative);
  check_close(value.width, expected.width, 0, relative);
}

/// The line or parabola through points by Neville's scheme.
double neville(double x, Numbers xs, Numbers ys) {
  for (std::size_t m = 1; m < xs.size(); ++m)
    for (std::size_t i = 0; i + m < xs.size(); ++i)
      ys[i] = ((x - xs[i + m]) * ys[i] + (xs[i] - x) * ys[i + 1]) / (xs[i] - xs[i + m]);
  return ys[0];
}

}  // namespace

TEST_CASE("a packet is measured as plain loops measure it", "[unit][traveller]") {
  const Chain chain{40};
  Traveller seen;
  std::size_t looks = 0;
  struct Case {
    double start, speed, phase, every;
    std::size_t from, to;
  };
  for (const Case& c : {Case{4.2, 0.1, 0.3, 0.7, 9, 14},
                        {6, 0.35, -0.4, 0.9, 12, 20},
                        {3.3, 0.8, 0.1, 1.1, 8, 30},
                        {5.1, 0.9, 0.2, 1.9, 10, 24},
                        {7, 0.2, 2.5, 0.31, 10, 11},
                        {6.3, 0.25, 0.7, 0.4, 9, 33}}) {
    CAPTURE(c.start);
    const Samples samples = packet(40, c.start, c.speed, c.phase, c.every);
    CHECK(watch(chain, samples, c.from, c.to, 1, seen, looks).empty());
    same(seen, seen_again(chain, samples, c.from, c.to), 1e-11);
    check_close(seen.shift_time, 1 / c.speed, 0, 0.05);
    check_close(seen.phase, c.phase, 0.05);
    // It has passed with the first sample whose centre is there
    check_close(c.start + c.speed * c.every * double(looks - 1), double(c.to - 1),
                1.1 * c.speed * c.every + 0.2);
  }
}

TEST_CASE("which packet comes, and whether it has passed", "[unit][traveller]") {
  const Chain chain{40};
  Traveller seen;
  std::size_t looks = 0;
  // One that begins two sites before has come, nearer it has not; a second one never does
  CHECK(watch(chain, packet(40, 7, 0.2, 0, 0.5), 10, 20, 1, seen, looks).empty());
  CHECK(!watch(chain, packet(40, 8, 0.2, 0, 0.5), 10, 20, 1, seen, looks).empty());
  CHECK(!watch(chain, packet(40, 9, 0.2, 0, 0.5), 10, 20, 1, seen, looks).empty());
  CHECK(!watch(chain, packet(40, 7, 0.2, 0, 0.5), 10, 20, 2, seen, looks).empty());
  // A packet that leaps over the site is seen one site further, with a leap over both it is not
  CHECK(watch(chain, packet(40, 6.1, 1, 0, 1.95), 9, 20, 1, seen, looks).empty());
  // Too few samples, or a single passage
  Samples few = packet(40, 7, 0.2, 0, 0.5);
  watch(chain, few, 10, 20, 1, seen, looks);
  few.resize(looks - 1);
  check_line(watch(chain, few, 10, 20, 1, seen, looks),
             "packet 1 has not passed the beads 10 to 20 by the end of the run");
  CHECK(TravellerWatch(chain, 4, 34).look(few[0]));
  for (const auto& [from, to] : {std::pair<int, int>{3, 20}, {9, 35}, {9, 9}, {9, 8}})
    CHECK_THROWS_AS(TravellerWatch(chain, std::size_t(from), std::size_t(to)),
                    std::invalid_argument);
  check_line(refusal([&] { TravellerWatch(chain, 9, 8); }), "from bead 9 to 8");
  const WatchedBeads usual;
  CHECK((usual.from == 12 && usual.to == 28 && usual.which == 1));
  CHECK((Traveller{}.shift_time == 0 && Traveller{}.phase == 0));
  CHECK((Traveller{}.energy == 0 && Traveller{}.width == 0));
}

TEST_CASE("a run shows every second step to the watch", "[unit][traveller]") {
  const DrivenChain driven{Chain{24}, {0.001, 0}};
  const State<double> start = struck(24, 1.5);
  Samples samples;
  State<double> state = start;
  run_driven(driven, state, time_grid(60, 0.3, 0.15), [&](const State<double>& now, const auto&) {
    samples.push_back(now);
    return true;
  });
  same(traveller_on(driven, start, 60, 0.15, {7, 11, 1}), seen_again(driven.chain, samples, 7, 11),
       1e-10);
  CHECK_THROWS_AS(traveller_on(driven, start, 4, 0.15, {7, 11, 1}), std::runtime_error);
}

TEST_CASE("members of a family on either side of its orbit of type I", "[unit][traveller]") {
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-9;
  const MemberGrid grid = member_grid(4, 5, {-0.3, 0, 0.2, 0.4});
  REQUIRE(grid.members.size() == 4);
  Staircase stairs(1, usual_reach, rule);
  for (std::size_t family : {0, 1}) {
    const double time = turn * (family == 0 ? 5 : 4);
    const Orbit<double> first = stairs.reach(family == 0 ? 5 : 4);
    const auto up = [&](const Orbit<double>& a, const Orbit<double>& b, double phase) {
      return next_member(a, b, time - phase, usual_reach, rule);
    };
    const Orbit<double> more = up(first, first, 0.2);
    const std::vector<Orbit<double>> orbits{up(first, first, -0.3), first, more,
                                            up(first, more, 0.4)};
    for (std::size_t p = 0; p < 4; ++p) {
      CAPTURE(family, p);
      const Traveller& m = grid.members[p].at(family);
      const double T = time - grid.phases[p];
      const Traveller free =
          traveller_on({Chain{32}}, embed(orbits[p].start, 32, 0), 8 * T, 0.1, {11, 13, 1});
      check_close(m.shift_time, T, 0, 1e-12);
      check_close(m.phase, grid.phases[p], 0);
      check_close(m.energy, free.energy, 0, 1e-8);
      check_close(m.width, free.width, 0, 1e-8);
    }
  }
  CHECK(grid.members[0][0].energy != grid.members[2][0].energy);
}

TEST_CASE("what lies between members, without the farthest of them", "[unit][traveller]") {
  const Numbers phases{-0.5, 0, 0.2, 0.6}, speeds{0.02, 0.03, 0.07, 0.1};
  const auto logs = [](double c, double f) { return 1 + std::sin(30 * c) * std::exp(f); };
  const auto width = [](double c, double f) { return 3 + 1 / (c + 0.1) + std::cos(2 * f); };
  MemberGrid grid{phases, {}};
  for (double f : phases) {
    auto& row = grid.members.emplace_back();
    for (double c : speeds)
      row.push_back({1 / c, f, std::exp(logs(c, f)) * std::pow(c, 4), width(c, f)});
  }
  struct Case {
    double speed, phase;
    std::size_t left_out;
    std::vector<std::size_t> speeds, phases;
  };
  for (const Case& c : {Case{0.028, 0.25, 2, {0, 1}, {1, 2}},
                        {0.028, 0.25, 1, {0, 1, 2}, {1, 2, 3}},
                        {0.08, -0.3, 1, {1, 2, 3}, {0, 1, 2}},
                        {0.05, 0.1, 0, {0, 1, 2, 3}, {0, 1, 2, 3}},
                        {0.09, 0.45, 3, {3}, {3}}}) {
    Numbers cs, fs, e, w;
    for (std::size_t k : c.speeds) cs.push_back(speeds[k]);
    for (std::size_t p : c.phases) {
      Numbers es, ws;
      for (double s : cs) es.push_back(logs(s, phases[p])), ws.push_back(width(s, phases[p]));
      fs.push_back(phases[p]), e.push_back(neville(c.speed, cs, es)),
          w.push_back(neville(c.speed, cs, ws));
    }
    const Traveller found = member_like(grid, {1 / c.speed, c.phase, 9, 9}, c.left_out);
    same(found,
         {1 / c.speed, c.phase, std::exp(neville(c.phase, fs, e)) * std::pow(c.speed, 4),
          neville(c.phase, fs, w)},
         1e-11);
  }
  CHECK(member_like(grid, {20, 0.1, 1, 1}).energy == member_like(grid, {20, 0.1, 1, 1}, 0).energy);
}

}  // namespace members_again
