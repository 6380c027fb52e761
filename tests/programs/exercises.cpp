// The exercises at the end of each chapter: their form, and that their commands print what they say.

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <vector>

#include "report/table.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;
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

/// One item of the list, in a line.
struct Exercise {
  std::string where, text;

  bool starts(const std::string& grade) const { return text.rfind("*" + grade + ".* ", 0) == 0; }

  std::vector<Expected> expected() const {
    static const std::regex said(
        "`build/bin/(sec[^`]+)` gives ((?:(?:,? and |, )?`\\w+` = -?[0-9.]+(?:e-?[0-9]+)?)+)"),
        one("`(\\w+)` = (-?[0-9]+(?:\\.[0-9]+)?(?:e-?[0-9]+)?)");
    std::vector<Expected> out;
    for (std::sregex_iterator at(text.begin(), text.end(), said), end; at != end; ++at) {
      const std::string values = (*at)[2];
      for (std::sregex_iterator v(values.begin(), values.end(), one); v != end; ++v)
        out.push_back({(*at)[1], (*v)[1], (*v)[2]});
    }
    return out;
  }
};

/// The items of a numbered list under "## Try it" in a source, with lines and spaces joined.
std::vector<Exercise> exercises(const std::string& name, const std::string& source) {
  const std::size_t from = source.find("\n## Try it\n");
  if (from == std::string::npos) return {};
  std::string list = source.substr(from, source.find("*/", from) - from);
  const std::size_t next = list.find("\n## ", 5);
  list = list.substr(0, next);
  const std::regex item("\n[0-9]+\\. "), space("\\s+");
  std::vector<Exercise> out;
  for (std::sregex_token_iterator at(list.begin(), list.end(), item, -1), end; at != end; ++at)
    if (at->str().find("## Try it") == std::string::npos)
      out.push_back({name, std::regex_replace(at->str(), space, " ")});
  return out;
}

std::vector<std::vector<Exercise>> of_all_chapters() {
  std::vector<std::vector<Exercise>> out;
  for (const auto& entry : fs::directory_iterator(fs::path(VOLUME_DIR) / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    out.push_back(exercises(entry.path().stem().string(), text));
  }
  return out;
}

/// What is wrong with the form of an exercise; empty if nothing.
std::string malformed(const Exercise& e) {
  if (!e.starts("Easy") && !e.starts("Harder")) return "no grade";
  if (e.expected().empty()) return "no command with a number";
  return e.text.find("Hint: ") == std::string::npos ? "no hint" : "";
}

}  // namespace

TEST_CASE("a number is as sharp as its last digit", "[cli]") {
  check_close(Expected{"", "", "1.20"}.half_unit(), 0.005, 1e-12);
  check_close(Expected{"", "", "-3e-4"}.half_unit(), 5e-5, 1e-12);
}

TEST_CASE("a chapter ends with three exercises at most", "[cli]") {
  for (const auto& chapter : of_all_chapters()) {
    CHECK(chapter.size() <= 3);
    for (const Exercise& e : chapter) {
      INFO(e.where + ": " + e.text);
      CHECK(malformed(e).empty());
    }
  }
}

// A number agrees within half a unit of its last digit and the error that is printed beside it, and has digits enough
// that a wrong answer does not agree.
TEST_CASE("the commands of the exercises print what they say", "[exercises]") {
  Scratch scratch;
  std::map<std::string, Table> answers;
  std::size_t count = 0;
  for (const auto& chapter : of_all_chapters())
    for (const Exercise& e : chapter)
      for (const Expected& expected : e.expected()) {
        INFO(e.where + ": " + expected.command + " gives " + expected.quantity);
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
        ++count;
      }
  CHECK(count > 5);
}
