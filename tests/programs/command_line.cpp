// Programs as a reader meets them: help, bad input, failures, and what they leave behind.

#include <filesystem>
#include <fstream>
#include <vector>

#include "support/check.hpp"
#include "support/commands.hpp"

using namespace report;
namespace fs = std::filesystem;

namespace {

/// What the header of a table says under a key.
std::string header(const Table& table, const std::string& key) {
  for (const auto& [name, value] : table.meta)
    if (name == key) return value;
  return "no entry";
}

}  // namespace

TEST_CASE("help and version", "[cli]") {
  const std::string help = offers().at("sec34_impact"), run = offers().at("sec34_impact run");
  CHECK(call("sec34_impact help").output == help);
  CHECK(call("sec34_impact help run").output == run);
  CHECK(call("sec34_impact --version").output.find("sec34_impact ") == 0);
  CHECK(run.find("--contact {hertz|power} ") != std::string::npos);
  CHECK(matches(run, "such as -1/6").size() == 1);
  CHECK(help.find("(default: build/data/sec34_impact,") != std::string::npos);
  // Wherever lines are broken
  const std::string words = in_one_line(run);
  for (const char* shown : {"(default: 1.87)", "(default: quartic)", "(default: as many as needed)",
                            "(default: standard output)", "is nan; the column reason says why"})
    CHECK(words.find(shown) != std::string::npos);
}

TEST_CASE("a line that cannot be meant is answered in one line, and nothing is computed", "[cli]") {
  const std::string run = "sec34_impact run ", profile = "sec32_dps_profiles profile ",
                    breather = "sec32_newton_breathers breather ", kick = "sec33_mobility kick ",
                    cantilever = "sec36_cantilever_defect ";
  const std::vector<std::pair<std::string, std::string>> lines{
      // Numbers and names
      {run + "--sites 2.5", "--sites: '2.5' is not a whole number (allowed: [2, 1000000])"},
      {run + "--sites ''", "--sites: '' is not a number"},
      {run + "--s 41/4", "'41/4' is not in the allowed range [-10, 10]"},
      {run + "--output ''", "--output"},
      {run + "--output 'two\nlines'", "--output: the name has a line break"},
      {"sec34_impact --threads many", "--threads: 'many' is not a number (allowed: [1, 1024])"},
      // What a range does not say
      {profile + "--centre site --sites 30", "--sites"},
      {"sec33_dps_stability spectrum --centre bond --sites 31", "--sites"},
      {kick + "--centre bond --sites 31", "--sites"},
      {breather + "--centre site --sites 30", "--sites"},
      {breather + "--centre site --sites 9", "--sites"},
      {"sec33_mobility threshold --centre site", "--centre"},
      {"sec33_mobility threshold --c 1e-4", "--c: belongs to "},
      {"sec34_impact --out /proc/nowhere", "--out: cannot write"},
      {run + "--output /proc/nowhere/x.ecsv", "--output: cannot write"},
      // Words in the wrong place
      {run + "2 --velocty 3", "'2': belongs to no option (allowed: --output, "},
      {run + "--velocty 3", "--velocty: unknown option; did you mean --velocity?"},
      {run + "--zzzzzz 3", "--zzzzzz: unknown option (allowed: --output, "},
      {run + "--quick", "--quick: belongs to a full run, without a command"},
      {"sec34_impact --quick run --time 20", "--quick: belongs to a full run, without 'run'"},
      {run + "run", "'run': the command is already 'run'"},
      {run + "--s 1 --s 2", "--s: given twice, '1' and '2' (allowed: once)"},
      {run + "--profile=yes", "--profile: takes no value, but got 'yes'"},
      {run + "-profile", "'-profile': an option is two dashes"},
      {run + "--", "'--': an option is two dashes"},
      {run + "--output --profile", "--output: needs a value, but '--profile' is an option"},
      {run + "--velocity", "--velocity: needs a value (allowed: [1e-06, 100])"},
      {run + "--well --s 1", "allowed: none, harmonic, quartic"},
      {run + "--output=", "--output: needs a value"},
      {run + "--s --4", "--s: needs a value"},
      {"sec34_impact rum", "'rum': unknown command; did you mean 'run'? (allowed: run"},
      {"sec34_impact fly", "'fly': unknown command (allowed: run"},
      {"sec34_impact --velocity 1", "--velocity: belongs to 'run'"},
      {"sec34_impact --quik", "did you mean --quick?"},
      {cantilever + "rum", "did you mean 'run'? (allowed: run)"},
      {"sec2_nonexistence run", "'run': belongs to no option, and this program has no commands"}};
  for (const auto& [line, complaint] : lines) check_refused(line, complaint);
}

