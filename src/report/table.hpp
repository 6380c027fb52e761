#pragma once
/**
# Tables on disk

Every number leaves a program in an ECSV 1.0 table: comma-separated rows under a header in comments,
written in YAML, that names each column, its unit and its meaning, and says which command made the file.
gnuplot, pandas and astropy read it as it is, and the tests read the very files from which the figures
are drawn.

Numbers have 17 significant digits, enough to restore the same bits, and a file contains no time of day; hence equal
inputs give equal bytes. A row is a line: text with a line break is refused when a table is written, and so is a file that
has one when it is read. */

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <iosfwd>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/parallel.hpp"

namespace report {

using namespace lattice;  // whose numbers it writes

/// One entry: a number, a count or a text.
using Cell = std::variant<double, std::int64_t, std::string>;

/// What a column holds: float64, int64 or string of the header.
enum class Kind { real, integer, text };

/// The heading of a column; the unit is empty if the quantity is dimensionless.
struct Column {
  std::string name, unit, description;
  Kind kind = Kind::real;
};
/// A column of real numbers.
Column number(std::string name, std::string description, std::string unit = "");
/// A column of whole numbers.
Column count(std::string name, std::string description, std::string unit = "");
/// A column of texts.
Column label(std::string name, std::string description);

/// Columns one after the other; a list of them may hold single columns and other lists.
struct Columns {
  std::vector<Column> all;

  Columns(Column column) : all{std::move(column)} {}
  Columns(std::vector<Column> columns) : all(std::move(columns)) {}
  Columns(std::initializer_list<Columns> lists);
};

/// A number with the column of its error, `x_error` to the right of `x`, which says in words `from` what the error was
/// obtained. A test asks every error for one per cent of its number; where it is to be judged on another scale these words
/// say so, such as *against the largest* (MAINTAINING.md).
Columns estimate(const std::string& name, std::string description, std::string unit = "",
                 std::string from = "difference of two resolutions");

/// A row is written as one would say it, `{s, speed, "fast"}`: whole numbers are counts, and an `Estimate` fills
/// two cells, its number and its error.
class Cells : public std::vector<Cell> {
 public:
  struct Entry {
    template <class T>
    requires std::integral<T> || std::is_enum_v<T> Entry(T k) : first(std::int64_t(k)) {}
    template <std::floating_point T>
    Entry(T x) : first(double(x)) {}
    template <class T>
    requires std::convertible_to<T, std::string> Entry(T&& text)
        : first(std::string(std::forward<T>(text))) {}
    Entry(const Estimate& e) : first(e.value), second(e.error) {}
    Entry(Cell cell) : first(std::move(cell)) {}

    Cell first;
    std::optional<double> second{};
  };

  Cells() = default;
  Cells(std::initializer_list<Entry> entries);
};

/**
A row is best written with its headings, `{{"s", s}, {"speed", runs.of(speed)}}`: the first row of a table that has no
columns yet makes them, of the kind that its cells have, and all others must be alike. What the columns of a chapter mean
stands beside it, in src/columns (columns.hpp). A command says it at once, `{"s", "anharmonicity of the well", s}`. */
struct Headed {
  Headed(const char* column, Cells::Entry entry) : name(column), cell(std::move(entry)) {}
  Headed(const char* column, const char* means, Cells::Entry entry, const char* in = "",
         const char* error_from = "difference of two resolutions")
      : name(column), description(means), cell(std::move(entry)), unit(in), from(error_from) {}

  const char *name, *description = "";  ///< literals
  Cells::Entry cell;
  const char *unit = "", *from = "";  ///< what an error was obtained from
};
struct Row {
  std::vector<Headed> cells{};
  Row() = default;
  Row(std::initializer_list<Headed> headed);
};

/// Ordered `key: value` pairs of the header's `meta` block.
using Meta = std::vector<std::pair<std::string, std::string>>;

/// A row that does not fit its columns and a column that is misspelt are errors, in writing as in reading.
struct Table {
  std::vector<Column> columns{};
  std::vector<std::vector<Cell>> rows{};
  Meta meta{};

  Table() = default;
  Table(std::initializer_list<Columns> lists) : columns(Columns(lists).all) {}

  /// Appends a row; throws std::invalid_argument unless it has one cell of the right kind per column.
  void add(Cells row);
  /// The same with headings; throws too where they are not those of the table.
  void add(const Row& row);

  /// Appends the row `of(item)` for every item, computed on all cores and in the order of `items`, and shows on a terminal
  /// how many are `done`.
  template <class Items, class Of>
  void fill(Items&& items, Of of, const std::string& done = "rows") {
    std::vector<decltype(of(*std::begin(items)))> fresh(std::size(items));
    parallel_for(done, fresh.size(),
                 [&](std::size_t i) { fresh[i] = of(*std::next(std::begin(items), i)); });
    for (auto& row : fresh) add(std::move(row));
  }

  /// Position of the column `name`; throws std::out_of_range if there is none.
  std::size_t find(const std::string& name) const;
  /// The numbers or counts of column `name`; throws std::bad_variant_access if it holds texts.
  std::vector<double> numbers(const std::string& name) const;
  /// The texts of column `name`; throws std::bad_variant_access if it holds none.
  std::vector<std::string> texts(const std::string& name) const;
};

/**
Numbers become text and text becomes numbers here and nowhere else, whatever language the machine is set to. */
/// The number with 17 significant digits, which restore every bit; a missing value is `nan`.
std::string number_text(double x);
/// The fewest digits that restore `x`, for people to read.
std::string short_text(double x);
/// The decimal number, with or without a sign, that is the whole of `text`; nothing if it is none.
std::optional<double> parse_number(std::string_view text);

/// The text of a table. Throws std::invalid_argument if a text in it has a line break.
std::string to_text(const Table& table);
/// The table of a text; other ECSV files are read too if their columns are described on one line each. Throws
/// std::runtime_error for a row or cell that does not fit.
Table from_text(std::istream& in);

/// Writes `text` under a temporary name and renames the file, so that a reader never finds half of it; what is no ordinary
/// file (a device, a pipe) is written to directly. Throws std::runtime_error on failure and leaves nothing behind.
void write_whole(const std::filesystem::path& path, const std::string& text);
/// Writes a table; throws like `to_text` and `write_whole`.
void write(const std::filesystem::path& path, const Table& table);
/// Reads a table; what is thrown, a std::runtime_error, has the name of the file.
Table read(const std::filesystem::path& path);

/**
Single rows are kept in files too, cell by cell. */
namespace ecsv {

/// The text of a cell, quoted if it would be misread.
std::string cell_text(const Cell& cell);
/// The cells of a line, unquoted. Throws std::runtime_error if the line ends inside quotes.
std::vector<std::string> fields(const std::string& line);
/// Throws std::runtime_error if `text` is not what the column promises. An empty number is `nan`.
Cell parse(const std::string& text, Kind kind);

}  // namespace ecsv

}  // namespace report
