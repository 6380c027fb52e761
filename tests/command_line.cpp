// Programs as a reader meets them: help, bad input, failures, and what they leave behind.

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "check.hpp"
#include "report/checksum.hpp"
#include "report/table.hpp"
#include "run.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const std::string bin = word(BIN_DIR);

/// A fresh folder that goes away again.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("lattice cli " + std::to_string(::getpid()));
  Scratch() { fs::create_directories(path); }
  ~Scratch() { fs::remove_all(path); }
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      count += entry.is_regular_file();
    return count;
  }
};

}  // namespace

TEST_CASE("help and version", "[cli]") {
  const Result help = call("sec34_impact --help");
  CHECK(help.code == 0);
  CHECK(help.output.find("run") != std::string::npos);
  CHECK(call("sec34_impact run --help").output.find("--velocity") != std::string::npos);
  CHECK(call("sec34_impact --version").output.find("sec34_impact") == 0);
  CHECK(call("sec34_impact help").output == help.output);
  CHECK(call("sec34_impact help run").output == call("sec34_impact run --help").output);
  CHECK(call("sec34_impact run --help").output.find("--contact {hertz|power} ") !=
        std::string::npos);
  // That fractions are accepted is said once, and where there are numbers
  const std::string run = call("sec34_impact run --help").output, fraction = "such as -1/6";
  REQUIRE(run.find(fraction) != std::string::npos);
  CHECK(run.find(fraction, run.find(fraction) + 1) == std::string::npos);
  CHECK(call("sec5_enclosures dps --help").output.find(fraction) == std::string::npos);
}

TEST_CASE("bad input: one line, exit code 2, no file", "[cli]") {
  Scratch scratch;
  const std::string out = " --output " + word(scratch.path / "x.ecsv");
  struct Bad {
    std::string arguments, option;
  };
  for (const auto& [arguments, option] :
       std::vector<Bad>{{"sec34_impact run --s nan", "--s"},
                        {"sec34_impact run --s abc", "--s"},
                        {"sec34_impact run --velocity -1", "--velocity"},
                        {"sec34_impact run --velocity inf", "--velocity"},
                        {"sec34_impact run --time 1e12", "--time"},
                        {"sec34_impact run --sites 1", "--sites"},
                        {"sec34_impact run --sites 2.5", "--sites"},
                        {"sec34_impact run --precompression -0.5", "--precompression"},
                        {"sec34_impact run --onsite cubic", "--onsite"},
                        {"sec34_impact run --onsite pendulum --s 1", "--s"},
                        {"sec34_impact run --colour red", "--colour"},
                        {"sec34_impact run --velocity 1,5", "--velocity"},
                        {"sec34_kink run --patience 10", "--patience"},
                        {"sec31_dps_limit impact --tau nan", "--tau"},
                        {"sec31_dps_limit impact --tau 0", "--tau"},
                        {"sec31_dps_limit impact --sites 1", "--sites"},
                        {"sec31_dps_limit impact --end periodic", "--end"},
                        {"sec32_dps_profiles profile --mu 0", "--mu"},
                        {"sec32_dps_profiles profile --mu -1", "--mu"},
                        {"sec32_dps_profiles profile --mu nan", "--mu"},
                        {"sec32_dps_profiles profile --sites 1", "--sites"},
                        {"sec32_dps_profiles profile --centre site --sites 30", "--sites"},
                        {"sec32_dps_profiles profile --centre bond --sites 31", "--sites"},
                        {"sec32_dps_profiles profile --centre corner", "--centre"},
                        {"sec33_dps_stability spectrum --mu 0", "--mu"},
                        {"sec33_dps_stability spectrum --mu nan", "--mu"},
                        {"sec33_dps_stability spectrum --centre corner", "--centre"},
                        {"sec33_dps_stability spectrum --centre site --sites 30", "--sites"},
                        {"sec33_dps_stability spectrum --centre bond --sites 31", "--sites"},
                        {"sec33_dps_stability spectrum --sites 1e9", "--sites"},
                        {"sec33_mobility kick --c 0", "--c"},
                        {"sec33_mobility kick --c nan", "--c"},
                        {"sec33_mobility kick --time 1e9", "--time"},
                        {"sec33_mobility kick --omega 1", "--omega"},
                        {"sec33_mobility kick --phase upside", "--phase"},
                        {"sec33_mobility kick --centre bond --sites 31", "--sites"},
                        {"sec33_mobility kick --centre bond --sites 10", "--sites"},
                        {"sec33_mobility threshold --centre site", "--centre"},
                        {"sec33_mobility threshold --omega 0.9", "--omega"},
                        {"sec34_kink run --velocity 0", "--velocity"},
                        {"sec32_newton_breathers breather --omega 1", "--omega"},
                        {"sec32_newton_breathers breather --omega 0.9", "--omega"},
                        {"sec32_newton_breathers breather --omega nan", "--omega"},
                        {"sec32_barrier barrier --omega inf", "--omega"},
                        {"sec32_barrier barrier --s nan", "--s"},
                        {"sec32_newton_breathers breather --centre corner", "--centre"},
                        {"sec32_newton_breathers breather --centre site --sites 30", "--sites"},
                        {"sec32_newton_breathers breather --centre bond --sites 31", "--sites"},
                        {"sec32_newton_breathers breather --centre site --sites 9", "--sites"},
                        {"sec32_newton_breathers breather --sites 1e9", "--sites"},
                        {"sec32_newton_breathers breather --precision single", "--precision"},
                        {"sec32_newton_breathers breather --phase upside", "--phase"},
                        {"sec34_boomeron run --s -1", "--s"},
                        {"sec34_boomeron run --time 10", "--time"},
                        {"sec34_boomeron_map map --part 0/4", "--part"},
                        {"sec5_experiment damped --lifetime -1", "--lifetime"},
                        {"sec5_experiment damped --velocity 0", "--velocity"},
                        {"sec5_experiment damped --restitution 1.1", "--restitution"},
                        {"sec5_driving drive --amplitude -1", "--amplitude"},
                        {"sec5_driving drive --frequency 50000", "--frequency"},
                        {"sec5_driving drive --time 5", "--time"},
                        {"sec5_driving drive --by hand", "--by"},
                        {"sec5_driving drive --lifetime 0", "--lifetime"},
                        {"sec5_driving chart --part 5/4", "--part"},
                        {"sec5_driving drive --amplitude nan", "--amplitude"},
                        {"sec5_growth growth --q 0", "--q"},
                        {"sec5_growth growth --q 3.2", "--q"},
                        {"sec5_growth growth --q nan", "--q"},
                        {"sec5_growth growth --modulation -1", "--modulation"},
                        {"sec5_growth growth --modulation 4", "--modulation"},
                        {"sec5_growth growth --amplitude -1", "--amplitude"},
                        {"sec5_growth growth --amplitude 0", "--amplitude"},
                        {"sec36_cantilever_defect run --ratio -1", "--ratio"},
                        {"sec36_cantilever_defect run --sites 50", "--sites"},
                        {"sec36_cantilever_defect run --radius -1", "--radius"},
                        {"sec36_cantilever_defect run --radius nan", "--radius"},
                        {"sec36_cantilever_defect map --part 5/4", "--part"},
                        {"sec36_cantilever_defect scales --radius 1", "--radius"},
                        {"sec4_precompression_mi coefficients --q 3.2", "--q"},
                        {"sec4_precompression_mi coefficients --q nan", "--q"},
                        {"sec4_precompression_mi coefficients --d 0", "--d"},
                        {"sec4_precompression_mi band --d -0.5", "--d"},
                        {"sec4_precompression_mi impact --time 0", "--time"},
                        {"sec4_precompression_mi impact --s inf", "--s"},
                        {"sec4_precompression_mi ring --waves 100", "--waves"},
                        {"sec5_travelling_breathers orbit --k 0", "--k"},
                        {"sec5_travelling_breathers orbit --k 61", "--k"},
                        {"sec5_travelling_breathers orbit --k 1.5", "--k"},
                        {"sec5_travelling_breathers orbit --sign both", "--sign"},
                        {"sec5_travelling_breathers orbit --s nan", "--s"},
                        {"sec5_travelling_breathers orbit --near 6", "--near"},
                        {"sec5_travelling_breathers orbit --near 1e9", "--near"},
                        {"sec5_travelling_breathers orbit --near 6 --k 1", "--near"},
                        {"sec5_travelling_breathers orbit --reach 3", "--reach"},
                        {"sec5_travelling_breathers orbit --s 1", "--s"},
                        {"sec5_kernel_equation wave --k 0", "--k"},
                        {"sec5_kernel_equation wave --k 1.5", "--k"},
                        {"sec5_kernel_equation wave --k 13", "--k"},
                        {"sec5_kernel_equation wave --sign both", "--sign"},
                        {"sec5_kernel_equation wave --alpha 1", "--alpha"},
                        {"sec5_kernel_equation wave --alpha 8.1", "--alpha"},
                        {"sec5_kernel_equation wave --alpha nan", "--alpha"},
                        {"sec5_kernel_equation wave --alpha 1e9", "--alpha"},
                        {"sec5_enclosures dps --centre corner", "--centre"},
                        {"sec5_enclosures breather --centre between", "--centre"},
                        {"sec5_enclosures breather --omega 1.2", "--omega"},
                        {"sec5_enclosures wave --sign both", "--sign"},
                        {"sec5_enclosures wave --k 2", "--k"}}) {
    CAPTURE(arguments);
    const Result r = call(arguments + out);
    CAPTURE(r.errors);
    CHECK(r.code == 2);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find(option) != std::string::npos);
    CHECK(r.output.empty());
    CHECK(scratch.files() == 0);
  }
}