TEST_CASE("places that cannot be written to", "[cli]") {
  Scratch scratch;
  const std::string run = "sec34_impact run --velocity 1 --time 20 --output ";
  // The second is too long with the suffix of a file that is not finished
  for (const std::string& name : {std::string(300, 'x'), std::string(252, 'x'), std::string()})
    check_refused(run + word(scratch.path / name), "sec34_impact: --output: ");
  check_refused("sec34_impact --out " + word(scratch.path / std::string(300, 'x')), "--out: ");
  CHECK(call(run + "/dev/null").code == 0);
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(call("sec34_impact run --velocity 1 --time 20 > /dev/full").code == 1);
  CHECK(scratch.empty());
}

TEST_CASE("the header records every parameter with the value used", "[cli]") {
  const std::string run = "sec34_impact run --velocity 1.50 --time 2e1";
  const Table table = table_of(run + " --threads 2 '--well' \"quartic\"");
  CHECK(header(table, "command") == run + " --well quartic");
  const std::string used = header(table, "parameters");
  CAPTURE(used);
  for (const char* part : {"velocity = 1.5", "time = 20", "s = ", "well = quartic",
                           "sites = ", "precompression = 0", "tolerance = ", "profile = no"})
    CHECK(used.find(part) != std::string::npos);
  CHECK(used.find("threads") == std::string::npos);
  for (const char* name : {"GSL ", "Eigen ", "Boost "})
    CHECK(header(table, "libraries").find(name) != std::string::npos);
  CHECK(header(table, "seed") != "no entry");
  CHECK(header(table, "build").find("-O") != std::string::npos);
}

TEST_CASE("no number of threads changes a bit", "[cli]") {
  Scratch scratch;
  const auto bytes = [&](const std::string& options) {
    fs::remove_all(scratch.path / "out");
    REQUIRE(call_in(scratch.path, "sec32_dps_profiles --quick --out out " + options).code == 0);
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(scratch.path / "out")) {
      std::ifstream in(entry.path(), std::ios::binary);
      files[entry.path().filename().string()].assign(std::istreambuf_iterator<char>(in), {});
    }
    return files;
  };
  const auto one = bytes("--threads 1");
  CHECK(one.size() > 3);  // two tables at least, their list, and what they were made with
  CHECK(one == bytes("--threads 3"));
  CHECK(one == bytes(""));
}

TEST_CASE("the inner loop has the same bits at every vector width", "[cli]") {
  const Result wide = call("fingerprint_wide"), scalar = call("fingerprint_scalar");
  REQUIRE(wide.code == 0);
  REQUIRE(scalar.code == 0);
  CHECK(wide.output.size() > 200);
  CHECK(wide.output == scalar.output);
}

