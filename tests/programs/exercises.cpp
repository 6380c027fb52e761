// The exercises of the chapters: their commands print what they say.

#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "report/table.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace report;
namespace fs = std::filesystem;

namespace {

/// What a command is said to print under the name of a quantity.
struct Expected {
  std::string command, quantity, number;

  /// Half a unit of the last digit that is given.
  double half_unit() const {
    const std::size_t end = number.find('e'), point = number.find('.');
    const double power = end == std::string::npos ? 0 : std::stod(number.substr(end + 1));
    const double places =
        point == std::string::npos ? 0 : double(std::min(end, number.size()) - point - 1);
    return 0.5 * std::pow(10.0, power - places);
  }
};

/// All that the chapters of this volume say of the form "`build/bin/sec... ...` gives `quantity` = number".
std::vector<Expected> all_expected() {
  const char* said =
      "`build/bin/(sec[^`]+)` gives (((,? and |, )?`\\w+` = -?[0-9.]+(e-?[0-9]+)?)+)";
  const char* one = "`(\\w+)` = (-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?)";
  std::vector<Expected> out;
  for (const auto& entry : fs::directory_iterator(fs::path(VOLUME_DIR) / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    const std::string source(std::istreambuf_iterator<char>(in), {});
    for (const auto& command : matches(in_one_line(source), said))
      for (const auto& value : matches(command[2], one))
        out.push_back({command[1], value[1], value[2]});
  }
  return out;
}

}  // namespace

// A number agrees within half a unit of its last digit and the error that is printed beside it, and has digits enough
// that a wrong answer does not agree.
TEST_CASE("the commands of the exercises print what they say", "[exercises]") {
  Scratch scratch;
  std::map<std::string, Table> answers;
  const std::vector<Expected> all = all_expected();
  CHECK(all.size() > 5);
  for (const Expected& expected : all) {
    INFO(expected.command + " gives " + expected.quantity);
    if (!answers.count(expected.command)) {
      const auto file = scratch.path / (std::to_string(answers.size()) + ".ecsv");
      const Result r = call(expected.command + " --output " + word(file));
      CAPTURE(r.errors);
      REQUIRE(r.code == 0);
      answers.emplace(expected.command, read(file));
    }
    const Table& table = answers.at(expected.command);
    const std::size_t row = row_of(table, expected.quantity);
    const double error = table.numbers("error")[row], number = std::stod(expected.number);
    check_close(table.numbers("value")[row], number, expected.half_unit() + error);
    CHECK((table.texts("kind")[row] == "exact" ||
           expected.half_unit() <= std::max(0.02 * std::abs(number), error)));
  }
}