TEST_CASE("a wrong value is answered with the allowed range", "[cli]") {
  struct Bad {
    std::string arguments, option, range;
  };
  const std::string run = "sec34_impact run ";
  for (const auto& [arguments, option, range] :
       std::vector<Bad>{{run + "--sites 2.5", "--sites", "[2, 1000000]"},
                        {run + "--sites abc", "--sites", "[2, 1000000]"},
                        {run + "--sites ''", "--sites", "[2, 1000000]"},
                        {run + "--sites 0x20", "--sites", "[2, 1000000]"},
                        {run + "--sites 1e7", "--sites", "[2, 1000000]"},
                        {run + "--s 1e", "--s", "[-10, 10]"},
                        {run + "--s nan", "--s", "[-10, 10]"},
                        {run + "--s --4", "--s", "[-10, 10]"},
                        {run + "--s 0x1p3", "--s", "[-10, 10]"},
                        {run + "--threads 0", "--threads", "[1, 1024]"},
                        {run + "--threads 1.5", "--threads", "[1, 1024]"},
                        {"sec34_impact --threads many", "--threads", "[1, 1024]"},
                        {run + "--onsite cubic", "--onsite", "quartic"}}) {
    const Result r = call(arguments);
    CAPTURE(arguments, r.errors);
    CHECK(r.code == 2);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find(option) != std::string::npos);
    CHECK(r.errors.find(range) != std::string::npos);
  }
}

TEST_CASE("numbers are decimal, and whole ones may be written as help writes them", "[cli]") {
  const auto rows = [](const std::string& sites) {
    const Result r = call("sec32_dps_profiles profile --centre site --sites " + sites);
    CAPTURE(sites, r.errors);
    REQUIRE(r.code == 0);
    std::istringstream in(r.output);
    return from_text(in).rows.size();
  };
  CHECK(rows("031") == 31);
  CHECK(rows("31.0") == 31);
  CHECK(rows("3.1e+01") == 31);
  CHECK(rows("+31") == 31);
  const std::string sites = "sec34_impact run --velocity 1 --time 20 --sites ";
  const Result big = call(sites + "1e+06"), plain = call(sites + "1000000");
  CHECK(big.code == 0);
  CHECK(quantity(big, "centre") == quantity(plain, "centre"));
}

