#pragma once
/**
# The frame of a program

Every chapter is a program with the same manners. Without a subcommand it computes
everything its section shows and writes tables to `--out`; a subcommand computes
one thing with the reader's parameters and prints a table. This file holds what
they share: provenance, results, progress and errors; options.hpp holds how options are read.

Bad input ends with exit code 2 and one line that names the option, the value and
what is allowed. A computation that does not deliver what it promised ends with exit
code 1. In neither case is a file left behind. */

#include <gsl/gsl_errno.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/options.hpp"
#include "lattice/report/table.hpp"

#ifndef LATTICE_BUILD
#define LATTICE_BUILD "unknown build"
#endif
#ifndef LATTICE_LIBRARIES
#define LATTICE_LIBRARIES "unknown versions"
#endif
#ifndef LATTICE_VERSION
#define LATTICE_VERSION "0.0.0"
#endif

namespace lattice {

/// The computation did not deliver what it promised: exit code 1.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The last column of results and facts says where an error of zero is meant.
inline Column kind_column() {
  return label("kind", "estimate, or exact where nothing could be different (error 0)");
}
inline std::string kind_of(const Estimate& e) {
  return e.is_exact ? "exact" : "estimate";
}

/**
A claim of the article is answered by a row of `results.ecsv`: its id, the value, an
error from at least two resolutions, and the unit. There are two kinds of answer. A number,
given by `add`, answers a printed number and equally a word that has none (excellent,
slightly, very close): such a word is measured, not judged. Yes or no, given by `claim` as one
or zero with the unit `claim`, answers a statement that a criterion of the chapter decides. */
struct Results {
  Table table{{label("id", "identifier in paper/published.ecsv"),
               number("value", "converged value; 1 or 0 where the unit is claim"),
               number("error", "absolute error estimated from two resolutions"),
               label("unit", "unit of value and error; claim for yes or no"), kind_column()}};

  /// A number with its error; throws Failure unless both are finite, the error is no less than
  /// zero and the claim has no answer yet.
  void add(const std::string& id, const Estimate& e, const std::string& unit = "") {
    if (!std::isfinite(e.value) || !std::isfinite(e.error) || e.error < 0)
      throw Failure(id + ": the computed value or its error is not finite");
    for (const auto& row : table.rows)
      if (std::get<std::string>(row[0]) == id) throw Failure(id + ": answered twice");
    table.add({id, e.value, e.error, unit, kind_of(e)});
  }
  /// Yes or no.
  void claim(const std::string& id, bool holds) { add(id, exact(holds ? 1 : 0), "claim"); }
};

/**
Not every number answers a claim. Subcommands and the facts of a chapter report rows
`quantity,value,error,unit`. A quantity that is not defined (the speed of a packet that never left)
is `nan` here, where a claim would refuse it. */
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

/**
The header of a table says who made it and from what. `parameters` are the options with the values
used. A chapter that knows more (a tolerance, a seed, the chain length that was chosen) adds it to
the table's own `meta`; where that has the name of a parameter or of an entry, it replaces it. */
struct Provenance {
  Meta entries, parameters;

  void set(const std::string& key, const std::string& value) {
    for (Meta* known : {&parameters, &entries})
      for (auto& [name, old] : *known)
        if (name == key) {
          old = value;
          return;
        }
    entries.emplace_back(key, value);
  }
  /**
  A table is signed with the whole header when it is written. */
  Table sign(Table table) const {
    Provenance all = *this;
    for (const auto& [key, value] : table.meta) all.set(key, value);
    std::string text;
    for (const auto& [key, value] : all.parameters)
      text += (text.empty() ? "" : ", ") + key + " = " + value;
    table.meta = {};
    for (const auto& [key, value] : all.entries) {
      table.meta.emplace_back(key, value);
      if (key == "command") table.meta.emplace_back("parameters", text);
    }
    return table;
  }
};

/**
A full run writes several tables that belong together. They are kept until the last one is computed,
so that a run that fails leaves no half of a set, and all carry the same header. */
class Output {
 public:
  Output(std::filesystem::path folder, Provenance provenance)
      : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

  /// Something that the headers of all tables say: a tolerance, a seed.
  void note(const std::string& key, const std::string& value) { provenance_.set(key, value); }

  /// Keeps `table` to be written as `name`.ecsv when the whole run has succeeded.
  void add(const std::string& name, Table table) { tables_.emplace_back(name, std::move(table)); }
  /// Where the tables go; work in progress may wait there under a name that begins with a dot.
  const std::filesystem::path& folder() const { return folder_; }
  /// Writes all tables, `results` last: its presence means that the folder is complete.
  void finish(const Results& results) {
    add("results", results.table);
    for (const auto& [name, table] : tables_)
      write(folder_ / (name + ".ecsv"), provenance_.sign(table));
  }

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
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
      : identity_(std::move(identity)),
        app_(identity_.title, identity_.name),
        command_(command_text(identity_.name, argc, argv)) {
    gsl_set_error_handler_off();  // its errors are ours to report, not a reason to abort
    app_.option_defaults()->always_capture_default();
    app_.formatter(std::make_shared<Help>());
    app_.set_version_flag("--version", identity_.name + " " LATTICE_VERSION " (" LATTICE_BUILD
                                                        "; " LATTICE_LIBRARIES ")");
    app_.add_option("--out", out_, "folder for the tables of a full run")
        ->check(not_empty())
        ->default_str("build/data/" + identity_.name);
    app_.add_flag("--quick", quick, "coarse parameters: seconds, for trying out");
    add_threads(app_);
    app_.require_subcommand(0, 1);
  }