TEST_CASE("coarse tables do not come into the place of full ones", "[cli]") {
  Scratch scratch;
  const auto run = [&](const std::string& options) {
    return call_in(scratch.path, "sec32_dps_profiles --threads 1 " + options);
  };
  const auto is_quick = [&](const std::string& folder) {
    return header(read(scratch.path / folder / "profile_site.ecsv"), "parameters");
  };
  const std::string full = "build/data/sec32_dps_profiles",
                    quick = "build/quick/data/sec32_dps_profiles";
  REQUIRE(run("--quick").code == 0);
  CHECK_FALSE(fs::exists(scratch.path / "build/data"));
  CHECK(is_quick(quick) == "quick = yes");
  // A full run is refused to a coarse one, and left as it is
  REQUIRE(run("").code == 0);
  CHECK(is_quick(full) == "quick = no");
  const Result refused = run("--quick --out " + full);
  check_refused(refused, "--out: '" + full + "' holds the tables of a full run");
  check_refused(refused, "(allowed: another folder, such as " + quick + ")");
  CHECK(is_quick(full) == "quick = no");
  // Into a coarse folder both may go
  REQUIRE(run("--out " + quick).code == 0);
  CHECK(is_quick(quick) == "quick = no");
  // Wherever tables are, their headers are the same
  const Table one = read(scratch.path / full / "profile_site.ecsv");
  CHECK(header(one, "command") == "sec32_dps_profiles");
  for (const char* key : {"revision", "build", "libraries"}) CHECK(header(one, key) == "no entry");
  CHECK(one.meta == read(scratch.path / quick / "profile_site.ecsv").meta);
}

TEST_CASE("what does not exist has a reason", "[cli]") {
  const struct {
    const char *command, *quantity, *reason;
  } all[] = {
      {"sec34_impact run --velocity 1 --sites 2 --time 20", "speed",
       "the chain is too short for a fit from site 20 to twenty sites before the far end: it needs "
       "more than 40 sites"},
      {"sec34_impact run --sites 5 --time 5", "strongest_site",
       "the chain has no site beyond the first five"},
      {"sec34_impact run --time 20", "speed",
       "no packet reaches site 20: the foremost one reaches"},
      {"sec34_impact run --time 20", "peak_energy_density",
       "% of the energy stays on the first 5 sites"},
      {"sec34_impact run --velocity 1 --well harmonic --sites 41 --time 96", "peak_energy_density",
       "the energy density has no maximum in time on this stretch"},
      {"sec31_dps_limit impact --tau 1 --sites 30", "amplitude",
       "no maximum in time on its last two sites"},
      {"sec31_dps_limit impact --tau 40 --sites 60", "speed",
       "% of the norm stays on the first 10 sites"},
      {"sec31_dps_limit impact --tau 10 --sites 30", "speed", "the chain is too short"},
      {"sec33_mobility kick --c 1e-6 --time 2000", "velocity", "sites, less than one"},
      {"sec33_mobility kick --c 0.05 --omega 1.2 --sites 24 --time 1000", "velocity",
       "shorter than four averages of the position, each over eleven periods"},
      {"sec34_boomeron run --time 60", "apex_site", "not come back by five sites by t = 60"},
      {"sec34_boomeron run --time 60", "decorrelation_time", "have not decorrelated by t = 240"},
      {"sec4_precompression_mi impact --velocity 20 --d 10 --s 10 --time 60", "width",
       "beyond the 21 sites of the fit"},
      {"sec4_precompression_mi band --s 0.3", "unstable_to", ""}};
  for (const auto& [command, name, reason] : all) check_reason(command, name, reason);
}

TEST_CASE("a computation that fails says why, and leaves nothing", "[cli]") {
  const std::vector<std::pair<const char*, const char*>> all{
      {"sec34_impact run --s -0.7 --velocity 1.3 --time 100", "a bead runs away at t = 8.19"},
      {"sec4_precompression_mi impact --s -0.7 --velocity 9 --time 60", "runs away"},
      {"sec32_newton_breathers breather --omega 2 --s -1", "folds back near 1.6"},
      {"sec33_mobility kick --c 0.5", "breaks up"},
      {"sec31_dps_limit impact --tau 1000 --sites 5 --end fixed --alpha 3", "too erratic"},
      {"sec34_kink run --velocity 4.68 --patience 400", "undecided"},
      {"sec36_cantilever_defect run --sites 120", "--sites 120 are too few"},
      {"sec36_cantilever_defect run --velocity 0.35", "has not passed the defect"},
      {"sec36_cantilever_defect run --until 20", "has not passed the defect"}};
  for (const auto& [command, said] : all) check_failure(command, said);
}