TEST_CASE("an option of the full run is not swallowed by a subcommand", "[cli]") {
  Scratch scratch;
  for (const std::string& option : {std::string("--quick"), "--out " + word(scratch.path / "a")}) {
    const Result r = call("sec34_impact " + option + " run --velocity 1 --time 20");
    CAPTURE(option, r.errors);
    CHECK(r.code == 2);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find(option.substr(0, 5)) != std::string::npos);
    CHECK(r.errors.find("'run'") != std::string::npos);
    CHECK(r.output.empty());
  }
  CHECK(scratch.files() == 0);
}

TEST_CASE("a name that the system refuses is bad input", "[cli]") {
  Scratch scratch;
  for (const std::string& name : {std::string(300, 'x'), std::string(252, 'x')}) {
    const Result r =
        call("sec34_impact run --velocity 1 --time 20 --output " + word(scratch.path / name));
    CAPTURE(r.errors);
    CHECK(r.code == 2);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find("sec34_impact: --output: ") == 0);
    CHECK(r.errors.find("filesystem") == std::string::npos);
  }
  CHECK(call("sec34_impact --out " + word(scratch.path / std::string(300, 'x'))).code == 2);
  CHECK(scratch.files() == 0);
}

TEST_CASE("help shows the default of every option and what nan means", "[cli]") {
  const struct {
    const char *command, *option, *value;
  } shown[] = {{"sec34_impact run", "--velocity", "1.87"},
               {"sec34_impact run", "--onsite", "quartic"},
               {"sec34_impact run", "--sites", "as long as needed"},
               {"sec34_impact run", "--output", "standard output"},
               {"sec32_dps_profiles profile", "--mu", "1"},
               {"sec34_impact", "--out",
                "build/data/sec34_impact, with --quick build/quick/data/sec34_impact"}};
  for (const auto& [command, option, value] : shown) {
    CAPTURE(command, option);
    std::istringstream help(call(std::string(command) + " --help").output);
    std::string text, line;
    for (bool here = false; std::getline(help, line);) {
      const auto at = line.find_first_not_of(' ');
      if (at != std::string::npos && line[at] == '-')
        here = line.compare(at, std::string(option).size() + 1, std::string(option) + " ") == 0;
      if (here) text += line.substr(at == std::string::npos ? 0 : at) + " ";
    }
    CHECK(text.find("(default: " + std::string(value) + ")") != std::string::npos);
  }
  for (const char* command : {"sec34_impact run", "sec31_dps_limit impact"})
    CHECK(call(std::string(command) + " --help").output.find("is nan, and its reason says why") !=
          std::string::npos);
}

TEST_CASE("the header records every parameter with the value used", "[cli]") {
  const auto header = [](const std::string& command, const std::string& key) {
    const Result r = call(command);
    CAPTURE(command, r.errors);
    REQUIRE(r.code == 0);
    std::istringstream in(r.output);
    for (const auto& [name, value] : from_text(in).meta)
      if (name == key) return value;
    return std::string("no entry");
  };
  const std::string run = "sec34_impact run --velocity 1.50 --time 2e1";
  const std::string used = header(run, "parameters");
  CAPTURE(used);
  for (const char* part : {"velocity = 1.5", "time = 20", "s = ", "onsite = quartic",
                           "sites = ", "precompression = 0", "tolerance = ", "profile = no"})
    CHECK(used.find(part) != std::string::npos);
  CHECK(used.find("threads") == std::string::npos);
  CHECK(header(run + " --threads 2", "command") == run);
  CHECK(header(run + " --threads=2", "command") == run);
  CHECK(header("sec34_impact run '--onsite' \"quartic\" --time '2e1'", "command") ==
        "sec34_impact run --onsite quartic --time 2e1");
  for (const char* name : {"GSL ", "Eigen ", "Boost "})
    CHECK(header(run, "libraries").find(name) != std::string::npos);
  CHECK(header(run, "seed") != "no entry");
  CHECK(header(run, "build").find("-O") != std::string::npos);
  CHECK(header("sec32_dps_profiles profile --mu 2", "parameters").find("centre = site, mu = 2") ==
        0);
}

TEST_CASE("an argument with a line break stays on its line of the header", "[cli]") {
  Scratch scratch;
  const fs::path path = scratch.path / "two\nlines.ecsv";
  REQUIRE(call("sec32_dps_profiles profile --output " + word(path)).code == 0);
  const Table table = read(path);
  CHECK(table.rows.size() == 31);
  for (const auto& [key, value] : table.meta)
    if (key == "command") CHECK(value.find("two\\x0alines") != std::string::npos);
}

TEST_CASE("no number of threads changes a bit", "[cli]") {
  Scratch scratch;
  const auto bytes = [&](const std::string& options) {
    const fs::path out = scratch.path / "out";
    fs::remove_all(out);
    REQUIRE(std::system(("cd " + word(scratch.path) + " && " + bin +
                         "/sec34_kink --quick --out out " + options + " 2>/dev/null")
                            .c_str()) == 0);
    std::string all;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(out)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      std::ifstream in(file, std::ios::binary);
      std::stringstream text;
      text << in.rdbuf();
      all += file.filename().string() + text.str();
    }
    return all;
  };
  const std::string one = bytes("--threads 1");
  CHECK(one.size() > 1000);
  CHECK(one == bytes("--threads 3"));
  CHECK(one == bytes(""));
}

