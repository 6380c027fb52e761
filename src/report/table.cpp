/**
# How tables are written and read

ECSV puts YAML into the comments of a CSV file. Both have rules of quoting, and these are all that is kept
here; what a table promises is said in table.hpp. */

#include "report/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace report {

Column number(std::string name, std::string description, std::string unit) {
  return {std::move(name), std::move(unit), std::move(description), Kind::real};
}
Column count(std::string name, std::string description, std::string unit) {
  return {std::move(name), std::move(unit), std::move(description), Kind::integer};
}
Column label(std::string name, std::string description) {
  return {std::move(name), "", std::move(description), Kind::text};
}

Columns::Columns(std::initializer_list<Columns> lists) {
  for (const Columns& list : lists) all.insert(all.end(), list.all.begin(), list.all.end());
}

Columns estimate(const std::string& name, std::string description, std::string unit,
                 std::string from) {
  return {number(name, std::move(description), unit),
          number(name + "_error", std::move(from), std::move(unit))};
}

Cells::Cells(std::initializer_list<Entry> entries) {
  for (const Entry& entry : entries) {
    push_back(entry.first);
    if (entry.second) push_back(*entry.second);
  }
}

// Rows come one by one or many at once, and columns are found by their names
void Table::add(Cells row) {
  bool fits = row.size() == columns.size();
  for (std::size_t i = 0; fits && i < row.size(); ++i)
    fits = row[i].index() == std::size_t(columns[i].kind);
  if (!fits) throw std::invalid_argument("a row does not fit the columns of its table");
  rows.push_back(std::move(row));
}

Row::Row(std::initializer_list<Headed> headed) : cells(headed) {}

void Table::add(const Row& row) {
  std::vector<Column> headings;
  Cells cells;
  for (const Headed& heading : row.cells) {
    const auto& [first, second] = heading.cell;
    headings.push_back({heading.name, heading.unit, heading.description, Kind(first.index())});
    cells.push_back(first);
    if (!second) continue;
    headings.push_back(number(std::string(heading.name) + "_error", heading.from, heading.unit));
    cells.push_back(*second);
  }
  if (columns.empty()) columns = headings;
  const auto same = [](const Column& a, const Column& b) { return a.name == b.name; };
  if (!std::equal(headings.begin(), headings.end(), columns.begin(), columns.end(), same))
    throw std::invalid_argument("a row does not have the columns of its table");
  add(std::move(cells));
}

// What is read back
std::size_t Table::find(const std::string& name) const {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return i;
  throw std::out_of_range("no column '" + name + "'");
}

std::vector<double> Table::numbers(const std::string& name) const {
  const std::size_t at = find(name);
  std::vector<double> out;
  for (const auto& row : rows) {
    const auto* count = std::get_if<std::int64_t>(&row[at]);
    out.push_back(count ? double(*count) : std::get<double>(row[at]));
  }
  return out;
}

std::vector<std::string> Table::texts(const std::string& name) const {
  const std::size_t at = find(name);
  std::vector<std::string> out;
  for (const auto& row : rows) out.push_back(std::get<std::string>(row[at]));
  return out;
}

/**
The functions of the standard library that we use here do not depend on the language of the machine. */
std::string number_text(double x) {
  if (std::isnan(x)) return "nan";
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 17).ptr;
  return std::string(buffer, end);
}

std::string short_text(double x) {
  if (x == std::floor(x) && std::abs(x) < 1e15) return std::to_string(std::int64_t(x));
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return x;
}

namespace ecsv {

/**
In YAML a single quote is doubled, in CSV a double one. A line break, which would end a row or a comment, is
refused in both. */
static std::string quoted(const std::string& text, char quote) {
  if (const auto end = text.find_first_of("\n\r"); end != std::string::npos)
    throw std::invalid_argument("a table cannot hold the line break in '" + text.substr(0, end) +
                                "...'");
  std::string out(1, quote);
  for (char c : text) out.append(c == quote ? 2 : 1, c);
  return out + quote;
}

/**
A text is quoted only if it is empty or if a comma, a quote or the sign of a comment in it would be
misread, so that plain words stay plain for gnuplot. */
std::string cell_text(const Cell& cell) {
  if (const auto* x = std::get_if<double>(&cell)) return number_text(*x);
  if (const auto* k = std::get_if<std::int64_t>(&cell)) return std::to_string(*k);
  const auto& text = std::get<std::string>(cell);
  const bool plain = !text.empty() && text.find_first_of(",\"#\n\r") == std::string::npos;
  return plain ? text : quoted(text, '"');
}

/**
Reading undoes the quoting. A line is split at the commas outside double quotes, and such quotes hold a whole
cell; if the line ends inside of them, the cell had a line break. */
std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool first = i == 0 || line[i - 1] == ',', last = i + 1 == line.size();
    if (inside && c == '"' && !last && line[i + 1] == '"')
      out.back() += line[++i];
    else if (c == '"' && (inside ? last || line[i + 1] == ',' : first))
      inside = !inside;
    else if (c == '"')
      throw std::runtime_error("a quote in the middle of a cell: " + line);
    else if (c == ',' && !inside)
      out.emplace_back();
    else
      out.back() += c;
  }
  if (inside) throw std::runtime_error("a cell with a line break: " + line);
  return out;
}

