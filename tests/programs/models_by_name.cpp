// Wells and contacts as values and by name in the programs: which are offered, what is refused, and that a well
// chosen when the program runs is the well itself.

#include <string>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec4/packets.hpp"
#include "support/check_potential.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

/// The command of a short impact.
std::string impact(const std::string& options) {
  return "sec34_impact run --time 20 " + options;
}

const std::string breather = "sec32_newton_breathers breather ";
const std::string multipliers = "sec33_floquet multipliers ";
const std::string squeezed = "sec4_precompression_mi impact --time 100 ";
const std::string boomeron = "sec34_boomeron run --time 100 ";

/// By how much a chain with these wells misses its start after one period, relative to the amplitude.
template <class Onsite>
double missed(const std::vector<double>& y, double omega) {
  Chain chain{y.size(), Onsite{}};
  chain.contact = Hertz{.floor = 0};
  State<double> start(y.size());
  start.y = y;
  State<double> end = start;
  evolve_reference(chain, end, 2 * std::acos(-1.0) / omega, 1e-13);
  end.t = start.t;
  return distance(end, start);
}

}  // namespace

TEST_CASE("a well and a contact are what they were made from", "[unit][model]") {
  const Chain chain{7, Quartic{-0.5}, CompressedHertz{0.5}, Ends::periodic};
  CHECK(chain.well.as<Quartic>().s == -0.5);
  CHECK(chain.contact.as<CompressedHertz>().d == 0.5);
  CHECK(std::holds_alternative<Harmonic>(Chain{}.well));
  CHECK(std::holds_alternative<Hertz>(Chain{}.contact));
  CHECK_THROWS_AS(chain.well.as<Pendulum>(), std::bad_variant_access);
  check_close(chain.well.rim(), std::sqrt(2.0), 1e-15);
  CHECK(chain.contact.opening() == 0.5);
  CHECK(chain.contact.exponent() == 1.5);
}

TEST_CASE("a well chosen at run time has the bits of the well itself", "[unit][potential][model]") {
  const auto same = [](auto well) {
    const Well chosen{well};
    for (double y : {-1.7, -1e-3, 0.0, 0.4, 2.5}) {
      CHECK(chosen.energy(y) == well.energy(y));
      CHECK(chosen.force(y) == well.force(y));
      CHECK(chosen.stiffness(y) == well.stiffness(y));
      CHECK(chosen.force((long double)y) == well.force((long double)y));
    }
    CHECK(rim_of(chosen) == rim_of(well));
    check_well(chosen);
  };
  same(Harmonic{});
  same(Quartic{-0.5});
  same(Pendulum{});
}

TEST_CASE("a chain is long enough for what travels in it", "[unit][model]") {
  struct Run {
    Chain like;
    double velocity, time;
  };
  for (const auto& [like, velocity, time] : {Run{{0, Quartic{1}}, 1.9, 200},
                                             {{0, None{}}, 1.9, 200},
                                             {{0, None{}}, 100, 60},
                                             {{0, None{}, CompressedHertz{4}}, 1, 60}}) {
    const Impact impact = on_long_chain({velocity, like, time});
    CAPTURE(velocity, impact.chain.sites);
    CHECK(impact.chain.sites < 4 * std::size_t(time) + 100);
    CHECK(strike(EventCorrected{0.05}, impact).far_end <= 1e-12 * velocity);
  }
}

TEST_CASE("a run that its far end sends back is no result", "[unit][model]") {
  Impact impact{1.9, {30}, 100};
  CHECK_THROWS_AS(strike(EventCorrected{0.05}, impact), FarEndReached);
  impact.far_end = may_move;
  CHECK(strike(EventCorrected{0.05}, impact).far_end > 0.01);
  // The packet leaves before it is back, so here the same chain will do
  impact.far_end = 1e-9, impact.until = 20;
  CHECK(strike(EventCorrected{0.05}, impact).path.centre.back() >= 20);
}

