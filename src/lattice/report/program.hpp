#pragma once
/**
# The frame of a program

Every chapter is a program with the same manners. Without a subcommand it computes
everything its section shows and writes tables to `--out`; a subcommand computes
one thing with the reader's parameters and prints a table. This file holds what
they share: options, provenance, results, progress and errors.

Bad input ends with exit code 2 and one line that names the option, the value and
what is allowed. A computation that does not deliver what it promised ends with exit
code 1. In neither case is a file left behind. */

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/table.hpp"

#ifndef LATTICE_BUILD
#define LATTICE_BUILD "unknown build"
#endif
#ifndef LATTICE_VERSION
#define LATTICE_VERSION "0.0.0"
#endif

namespace lattice {

/// The reader's input cannot be used: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation did not deliver what it promised: exit code 1.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Option check: a finite number in [lo, hi], whose meaning `unit` completes the message.
inline CLI::Validator in_range(double lo, double hi, const std::string& unit = "") {
  const auto text = [](double x) {
    std::ostringstream out;
    out << x;
    return out.str();
  };
  const std::string range =
      "[" + text(lo) + ", " + text(hi) + "]" + (unit.empty() ? "" : " " + unit);
  return CLI::Validator(
      [lo, hi, range](std::string& value) {
        char* end = nullptr;
        const double x = std::strtod(value.c_str(), &end);
        if (value.empty() || *end != '\0') return "'" + value + "' is not a number";
        const bool good = x >= lo && x <= hi;
        return good ? std::string() : "'" + value + "' is not in the allowed range " + range;
      },
      range);
}

/// Option check: a name that is not empty.
inline CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& value) { return value.empty() ? "'' is not a name" : std::string(); }, "");
}

/// The last column of results and facts says where an error of zero is meant.
inline Column kind_column() {
  return label("kind", "estimate, or exact where nothing could be different (error 0)");
}
inline std::string kind_of(const Estimate& e) {
  return e.is_exact ? "exact" : "estimate";
}

/**
A claim of the article is answered by a row of `results.ecsv`: its id, the value, an
error from at least two resolutions, and the unit. Claims in words are answered by
one (holds) or zero (does not hold). */
struct Results {
  Table table{{label("id", "identifier in paper/published.ecsv"),
               number("value", "converged value; 1 or 0 for a claim in words"),
               number("error", "absolute error estimated from two resolutions"),
               label("unit", "unit of value and error"), kind_column()}};

  void add(const std::string& id, const Estimate& e, const std::string& unit = "") {
    if (!std::isfinite(e.value) || !std::isfinite(e.error))
      throw Failure(id + ": the computed value is not finite");
    table.add({id, e.value, e.error, unit, kind_of(e)});
  }
  void claim(const std::string& id, bool holds) { add(id, exact(holds ? 1 : 0), "claim"); }
};

/// Rows `quantity,value,error,unit`, the form in which subcommands report. A quantity that is not
/// defined (the speed of a packet that never left) is `nan`.
struct Quantities {
  Table table{{label("quantity", "what is reported"), number("value", "converged value"),
               number("error", "absolute error estimated from two resolutions"),
               label("unit", "unit of value and error"), kind_column()}};

  void add(const std::string& quantity, const Estimate& e, const std::string& unit = "") {
    table.add({quantity, e.value, e.error, unit, kind_of(e)});
  }
};

/// What a program is called and which section it belongs to.
struct Identity {
  std::string name, section, title;
};

/// Where the tables of a full run go, with the header they all carry.
class Output {
 public:
  Output(std::filesystem::path folder, Meta meta)
      : folder_(std::move(folder)), meta_(std::move(meta)) {}

  /// Keeps `table` to be written as `name`.ecsv when the whole run has succeeded.
  void add(const std::string& name, Table table) {
    table.meta.insert(table.meta.begin(), meta_.begin(), meta_.end());
    tables_.emplace_back(name, std::move(table));
  }
  /// Writes all tables, `results` last: its presence means that the folder is complete.
  void finish(const Results& results) {
    add("results", results.table);
    for (const auto& [name, table] : tables_) write(folder_ / (name + ".ecsv"), table);
  }

 private:
  std::filesystem::path folder_;
  Meta meta_;
  std::vector<std::pair<std::string, Table>> tables_;
};

