#pragma once
/**
# Tables on disk

Every number leaves a program in an ECSV 1.0 table: comma-separated rows under a header in comments,
written in YAML, that names each column, its unit and its meaning, and says which command made the file.
gnuplot, pandas and astropy read it as it is, and the tests read the very files from which the figures
are drawn.

Numbers have 17 significant digits, enough to restore the same bits. A file is written under a temporary
name and then renamed, so that an interrupted run leaves either the old file or the new one. It contains
no time of day; hence equal inputs give equal bytes.

A row is a line: text with a line break is refused when a table is written, and so is a file that has one
when it is read. */

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace lattice {

/// One entry: a number, a count or a text.
using Cell = std::variant<double, std::int64_t, std::string>;

enum class Kind { real, integer, text };

/// The heading of a column.
struct Column {
  std::string name, unit, description;
  Kind kind = Kind::real;
};

/**
A table should explain itself, so no column can be made without a description. There are columns of
numbers, of counts and of texts; the unit is empty if the quantity is dimensionless. */
inline Column number(std::string name, std::string description, std::string unit = "") {
  return {std::move(name), std::move(unit), std::move(description), Kind::real};
}
inline Column count(std::string name, std::string description, std::string unit = "") {
  return {std::move(name), std::move(unit), std::move(description), Kind::integer};
}
inline Column label(std::string name, std::string description) {
  return {std::move(name), "", std::move(description), Kind::text};
}

/// Ordered `key: value` pairs of the header's `meta` block.
using Meta = std::vector<std::pair<std::string, std::string>>;

/**
A row that does not fit its columns would shift all that follows, and a misspelt column would go unnoticed
until someone looked for it. Both are errors here, in writing as in reading. */
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows{};
  Meta meta{};

  /// Appends a row; throws std::invalid_argument unless it has one cell of the right kind per column.
  void add(std::vector<Cell> row) {
    bool fits = row.size() == columns.size();
    for (std::size_t i = 0; fits && i < row.size(); ++i)
      fits = row[i].index() == std::size_t(columns[i].kind);
    if (!fits) throw std::invalid_argument("a row does not fit the columns of its table");
    rows.push_back(std::move(row));
  }

  /// Position of the column `name`; throws std::out_of_range if there is none.
  std::size_t find(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == name) return i;
    throw std::out_of_range("no column '" + name + "'");
  }

  /**
  Tests and programs read columns by name, as the scripts of the figures do. Counts are converted if
  numbers are asked for. Throws std::out_of_range if there is no such column. */
  std::vector<double> numbers(const std::string& name) const {
    const std::size_t at = find(name);
    std::vector<double> out;
    for (const auto& row : rows) {
      const auto* count = std::get_if<std::int64_t>(&row[at]);
      out.push_back(count ? double(*count) : std::get<double>(row[at]));
    }
    return out;
  }

  /// The texts of column `name`.
  std::vector<std::string> texts(const std::string& name) const {
    const std::size_t at = find(name);
    std::vector<std::string> out;
    for (const auto& row : rows) out.push_back(std::get<std::string>(row[at]));
    return out;
  }
};

/**
Numbers become text and text becomes numbers here and nowhere else, whatever language the machine is set
to: 17 significant digits restore every bit, and `nan` stands where there is no value. */
inline std::string number_text(double x) {
  if (std::isnan(x)) return "nan";
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 17).ptr;
  return std::string(buffer, end);
}

/// The fewest digits that restore `x`, for people to read.
inline std::string short_text(double x) {
  if (x == std::floor(x) && std::abs(x) < 1e15) return std::to_string(std::int64_t(x));
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
}

/// The decimal number, with or without a sign, that is the whole of `text`; nothing if it is none. All
/// programs read their numbers through this function.
inline std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return x;
}

