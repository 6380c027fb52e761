// What holds for every program of a volume: what its help and the prose of its chapters promise.

#include <filesystem>
#include <fstream>

#include "support/check.hpp"
#include "support/commands.hpp"

using namespace lattice;
namespace fs = std::filesystem;

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

TEST_CASE("every option of every command refuses what its help does not allow", "[cli]") {
  Scratch scratch;
  std::size_t seen = 0;
  const auto refused = [&](const std::string& command, const std::string& option,
                           const std::string& value, const std::string& range) {
    const std::string line = command + " " + option + " " + value;
    const std::string out = command.find(' ') == std::string::npos ? " --out " : " --output ";
    const Result r = call(line + out + word(scratch.path / "x"));
    CAPTURE(line);
    check_refused(r, option + ": '" + value + "' is not ");
    check_refused(r, range);
    CHECK(scratch.empty());
    ++seen;
  };
  for (const auto& [command, help] : offers()) {
    for (const auto& found : matches(help, "^  (--[a-z]+) (\\[[^,]+, ([^\\]]+)\\])")) {
      if (found[1] == "--threads" && command != offers().begin()->first) continue;
      refused(command, found[1], "9" + found[3].str(), found[2]);
      refused(command, found[1], seen % 2 ? "nan" : "1,5", found[2]);
    }
    for (const auto& found : matches(help, "^  (--[a-z]+) \\{([a-z]+)"))
      refused(command, found[1], "corner", found[2]);
  }
  CHECK(seen > 30);
}
