#pragma once
/**
# Statements, judged on tables

Programs compute and claim nothing. What the article says stands in `paper/claims.ecsv`, and whether it is so is decided in
`src/statements`, in one file for each program: a function for each statement reads the tables that the figures are drawn
from, and compares.

    STATEMENT("impact.slower") {
      const Data sweep = table("velocity_sweep");
      for (double s : {-1.0 / 6, -0.7})
        for (const auto& soft : sweep.where("s", s).where("velocity", 0.3, HUGE_VAL))
          less(soft["speed"], sweep.at("s", 0, "velocity", soft("velocity"))["speed"]);
    }

A statement holds if each of its comparisons holds by more than the errors, and holds in part if some of them do: a
comparison stands for each point of the range that the article prints. Bounds that the article does not print are written
`bound(0.01)`, other natural choices are each a `reading`. A statement that is a number gives its `answer`
instead, which verdict.hpp compares with what is printed. A selection without a row, a row that is not the only one, a
column that is missing and a value without an error leave a statement unresolved. Nothing passes by having nothing to
compare. */

#include <cmath>
#include <compare>
#include <concepts>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <source_location>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "report/table.hpp"

namespace report {

/**
## Arithmetic with errors

A plain number, as in `less(0, x)`, is known to rounding; counts and whole numbers of a table are exact, and so is
`exact(3)`. The errors of both sides add up, those of products and quotients in the worst case; what is exact stays so. A quotient
whose denominator may be zero leaves the statement unresolved. */
Estimate operator+(const Estimate& a, const Estimate& b);
Estimate operator-(const Estimate& a, const Estimate& b);
Estimate operator*(const Estimate& a, const Estimate& b);
Estimate operator/(const Estimate& a, const Estimate& b);
Estimate operator-(const Estimate& a);
Estimate abs(const Estimate& a);

/// What stands in a table: a value with its error and the unit of its column.
struct Quantity : Estimate {
  std::string unit{};
};

/**
## The tables of all programs

They are read when a statement asks for them. Each cell that it reads is recorded: to say what a comparison is about, and so
that a test can change it and see whether the verdict changes. */
struct CellRead {
  std::string program, table, column;
  std::size_t row;
  auto operator<=>(const CellRead&) const = default;
};

/// A change of a column, or of one cell of it, for that test.
struct Change {
  std::string program, table, column;
  std::optional<std::size_t> row{};
  double factor = 1, offset = 0;
};

/// Why a statement has no verdict: a program that has not run, or what its tables lack.
struct NotRun {
  std::string program;
};
struct Unresolved {
  std::string why;
};

struct Source;  // a table, below

/// The tables of the programs in a folder.
class Tables {
 public:
  /// `folder` holds a folder of tables for each program.
  explicit Tables(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Throws NotRun if the program has not finished, Unresolved if it has no such table.
  const Table& of(const std::string& program, const std::string& name);
  /// What a cell says after the change.
  double changed(const Source& table, const std::string& column, std::size_t row,
                 double value) const;

  std::optional<Change> change{};
  /// Leaves only the first `rows` rows of a table, until `restore`.
  void cut(const std::string& program, const std::string& name, std::size_t rows);
  void restore();

 private:
  std::filesystem::path folder_;
  std::map<std::pair<std::string, std::string>, Table> read_{},
      whole_{};  ///< of those that are cut
};

/// What was read since the last comparison, and altogether.
struct Reading {
  Tables* tables;
  std::set<CellRead> latest{}, all{};
};

/**
## Rows and selections of rows

Keys match to 1e-9 of their size, since 94 times 0.01 is not 0.94. `row("s")` is a number that was given, such as a
parameter, and no result; `row["speed"]` is a result with its error, which is in the column `speed_error`. Whole numbers are
exact. */
struct Key : std::variant<double, std::string> {
  Key(double number) : variant(number) {}
  Key(std::integral auto number) : variant(double(number)) {}
  Key(const char* text) : variant(std::string(text)) {}
  Key(std::string text) : variant(std::move(text)) {}
};

/// A table that a statement reads.
struct Source {
  const Table& table;
  std::string program, name;
  Reading& reading;