TEST_CASE("coarse tables do not come into the place of full ones", "[cli]") {
  Scratch scratch;
  const auto run = [&](const std::string& options) {
    return call_in(scratch.path, "sec32_dps_profiles --threads 1 " + options);
  };
  const auto is_quick = [&](const std::string& folder) {
    for (const auto& [key, value] : read(scratch.path / folder / "results.ecsv").meta)
      if (key == "parameters") return value;
    return std::string("no entry");
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
  CAPTURE(refused.errors);
  CHECK(refused.code == 2);
  CHECK(refused.error_lines() == 1);
  CHECK(refused.errors.find("--out: '" + full + "' holds the tables of a full run") !=
        std::string::npos);
  CHECK(refused.errors.find("(allowed: another folder, such as " + quick + ")") !=
        std::string::npos);
  CHECK(altered_tables(scratch.path / full).empty());
  CHECK(is_quick(full) == "quick = no");
  // Into a coarse folder both may go
  REQUIRE(run("--quick").code == 0);
  REQUIRE(run("--out " + quick).code == 0);
  CHECK(is_quick(quick) == "quick = no");
}

TEST_CASE("a run that is killed leaves no table", "[cli]") {
  Scratch scratch;
  const std::string command =
      "timeout -s KILL 0.3 " + bin + "/sec34_impact --out " + word(scratch.path) + " 2>/dev/null";
  CHECK(std::system(command.c_str()) != 0);
  for (const auto& entry : fs::directory_iterator(scratch.path))
    CHECK(entry.path().extension() != ".ecsv");
}

TEST_CASE("an unwritable place is refused before computing", "[cli]") {
  for (const char* arguments : {"sec34_impact --out /proc/nowhere", "sec34_kink --out /dev/null/x",
                                "sec34_impact run --output /proc/nowhere/x.ecsv"}) {
    const Result r = call(arguments);
    CAPTURE(arguments, r.errors);
    CHECK(r.code == 2);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find("--out") != std::string::npos);
  }
}

TEST_CASE("a folder, a device and a closed output are told apart", "[cli]") {
  Scratch scratch;
  const std::string run = "sec34_impact run --velocity 1 --time 20";
  const Result folder = call(run + " --output " + word(scratch.path));
  CHECK(folder.code == 2);
  CHECK(folder.error_lines() == 1);
  CHECK(call(run + " --output ''").code == 2);
  CHECK(call(run + " --output /dev/null").code == 0);
  CHECK(fs::is_character_file("/dev/null"));
  CHECK(call(run + " > /dev/full").code == 1);
  CHECK(scratch.files() == 0);
}

TEST_CASE("a short chain does not spoil the speed", "[cli]") {
  const std::string run = "sec34_impact run --velocity 1.87 --s -0.1667 --time 587 --sites ";
  const Result small = call(run + "80"), large = call(run + "82");
  check_close(quantity(small, "speed"), quantity(large, "speed"), 0, 0.01);
  CHECK(quantity(small, "speed") > 0.19);
}

TEST_CASE("what does not exist has a reason", "[cli]") {
  const struct {
    const char *command, *quantity, *reason;
  } all[] = {
      {"sec34_impact run --velocity 1 --sites 2 --time 20", "speed",
       "the way from site 20 to twenty sites before the far end is empty: it takes more than 40 "
       "sites"},
      {"sec34_impact run --sites 5 --time 5", "strongest_site",
       "the chain has no site beyond the first five"},
      {"sec34_impact run --time 20", "speed",
       "no packet comes to site 20: the foremost one comes to"},
      {"sec34_impact run --time 20", "peak_energy_density",
       "% of the energy stays on the first 5 sites"},
      {"sec31_dps_limit impact --tau 40 --sites 60", "speed",
       "% of the norm stays on the first 10 sites"},
      {"sec31_dps_limit impact --tau 10 --sites 30", "speed", "is empty"},
      {"sec33_mobility kick --c 1e-6 --time 2000", "velocity", "sites, less than one"},
      {"sec33_mobility kick --c 0.05 --omega 1.2 --sites 24 --time 1000", "velocity",
       "averaged four times over eleven periods"},
      {"sec34_boomeron run --time 60", "apex_site", "not come back by five sites by t = 60"},
      {"sec34_boomeron run --time 60", "return_time", "not come back by five sites by t = 60"},
      {"sec34_boomeron run --time 60", "decorrelation_time", "have not parted by t = 240"},
      {"sec4_precompression_mi ring --longest 200", "gathered",
       "the energy has not gathered by t = 200"},
      {"sec4_precompression_mi ring --longest 200", "width",
       "the energy has not gathered by t = 200"},
      {"sec4_precompression_mi impact --velocity 20 --d 10 --s 10 --time 60", "width",
       "beyond the 21 sites of the fit"},
      {"sec4_precompression_mi band --s 0.3", "unstable_to", ""},
      {"sec5_growth growth --q 1", "edge", "the wave is stable: no modulation of it grows"}};
  for (const auto& [command, name, reason] : all) {
    const Result answer = call(command);
    CAPTURE(command, name, answer.output, answer.errors);
    REQUIRE(answer.code == 0);
    const std::string said = text_of(answer, name, "reason");
    CHECK(std::isnan(quantity(answer, name)) == (*reason != '\0'));
    CHECK(said.empty() == (*reason == '\0'));
    CHECK(said.find(reason) != std::string::npos);
  }
}

TEST_CASE("an error beyond its value is a failure", "[cli]") {
  const Result r = call("sec4_precompression_mi impact --d 0.001 --time 2000");
  CAPTURE(r.errors, r.output);
  CHECK(r.code == 1);
  CHECK(r.output.empty());
  CHECK(r.error_lines() == 1);
  CHECK(r.errors.find("centre: the error ") != std::string::npos);
  CHECK(r.errors.find("take a --time at which") != std::string::npos);
}