/**
The parts of a chapter write the tables of their figures, answer their claims and note further
numbers among the `facts`, from which text and captions quote. A claim in words is decided by
a criterion that stands in the chapter's code; its margin stands among the facts. */
struct Report {
  Output& output;
  bool quick;
  Results results{};
  Quantities facts{};
};

/**
The frame parses the command line, runs either the chapter's full computation or one
subcommand, and turns exceptions into exit codes. Chapters register what they offer
with `command` and set `everything`. */
class Program {
 public:
  Program(Identity identity, int argc, char** argv)
      : identity_(std::move(identity)), app_(identity_.title, identity_.name) {
    for (int i = 0; i < argc; ++i)
      command_ += (i ? " " : "") + (i ? std::string(argv[i]) : identity_.name);
    app_.set_version_flag("--version", identity_.name + " " LATTICE_VERSION " (" LATTICE_BUILD ")");
    app_.add_option("--out", out_, "folder for the tables of a full run")
        ->check(not_empty())
        ->default_str("build/data/" + identity_.name);
    app_.add_flag("--quick", quick, "coarse parameters: seconds, for trying out");
    app_.require_subcommand(0, 1);
  }

  /// Adds a subcommand; set options on the returned app. `compute` gives the table to print.
  CLI::App* command(const std::string& name, const std::string& help,
                    std::function<Table()> compute) {
    CLI::App* sub = app_.add_subcommand(name, help);
    sub->add_option("--output", output_, "file to write instead of standard output")
        ->check(not_empty());
    commands_.emplace_back(sub, std::move(compute));
    return sub;
  }

  /// The full computation of the section.
  std::function<Results(Output&)> everything;
  bool quick = false;

  /// Parses and computes; returns the exit code.
  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
      for (const auto& [sub, compute] : commands_)
        if (sub->parsed()) return print(compute);
      return run_everything();
    } catch (const CLI::Success& success) {
      return app_.exit(success);
    } catch (const CLI::ParseError& error) {
      return complain(error.what(), 2);
    } catch (const UsageError& error) {
      return complain(error.what(), 2);
    } catch (const std::exception& error) {
      return complain(error.what(), 1);
    }
  }

 private:
  int complain(std::string message, int code) const {
    for (char& c : message)
      if (c == '\n') c = ' ';
    std::cerr << identity_.name << ": " << message << '\n';
    return code;
  }

  /// Who made the table: everything needed to make it again, and no clock time.
  Meta provenance() const {
    const char* revision = std::getenv("LATTICE_REVISION");
    return {{"program", identity_.name},
            {"section", identity_.section},
            {"command", command_},
            {"revision", revision ? revision : LATTICE_VERSION},
            {"build", LATTICE_BUILD}};
  }

  /// Fails early, before hours of work, where the result could not be written.
  static void need_writable(const std::filesystem::path& folder, const std::string& option) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const auto probe = folder / ".writable";
    const bool good = !error && std::ofstream(probe).good();
    std::filesystem::remove(probe, error);
    if (!good)
      throw UsageError(option + ": cannot write to '" + folder.string() +
                       "' (allowed: a folder you may write to)");
  }

  int print(const std::function<Table()>& compute) {
    if (!output_.empty()) {
      if (std::filesystem::is_directory(output_))
        throw UsageError("--output: '" + output_ + "' is a folder (allowed: a file)");
      const auto parent = std::filesystem::path(output_).parent_path();
      need_writable(parent.empty() ? "." : parent, "--output");
    }
    Table table = compute();
    const Meta meta = provenance();
    table.meta.insert(table.meta.begin(), meta.begin(), meta.end());
    if (!output_.empty()) {
      write(output_, table);
    } else if (!(std::cout << to_text(table) << std::flush)) {
      throw Failure("cannot write to standard output");
    }
    return 0;
  }

  int run_everything() {
    if (out_.empty()) out_ = "build/data/" + identity_.name;
    need_writable(out_, "--out");
    std::error_code ignored;
    std::filesystem::remove(std::filesystem::path(out_) / "results.ecsv", ignored);
    Output output(out_, provenance());
    output.finish(everything(output));
    return 0;
  }

  Identity identity_;
  CLI::App app_;
  std::string command_, out_, output_;
  std::vector<std::pair<CLI::App*, std::function<Table()>>> commands_;
};

}  // namespace lattice