  /// Throws Unresolved if there is no such column.
  std::size_t find(const std::string& column) const;
};

/// The rows of a table, or some of them.
class Data {
 public:
  struct Row {
    std::shared_ptr<const Source> source;
    std::size_t at;

    double operator()(const std::string& column) const;
    Quantity operator[](const std::string& column) const;
    const Cell& cell(const std::string& column) const;
  };

  explicit Data(Source source);

  /// The rows whose `column` is `key`, or from `low` to `high`. Throws Unresolved if there is none; each finite end must be
  /// the key of a row, since what is said of a range is not said of a part of it.
  Data where(const std::string& column, const Key& key) const;
  Data where(const std::string& column, double low, double high) const;
  /// The row with these keys, `at("s", 0, "velocity", 0.3)`. Throws Unresolved unless there is exactly one.
  Row at(const std::string& column, const Key& key, const auto&... more) const {
    const Data rows = where(column, key);
    if constexpr (sizeof...(more) == 0)
      return rows.only();
    else
      return rows.at(more...);
  }
  /// The only row of a table, or of a selection.
  Row only() const;
  /// A result in the only row.
  Quantity operator[](const std::string& column) const { return only()[column]; }
  std::size_t size() const { return rows_.size(); }
  const Row* begin() const { return rows_.data(); }
  const Row* end() const { return rows_.data() + rows_.size(); }

 private:
  Data chosen(const std::string& column, const std::function<bool(const Cell&)>& is,
              const std::string& wanted) const;

  std::shared_ptr<const Source> source_;
  std::vector<Row> rows_{};
};

/**
## Over several rows

Errors count: the least of some numbers may be as small as the least of their lower ends. */
Estimate least_of(const std::vector<Estimate>& all);
Estimate largest_of(const std::vector<Estimate>& all);

/// `of(row)` of every row; a name stands for what is in this column.
template <class Of>
std::vector<Estimate> each(const Data& rows, Of of) {
  std::vector<Estimate> out;
  for (const Data::Row& row : rows) {
    if constexpr (std::is_convertible_v<Of, std::string>)
      out.push_back(row[of]);
    else
      out.push_back(of(row));
  }
  return out;
}
template <class Of>
Estimate least(const Data& rows, Of of) {
  return least_of(each(rows, of));
}
template <class Of>
Estimate largest(const Data& rows, Of of) {
  return largest_of(each(rows, of));
}

/**
## A statement and what it finds */
struct Comparison {
  std::string what;       ///< the cells that were read for it
  Estimate small, large;  ///< the sides
  bool may_be_equal = false;
  bool is_flipped = false;  ///< by a test

  /// What is left to the limit: negative on the wrong side.
  Estimate left() const;
  bool holds() const;
  bool fails() const;
  bool is_decided() const;
  /// The same as a fraction of the larger side.
  Estimate margin() const;
  std::string text() const;
};

/// How far the comparisons of a statement hold. A part that is not decided decides nothing.
enum class Outcome { holds, in_part, fails, undecided };
Outcome outcome_of(const std::vector<Comparison>& all);

/// The same statement with another choice where the article prints none: a value of a number, an outcome of an assertion.
struct OtherReading {
  std::string name;
  std::optional<Quantity> value{};
  std::optional<Outcome> outcome{};
  bool is_bound = false;  ///< a bound of ours, halved or doubled
};

/// What a statement found.
struct Judged {
  std::string program{};  ///< whose tables decide
  std::vector<Comparison> comparisons{},
      controls{};  ///< of the measure: where one fails there is no verdict
  std::vector<OtherReading> readings{};
  std::optional<Quantity> answer{}, accuracy{};
  std::string answered_by{};  ///< the cells from which the answer was read
  std::string lost{};         ///< why there is no verdict
  std::string not_run{};      ///< the program that has not run
  bool is_quick = false;      ///< whether a table is of a coarse run
  std::set<CellRead> cells{};