TEST_CASE("an impact in two parts is the impact", "[unit][model]") {
  const Impact impact{1.9, {60, Quartic{1}}, 60};
  const ImpactRun whole = strike(EventCorrected{0.1}, impact);
  ImpactRun parts{struck(60, 1.9)};
  follow(EventCorrected{0.1}, impact, parts, 20);
  follow(EventCorrected{0.1}, impact, parts, 60);
  CHECK(whole.end.y == parts.end.y);
  CHECK(whole.density == parts.density);
  CHECK(whole.run.steps == parts.run.steps);
}

TEST_CASE("what rests has no energy, whatever the sum is over", "[unit][model]") {
  Chain chain{50, Quartic{1}, CompressedHertz{0.5}};
  State<double> state(50);
  state.v[20] = 1, state.y[20] = 0.3, state.y[22] = -0.1;
  const auto all = energy_density(chain, state);
  for (std::size_t n = 0; n < 50; ++n) {
    const double y = state.y[n], v = state.v[n];
    const double contact = n < 49 ? chain.contact.energy(state.y[n + 1] - y) : 0;
    CHECK(all[n] == v * v / 2 + chain.well.energy(y) + contact);
  }
}

TEST_CASE("options choose well and contact by name", "[cli][model]") {
  const std::string plain = rows(impact(""));
  CHECK(rows(impact("--well quartic --s 0")) == plain);
  CHECK(rows(impact("--well harmonic")) == plain);  // the same well by another type
  CHECK(rows(impact("--contact hertz --precompression 0")) == plain);
  CHECK(rows(impact("--contact power --alpha 1.5")) == plain);
  CHECK(rows(impact("--well pendulum")) != plain);
  CHECK(rows(impact("--well none")) != plain);
  CHECK(rows(impact("--contact power --alpha 2")) != plain);
  CHECK(rows(impact("--precompression 0.5")) ==
        rows(impact("--contact power --precompression 0.5")));
  CHECK(rows(impact("--precompression 0.5")) != plain);
}

TEST_CASE("every command answers a wrong well in one line", "[cli][model]") {
  for (const std::string& command : {breather, multipliers, squeezed, boomeron, impact("")}) {
    check_refused(command + "--well cubic", "none, harmonic, quartic, pendulum");
    check_refused(command + "--well pendulum --s 0.1", "--s: 'pendulum' has no parameter s");
    check_refused(command + "--well harmonic --s 0", "--s: 'harmonic' has no parameter s");
    check_refused(command + "--well quartic --s nan", "--s");
  }
  const std::string why = "'none' holds no bead, and without a well ";
  const std::string others = " (allowed: harmonic, quartic, pendulum)";
  check_refused(breather + "--well none", why + "there is no breather" + others);
  check_refused(multipliers + "--well none", why + "there is no breather" + others);
  check_refused(squeezed + "--well none", why + "the phonons are others" + others);
  check_refused(squeezed + "--contact power", "--contact");
  check_refused(boomeron + "--contact glue", "hertz, power");
  check_refused(impact("--contact power --alpha 0.5"), "[1, 10]");
  check_refused(boomeron + "--alpha 2", "--alpha: 'hertz' has no parameter alpha");
  check_refused(boomeron + "--well quartic --s -0.1", "[0, 1000]");
}

TEST_CASE("the name of a program's own well changes nothing", "[cli][model]") {
  for (const std::string& command : {breather, squeezed}) {
    CAPTURE(command);
    const std::string plain = rows(command), other = rows(command + "--s 0.3");
    CHECK(rows(command + "--well quartic") == plain);
    CHECK(rows(command + "--well quartic --s 0.3") == other);
    CHECK(other != plain);
    const std::string harmonic = rows(command + "--well harmonic");
    CHECK(harmonic == rows(command + "--s 0"));  // the same well by another type
    CHECK(harmonic != other);
    CHECK(rows(command + "--well pendulum") != harmonic);
  }
}

