// What holds for every program of a volume: what its help and the prose of its chapters promise.

#include <cmath>
#include <filesystem>
#include <fstream>

#include "report/parameters.hpp"
#include "support/check.hpp"
#include "support/commands.hpp"

using namespace lattice;
namespace fs = std::filesystem;

TEST_CASE("every program says what a full run takes", "[cli]") {
  for (const std::string& program :
       read(fs::path(VOLUME_DIR) / "paper/costs.ecsv").texts("program"))
    CHECK(offers().at(program).find("A full run takes ") != std::string::npos);
}

TEST_CASE("what the prose tells a reader to type is there", "[cli]") {
  // `sec34_impact run --velocity 4`, with or without its folder, over the end of a line too
  const std::regex typed("`(?:build/bin/)?(sec[0-9A-Z]+_\\w+) ([a-z]+)(\\s[^`]*)?`"),
      option("--([a-z][a-z-]*)");
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VOLUME_DIR) / "src")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (std::sregex_iterator at(text.begin(), text.end(), typed), end; at != end; ++at, ++found) {
      const std::string command = (*at)[1].str() + " " + (*at)[2].str(), rest = (*at)[3];
      INFO(entry.path().string() + ": " + at->str());
      // A chapter of volume two may call a program of the article, and never the other way round
      CHECK((offers().count(command) || std::string(VOLUME_DIR) != SOURCE_DIR));
      const std::string help = call(command + " --help").output;
      REQUIRE(!help.empty());
      for (std::sregex_iterator word(rest.begin(), rest.end(), option); word != end; ++word)
        CHECK(help.find("--" + (*word)[1].str() + " ") != std::string::npos);
    }
  }
  CHECK(found > 10);
}

TEST_CASE("every option takes what --describe says, and nothing beyond", "[cli]") {
  const auto check = [](const std::string& line, const std::string& option,
                        const std::vector<std::string>& good, const std::vector<std::string>& bad) {
    // Values are checked from the left to the right, and the threads refuse what would compute
    for (const std::string& value : good)
      check_refused(line + " " + option + "=" + word(value) + " --threads 0", "--threads: '0' is");
    for (const std::string& value : bad)
      check_refused(line + " " + option + "=" + value, option + ": '" + value + "' is not ");
  };
  std::size_t seen = 0;
  for (const auto& [program, help] : offers()) {
    if (program.find(' ') != std::string::npos) continue;
    const Table told = table_of(program + " --describe");
    const auto text = [&](const char* column, std::size_t k) { return told.texts(column)[k]; };
    for (std::size_t k = 0; k < told.rows.size(); ++k) {
      const std::string command = text("command", k), takes = text("takes", k),
                        line = program + (command.empty() ? "" : " " + command),
                        option = "--" + text("option", k), standard = text("default", k);
      CHECK((takes.empty() || offers().at(line).find("\n  " + option + " ") != std::string::npos));
      if (option == "--threads" || takes.empty() || takes == "flag") continue;
      const double least = told.numbers("lowest")[k], most = told.numbers("highest")[k];
      const bool number = std::isfinite(least), plain = !number || typed_number(standard);
      check(line, option,
            plain && !standard.empty() ? std::vector{standard} : std::vector<std::string>{}, {});
      if (number)
        check(line, option, {number_text(least), number_text(most)},
              {number_text(least - 1), number_text(2 * std::abs(most) + 1), "nan"});
      if (takes == "name") check(line, option, {}, {"corner"});
      ++seen;
    }
  }
  CHECK(seen > 30);
}