TEST_CASE("what the reader has typed is named where a run does not succeed", "[cli]") {
  const struct {
    const char *command, *said;
  } all[] = {
      {"sec36_cantilever_defect run --sites 120", "--sites 120 are too few"},
      {"sec5_driven_packets packet --strength 0.5", "packet 1 has not passed the beads 12 to 28"}};
  for (const auto& [command, said] : all) {
    const Result r = call(command);
    CAPTURE(command, r.errors);
    CHECK(r.code == 1);
    CHECK(r.error_lines() == 1);
    CHECK(r.errors.find(said) != std::string::npos);
  }
  const Result hard = call("sec34_boomeron run --velocity 100 --s 1000 --time 50");
  CAPTURE(hard.errors);  // once: a path needs at least three samples
  CHECK(hard.code == 0);
}

TEST_CASE("a runaway is a failure, not a number", "[cli]") {
  Scratch scratch;
  const Result r = call("sec34_impact run --s -0.7 --velocity 1.3 --time 100 --output " +
                        word(scratch.path / "x.ecsv"));
  CHECK(r.code == 1);
  CHECK(r.error_lines() == 1);
  CHECK(r.errors.find("a bead runs away at t = 8.19") != std::string::npos);
  CHECK(r.errors.find("threshold") == std::string::npos);
  CHECK(scratch.files() == 0);
}

TEST_CASE("a breather beyond the fold of its family is a failure", "[cli]") {
  Scratch scratch;
  const Result r = call("sec32_newton_breathers breather --omega 2 --s -1 --output " +
                        word(scratch.path / "x.ecsv"));
  CHECK(r.code == 1);
  CHECK(r.error_lines() == 1);
  CHECK(r.errors.find("turns back near 1.6") != std::string::npos);
  CHECK(scratch.files() == 0);
}

TEST_CASE("a kick that breaks the breather up is a failure", "[cli]") {
  Scratch scratch;
  const Result r = call("sec33_mobility kick --c 0.5 --output " + word(scratch.path / "x.ecsv"));
  CHECK(r.code == 1);
  CHECK(r.error_lines() == 1);
  CHECK(r.errors.find("breaks up") != std::string::npos);
  CHECK(scratch.files() == 0);
}

TEST_CASE("kick reports the contract's quantities", "[cli]") {
  const Result r = call("sec33_mobility kick --centre bond --phase stretched --c 2e-4 --time 8000");
  REQUIRE(r.code == 0);
  check_close(quantity(r, "velocity"), -5.363e-4, 0, 1e-3);
  CHECK(quantity(r, "drift") < 1e-8);
  check_close(quantity(r, "sites_travelled"), -4.25, 0.06);
  const Result still = call("sec33_mobility kick --c 1e-6 --time 2000");
  REQUIRE(still.code == 0);
  CHECK(std::isnan(quantity(still, "velocity")));
}

TEST_CASE("breather and barrier report the contract's quantities", "[cli]") {
  const Result r =
      call("sec32_newton_breathers breather --centre site --omega 1.1 --s 0 --sites 31");
  REQUIRE(r.code == 0);
  check_close(quantity(r, "amplitude"), 0.01074795250745621, 0, 1e-12);
  check_close(quantity(r, "energy"), 1.5359852004088633e-4, 0, 1e-12);
  check_close(quantity(r, "area"), 8.9264257072819404e-4, 0, 1e-12);
  CHECK(quantity(r, "energy", "error") < 1e-12 * quantity(r, "energy"));
  CHECK(quantity(r, "residual") < 1e-13);
  CHECK(quantity(r, "iterations") <= 6);
  const Result b = call("sec32_barrier barrier --omega 1.1 --s 0");
  REQUIRE(b.code == 0);
  check_close(quantity(b, "equal_frequency"), 1.62422472e-11, 0, 1e-8);
  check_close(quantity(b, "equal_area"), -2.35229159e-13, 0, 1e-7);
  const Result p =
      call("sec32_newton_breathers breather --centre bond --phase stretched --profile");
  REQUIRE(p.code == 0);
  CHECK(p.output.find("\nn,y\n-15,") != std::string::npos);
  CHECK(p.output.find("\n1,0.0101305") != std::string::npos);
}

TEST_CASE("a modulated wave and a drive report the contract's quantities", "[cli]") {
  const Result r = call("sec5_growth growth --modulation 0.8410686705679303");
  REQUIRE(r.code == 0);
  check_close(quantity(r, "growth"), 0.3736744433810828, 0, 1e-12);
  check_close(quantity(r, "fastest_growth"), 0.3736744433810828, 0, 1e-12);
  check_close(quantity(r, "edge"), 1.230959417340775, 0, 1e-12);
  check_close(quantity(r, "frequency"), -1.8306234324043515, 0, 1e-12);
  CHECK(quantity(r, "growth", "error") < 1e-14);
  const Result stable = call("sec5_growth growth --q 1.5");
  REQUIRE(stable.code == 0);
  CHECK(quantity(stable, "growth") == 0);
  CHECK(std::isnan(quantity(stable, "edge")));
  const Result drive = call("sec5_driving drive --amplitude 20 --time 20");
  REQUIRE(drive.code == 0);
  CHECK(quantity(drive, "outcome") == 1);
  CHECK(quantity(drive, "budget") > 0);
  CHECK(quantity(drive, "budget") < 1e-10);
  CHECK(quantity(drive, "power", "error") > 0);
}

