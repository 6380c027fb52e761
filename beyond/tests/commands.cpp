// Maps computed in parts (commands/sweep.hpp).

#include "commands/sweep.hpp"

#include <atomic>
#include <filesystem>

#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace lattice;
using namespace report;
namespace fs = std::filesystem;

namespace {

Sweep squares(const fs::path& folder, const std::string& parameters = "squares") {
  return {folder,
          "squares",
          {number("x", "root"), number("y", "a third of its square")},
          10,
          parameters};
}

/// Computes a part and counts the points that had to be computed.
std::size_t work(Sweep& sweep, Part part) {
  std::atomic<std::size_t> count{0};
  sweep.compute(part, [&](std::size_t i) {
    ++count;
    return Cells{double(i), double(i * i) / 3};
  });
  return count;
}

}  // namespace

TEST_CASE("parts of a map merge to the same bytes", "[unit][sweep]") {
  Scratch whole, parts;
  Sweep all = squares(whole.path);
  CHECK(work(all, {}) == 10);
  for (std::size_t k : {3, 1, 2}) {
    Sweep one = squares(parts.path);
    CHECK(work(one, {k, 3}) == (k == 1 ? 4 : 3));
    CHECK(one.table({k, 3}).rows.size() == (k == 1 ? 4 : 3));
  }
  Sweep merged = squares(parts.path);
  CHECK(work(merged, {}) == 0);
  CHECK(to_text(merged.table()) == to_text(all.table()));
  merged.forget();
  CHECK(parts.empty());
}

TEST_CASE("a row that failed is not kept", "[unit][sweep]") {
  Scratch folder;
  Sweep sweep = squares(folder.path);
  CHECK_THROWS_AS(sweep.compute({},
                                [](std::size_t i) {
                                  if (i == 4) throw std::runtime_error("no");
                                  return Cells{double(i), 1.0};
                                }),
                  std::runtime_error);
  CHECK(squares(folder.path).table().rows.size() < 10);
}

TEST_CASE("parts are written k/n", "[unit][sweep]") {
  CHECK(parse_part("2/8").index == 2);
  for (const char* bad :
       {"", "0/3", "4/3", "1", "1/", "a/b", "1/2/3", "-1/2", "1/0", " 1/2", "1/999999"})
    CHECK_THROWS_AS(parse_part(bad), std::invalid_argument);
}
