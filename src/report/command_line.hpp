#pragma once
/**
# How the command line is read

A line is the program's name, perhaps a command, and options, each a name with two dashes that is followed by
its value after a blank or `=`. What can be wrong is answered in one line that names the option, the value and
what is allowed, and the nearest name where one was misspelt. */

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/parameters.hpp"

namespace report {

/// Parameters under the name of a command; the program itself has them under no name.
struct Offer {
  std::string name, meaning, note{};  ///< the note is the last line of its help
  Parameters parameters{};
  std::function<Table()> compute{};  ///< what a command computes from their values
};

/// What was asked for: the offer that was chosen, or its help, or the version, or what the program offers, as a table.
struct Asked {
  enum class What { run, help, version, describe } what = What::run;
  Offer* of = nullptr;  ///< one of the offers
};

/// Reads `words`, which do not contain the name of the program, into the variables of the chosen offer, the
/// first of `offers` being the program itself. Throws UsageError.
Asked read_line(std::deque<Offer>& offers, const std::vector<std::string>& words);

/// What `--help` prints for `of`, which ends with its note.
std::string help_text(const std::string& program, const std::deque<Offer>& offers, const Offer& of);

/// What `--describe` prints: a row for each offer, without an option, and below it a row for each of its options.
Table description(const std::string& program, const std::deque<Offer>& offers);

/// The name that is nearest to `word`, if one is near.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& names);

/// The whole command as a shell would read it, on one line and without `--threads` and `--out`, on which no result depends.
std::string command_text(const std::string& program, int argc, const char* const* argv);

}  // namespace report