namespace ecsv {

/**
ECSV puts YAML into the comments of a CSV file, and each has its own rules of quoting. In YAML a single
quote is doubled, in CSV a double one. A line break, which would end a row or a comment, is refused in
both. */
inline const char* datatype(Kind kind) {
  return kind == Kind::real ? "float64" : kind == Kind::integer ? "int64" : "string";
}

/// Throws std::invalid_argument if `text` has a line break.
inline const std::string& one_line(const std::string& text) {
  if (text.find_first_of("\n\r") != std::string::npos)
    throw std::invalid_argument("a table cannot hold the line break in '" +
                                text.substr(0, text.find_first_of("\n\r")) + "...'");
  return text;
}

/// A YAML single-quoted scalar.
inline std::string quoted(const std::string& text) {
  one_line(text);
  std::string out = "'";
  for (char c : text) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

/**
A text is quoted only if it is empty or if a comma, a quote or the sign of a comment in it would be
misread, so that plain words stay plain for gnuplot. */
inline std::string cell_text(const Cell& cell) {
  if (const auto* x = std::get_if<double>(&cell)) return number_text(*x);
  if (const auto* k = std::get_if<std::int64_t>(&cell)) return std::to_string(*k);
  const auto& text = one_line(std::get<std::string>(cell));
  if (!text.empty() && text.find_first_of(",\"#") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/**
Reading undoes the quoting. A line is split at the commas outside double quotes. If it ends inside such
quotes, a cell had a line break: throws std::runtime_error. */
inline std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (inside && c == '"' && i + 1 < line.size() && line[i + 1] == '"')
      out.back() += line[++i];
    else if (c == '"')
      inside = !inside;
    else if (c == ',' && !inside)
      out.emplace_back();
    else
      out.back() += c;
  }
  if (inside) throw std::runtime_error("a cell with a line break: " + line);
  return out;
}

/**
Of YAML we read only what we write: `yaml_value` is the value of `key` in a mapping on a single line, or an
empty text if there is none. */
inline std::string yaml_value(const std::string& line, const std::string& key) {
  const auto at = line.find(key + ": ");
  if (at == std::string::npos) return "";
  std::size_t i = at + key.size() + 2;
  std::string out;
  if (line[i] != '\'') return line.substr(i, line.find_first_of(",}", i) - i);
  for (++i; i < line.size(); ++i) {
    if (line[i] == '\'' && (i + 1 >= line.size() || line[i + 1] != '\'')) break;
    if (line[i] == '\'') ++i;
    out += line[i];
  }
  return out;
}

/**
A cell that is not what its column promises is an error (std::runtime_error), never a zero. An empty number
is `nan`. */
inline Cell parse(const std::string& text, Kind kind) {
  if (kind == Kind::text) return text;
  if (kind == Kind::real) {
    const auto x = text.empty() ? std::numeric_limits<double>::quiet_NaN() : parse_number(text);
    if (!x) throw std::runtime_error("not a number: '" + text + "'");
    return *x;
  }
  const char *begin = text.data(), *end = begin + text.size();
  std::int64_t k = 0;
  const auto result = std::from_chars(begin, end, k);
  if (result.ec != std::errc() || result.ptr != end)
    throw std::runtime_error("not a count: '" + text + "'");
  return k;
}

}  // namespace ecsv

/**
Now the whole table, in the order of ECSV 1.0: first the columns, then who made it, then the names and the
rows. Throws std::invalid_argument if a text has a line break. */
inline std::string to_text(const Table& table) {
  std::ostringstream out;
  out << "# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n";
  for (const Column& c : table.columns)
    out << "# - {name: " << ecsv::quoted(c.name) << ", unit: " << ecsv::quoted(c.unit)
        << ", datatype: " << ecsv::datatype(c.kind)
        << ", description: " << ecsv::quoted(c.description) << "}\n";
  out << "# meta: !!omap\n";
  for (const auto& [key, value] : table.meta)
    out << "# - {" << key << ": " << ecsv::quoted(value) << "}\n";
  out << "# schema: astropy-2.0\n";
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    out << (i ? "," : "") << table.columns[i].name;
  out << '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i ? "," : "") << ecsv::cell_text(row[i]);
    out << '\n';
  }
  return out.str();
}

/**
A reader must never find half a file, so `text` is written under a temporary name and the file renamed. If
`path` is not an ordinary file (a device, a pipe) it is written to directly. Throws std::runtime_error on
failure and leaves nothing behind. */
inline void write_whole(const std::filesystem::path& path, const std::string& text) {
  std::error_code ignored, failed;
  const bool special =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  const std::filesystem::path part = path.string() + (special ? "" : ".part");
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  bool good = bool(out);
  if (good && !special) {
    std::filesystem::rename(part, path, failed);
    good = !failed;
  }
  if (good) return;
  if (!special) std::filesystem::remove(part, ignored);
  throw std::runtime_error("cannot write " + path.string());
}

/// Writes a table; throws like `to_text` and `write_whole`.
inline void write(const std::filesystem::path& path, const Table& table) {
  write_whole(path, to_text(table));
}

/**
To read a table, its header is taken apart line by line: up to the line `meta:` a line describes a
column, after it an entry of the provenance. */
namespace ecsv {

inline Column column_of(const std::string& line) {
  const std::string type = yaml_value(line, "datatype");
  return {yaml_value(line, "name"), yaml_value(line, "unit"), yaml_value(line, "description"),
          type == "string"  ? Kind::text
          : type == "int64" ? Kind::integer
                            : Kind::real};
}

inline std::pair<std::string, std::string> entry_of(const std::string& line) {
  const std::string body = line.substr(5), key = body.substr(0, body.find(": "));
  return {key, yaml_value(line, key)};
}

inline std::vector<Cell> row_of(const std::string& line, const std::vector<Column>& columns) {
  const auto cells = fields(line);
  if (cells.size() != columns.size()) throw std::runtime_error("ragged row: " + line);
  std::vector<Cell> row;
  for (std::size_t i = 0; i < cells.size(); ++i) row.push_back(parse(cells[i], columns[i].kind));
  return row;
}

}  // namespace ecsv

/**
`from_text` reads what `to_text` writes, and other ECSV files whose columns are described on one line
each. The first line without a comment repeats the names of the columns; the rows follow. Throws
std::runtime_error for a row or cell that does not fit. */
inline Table from_text(std::istream& in) {
  Table table;
  bool header_done = false, in_meta = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.front() == '#') {
      if (line.rfind("# meta:", 0) == 0) in_meta = true;
      if (line.rfind("# - {", 0) != 0) continue;
      if (in_meta)
        table.meta.push_back(ecsv::entry_of(line));
      else
        table.columns.push_back(ecsv::column_of(line));
    } else if (!header_done) {
      header_done = true;
    } else if (!line.empty()) {
      table.rows.push_back(ecsv::row_of(line, table.columns));
    }
  }
  return table;
}

/**
If a table cannot be read, the message must say which file it was: `read` throws std::runtime_error with
the name of the file. */
inline Table read(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  try {
    return from_text(in);
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace lattice