  /**
  What a subcommand computes is a function from its options to one table, `compute`; the chapter sets
  the options on the app that is returned. */
  CLI::App* command(const std::string& name, const std::string& help,
                    std::function<Table()> compute) {
    CLI::App* sub = app_.add_subcommand(name, help);
    sub->add_option("--output", output_, "file to write (default: standard output)")
        ->check(not_empty());
    add_threads(*sub);
    sub->footer(
        "A quantity that does not exist, such as the speed of a packet that never left, is "
        "nan.");
    commands_.emplace_back(sub, std::move(compute));
    return sub;
  }

  /// The full computation of the section.
  std::function<Results(Output&)> everything;
  bool quick = false;

  /**
  All that can go wrong arrives here as an exception, and this is the only place that knows exit
  codes: 2 for input that cannot be used, 1 for a computation that failed. */
  int run(int argc, char** argv) {
    try {
      settle_options(app_);
      for (const auto& [sub, compute] : commands_) settle_options(*sub);
      app_.parse(argc, argv);
      set_threads(threads_ > 0 ? threads_ : granted());
      for (const auto& [sub, compute] : commands_)
        if (sub->parsed()) return print(*sub, compute);
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
  /**
  A job on a shared machine must not take more cores than it was given. Beside the cores that the
  system grants we obey Slurm, which may have given the task fewer. */
  void add_threads(CLI::App& app) {
    app.add_option("--threads", threads_,
                   "threads, on which no result depends (default: the cores granted)")
        ->check(in_range(1, 1024));
  }

  static std::size_t granted() {
    const char* share = std::getenv("SLURM_CPUS_PER_TASK");
    const auto number = share ? parse_number(share) : std::nullopt;
    const std::size_t cores = granted_cores();
    return number && *number >= 1 && *number < double(cores) ? std::size_t(*number) : cores;
  }

  int complain(std::string message, int code) const {
    for (char& c : message)
      if (c == '\n') c = ' ';
    std::cerr << identity_.name << ": " << message << '\n';
    return code;
  }

  /**
  Who made the table: everything needed to make it again, and no clock time, which would make equal
  runs differ. */
  Provenance provenance(const CLI::App& app) const {
    const char* revision = std::getenv("LATTICE_REVISION");
    return {{{"program", identity_.name},
             {"section", identity_.section},
             {"command", command_},
             {"seed", "none: no random numbers"},
             {"revision", revision && *revision ? revision : LATTICE_VERSION},
             {"build", LATTICE_BUILD},
             {"libraries", LATTICE_LIBRARIES}},
            recorded_options(app)};
  }

  /**
  Nobody wants to learn after hours of work that `file` in `folder` cannot be written, so we make the
  folder and try at once, under a temporary name. What exists and is no ordinary file (a device, a
  pipe) is taken as it is. */
  static void need_writable(const std::filesystem::path& folder, const std::string& file,
                            const std::string& option) {
    std::error_code error, ignored;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path path = folder / file, part = path.string() + ".part";
    if (!error && std::filesystem::exists(path, error) &&
        !std::filesystem::is_regular_file(path, ignored))
      return;
    if (!error) {
      const bool known = std::filesystem::exists(part, ignored);
      errno = 0;
      if (!std::ofstream(part, std::ios::app)) error.assign(errno, std::generic_category());
      if (!known) std::filesystem::remove(part, ignored);
    }
    if (error)
      throw UsageError(option + ": cannot write to '" + path.string() + "': " + error.message() +
                       " (allowed: a place where you may write)");
  }

  /**
  A subcommand prints its table or writes it to `--output`; options of a full run mean nothing to it,
  and rather than ignore them we say so. */
  int print(const CLI::App& sub, const std::function<Table()>& compute) {
    for (const char* option : {"--out", "--quick"})
      if (app_.count(option) > 0)
        throw UsageError(std::string(option) + ": has no meaning before '" + sub.get_name() +
                         "' (allowed: in a full run, without a subcommand)");
    if (!output_.empty()) {
      const std::filesystem::path path(output_), parent = path.parent_path();
      std::error_code ignored;
      if (path.filename().empty() || std::filesystem::is_directory(path, ignored))
        throw UsageError("--output: '" + output_ + "' is a folder (allowed: a file)");
      need_writable(parent.empty() ? "." : parent, path.filename().string(), "--output");
    }
    const Table table = provenance(sub).sign(compute());
    if (!output_.empty()) {
      write(output_, table);
    } else if (!(std::cout << to_text(table) << std::flush)) {
      throw Failure("cannot write to standard output");
    }
    return 0;
  }

  /**
  A full run removes the old `results.ecsv` before it begins: as long as there is none, the folder is
  not complete. */
  int run_everything() {
    if (out_.empty()) out_ = "build/data/" + identity_.name;
    need_writable(out_, "results.ecsv", "--out");
    std::error_code ignored;
    std::filesystem::remove(std::filesystem::path(out_) / "results.ecsv", ignored);
    Output output(out_, provenance(app_));
    output.finish(everything(output));
    return 0;
  }

  Identity identity_;
  CLI::App app_;
  std::string command_, out_, output_;
  std::size_t threads_ = 0;
  std::vector<std::pair<CLI::App*, std::function<Table()>>> commands_;
};

}  // namespace lattice
