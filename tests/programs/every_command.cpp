// What holds for every program of a volume: what its help and the prose of its chapters promise.

#include <cmath>
#include <filesystem>
#include <fstream>

#include "report/parameters.hpp"
#include "support/check.hpp"
#include "support/commands.hpp"

using namespace report;
namespace fs = std::filesystem;

TEST_CASE("what the prose tells a reader to type is there", "[cli]") {
  // `sec34_impact run --velocity 4`, with or without its folder, over the end of a line too
  const char* typed = "`(build/bin/)?(sec[0-9A-Z]+_\\w+) ([a-z]+)(\\s[^`]*)?`";
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VOLUME_DIR) / "src")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (const auto& line : matches(text, typed)) {
      ++found;
      const std::string command = line[2] + " " + line[3];
      INFO(entry.path().string() + ": " + line[0]);
      // A chapter of volume two may call a program of the article, and never the other way round
      CHECK((offers().count(command) || std::string(VOLUME_DIR) != SOURCE_DIR));
      const std::string help = call(command + " --help").output;
      REQUIRE(!help.empty());
      for (const auto& option : matches(line[4], "--[a-z][a-z-]*"))
        CHECK(help.find(option[0] + " ") != std::string::npos);
    }
  }
  CHECK(found > 10);
}

TEST_CASE("every option takes what --describe says, and nothing beyond", "[cli]") {
  // Values are checked from the left to the right, and no threads are what keeps a line from being computed
  const auto taken = [](const std::string& option, const std::string& value) {
    check_refused(option + "=" + word(value) + " --threads 0", "--threads: '0' is not ");
  };
  const auto refused = [](const std::string& option, const std::string& value) {
    check_refused(option + "=" + value + " --threads 0", "'" + value + "' is not ");
  };
  const auto check = [&](const std::string& option, const std::string& takes, double least,
                         double most, const std::string& standard) {
    const bool whole = takes == "whole number", number = whole || takes == "number";
    if (!number || typed_number(standard)) taken(option, standard);
    if (takes == "name") refused(option, "corner");
    if (!number) return;
    for (double end : {least, most}) taken(option, number_text(end));
    refused(option, number_text(whole ? least - 1 : std::nextafter(least, -HUGE_VAL)));
    refused(option, number_text(whole ? most + 1 : std::nextafter(most, HUGE_VAL)));
    refused(option, "nan");
    refused(option, "1,5");
  };
  std::size_t seen = 0;
  for (const auto& [offer, help] : offers()) {
    if (offer.find(' ') != std::string::npos) continue;
    const Table described = table_of(offer + " --describe");
    for (std::size_t k = 0; k < described.rows.size(); ++k) {
      const auto text = [&](const char* column) { return described.texts(column)[k]; };
      const std::string command = text("command"), name = text("option"), takes = text("takes"),
                        line = offer + (command.empty() ? "" : " " + command);
      CHECK((name.empty() || offers().at(line).find("\n  --" + name + " ") != std::string::npos));
      if (name.empty() || takes == "flag" || name == "threads") continue;
      check(line + " --" + name, takes, described.numbers("lowest")[k],
            described.numbers("highest")[k], text("default"));
      ++seen;
    }
  }
  CHECK(seen > 30);
}