TEST_CASE("exact travelling breathers report the contract's quantities", "[cli]") {
  const Result r = call("sec5_travelling_breathers orbit --k 1 --sign plus --s 0");
  REQUIRE(r.code == 0);
  check_close(quantity(r, "shift_time"), 6.283185307179586, 0, 1e-14);
  check_close(quantity(r, "energy"), 0.180833513579908, 0, 1e-12);
  check_close(quantity(r, "speed"), 0.159154943091895, 0, 1e-12);
  CHECK(quantity(r, "peak") > 0);
  CHECK(quantity(r, "tail") < 1e-11);
  CHECK(quantity(r, "residual") < 1e-13);
  CHECK(quantity(r, "multiplier_modulus") == 1);
  const Result m = call("sec5_travelling_breathers orbit --sign minus");
  REQUIRE(m.code == 0);
  check_close(quantity(m, "multiplier_modulus") - 1, 1.8856e-5, 1e-8);
  const Result near = call("sec5_travelling_breathers orbit --near 5.6");
  REQUIRE(near.code == 0);
  check_close(quantity(near, "shift_time"), 5.63857165159, 0, 1e-10);
  const Result hard = call("sec5_travelling_breathers orbit --k 3 --s 1 --profile");
  REQUIRE(hard.code == 0);
  CHECK(hard.output.find("\nn,y,v\n-8,") != std::string::npos);
  CHECK(call("sec5_travelling_breathers orbit --s 1").errors.find("folds") != std::string::npos);
}

TEST_CASE("a wave of the kernel equation reports the contract's quantities", "[cli]") {
  const Result plus = call("sec5_kernel_equation wave --k 1 --sign plus"),
               minus = call("sec5_kernel_equation wave --k 1 --sign minus --alpha 3/2");
  REQUIRE(plus.code == 0);
  REQUIRE(minus.code == 0);
  check_close(quantity(plus, "energy"), 0.180833513579908, 0, 1e-11);
  check_close(quantity(minus, "energy"), 0.180833513658335, 0, 1e-11);
  CHECK(quantity(plus, "contacts") == 18);
  CHECK(quantity(minus, "contacts") == 17);
  check_close(quantity(plus, "action"), 0.486064036495, 0, 1e-11);
  check_close(quantity(plus, "quotient"), 1.155210964204, 0, 1e-11);
  check_close(quantity(plus, "peak"), 0.44625, 1e-5);
  CHECK(quantity(plus, "residual") < 1e-14);
}

TEST_CASE("run reports the contract's quantities with errors", "[cli]") {
  const Result r = call("sec34_impact run --velocity 0.94 --s -0.7 --time 300");
  REQUIRE(r.code == 0);
  for (const char* name :
       {"speed", "centre", "strongest_site", "peak_energy_density", "packet_energy_fraction",
        "boundary_energy_fraction", "energy_drift", "escaped"}) {
    CAPTURE(name);
    CHECK(std::isfinite(quantity(r, name)));
    CHECK(std::isfinite(quantity(r, name, "error")));
  }
  CHECK(quantity(r, "boundary_energy_fraction") > 0.5);
  CHECK(quantity(r, "energy_drift") < 1e-5);
  CHECK(quantity(r, "escaped") == 0);
  CHECK(call("sec34_impact run --velocity 5 --onsite pendulum --time 60").code == 0);
  CHECK(call("sec34_impact run --velocity 1 --precompression 0.5 --time 60 --profile")
            .output.find("n,y,v,e") != std::string::npos);
}

TEST_CASE("the DpS impact agrees with the impact chapter", "[cli]") {
  const Result r = call("sec31_dps_limit impact --tau 250");
  REQUIRE(r.code == 0);
  for (const char* name : {"centre", "speed", "amplitude", "norm_window", "residual_boundary"}) {
    CAPTURE(name);
    CHECK(std::isfinite(quantity(r, name)));
    CHECK(quantity(r, name, "error") < 1e-3 * quantity(r, name));
  }
  const Table facts = read(fs::path(DATA_DIR) / "sec34_dps_impact/facts.ecsv");
  const auto names = facts.texts("quantity");
  const auto values = facts.numbers("value");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == "dps_speed") check_close(quantity(r, "speed"), values[i], 0, 1e-4);
    if (names[i] == "dps_packet_norm") check_close(quantity(r, "norm_window"), values[i], 0, 1e-6);
  }
  const Result fixed = call("sec31_dps_limit impact --tau 250 --end fixed");
  CHECK(quantity(fixed, "amplitude") > 1.2 * quantity(r, "amplitude"));
}

TEST_CASE("phonons and compressed impacts report the contract's quantities", "[cli]") {
  const Result c = call("sec4_precompression_mi coefficients --q 0.7853981633974483 --d 0.5 --s 0");
  REQUIRE(c.code == 0);
  check_close(quantity(c, "omega"), 1.2731, 1e-3);
  check_close(quantity(c, "phi"), -quantity(c, "beta") * quantity(c, "omega_2"), 1e-15);
  CHECK(quantity(c, "group_velocity") > 0.5);
  const Result b = call("sec4_precompression_mi band --d 0.5 --s 1");
  REQUIRE(b.code == 0);
  CHECK(quantity(b, "lower_edge") == 1);
  check_close(quantity(b, "upper_edge"), std::sqrt(1 + 6 * std::sqrt(0.5)), 1e-14);
  check_close(quantity(b, "phi_at_0"), -1.5, 1e-14);
  check_close(quantity(b, "unstable_from"), quantity(b, "inflection"), 1e-14);
  check_close(quantity(b, "unstable_to"), 2.0068, 5e-5);
  const Result i = call("sec4_precompression_mi impact --s 1 --time 724");
  REQUIRE(i.code == 0);
  for (const char* name : {"centre", "width", "energy_fraction"}) {
    CAPTURE(name);
    CHECK(quantity(i, name) > 0);
    CHECK(quantity(i, name, "error") < 1e-3 * quantity(i, name));
  }
  check_close(quantity(i, "centre"), 439.4, 0.5);
  CHECK(call("sec4_precompression_mi impact --s -0.7 --velocity 9 --time 60").code == 1);
}

