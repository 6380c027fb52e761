#include "report/columns.hpp"

#include <map>
#include <sstream>
#include <utility>

#include "report/table.hpp"

namespace report {

static const char* list = nullptr;  // of this program

ColumnList::ColumnList(const char* ecsv) {
  list = ecsv;
}

namespace {

struct Meaning {
  std::string unit, description, error;
};
using Meanings = std::map<std::pair<std::string, std::string>, Meaning>;  // by table and column

Meanings read_meanings() {
  Meanings out;
  if (!list) return out;
  std::istringstream text(list);
  const Table table = from_text(text);
  const auto tables = table.texts("table"), columns = table.texts("column"),
             units = table.texts("unit"), descriptions = table.texts("description"),
             errors = table.texts("error");
  for (std::size_t i = 0; i < tables.size(); ++i)
    out[{tables[i], columns[i]}] = {
        units[i], descriptions[i], errors[i].empty() ? "difference of two resolutions" : errors[i]};
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
  const std::string error = "_error";
  for (Column& column : table.columns) {
    if (!column.description.empty()) continue;
    if (const Meaning* own = find(known, name, column.name)) {
      column.unit = own->unit;
      column.description = own->description;
      continue;
    }
    if (!column.name.ends_with(error)) continue;
    const std::string of = column.name.substr(0, column.name.size() - error.size());
    if (const Meaning* whole = find(known, name, of)) {
      column.unit = whole->unit;
      column.description = whole->error;
    }
  }
}

}  // namespace report
