// ECSV: what is written is read back, bit by bit, and no half file is left.

#include "report/table.hpp"

#include <cstring>
#include <sstream>
#include <utility>

#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace report;

TEST_CASE("a table survives the round trip", "[unit][table]") {
  Table table{number("x", "a number, with 'quotes'", "m"), count("k", "a count"),
              label("s", "a text")};
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

TEST_CASE("a table that was cut or edited is refused", "[unit][table]") {
  Table table{{number("x", "a number"), count("k", "a count"), label("s", "a text")}};
  table.add({1.5, std::int64_t(2), std::string("a \"b\", c")});
  const std::string good = to_text(table);
  const auto refused = [](const std::string& text) {
    std::istringstream in(text);
    return !refusal<std::runtime_error>([&] { from_text(in); }).empty();
  };
  const auto with = [&](const std::string& old, const std::string& fresh) {
    std::string text = good;
    const auto at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), fresh);
  };
  CHECK_FALSE(refused(good));
  // Cut anywhere but behind the names and behind the row
  const std::size_t names = good.find("x,k,s\n") + 6;
  for (std::size_t n = 0; n < good.size(); ++n)
    if (n != names) {
      CAPTURE(n, good.substr(0, n));
      CHECK(refused(good.substr(0, n)));
    }
  const std::pair<const char*, const char*> edits[] = {
      {"x,k,s", "x,s,k"},   {"x,k,s", "x,k"},     {"1.5,2", "1.5,2.5"},
      {"1.5,2", "1_5,2"},   {"1.5,2", " 1.5,2"},  {"1.5,2", "1.5,"},
      {"1.5,2", "1.5,2,2"}, {"1.5,2", "1e999,2"}, {"1.5,2", "0x1,2"},
      {"1.5,2", "1.5"},     {"1.5,2", "1.5,2\r"}, {"\"a \"\"", "a \"\""},
      {"c\"\n", "c\n"},     {"c\"\n", "c\"d\n"},  {"1.5,2", "1.5,99999999999999999999"}};
  for (const auto& [old, fresh] : edits) {
    CAPTURE(old, fresh);
    CHECK(refused(with(old, fresh)));
  }
}

TEST_CASE("writing where it cannot leaves nothing", "[unit][table]") {
  const Scratch scratch;
  Table table{label("s", "")};
  CHECK_THROWS_AS(write("/nonexistent/folder/x.ecsv", table), std::runtime_error);
  write(scratch.path / "x.ecsv", table);
  CHECK_FALSE(std::filesystem::exists(scratch.path / "x.ecsv.part"));
  table.add({std::string("two\nlines")});
  CHECK_THROWS(write(scratch.path / "y.ecsv", table));
  std::filesystem::remove(scratch.path / "x.ecsv");
  CHECK(scratch.empty());
}

TEST_CASE("numbers are read in one way", "[unit][table]") {
  for (const char* text : {"31", "031", "+31", "31.0", "3.1e1", "3.1e+01"}) {
    CAPTURE(text);
    REQUIRE(parse_number(text));
    CHECK(*parse_number(text) == 31);
  }
  CHECK(*parse_number("-1.5e-3") == -1.5e-3);
  CHECK(*parse_number("0.1") == 0.1);
  for (const char* text : {"", " ", "1 ", " 1", "1,5", "0x1f", "1e", "--1", "+-1", "+", "one"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text));
  }
  CHECK(number_text(0.1 + 0.2) == "0.30000000000000004");
  CHECK(short_text(1e6) == "1000000");
  CHECK(short_text(-0.1) == "-0.1");
  CHECK(short_text(1e-6) == "1e-06");
}