  /// Whether a reading, or a bound of ours halved or doubled, has another outcome than the comparisons.
  bool is_sensitive() const;
  /// How many comparisons fail.
  int failures() const;
  /// The first control that fails.
  const Comparison* lost_control() const;
  /// The comparison with the smallest margin.
  const Comparison* closest() const;
  /// What was found, in a line: the answer, or the comparisons, of more than three only the closest one.
  std::string text() const;
};

/// What the body of a statement may call.
class Statement {
 public:
  virtual ~Statement() = default;
  Judged judged(Tables& tables, const std::string& program);

 protected:
  virtual void judge() = 0;

  /// A table of the program of this file, or of another one.
  Data table(const std::string& name);
  Data table(const std::string& program, const std::string& name);

  /// a < b by more than the errors of both.
  void less(const Estimate& a, const Estimate& b);
  /// The same, where equal within the errors is enough; errors as large as the sides decide nothing.
  void not_more(const Estimate& a, const Estimate& b);
  /// |a - b| < distance.
  void near(const Estimate& a, const Estimate& b, const Estimate& distance);
  /// A result grows from each row to the next, along a given number.
  void increases(const Data& rows, const std::string& along, const std::string& column);
  /// low < a < high.
  void within(const Estimate& a, const Estimate& low, const Estimate& high);

  /// A bound that is ours and not the article's. The statement is judged again with half and with twice of it; if its outcome
  /// changes, the verdict assumes this bound. One near one is written `1 - bound(0.05)`.
  Estimate bound(double ours, std::source_location at = std::source_location::current());
  /// Comparisons that make sure of the measure and claim nothing: two resolutions agree, a control run does what it must.
  void control(const std::function<void()>& compare);
  /// What another choice gives where the article prints none. Each is a row of `paper/readings.ecsv`.
  void reading(const std::string& name, const Quantity& value);
  void reading(const std::string& name, const Estimate& value) { reading(name, Quantity{value}); }
  void reading(const std::string& name, const std::function<void()>& compare);
  /// What is printed is compared with this number.
  void answer(const Quantity& found);
  void answer(const Estimate& found, const std::string& unit) { answer({{found}, unit}); }
  /// How accurate the article itself says that its number is.
  void accuracy(const Quantity& known) { judged_.accuracy = known; }

 private:
  using Place = std::pair<unsigned, unsigned>;  // line and column
  void note(const Estimate& a, const Estimate& b, bool may_be_equal);
  std::vector<Comparison> apart(const std::function<void()>& compare);
  Judged judged_once(Tables& tables, const std::string& program);
  std::string cells_read();

  Judged judged_{};
  Reading reading_{};
  std::string program_{};
  std::map<Place, double> bounds_{};  ///< those that were asked for
  Place changed_{};                   ///< the one that is halved or doubled
  double factor_ = 1;
};

/// All statements that are linked, by their ids.
struct Registered {
  std::string program;
  std::function<Judged(Tables&)> judge;
};
const std::map<std::string, Registered>& statements();

/// Judges all that are linked on the tables below `folder` and prints a line for each; whether all hold. For a chapter of
/// one's own, which has no list of what is printed.
bool all_hold(const std::filesystem::path& folder);

/// Adds one; throws std::logic_error for an id that is there.
struct Register {
  Register(const std::string& id, const char* file, Judged (*judge)(Tables&, const std::string&));
};

}  // namespace report

#define LATTICE_STATEMENT(id, name)                                                               \
  namespace {                                                                                     \
  struct name final : report::Statement {                                                         \
    void judge() override;                                                                        \
  };                                                                                              \
  const report::Register register_##name(id, __FILE__,                                            \
                                         [](report::Tables& tables, const std::string& program) { \
                                           return name().judged(tables, program);                 \
                                         });                                                      \
  }                                                                                               \
  void name::judge()
#define LATTICE_EXPANDED(id, number) LATTICE_STATEMENT(id, Statement_##number)
#define LATTICE_AT(id, number) LATTICE_EXPANDED(id, number)
/// A statement of the list with this id; its body follows.
#define STATEMENT(id) LATTICE_AT(id, __COUNTER__)