TEST_CASE("a profile has one row a site", "[cli]") {
  for (const char* options : {"--centre bond --sites 12 --mu 2", "--centre site --sites 13"}) {
    const Result r = call(std::string("sec32_dps_profiles profile ") + options);
    REQUIRE(r.code == 0);
    std::istringstream in(r.output);
    const Table t = from_text(in);
    CHECK(r.output.find("\nn,u,quasi_continuum\n") != std::string::npos);
    CHECK(t.rows.size() == (std::string(options).find("12") != std::string::npos ? 12 : 13));
  }
}

TEST_CASE("the same command gives the same bytes", "[cli]") {
  const std::string command = "sec34_impact run --velocity 1.5 --time 150 --profile";
  CHECK(call(command).output == call(command).output);
}

TEST_CASE("the inner loop has the same bits at every vector width", "[cli]") {
  const Result wide = call("fingerprint_wide"), scalar = call("fingerprint_scalar");
  REQUIRE(wide.code == 0);
  REQUIRE(scalar.code == 0);
  CHECK(wide.output.size() > 200);
  CHECK(wide.output == scalar.output);
}

TEST_CASE("the spectrum of a DpS breather", "[cli]") {
  for (const std::string centre : {"site", "bond"}) {
    const Result r = call("sec33_dps_stability spectrum --mu 10 --centre " + centre +
                          (centre == "site" ? " --sites 21" : " --sites 20"));
    CAPTURE(centre, r.errors);
    REQUIRE(r.code == 0);
    std::istringstream in(r.output);
    const Table table = from_text(in);
    const auto re = table.numbers("real"), im = table.numbers("imag"), off = table.numbers("error");
    REQUIRE(re.size() == (centre == "site" ? 42 : 40));
    std::size_t growing = 0;
    for (std::size_t i = 0; i < re.size(); ++i) {
      growing += re[i] > 0;
      CHECK(std::hypot(re[i], im[i]) <= 10 * (1 + 1e-15));
      CHECK(off[i] < 1e-9);
    }
    CHECK(growing == (centre == "site"));
    check_close(re[2], centre == "site" ? 0.015577076044674 : 0, 1e-14);
  }
}

TEST_CASE("a number may be a fraction", "[cli]") {
  const std::string run = "sec4_precompression_mi coefficients --d 1/2 --s ";
  CHECK(rows(run + "-1/6 --q 3/4") == rows(run + "-0.16666666666666666 --q 0.75"));
  CHECK(rows("sec32_dps_profiles profile --centre site --sites 62/2") ==
        rows("sec32_dps_profiles profile --centre site --sites 31"));
  const Result r = call(run + "-1/6");
  CHECK(r.output.find("s = -0.16666666666666666") != std::string::npos);  // the decimal used
  CHECK(r.output.find("--s -1/6") != std::string::npos);                  // the line typed
  for (const char* bad : {"1/0", "1/", "/2", "1/2/3", "a/b", "1 /2"})
    check_refused(run + "'" + bad + "'", "--s: '" + std::string(bad) + "' is not a number");
  check_refused(run + "401/4", "'401/4' is not in the allowed range [-100, 100]");
}

TEST_CASE("an option takes no other option for its value", "[cli]") {
  check_refused("sec34_impact run --output --profile", "--output: needs a value");
  check_refused("sec34_impact --out --bogus", "--out: needs a value");
  check_refused("sec34_impact run --velocity", "--velocity: needs a value (allowed: [1e-06, 100])");
  check_refused("sec34_impact run --onsite --s 1", "allowed: none, harmonic, quartic");
  check_refused("sec34_impact run --output=", "--output: needs a value");
  check_refused("sec34_impact run --onsite -v", "--onsite: needs a value");
  CHECK_FALSE(fs::exists("--profile"));
  CHECK_FALSE(fs::exists("--bogus"));
  CHECK(call("sec4_precompression_mi band --s -.5").code == 0);
  CHECK(call("sec4_precompression_mi band --s=-.5").code == 0);
}

TEST_CASE("every complaint about the line is one of ours", "[cli]") {
  const std::string run = "sec34_impact run ";
  const struct {
    std::string arguments, complaint;
  } lines[] = {
      {run + "2 --velocty 3", "'2': belongs to no option (allowed: --output, "},
      {run + "--velocty 3", "--velocty: there is no such option; did you mean --velocity?"},
      {run + "--veloc=3", "did you mean --velocity?"},
      {run + "--zzzzzz 3", "--zzzzzz: there is no such option (allowed: --output, "},
      {run + "--quick", "--quick: belongs to a full run, without a command"},
      {run + "run", "'run': there is a command already"},
      {run + "--s 1 --s 2", "--s: given twice, '1' and '2'"},
      {run + "--profile=yes", "--profile: takes no value, but got 'yes'"},
      {run + "-profile", "'-profile': an option has two dashes"},
      {run + "--", "'--': an option has two dashes"},
      {"sec34_impact rum", "'rum': there is no such command; did you mean 'run'? (allowed: run)"},
      {"sec34_impact rnu", "did you mean 'run'?"},
      {"sec33_mobility kikc", "did you mean 'kick'?"},
      {"sec34_impact --velocity 1", "--velocity: belongs to 'run'"},
      {"sec34_impact fly", "'fly': there is no such command (allowed: run)"},
      {"sec36_cantilever_defect scale", "did you mean 'scales'? (allowed: run, scales, map)"},
      {"sec2_nonexistence run", "'run': belongs to no option, and there are no commands"},
      {"sec5_travelling_breathers orbit --near 6 --k 1",
       "--near: '6' cannot be together with --k (allowed: one of the two)"},
      {"sec34_impact --quik", "did you mean --quick?"}};
  for (const auto& [arguments, complaint] : lines) {
    check_refused(arguments, complaint);
    const std::string errors = call(arguments).errors;
    for (const char* foreign : {"required", "UINT", "FLOAT", "TEXT", "expected", "Run with --help"})
      CHECK(errors.find(foreign) == std::string::npos);
  }
}

