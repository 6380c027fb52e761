#pragma once
/**
# The frame of a program

Every chapter is a program with the same manners. Without a subcommand it computes
everything its section shows and writes tables to `--out`; a subcommand computes
one thing with the reader's parameters and prints a table. This file holds what
they share: provenance, results, progress and errors; options.hpp holds what a chapter says of its
options, and frame.hpp how the line is read.

Bad input ends with exit code 2 and one line that names the option, the value and
what is allowed. A computation that does not deliver what it promised ends with exit
code 1. In neither case is a file left behind. */

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/report/checksum.hpp"
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

  /**
  A run is complete when its results are there, so they are written last. */
  /// Writes all tables, then their checksums, and `results`.
  void finish(const Results& results) {
    add("results", results.table);
    std::string sums;
    for (const auto& [name, table] : tables_) {
      const std::string file = name + ".ecsv", text = to_text(provenance_.sign(table));
      std::istringstream lines(text);
      sums += table_checksum(lines) + "  " + file + '\n';
      if (&table == &tables_.back().second) write_whole(folder_ / checksums_name, sums);
      write_whole(folder_ / file, text);
    }
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
  Program(Identity identity, int argc, char** argv);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// What a subcommand computes is a function from its options to one table, `compute`; the chapter
  /// adds the options to the command that is returned.
  Command* command(const std::string& name, const std::string& help,
                   std::function<Table()> compute);

  /// The full computation of the section. What it has reported is written when it has succeeded.
  std::function<void(Report&)> everything;
  bool quick = false;

  /// Reads the line and computes; the exit code is 2 for input that cannot be used and 1 for a
  /// computation that failed.
  int run(int argc, char** argv);

 private:
  struct Frame;
  std::unique_ptr<Frame> frame_;
};

}  // namespace lattice
