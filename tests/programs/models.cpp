// Wells and contacts as programs offer them by name, and what commands say of runs in them: that a step was too long, a
// peak is a maximum.

#include <string>
#include <vector>

#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/refinement.hpp"
#include "support/run.hpp"

using namespace report;

namespace {

const std::string impact = "sec34_impact run --time 20 ";
const std::string squeezed = "sec4_precompression_mi impact --time 100 ";
const std::string boomeron = "sec34_boomeron run --time 60 ";

/// By how much a chain with these wells misses its start after one period, relative to the amplitude.
double missed(const Well& well, const std::vector<double>& y, double omega) {
  const Chain chain{y.size(), well, Hertz{.negligible = 0}};
  State<double> start(y.size());
  start.y = y;
  State<double> end = start;
  evolve_reference(chain, end, 2 * std::acos(-1.0) / omega, 1e-13);
  end.t = start.t;
  return distance(end, start);
}

}  // namespace

TEST_CASE("options choose well and contact by name", "[cli][model]") {
  const std::string plain = rows(impact), pressed = rows(impact + "--precompression 0.5");
  CHECK(rows(impact + "--well quartic --s 0") == plain);
  CHECK(rows(impact + "--well harmonic") == plain);  // the same well by another type
  CHECK(rows(impact + "--contact power --alpha 1.5 --precompression 0") == plain);
  CHECK(rows(impact + "--well pendulum") != plain);
  CHECK(rows(impact + "--well none") != plain);
  CHECK(rows(impact + "--contact power --alpha 2") != plain);
  CHECK(rows(impact + "--contact power --precompression 0.5") == pressed);
  CHECK(pressed != plain);
  // The name of a program's own well changes nothing
  for (const std::string& command : {breather, squeezed}) {
    CAPTURE(command);
    const std::string other = rows(command + "--s 0.3");
    CHECK(rows(command + "--well quartic") == rows(command));
    CHECK(rows(command + "--well quartic --s 0.3") == other);
    const std::string harmonic = rows(command + "--well harmonic");
    CHECK(harmonic == rows(command + "--s 0"));
    CHECK(harmonic != other);
  }
}

TEST_CASE("every command answers a wrong well in one line", "[cli][model]") {
  for (const std::string& command : {breather, multipliers, squeezed, boomeron, impact}) {
    check_refused(command + "--well cubic", "none, harmonic, quartic, pendulum");
    check_refused(command + "--well pendulum --s 0.1", "--s: 'pendulum' has no parameter s");
  }
  const std::string why = "'none' does not hold a bead, and without a well ";
  const std::string others = " (allowed: harmonic, quartic, pendulum";
  check_refused(breather + "--well none", why + "there is no breather" + others);
  check_refused(multipliers + "--well none", why + "there is no breather" + others);
  check_refused(squeezed + "--well none", why + "the phonon band is different" + others);
  check_refused(squeezed + "--contact power", "--contact");
  check_refused(boomeron + "--contact glue", "hertz, power");
  check_refused(impact + "--contact power --alpha 0.5", "[1, 10]");
  check_refused(boomeron + "--alpha 2", "--alpha: 'hertz' has no parameter alpha");
  check_refused(boomeron + "--well quartic --s -0.1", "[0, 1000]");
  check_refused(boomeron + "--well quartic --s nan", "--s");
}

TEST_CASE("a frequency without breathers is refused with the reason", "[cli][model]") {
  const std::string why = "these breathers bifurcate from 1, the frequency of a single bead";
  for (const std::string& command : {breather, multipliers, std::string("sec32_barrier barrier ")})
    for (const char* omega : {"1", "3.5"})
      check_refused(command + "--omega " + omega,
                    "'" + std::string(omega) + "' is not in the allowed range [1.0001, 3]: " + why);
  check_refused("sec33_mobility kick --omega 0.9", "is not in the allowed range [1.01, 2]: " + why);
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

TEST_CASE("a packet turns round in the well that was named", "[cli][model]") {
  // In the program's own well, s = 1, it turns at site 20
  CHECK(quantity(call("sec34_boomeron run --time 300 --well quartic --s 1.2"), "apex_site") < 10);
  CHECK(call(boomeron + "--s 300").code == 0);
}

TEST_CASE("breathers of pendulums are periodic orbits by an independent route", "[cli][model]") {
  for (const auto& [centre, omega] : {std::pair<std::string, double>{"site", 1.1}, {"bond", 1.5}}) {
    CAPTURE(centre, omega);
    const std::vector<double> y = table_of(breather + "--well pendulum --profile --centre " +
                                           centre + " --omega " + std::to_string(omega))
                                      .numbers("y");
    REQUIRE(y.size() >= 31);
    CHECK(missed(Pendulum{}, y, omega) < 1e-9);
    CHECK(missed(Harmonic{}, y, omega) > 1e-5);  // in another well it is none
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

TEST_CASE("commands halve a step that is too long", "[cli]") {
  for (const char* command :
       {"sec34_impact run --velocity 100 --contact power --alpha 10 --sites 10 --time 5",
        "sec4_precompression_mi impact --velocity 100 --d 10 --s 10 --time 60"})
    CHECK(quantity(call(command), "energy_drift") < 1e-5);
}

TEST_CASE("the peak of a packet is a maximum in time and no flank", "[cli]") {
  // By an integrator of order eight and samples every hundredth; at site 20 the density falls from 0.139 and from 0.211
  for (const auto& [options, peak] :
       {std::pair{"--well harmonic --sites 41 --velocity 1 --time 150", 0.126289144},
        {"--well harmonic --sites 41 --velocity 1.2 --time 120", 0.192802249},
        {"--well harmonic --sites 41 --velocity 1.03 --time 130", 0.175245315},
        {"--well none --sites 56 --velocity 2.723633454804505 --time 90", 2.725489064}}) {
    const Result answer = call("sec34_impact run --tolerance 1e-7 " + std::string(options));
    CAPTURE(options);
    check_close(quantity(answer, "peak_energy_density"), peak,
                quantity(answer, "peak_energy_density", "error"));
  }
}
