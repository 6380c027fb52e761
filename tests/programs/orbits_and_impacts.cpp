// Programs of breathers and impacts: that options reach the chain, the contract of an impact, and what is refused.

#include "commands/multipliers.hpp"
#include "commands/one_breather.hpp"
#include "support/commands.hpp"

using namespace lattice;
using namespace report;

namespace {

const std::string barriers = "sec32_barrier barrier ";

}  // namespace

TEST_CASE("the options of a breather reach its chain", "[cli][chains]") {
  const auto energy_of = [](double omega, const Contact& contact, Centre centre,
                            const std::vector<double>& mass = {}) {
    OneBreather one;
    one.omega_b = omega, one.centre = centre, one.like.contact = contact;
    one.like.sites = mass.size();
    if (!mass.empty()) vary(one.like, mass, {});
    return double(one.find().wide.energy);
  };
  const auto check = [](const std::string& options, double energy) {
    CAPTURE(options);
    check_close(quantity(call(breather + options), "energy"), energy, 0, 1e-15);
  };
  check("--contact power --omega 1.2 --centre bond --alpha 3",
        energy_of(1.2, PowerContact{3}, Centre::bond));
  check("--precompression 1e-3 --omega 1.35", energy_of(1.35, CompressedHertz{1e-3}, Centre::site));
  check("--mass-ratio 0.9 --defect-mass 1.2 --omega 1.3",
        energy_of(1.3, {}, Centre::site, {1, 0.9, 1.2, 0.9, 1}));
  // The power law with the exponent of spheres is that of spheres, and so are masses of one
  CHECK(rows(breather + "--contact power --alpha 1.5") == rows(breather));
  CHECK(rows(breather + "--mass-ratio 1 --defect-mass 1") == rows(breather));
}

TEST_CASE("what has no breather is refused in one line by the program", "[cli][chains]") {
  for (const std::string& command : {breather, multipliers}) {
    check_refused(command + "--precompression 0.01 --omega 1.2", "[1, 1.26491]");
    check_refused(command + "--mass-ratio 0.8", "--omega: 1.1 is not above the linear waves");
    check_refused(command + "--mass-ratio 0.8 --centre bond",
                  "--mass-ratio: such a chain is not symmetric");
    check_refused(command + "--defect-mass 2 --centre bond",
                  "--defect-mass: such a chain is not symmetric");
    check_refused(command + "--precompression 1e-3 --omega 1.3 --sites 15", "--sites: 15");
    check_refused(command + "--well none --precompression 0.1", "there is no breather");
  }
  check_refused(barriers + "--precompression 0.01 --omega 1.2", "[1, 1.26491]");
}

TEST_CASE("commands take an exponent", "[cli][exponents]") {
  for (const std::string line : {"sec32_dps_profiles profile", "sec33_dps_stability spectrum",
                                 "sec31_dps_limit impact --tau 30"}) {
    const std::string spheres = rows(line);
    CHECK(spheres.size() > 200);
    CHECK(spheres == rows(line + " --alpha 3/2"));
    CHECK(spheres != rows(line + " --alpha 1.51"));
  }
}

TEST_CASE("the boomeron run keeps its contract", "[cli][boomeron]") {
  const Result r = call("sec34_boomeron run --velocity 1.9 --s 1 --time 1000");
  check_close(quantity(r, "apex_site"), 20.06, 0.05);
  check_close(quantity(r, "apex_time"), 466.6, 2);
  check_close(quantity(r, "return_time"), 897.7, 1);
  CHECK(quantity(r, "decorrelation_time") > 900);
  const std::string brief = "sec34_boomeron run --time 60 --tolerance 0.01";
  CHECK(rows(brief) == rows(brief + " --sites 300"));
  CHECK(
      std::isnan(quantity(call("sec34_boomeron run --velocity 1 --s 0 --time 200"), "apex_site")));
}