TEST_CASE("help says how long a full run takes", "[cli]") {
  const Table costs = read(fs::path(SOURCE_DIR) / "bench/costs.ecsv");
  for (const std::string& program : costs.texts("program")) {
    const std::string help = call(program + " --help").output;
    CAPTURE(program, help);
    CHECK(help.find("A full run takes ") != std::string::npos);
  }
  CHECK(call("sec34_impact run --help").output.find("A full run takes") == std::string::npos);
}

TEST_CASE("a map with a bad folder is refused", "[cli]") {
  for (const char* program : {"sec34_boomeron_map", "sec36_cantilever_defect"})
    for (const char* folder : {"/proc/nowhere", "/dev/null/x", "''"}) {
      const std::string command = std::string(program) + " map --folder " + folder;
      check_refused(command, "--folder: ");
      CHECK(call(command).errors.find("filesystem error") == std::string::npos);
    }
}

TEST_CASE("old names of options keep working", "[cli]") {
  const std::string run = "sec36_cantilever_defect run --velocity 1 --", old = "radius 1.3";
  CHECK(rows(run + old) == rows(run + "ratio 1.3"));
  CHECK(call(run + old).output.find("ratio = 1.3") != std::string::npos);
  CHECK(call("sec36_cantilever_defect run --help").output.find("--radius") == std::string::npos);
  check_refused(run + "radius 1 --ratio 2", "--ratio: given twice");
}

TEST_CASE("facts and results name the function that made them", "[cli]") {
  Scratch scratch;
  REQUIRE(call("sec34_kink --quick --out " + word(scratch.path)).code == 0);
  for (const char* table : {"facts.ecsv", "results.ecsv"}) {
    const Table made = read(scratch.path / table);
    CHECK(made.columns.back().name == "made_by");
    REQUIRE_FALSE(made.rows.empty());
    std::set<std::string> functions;
    for (const std::string& function : made.texts("made_by")) functions.insert(function);
    CHECK(functions == std::set<std::string>{"report_confinement", "reproduce"});
  }
  const Result printed = call("sec34_kink run --velocity 2");
  CHECK(printed.output.find("\nquantity,value,error,unit,kind,meaning,reason\n") !=
        std::string::npos);
}

/// The commands that a program offers.
static std::vector<std::string> commands_of(const std::string& program) {
  std::istringstream help(call(program + " --help").output);
  std::vector<std::string> names;
  bool here = false;
  for (std::string line; std::getline(help, line); here = here && !line.empty()) {
    if (here && line.size() > 2 && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    here = here || line.rfind("Commands", 0) == 0;
  }
  return names;
}

TEST_CASE("every quantity of every command says what it is", "[cli]") {
  // How a command is called, so that it takes a moment; those of no entry print no quantities
  const std::map<std::string, std::string> asks{
      {"sec31_dps_limit impact", "--tau 10"},
      {"sec32_barrier barrier", ""},
      {"sec32_newton_breathers breather", ""},
      {"sec33_floquet exchange", "--omega 1.3"},
      {"sec33_mobility kick", "--c 1e-4 --time 1000"},
      {"sec33_mobility threshold", "--centre bond --omega 1.8"},
      {"sec34_boomeron run", "--time 60"},
      {"sec34_impact run", "--time 20"},
      {"sec34_kink run", "--velocity 2"},
      {"sec36_cantilever_defect run", ""},
      {"sec4_precompression_mi coefficients", ""},
      {"sec4_precompression_mi band", "--s -4"},
      {"sec4_precompression_mi impact", "--time 20"},
      {"sec4_precompression_mi ring", "--longest 200"},
      {"sec5_driven_packets packet", "--strength 0"},
      {"sec5_driving drive", "--time 20"},
      {"sec5_enclosures dps", ""},
      {"sec5_enclosures breather", ""},
      {"sec5_enclosures wave", ""},
      {"sec5_experiment damped", ""},
      {"sec5_growth growth", ""},
      {"sec5_kernel_equation wave", ""},
      {"sec5_travelling_breathers orbit", ""}};
  // Single parts of maps, multipliers, profiles; `scales` prints a table of the full run
  const std::set<std::string> others{
      "sec32_dps_profiles profile",  "sec33_dps_stability spectrum",
      "sec33_floquet multipliers",   "sec34_boomeron_map map",
      "sec36_cantilever_defect map", "sec36_cantilever_defect scales",
      "sec5_driving chart"};
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(BIN_DIR)) {
    const std::string program = entry.path().filename().string();
    if (program.rfind("sec", 0) != 0) continue;
    for (const std::string& command : commands_of(program)) {
      const std::string line = program + " " + command;
      CAPTURE(line);
      if (others.count(line)) continue;
      REQUIRE(asks.count(line) == 1);
      const Result answer = call(line + " " + asks.at(line));
      CAPTURE(answer.errors);
      REQUIRE(answer.code == 0);
      std::istringstream in(answer.output);
      const Table table = from_text(in);
      REQUIRE(table.columns.back().name ==
              (program == "sec5_enclosures" ? "meaning" : "reason"));  // bounds always exist
      for (const std::string& meaning : table.texts("meaning")) CHECK(meaning.size() > 10);
      ++seen;
    }
  }
  CHECK(seen == asks.size());
}

TEST_CASE("the strongest site is not always in the foremost packet", "[cli]") {
  const Result hard = call("sec34_impact run --velocity 2.5 --s 1 --time 200");
  REQUIRE(hard.code == 0);
  CHECK(quantity(hard, "packet_energy_fraction") < 0.1);
  CHECK(quantity(hard, "strongest_site") < quantity(hard, "centre") - 5);
  CHECK(std::isnan(quantity(call("sec34_impact run --sites 5 --time 5"), "strongest_site")));
}
