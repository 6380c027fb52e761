#pragma once
/**
# A chapter as a program

Every chapter is a program with the same manners. Without a command it computes everything its section
shows and writes tables to `--out`; a command computes one thing with the reader's parameters and prints a
table. What they share is in this file: provenance, errors and exit codes.

Bad input ends with exit code 2 and one line that names the option, the value and what is allowed. A
computation that does not deliver what it promised ends with exit code 1. In neither case is a file left
behind. */

#include <deque>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/parameters.hpp"
#include "report/table.hpp"

namespace report {

/// The computation did not deliver what it promised: exit code 1.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a command answers: the columns quantity, value, error, unit, kind.
Columns quantity_columns();

/// A quantity that is not defined, such as the speed of a packet that never left.
inline const Estimate undefined{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::quiet_NaN()};

/**
Each row of an answer says what it means and, where its value is `nan`, why. A value smaller than its error is no answer,
and the command fails. Only what may vanish is printed whatever its error is: drifts, residuals and shares that are left,
differences of either sign, counts. */
struct Answers {
  std::string remedy = "other parameters";  ///< what to take where an error is too large
  Table table{quantity_columns(), label("meaning", "meaning of the quantity"),
              label("reason", "why the value is nan; empty otherwise")};

  /// One row. `reason` is why the value is nan, if it is; throws std::logic_error for a nan without one or an empty
  /// meaning, and Failure if the error exceeds the value.
  void add(const std::string& quantity, const Estimate& e, const std::string& unit,
           const std::string& meaning, const std::string& reason = "");
  /// The same for a quantity that may vanish within its error.
  void add_small(const std::string& quantity, const Estimate& e, const std::string& unit,
                 const std::string& meaning, const std::string& reason = "");
};

/**
The header of a table says who made it and from what. A chapter that knows more (a tolerance, the chain length that was
chosen) adds it to the table's own `meta`; where that has the name of a parameter or of an entry, it replaces it. */
struct Provenance {
  Meta entries, parameters;  ///< the parameters are the options with the values used

  /// Adds an entry, or replaces the one of this key.
  void set(const std::string& key, const std::string& value);
  /// The table under the whole header, as it is written.
  Table sign(Table table) const;
};

/**
A full run writes several tables that belong together. They are kept until the last one is computed,
so that a run that fails leaves no half of a set, and all carry the same header. */
class Output {
 public:
  Output(std::filesystem::path folder, Provenance provenance)
      : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

  /// Something that the headers of all tables say.
  void note(const std::string& key, const std::string& value) { provenance_.set(key, value); }
  /// Keeps `table` to be written as `name`.ecsv when the whole run has succeeded; returns it.
  Table& add(const std::string& name, Table table);
  /// Where the tables go; work in progress may wait there under a name that begins with a dot.
  const std::filesystem::path& folder() const { return folder_; }
  /// Writes all tables, then `run.ecsv`, and last `SHA256SUMS` (sums.hpp).
  void finish();

 private:
  std::filesystem::path folder_;
  Provenance provenance_;
  std::deque<std::pair<std::string, Table>> tables_{};
};

/// What the parts of a chapter write: tables.
struct Report {
  Output& output;
  bool quick;  ///< whether the run has coarse parameters

  /// A new table of the output, to be filled; without columns its first row has them.
  Table& table(const std::string& name, const Columns& columns = {});
};

/**
## Commands

A command is a struct that has a title, declares its parameters (parameters.hpp) and computes a `table()` from them, as in
CONTRIBUTING.md. `commands<OneRun, ...>()` is what a program offers of such structs. One that Python calls too has `find()`,
and two tables of what it found: `quantities` and `profile`. */
struct Title {
  const char *name, *meaning;
  /// The last line of its help: what is not obvious about its answers.
  const char* note = "A quantity that does not exist is nan; the column reason says why.";
};

/// A command as a program offers it.
struct Command {
  Title title;
  /// Declares the parameters and returns what computes the table from their values.
  std::function<std::function<Table()>(Parameters&)> declare;
};

/// The list of commands for `main`.
template <class... Declared>
std::vector<Command> commands() {
  return {Command{Declared::title, [](Parameters& p) -> std::function<Table()> {
                    const auto values = std::make_shared<Declared>();
                    values->parameters(p);
                    return [values] { return values->table(); };
                  }}...};
}

/// A program: its name, its section, its title, what computes the whole section, and commands.
struct Program {
  std::string name, section, title;
  std::function<void(Report&)> reproduce;
  std::vector<Command> commands = {};
};

/// Reads the line, computes and writes; returns the exit code. Every `main` ends with it.
int run(const Program& program, int argc, char** argv);

/// Calls `work` and returns the exit code: what it throws is one line under the name of the `program`.
int exit_code(const std::string& program, const std::function<void()>& work);

}  // namespace report
