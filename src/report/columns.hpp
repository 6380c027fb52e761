#pragma once
/**
# What the columns of a chapter mean

A chapter names a column where it computes it, and nothing more. What is in the column, its unit and where its error comes
from is written into the header of the table, and stands in a list of the chapter's own: `src/columns/<program>.csv` with
the columns *table*, *column*, *unit* (empty if dimensionless), *description* and *error* (what the error beside it was
obtained from; empty: difference of two resolutions). A row without a table is for all tables that have none of their own
for that column. The list is compiled into the program. A column that is not in it can be written all the same; `make test`
asks for its row. */

#include <string>

namespace report {

struct Table;  // of table.hpp, which a list of columns need not read

/// Makes a list known to the program, whose text lives as long as it. One object of it stands beside each chapter.
struct ColumnList {
  explicit ColumnList(const char* csv);
};

/// Fills in units and descriptions that the columns of `table` lack, for the table of this `name`.
void describe(const std::string& name, Table& table);

}  // namespace report