TEST_CASE("every command reports the contract's quantities, and says what they are", "[cli]") {
  const auto any = std::nan("");
  // Open are tables of another kind, and what takes long and is judged in an exercise or a test of its own
  check_answers(
      {{"sec31_dps_limit impact --tau 250",
        {{"centre", any},
         {"speed", 0.361292, 0, 1e-4},
         {"norm_window", 0.448899965, 0, 1e-6},
         {"amplitude", any},
         {"residual_boundary", any}}},
       {"sec32_barrier barrier --omega 1.1 --s 0",
        {{"equal_frequency", 1.62422472e-11, 0, 1e-8}, {"equal_area", -2.35229159e-13, 0, 1e-7}}},
       {"sec32_newton_breathers breather --centre site --omega 1.1 --s 0 --sites 31",
        {{"amplitude", 0.01074795250745621, 0, 1e-12},
         {"energy", 1.5359852004088633e-4, 0, 1e-12},
         {"area", 8.9264257072819404e-4, 0, 1e-12},
         {"residual", 0, 1e-13},
         {"iterations", 3, 3}}},
       {"sec33_mobility kick --centre bond --phase stretched --c 2e-4 --time 8000",
        {{"velocity", -5.363e-4, 0, 1e-3}, {"drift", 0, 1e-8}, {"sites_travelled", -4.25, 0.06}}},
       {"sec34_boomeron run --time 60", {}},
       {"sec34_dps_impact compare --tau 100",
        {{"speed", any},
         {"amplitude", any},
         {"speed_same_start", any},
         {"amplitude_same_start", any}}},
       {"sec34_impact run --velocity 0.94 --s -0.7 --time 300",
        {{"speed", any},
         {"centre", any},
         {"strongest_site", any},
         {"peak_energy_density", any},
         {"packet_energy_fraction", any},
         {"boundary_energy_fraction", 0.75, 0.25},
         {"energy_drift", 0, 1e-5},
         {"escaped", 0}}},
       {"sec34_kink run --velocity 2", {}},
       {"sec36_cantilever_defect run",
        {{"net_reflected", any}, {"net_near", any}, {"net_transmitted", any}}},
       {"sec4_precompression_mi coefficients --q 0.7853981633974483 --d 0.5 --s 0",
        {{"omega", 1.2731, 1e-3}, {"group_velocity", any}, {"beta", any}, {"phi", any}}},
       {"sec4_precompression_mi band --d 0.5 --s 1",
        {{"lower_edge", 1},
         {"upper_edge", std::sqrt(1 + 6 * std::sqrt(0.5)), 1e-14},
         {"phi_at_0", -1.5, 1e-14},
         {"unstable_to", 2.0068, 5e-5}}},
       {"sec4_precompression_mi impact --s 1 --time 724",
        {{"centre", 439.4, 0.5}, {"width", any}, {"energy_fraction", any}}}},
      {"sec32_dps_profiles profile", "sec33_dps_stability spectrum", "sec33_floquet exchange",
       "sec33_floquet multipliers", "sec33_mobility threshold", "sec35_scales scales"});
}

TEST_CASE("the commands agree with each other", "[cli]") {
  const std::string dps = "sec31_dps_limit impact --tau 250";
  CHECK(quantity(call(dps + " --end fixed"), "amplitude") > 1.2 * quantity(call(dps), "amplitude"));
  // The length of the chain does not spoil the speed; weak waves ahead are not the strongest packet
  const std::string run = "sec34_impact run --velocity 1.87 --s -0.1667 --time 587 --sites ";
  check_close(quantity(call(run + "80"), "speed"), quantity(call(run + "82"), "speed"), 0, 0.01);
  const Result hard = call("sec34_impact run --velocity 2.5 --s 1 --time 200");
  CHECK(quantity(hard, "packet_energy_fraction") < 0.1);
  CHECK(quantity(hard, "strongest_site") < quantity(hard, "centre") - 5);
}

