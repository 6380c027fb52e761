#pragma once
/**
# Options

What a reader types is checked where it enters: a wrong value is answered by one line that names the
option, the value and what is allowed. Numbers are read in one way everywhere: in decimal (`031` is
31), whole ones also as `1e+06`. And what was not typed is said too: help shows every default, and
the header of a table records every parameter with the value that was used. */

#include <CLI/CLI.hpp>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/report/table.hpp"

namespace lattice {

/// The reader's input cannot be used: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Option check: a number in [lo, hi], whose meaning `unit` completes the message.
inline CLI::Validator in_range(double lo, double hi, const std::string& unit = "") {
  const std::string range =
      "[" + short_text(lo) + ", " + short_text(hi) + "]" + (unit.empty() ? "" : " " + unit);
  return CLI::Validator(
      [lo, hi, range](std::string& value) {
        const auto x = parse_number(value);
        if (!x) return "'" + value + "' is not a number (allowed: " + range + ")";
        const bool good = *x >= lo && *x <= hi;
        return good ? "" : "'" + short_text(*x) + "' is not in the allowed range " + range;
      },
      range);
}

/// Option check: a name that is not empty.
inline CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& value) { return value.empty() ? "'' is not a name" : std::string(); }, "");
}

/**
CLI11 would read `031` as octal, refuse `1e+06` for a count and round a number twice. So each number
is read by us first and handed on in a form without doubt. The library names the type of an option
and what is allowed in one text, `UINT:[2, 100000]`. */
inline void read_numbers_ourselves(CLI::Option& option) {
  const std::string text = option.get_type_name(), type = text.substr(0, text.find(':'));
  const bool whole = type == "UINT" || type == "INT";
  if (!whole && type != "FLOAT") return;
  const std::string allowed =
      text.find(':') == std::string::npos ? "" : " (allowed: " + text.substr(type.size() + 1) + ")";
  option.transform(CLI::Validator(
      [whole, allowed](std::string& value) {
        const auto x = parse_number(value);
        if (!x) return "'" + value + "' is not a number" + allowed;
        if (whole && !(*x == std::floor(*x) && std::abs(*x) < 1e15))
          return "'" + value + "' is not a whole number" + allowed;
        value = whole ? short_text(*x) : number_text(*x);
        return std::string();
      },
      ""));
}

/**
Help must show every default, also one that is no plain value, such as a length that follows from
another option. Such a default stands in the description, `(default: as long as needed)`, and is
taken out of it here, so that it is shown, and recorded, like all the others. */
inline void take_default_from_description(CLI::Option& option) {
  const std::string text = option.get_description(), mark = " (default: ";
  const auto at = text.find(mark);
  if (at == std::string::npos || text.back() != ')') return;
  option.default_str(text.substr(at + mark.size(), text.size() - at - mark.size() - 1));
  option.description(text.substr(0, at));
}

/// Makes all options of `app` as this file promises; to be called when all of them are there.
inline void settle_options(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    take_default_from_description(*option);
    read_numbers_ourselves(*option);
  }
}

/**
The two readers of the defaults follow: help, for those who ask before a run, and the header of a
table, for those who ask afterwards which parameters a number belongs to. A flag has no value and
shows none. */
inline bool is_flag(const CLI::Option* option) {
  return option->get_items_expected_max() == 0;
}

/// Help that ends each option with its default.
struct Help : CLI::Formatter {
  std::string make_option_opts(const CLI::Option* option) const override {
    return is_flag(option) ? "" : " " + option->get_type_name();
  }
  std::string make_option_desc(const CLI::Option* option) const override {
    const std::string value = is_flag(option) ? "" : option->get_default_str();
    return option->get_description() + (value.empty() ? "" : " (default: " + value + ")");
  }
};

/**
A header must be the same for the same result. So it holds the options that decide a result, each
with its value, the one typed or the default, and leaves out the number of threads and the place
of the output, on which no digit depends. */
inline Meta recorded_options(const CLI::App& app) {
  Meta out;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    if (name == "help" || name == "version" || name == "threads" || name == "out" ||
        name == "output")
      continue;
    std::string value = option->get_default_str();
    if (is_flag(option))
      value = option->count() > 0 ? "yes" : "no";
    else if (option->count() > 0)
      value = option->results().back();
    if (const auto x = parse_number(value)) value = short_text(*x);
    out.emplace_back(name, value);
  }
  return out;
}

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
