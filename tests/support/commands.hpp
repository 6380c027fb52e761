#pragma once
// What the programs of a volume offer, and what is asked of each command.

#include <map>
#include <set>
#include <vector>

#include "support/run.hpp"

/// Commands that several tests call.
inline const std::string breather = "sec32_newton_breathers breather ",
                         multipliers = "sec33_floquet multipliers ";

/// All programs of the volume, each by its name and then with its commands, and their help.
inline const std::map<std::string, std::string>& offers() {
  static const auto all = [] {
    std::map<std::string, std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(VOLUME_DIR "/src")) {
      const std::string program = entry.path().stem().string();
      if (entry.path().extension() != ".cpp") continue;
      const std::string& help = out[program] = call(program + " --help").output;
      const std::string commands = help.substr(std::min(help.find("\nCommands"), help.size()));
      for (const auto& found : matches(commands, "\n  ([a-z]+) ")) {
        const std::string one = program + " " + found[1];
        out[one] = call(one + " --help").output;
      }
    }
    return out;
  }();
  return all;
}

/// What a command is to answer: a value with its margins, and nan for any number with its error.
struct Answer {
  std::string quantity;
  double value, absolute = 0, relative = 0;
};

/// All these commands answer, and say what their quantities are; with those that are `open` they are all that there are.
inline void check_answers(const std::vector<std::pair<std::string, std::vector<Answer>>>& commands,
                          std::set<std::string> open) {
  for (const auto& [line, answers] : commands) {
    const std::string command = line.substr(0, line.find(' ', line.find(' ') + 1));
    const Result r = call(line);
    CAPTURE(line, r.errors, r.output);
    for (const std::string& meaning : table_of(r).texts("meaning")) CHECK(meaning.size() > 10);
    for (const Answer& a : answers) {
      CAPTURE(a.quantity);
      const double value = quantity(r, a.quantity),
                   expected = std::isnan(a.value) ? value : a.value;
      check_close(value, expected, a.absolute, a.relative);
      CHECK(quantity(r, a.quantity, "error") >= 0);
    }
    open.insert(command);
  }
  for (const auto& [offer, help] : offers())
    if (offer.find(' ') != std::string::npos) {
      CAPTURE(offer);  // a new command has its quantities in the list above
      CHECK(open.count(offer) == 1);
    }
}

/// A quantity that does not exist is nan with its reason; an empty reason is for one that does.
inline void check_reason(const std::string& command, const std::string& name,
                         const std::string& reason) {
  const Result answer = call(command);
  CAPTURE(command, name, answer.output, answer.errors);
  REQUIRE(answer.code == 0);
  const std::string said = text_of(answer, name, "reason");
  CHECK(std::isnan(quantity(answer, name)) == !reason.empty());
  CHECK(said.empty() == reason.empty());
  CHECK(said.find(reason) != std::string::npos);
}

/// A computation that fails says so in one line, and leaves nothing.
inline void check_failure(const std::string& command, const std::string& said) {
  const Scratch scratch;
  const Result r = call(command + (" --output " + word(scratch.path / "x.ecsv")));
  CAPTURE(command, r.errors);
  CHECK(r.code == 1);
  CHECK(r.error_lines() == 1);
  CHECK(r.errors.find(said) != std::string::npos);
  CHECK(scratch.empty());
}

/// A table has these columns, the beginning of its first row, and so many rows.
inline void check_rows(const std::string& command, const std::string& names, std::size_t rows) {
  const Result r = call(command);
  CAPTURE(command, r.output, r.errors);
  CHECK(r.output.find(names) != std::string::npos);
  CHECK(table_of(r).rows.size() == rows);
}
