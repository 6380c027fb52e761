// What section 2 found: counts and limits.

#include <filesystem>

#include "check.hpp"
#include "run.hpp"

using namespace lattice;

namespace {

const std::filesystem::path data = DATA_DIR, tables = data / "sec2_nonexistence";

double number_of(const std::filesystem::path& table, const std::string& name,
                 const std::string& column) {
  const Table t = read(table);
  return t.numbers(column)[row_of(t, name)];
}

double fact(const std::string& name) {
  return number_of(tables / "facts.ecsv", name, "value");
}

}  // namespace

TEST_CASE("searches are counted completely, and the free chain has no end but two",
          "[published][mean_force]") {
  const Table t = read(tables / "searches.ecsv");
  const double all = fact("searches");
  CHECK(all == 100);
  for (const Column& column : t.columns) {
    if (column.name == "ends_in") continue;
    double sum = 0;
    for (double x : t.numbers(column.name)) sum += x;
    CAPTURE(column.name);
    CHECK(sum == all);
  }
  for (const char* end : {"localized", "extended", "doubtful"})
    for (const char* column : {"free", "free_fine", "free_large", "free_large_fine"})
      CHECK(number_of(tables / "searches.ecsv", end, column) == 0);
  CHECK(number_of(tables / "searches.ecsv", "localized", "wells") > all / 20);
  CHECK(number_of(tables / "searches.ecsv", "extended", "walls") > all / 20);
}

TEST_CASE("what is not periodic is not mistaken for a motion of the free chain",
          "[published][mean_force]") {
  CHECK(fact("mean_force_spread_not_periodic") > 1e4 * fact("mean_force_spread_uneven_ring"));
}
