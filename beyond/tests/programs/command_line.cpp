// The programs of volume two as a reader meets them.

#include "support/commands.hpp"

#include "support/check.hpp"

using namespace lattice;
using namespace report;

TEST_CASE("a line that cannot be meant is refused by what is beyond the article", "[cli]") {
  const std::string orbit = "sec5_travelling_breathers orbit ", map = "sec34_boomeron_map map ";
  const std::vector<std::pair<std::string, std::string>> lines{
      {map + "--part 0/4", "--part"},
      {map + "--folder ''", "--folder: "},
      {map + "--folder /proc/nowhere", "--folder: cannot write to '/proc/nowhere'"},
      {orbit + "--near 6 --k 1",
       "--near: '6' cannot be combined with --k (allowed: one of the two)"},
      {orbit + "--s 1", "folds"}};
  for (const auto& [line, complaint] : lines) check_refused(line, complaint);
  check_reason("sec5_experiment growth --q 1", "edge",
               "the wave is stable: none of its modulations grows");
}

TEST_CASE("a band of modulations has the side that is told", "[cli]") {
  for (const auto& [q, growing] : {std::pair{"1.6", true}, {"1.77", true}, {"1.78", false}}) {
    const Result answer =
        call("sec5_experiment growth --q " + std::string(q) + " --modulation 3.14");
    const std::string side = text_of(answer, "edge", "meaning");
    CAPTURE(q, side);
    CHECK((quantity(answer, "growth") > 0) == growing);
    CHECK((side.find("above which all modulations grow, up to Q = pi") != std::string::npos) ==
          growing);
    CHECK((side.find("below which all modulations grow, down to Q = 0") != std::string::npos) !=
          growing);
  }
}

// The tail of an exact orbit is rounding; two tolerances from the same start agree on it to 1e-3
TEST_CASE("what is left of a tail is known to nothing but its size", "[cli][travelling]") {
  for (const char* orbit : {"--k 7", "--k 4 --sign minus", "--k 3"}) {
    const Result r = call(std::string("sec5_travelling_breathers orbit ") + orbit);
    CAPTURE(orbit, r.output);
    REQUIRE(r.code == 0);
    CHECK(quantity(r, "tail") <= quantity(r, "tail", "error"));
  }
}

TEST_CASE("every command of volume two reports its quantities", "[cli]") {
  const auto any = std::nan("");
  check_answers(
      {{"sec5_experiment drive --amplitude 20 --time 20",
        {{"outcome", 1}, {"budget", 0, 1e-10}, {"power", any}}},
       {"sec5_enclosures dps", {}},
       {"sec5_enclosures breather", {}},
       {"sec5_experiment damped", {{"sites_10ms", any}, {"periods_10ms", any}, {"speed", any}}},
       {"sec5_experiment growth --modulation 0.8410686705679303",
        {{"growth", 0.3736744433810828, 0, 1e-12},
         {"fastest_growth", 0.3736744433810828, 0, 1e-12},
         {"edge", 1.230959417340775, 0, 1e-12},
         {"frequency", -1.8306234324043515, 0, 1e-12}}},
       {"sec5_kernel_equation wave --k 1 --sign plus",
        {{"energy", 0.180833513579908, 0, 1e-11},
         {"contacts", 18},
         {"action", 0.486064036495, 0, 1e-11},
         {"quotient", 1.155210964204, 0, 1e-11},
         {"peak", 0.44625, 1e-5},
         {"residual", 0, 1e-14}}},
       {"sec5_travelling_breathers orbit --k 1 --sign minus --s 0",
        {{"shift_time", 6.283185307179586, 0, 1e-14},
         {"speed", 0.159154943091895, 0, 1e-12},
         {"peak", any},
         {"tail", 0, 1e-11},
         {"residual", 0, 1e-13},
         {"multiplier_modulus", 1.000018856, 1e-8}}}},
      {"sec34_boomeron_map map"});
  check_rows("sec5_travelling_breathers orbit --profile", "\nn,y,v\n-8,", 18);
}

// Extrapolated midpoint rule in another program; after twenty lifetimes overlaps are below 1e-90
TEST_CASE("a damped packet is where another program has it", "[cli][arrivals]") {
  const auto there = [](const std::string& options, double sites, double centre) {
    const Result r = call("sec5_experiment damped " + options);
    CAPTURE(options);
    check_close(quantity(r, "sites_10ms"), sites, 2e-6);
    check_close(quantity(r, "centre_10ms"), centre, 5e-6);
  };
  there("--velocity 0.4 --lifetime 5000", 13.8263789, 10.0710085);
  there("--velocity 0.2 --lifetime 10", 8.9290074, 7.0960342);
  there("--velocity 1 --lifetime 0.5", 14.3815192, 4.1210768);
}

TEST_CASE("orbits by another name, and a stable wave", "[cli]") {
  const Result near = call("sec5_travelling_breathers orbit --near 5.6");
  check_close(quantity(near, "shift_time"), 5.63857165159, 0, 1e-10);
  CHECK(quantity(call("sec5_experiment growth --q 1.5"), "growth") == 0);
}
