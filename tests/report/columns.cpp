// What columns mean: a row of the table itself, one of all tables, and the words of errors.

#include "report/columns.hpp"

#include "report/table.hpp"
#include "support/check.hpp"

using namespace report;

TEST_CASE("a column takes its meaning from the list beside the chapter", "[unit][table]") {
  Table table;
  table.add({{"velocity", 1.9}, {"speed", Estimate(0.2, 1e-6)}, {"drift", Estimate(1e-9, 0.0)}});
  const ColumnList list(R"(table,column,unit,description,error
"",velocity,"",of the impact,""
"",speed,m/s,anywhere,""
sweep,speed,site per unit of time,"mean, to site 60",two steps and the fit
"",drift,"",of the energy,""
)");
  describe("sweep", table);
  CHECK(table.columns[0].description == "of the impact");
  CHECK(table.columns[1].description == "mean, to site 60");
  CHECK(table.columns[1].unit == "site per unit of time");
  CHECK(table.columns[2].description == "two steps and the fit");
  CHECK(table.columns[2].unit == "site per unit of time");
  CHECK(table.columns[4].description == "difference of two resolutions");

  // Another table has the row of all tables, and what a program says itself stays
  Table other{number("speed", ""), number("drift", "said at once"), number("unknown", "")};
  other.add({1.0, 2.0, 3.0});
  describe("profiles", other);
  CHECK(other.columns[0].description == "anywhere");
  CHECK(other.columns[1].description == "said at once");
  CHECK(other.columns[2].description.empty());
}
