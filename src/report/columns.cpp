#include "report/columns.hpp"

#include <map>
#include <sstream>
#include <utility>

#include "report/table.hpp"

namespace report {

static const char* list = "";  // of this program

ColumnList::ColumnList(const char* csv) {
  list = csv;
}

namespace {

struct Meaning {
  std::string unit, description, error;
};
using Meanings = std::map<std::pair<std::string, std::string>, Meaning>;  // by table and column

Meanings read_meanings() {
  Meanings out;
  std::istringstream text(list);
  std::string line;
  std::getline(text, line);  // the names of its columns
  while (std::getline(text, line)) {
    const auto cells = ecsv::fields(line);
    const std::string& error = cells.at(4);
    out[{cells[0], cells[1]}] = {cells[2], cells[3],
                                 error.empty() ? "difference of two resolutions" : error};
  }
  return out;
}

/// The row of the table itself or the one of all tables.
const Meaning* find(const Meanings& known, const std::string& table, const std::string& column) {
  for (const std::string& home : {table, std::string()})
    if (const auto found = known.find({home, column}); found != known.end()) return &found->second;
  return nullptr;
}

}  // namespace

void describe(const std::string& name, Table& table) {
  const Meanings known = read_meanings();
  for (Column& column : table.columns) {
    if (!column.description.empty()) continue;
    const Meaning* meaning = find(known, name, column.name);
    const bool is_error = !meaning && column.name.ends_with("_error");
    if (is_error) meaning = find(known, name, column.name.substr(0, column.name.rfind('_')));
    if (!meaning) continue;
    column.unit = meaning->unit;
    column.description = is_error ? meaning->error : meaning->description;
  }
}

}  // namespace report
