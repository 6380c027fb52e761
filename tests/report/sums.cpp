// The list of a run: as sha256sum writes and reads it, over the bytes of the tables, and the same everywhere.

#include "report/sums.hpp"

#include <cstdlib>

#include "report/program.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace report;

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
