// ECSV: what is written is read back, bit by bit, and no half file is left.

#include "lattice/report/table.hpp"

#include <cstring>

#include "check.hpp"

using namespace lattice;

TEST_CASE("a table survives the round trip", "[unit][table]") {
  Table table{{{"x", "m", "a number, with 'quotes'", Kind::real},
               {"k", "", "a count", Kind::integer},
               {"s", "", "a text", Kind::text}}};
  table.meta = {{"program", "test"}, {"command", "test --a 'b c', d}"}};
  table.add({0.1, std::int64_t(-3), std::string("plain")});
  table.add({-5e-324, std::int64_t(1) << 60, std::string("comma, \"quote\" # hash")});
  table.add({std::nan(""), std::int64_t(0), std::string()});
  std::istringstream in(to_text(table));
  const Table back = from_text(in);
  REQUIRE(back.columns.size() == 3);
  CHECK(back.columns[0].description == "a number, with 'quotes'");
  CHECK(back.columns[0].unit == "m");
  CHECK(back.meta == table.meta);
  CHECK(back.texts("s") == table.texts("s"));
  const auto x = back.numbers("x"), y = table.numbers("x");
  CHECK(std::memcmp(x.data(), y.data(), 2 * sizeof(double)) == 0);
  CHECK(std::isnan(x[2]));
  CHECK(std::get<std::int64_t>(back.rows[1][1]) == std::int64_t(1) << 60);
  CHECK(to_text(back) == to_text(table));
}

TEST_CASE("rows must fit, columns must exist", "[unit][table]") {
  Table table{{{"x", "", "", Kind::real}}};
  CHECK_THROWS_AS(table.add({std::int64_t(1)}), std::invalid_argument);
  CHECK_THROWS_AS(table.add({1.0, 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(table.numbers("y"), std::out_of_range);
  std::istringstream ragged(
      "# - {name: 'x', unit: '', datatype: float64, description: ''}\nx\n1,2\n");
  CHECK_THROWS_AS(from_text(ragged), std::runtime_error);
}

TEST_CASE("writing where it cannot leaves nothing", "[unit][table]") {
  const Table table{{{"x", "", "", Kind::real}}};
  CHECK_THROWS_AS(write("/nonexistent/folder/x.ecsv", table), std::runtime_error);
  const auto path = std::filesystem::temp_directory_path() / "lattice_table_test.ecsv";
  write(path, table);
  CHECK(std::filesystem::exists(path));
  CHECK_FALSE(std::filesystem::exists(path.string() + ".part"));
  std::filesystem::remove(path);
}