/**
A cell that is not what its column promises is an error, never a zero. */
Cell parse(const std::string& text, Kind kind) {
  if (kind == Kind::text) return text;
  if (kind == Kind::real) {
    const auto x = text.empty() ? std::numeric_limits<double>::quiet_NaN() : parse_number(text);
    if (!x) throw std::runtime_error("not a number: '" + text + "'");
    return *x;
  }
  std::int64_t k = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, k);
  if (error != std::errc() || stop != end) throw std::runtime_error("not a count: '" + text + "'");
  return k;
}

}  // namespace ecsv

/**
Now the whole table, in the order of ECSV 1.0: first the columns, then who made it, then the names and the
rows. */
static const char* const datatypes[] = {"float64", "int64", "string"};  // in the order of Kind

static std::string heading(const std::vector<Column>& columns) {
  std::string names;
  for (const Column& c : columns) names += (names.empty() ? "" : ",") + c.name;
  return names;
}

std::string to_text(const Table& table) {
  std::ostringstream out;
  const auto yaml = [](const std::string& text) { return ecsv::quoted(text, '\''); };
  out << "# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n";
  for (const Column& c : table.columns)
    out << "# - {name: " << yaml(c.name) << ", unit: " << yaml(c.unit)
        << ", datatype: " << datatypes[int(c.kind)] << ", description: " << yaml(c.description)
        << "}\n";
  out << "# meta: !!omap\n";
  for (const auto& [key, value] : table.meta) out << "# - {" << key << ": " << yaml(value) << "}\n";
  out << "# schema: astropy-2.0\n" << heading(table.columns) << '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i ? "," : "") << ecsv::cell_text(row[i]);
    out << '\n';
  }
  return out.str();
}

// A file has its name when it is whole
void write_whole(const std::filesystem::path& path, const std::string& text) {
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

void write(const std::filesystem::path& path, const Table& table) {
  write_whole(path, to_text(table));
}

/**
Of YAML we read only what we write: the value of `key` in a mapping on a single line, or an empty text if there is
none. */
static std::string yaml_value(const std::string& line, const std::string& key) {
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

static Column column_of(const std::string& line) {
  const std::string type = yaml_value(line, "datatype");
  return {yaml_value(line, "name"), yaml_value(line, "unit"), yaml_value(line, "description"),
          type == "string"  ? Kind::text
          : type == "int64" ? Kind::integer
                            : Kind::real};
}

static std::vector<Cell> row_of(const std::string& line, const std::vector<Column>& columns) {
  const auto cells = ecsv::fields(line);
  if (cells.size() != columns.size()) throw std::runtime_error("ragged row: " + line);
  std::vector<Cell> row;
  for (std::size_t i = 0; i < cells.size(); ++i)
    row.push_back(ecsv::parse(cells[i], columns[i].kind));
  return row;
}

/**
Up to the line `meta:` a line of the header describes a column, after it an entry of the provenance. The first line without
a comment repeats the names of the columns; the rows follow, and the last one ends like the others, or the file was cut
off. */
Table from_text(std::istream& in) {
  Table table;
  bool header_done = false, in_meta = false;
  for (std::string line; std::getline(in, line);) {
    if (in.eof()) throw std::runtime_error("the file is cut off in the line: " + line);
    if (line.empty()) continue;
    if (line.front() == '#') {
      if (line.rfind("# meta:", 0) == 0) in_meta = true;
      if (line.rfind("# - {", 0) != 0) continue;
      const std::string key = line.substr(5, line.find(": ", 5) - 5);
      if (in_meta)
        table.meta.emplace_back(key, yaml_value(line, key));
      else
        table.columns.push_back(column_of(line));
    } else if (header_done) {
      table.rows.push_back(row_of(line, table.columns));
    } else if (table.columns.empty() || line != heading(table.columns)) {
      throw std::runtime_error("the column names above the rows differ from those of the header: " +
                               line);
    } else {
      header_done = true;
    }
  }
  if (!header_done) throw std::runtime_error("not a table: the file ends in its header");
  return table;
}

Table read(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  try {
    return from_text(in);
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace report