TEST_CASE("a packet turns round in the well and with the contact that were named", "[cli][model]") {
  const std::string turns = "sec34_boomeron run --time 800 ";  // it has turned by then
  const Result plain = call(turns), harder = call(turns + "--well quartic --s 1.2");
  REQUIRE(plain.code == 0);
  CHECK(quantity(plain, "apex_site") > quantity(harder, "apex_site") + 1);
  CHECK(rows(turns + "--well quartic --contact power --alpha 1.5") == body(plain.output));
  CHECK(call(boomeron + "--s 300").code == 0);
}

TEST_CASE("the header does not record a parameter that the well lacks", "[cli][model]") {
  const auto parameters = [](const std::string& command) {
    for (const auto& [name, value] : table_of(command).meta)
      if (name == "parameters") return value;
    return std::string();
  };
  CHECK(parameters(boomeron).find("well = quartic, s = 1,") != std::string::npos);
  CHECK(parameters(boomeron + "--well pendulum").find("s = none") != std::string::npos);
  CHECK(parameters(breather + "--well quartic").find("s = 0,") != std::string::npos);
}

TEST_CASE("breathers of pendulums are periodic orbits by an independent route", "[cli][model]") {
  struct Wanted {
    std::string centre;
    double omega;
  };
  for (const auto& [centre, omega] : {Wanted{"site", 1.1}, {"bond", 1.5}}) {
    CAPTURE(centre, omega);
    const std::vector<double> y = table_of(breather + "--well pendulum --profile --centre " +
                                           centre + " --omega " + std::to_string(omega))
                                      .numbers("y");
    REQUIRE(y.size() >= 31);
    CHECK(missed<Pendulum>(y, omega) < 1e-9);
    CHECK(missed<Harmonic>(y, omega) > 1e-5);  // in another well it is none
  }
}

TEST_CASE("small breathers of pendulums are those of the quartic well with s = -1/6",
          "[cli][model]") {
  const std::string near = " --s -0.16666666666666666";
  const Result pendulum = call(breather + "--well pendulum"), soft = call(breather + near),
               harmonic = call(breather);
  for (const char* name : {"amplitude", "energy", "area"}) {
    CAPTURE(name);
    check_close(quantity(pendulum, name), quantity(soft, name), 0, 1e-7);
    CHECK(std::abs(quantity(pendulum, name) / quantity(harmonic, name) - 1) > 1e-5);
  }
  const auto pinning = [](const std::string& options) {
    return table_of(multipliers + options).numbers("modulus")[2] - 1;
  };
  check_close(pinning("--well pendulum"), pinning(near), 0, 1e-3);
  CHECK(pinning("--well pendulum") > 1.2 * pinning(""));
}

TEST_CASE("breathers begin only in wells of frequency one", "[unit][model]") {
  CHECK_THROWS_AS(breather_problem(Centre::site, 1.1, None{}, 31), std::invalid_argument);
  CHECK_THROWS_AS(breather_problem(Centre::site, 1.1, Well{None{}}, 31), std::invalid_argument);
  CHECK_NOTHROW(breather_problem(Centre::site, 1.1, Well{Pendulum{}}, 31));
}

TEST_CASE("the compressed impact strikes the well that was named", "[cli][model]") {
  const auto own = refined(1e-4, [&](const EventCorrected& method) {
    return strike(
        method, on_long_chain({1.87, {.well = Pendulum{}, .contact = CompressedHertz{0.5}}, 100}));
  });
  const PacketSample packet = packet_sample(100, own.fine.density);
  const Result r = call(squeezed + "--well pendulum");
  REQUIRE(r.code == 0);
  CHECK(quantity(r, "centre") == packet.centre);
  CHECK(quantity(r, "energy_fraction") == packet.share);
}

TEST_CASE("a frequency without breathers is refused with the reason", "[cli][model]") {
  const std::string why = "these breathers begin at 1, the frequency of a bead at rest";
  for (const std::string& command : {breather, multipliers, std::string("sec32_barrier barrier ")})
    for (const char* omega : {"0.9", "1", "3.5"})
      check_refused(command + "--omega " + omega,
                    "'" + std::string(omega) + "' is not in the allowed range [1.0001, 3]: " + why);
  check_refused("sec33_mobility kick --omega 0.9", "is not in the allowed range [1.01, 2]: " + why);
}