TEST_CASE("profiles and spectra have a row for each site and each eigenvalue", "[cli]") {
  const struct {
    const char *command, *names;
    std::size_t rows;
  } all[] = {{"sec32_dps_profiles profile --centre bond --sites 12 --mu 2",
              "\nn,u,quasi_continuum\n-5,", 12},
             {"sec32_newton_breathers breather --centre bond --phase stretched --profile",
              "\nn,y,y_error\n-15,", 32},
             {"sec33_dps_stability spectrum --mu 10 --centre site --sites 21", "\nreal,imag,", 42},
             {"sec34_impact run --precompression 0.5 --sites 50 --time 20 --profile",
              "\nn,y,v,e\n1,", 50}};
  for (const auto& [command, names, rows] : all) check_rows(command, names, rows);
}

TEST_CASE("what a strong kick sheds and the ends send back is in the error", "[cli][kick]") {
  // From chains of 212 sites, from whose ends nothing has come back by then
  const std::pair<std::string, double> far[] = {
      {"--omega 2 --c 0.5", -8.0950373096}, {"--omega 1.8 --c 0.2 --centre site", -7.0425377916}};
  for (const auto& [kick, way] : far) {
    const Result r = call("sec33_mobility kick --time 1000 " + kick);
    CAPTURE(kick, r.output);
    check_close(quantity(r, "sites_travelled"), way, quantity(r, "sites_travelled", "error"));
  }
}

TEST_CASE("no error is zero by chance, or forgets how an option is rounded", "[cli]") {
  // A kick whose runs with the two shortest steps agree too well; the value from shorter steps
  const Result kick = call("sec33_mobility kick --centre site --omega 1.05 --c 1e-4 --time 3000");
  const double way = quantity(kick, "sites_travelled");
  check_close(way, -1.933421496708, quantity(kick, "sites_travelled", "error"));
  const Result breather =
      call("sec32_newton_breathers breather --centre site --omega 1.1 --contact power --alpha 2.8");
  for (const std::string name : {"amplitude", "energy", "area"})
    CHECK(quantity(breather, name, "error") > 0);
  // Of the exponents only the two zeros of the phase are exact
  for (const std::string chain :
       {"site --mu .37 --alpha 3 --sites 13", "bond --mu 2.1 --sites 12"}) {
    const Table table = table_of(call("sec33_dps_stability spectrum --centre " + chain));
    const auto error = table.numbers("error");
    CHECK(std::count(error.begin(), error.end(), 0.0) == 2);
  }
  // Large terms cancel at q = pi, and at a rounding of it nothing is left of them (the values from 50 digits)
  const std::string wave = "sec4_precompression_mi coefficients --d 1 --q 3.141592653589793 --s ";
  const Result zero = call(wave + "1");
  CHECK(std::abs(quantity(zero, "beta") - 1.62474e-32) < quantity(zero, "beta", "error"));
  CHECK(quantity(zero, "beta", "error") < 1e-14);
  CHECK(std::abs(quantity(zero, "group_velocity") - 6.943094730932493e-17) <
        quantity(zero, "group_velocity", "error"));
}

TEST_CASE("the program that judges says what it cannot use in one line", "[cli]") {
  Scratch scratch;
  for (const auto& [options, said] : std::vector<std::array<std::string, 2>>{
           {"--data nowhere", "--data: 'nowhere' is not a folder"},
           {"--root . --data .", "--root: '.' has no list of claims"},
           {"--dta .", "--dta: unknown option; did you mean --data?"}}) {
    check_refused(call_in(scratch.path, "verdicts " + options), said);
    CHECK_FALSE(fs::exists(scratch.path / "build"));
  }
}
