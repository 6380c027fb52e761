// The list of a run: as sha256sum writes and reads it, over the bytes of the tables, and the same everywhere.

#include "report/sums.hpp"

#include <cstdlib>

#include "report/program.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace lattice;
using namespace report;

TEST_CASE("the sum is SHA-256", "[unit][sums]") {
  // Of the standard, FIPS 180-2
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_of("/none").empty());
}

TEST_CASE("a run lists its tables for sha256sum, without what differs between machines",
          "[unit][sums]") {
  const Scratch scratch;
  const auto list_of = [&](const char* revision) {
    setenv("LATTICE_REVISION", revision, 1);
    Output output(scratch.path, {{{"program", "sec1_demo"}}, {{"quick", "yes"}}});
    Table& speeds = output.add("speeds", {number("x", "number")});
    speeds.add({1.0});
    output.add("impacts", speeds);
    output.finish();
    const Table run = read(scratch.path / "run.ecsv");
    CHECK(run.texts("value")[0] == sha256_of("/proc/self/exe"));
    CHECK(run.texts("value")[1] == revision);
    return sums_in(scratch.path);
  };
  const Sums one = list_of("one");
  REQUIRE(one.size() == 2);
  CHECK(one == list_of("two"));
  for (const auto& [name, sum] : one) CHECK(sum == sha256_of(scratch.path / name));
  const std::string check =
      "cd '" + scratch.path.string() + "' && sha256sum --strict --quiet -c SHA256SUMS 2> said";
  CHECK(std::system(check.c_str()) == 0);
  write(scratch.path / "speeds.ecsv", Table{number("x", "number")});
  CHECK(std::system(check.c_str()) != 0);
  unsetenv("LATTICE_REVISION");
}

TEST_CASE("a coarse table says so", "[unit][sums]") {
  Table table{number("x", "number")};
  CHECK_FALSE(is_quick(table));
  table.meta = {{"command", "p --quick"}, {"parameters", "quick = no"}};
  CHECK_FALSE(is_quick(table));
  table.meta[1].second = "sites = 3, quick = yes";
  CHECK(is_quick(table));
}
