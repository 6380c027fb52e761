#pragma once
/**
# Options

What a reader types is checked where it enters: a wrong value is answered by one line that names the
option, the value and what is allowed. Numbers are read in one way everywhere: in decimal (`031` is
31), whole ones also as `1e+06`. And what was not typed is said too: help shows every default, and
the header of a table records every parameter with the value that was used.

Here stands what a chapter sees of it. The library that reads the command line, CLI11, is known to
frame.hpp alone: its headers take longer to compile than a chapter. */

#include <cctype>
#include <cstdio>
#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/report/table.hpp"

// What reads the command line is the same in every program: our own have it compiled once for all.
#ifndef LATTICE_ONCE_COMPILED
#define LATTICE_ONCE inline
#else
#define LATTICE_ONCE
#endif

namespace lattice {

/// The reader's input cannot be used: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
A check is told what was typed and answers with a complaint, or with nothing. */
struct Check {
  std::function<std::string(const std::string&)> complaint;
  std::string allowed;  ///< as help shows it
};

/// A number in [lo, hi], whose meaning `unit` completes the message.
Check in_range(double lo, double hi, const std::string& unit = "");
/// A name that is not empty.
Check not_empty();
/// One of `names`.
Check one_of(const std::vector<std::string>& names);

/**
An option is a name beside the variable that takes its value; what this holds before the line is read is
the default. A default that is no plain value, such as a length that follows from another option, stands
in the description, `(default: as long as needed)`, and is shown and recorded like all the others. */
class Option {
 public:
  explicit Option(void* option) : option_(option) {}
  Option* check(const Check& check);
  /// What help and header show instead of the value of the variable.
  Option* shows(const std::string& value);
  /// Typing both is refused.
  Option* excludes(const Option* other);
  bool given() const;

 private:
  void* option_;  ///< what frame.hpp makes of it
};

/**
A command is what a chapter adds its options to. The variables must live as long as the program. */
class Command {
 public:
  explicit Command(void* app) : app_(app) {}
  Option* add_option(const std::string& name, double& value, const std::string& meaning);
  Option* add_option(const std::string& name, std::size_t& value, const std::string& meaning);
  Option* add_option(const std::string& name, std::string& value, const std::string& meaning);
  Option* add_option(const std::string& name, std::function<void(const std::string&)> take,
                     const std::string& meaning);
  void add_flag(const std::string& name, bool& value, const std::string& meaning);
  /// Calls `then` when the whole line has been read.
  void when_read(std::function<void()> then);

 private:
  Option* kept(void* option);
  void* app_;
  std::deque<Option> options_{};
};

/**
The command in a header is there to be typed again. An argument with blanks, quotes or control
characters is therefore quoted as a shell would want it, and kept on one line: a line feed in a
name would otherwise break the header. */
inline std::string shell_quoted(const std::string& argument) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("-_=+./,:@%").find(char(c)) != std::string::npos;
  };
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), plain)) return argument;
  std::string out;
  bool strange = false;
  for (unsigned char c : argument) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", unsigned(c));
    strange = strange || c < 32 || c == 127;
    out += c < 32 || c == 127       ? code
           : c == '\'' || c == '\\' ? "\\" + std::string(1, char(c))
                                    : std::string(1, char(c));
  }
  if (strange || argument.find('\'') != std::string::npos) return "$'" + out + "'";
  return "'" + argument + "'";
}

/**
Also the command leaves out the threads, in either way of typing them, with a blank or with `=`. */
inline std::string command_text(const std::string& program, int argc, const char* const* argv) {
  std::string out = program;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads") ++i;
    if (argument.rfind("--threads", 0) == 0) continue;
    out += " " + shell_quoted(argument);
  }
  return out;
}

}  // namespace lattice
