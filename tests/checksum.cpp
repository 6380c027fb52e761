// Checksums: SHA-256 by the examples of its standard, and a table that was altered is found.

#include "report/checksum.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "check.hpp"
#include "report/program.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

/// A folder as a full run leaves it.
struct Finished {
  fs::path path = fs::temp_directory_path() / ("lattice_sums_" + std::to_string(::getpid()));
  Finished() {
    fs::remove_all(path);
    fs::create_directories(path);
    Table speeds{{number("speed", "of a packet"), label("how", "in words")}};
    speeds.add({1.5, std::string("slow # comma, \"quote\"")});
    speeds.add({2.5, std::string("fast")});
    Output output(path, {{{"command", "test --speeds"}}, {}});
    output.add("speeds", speeds);
    Results results;
    results.add("a.b", {1, 0.1});
    output.finish(results);
  }
  ~Finished() { fs::remove_all(path); }

  std::string text(const std::string& name) const {
    std::ifstream in(path / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Replaces `old` in a file and returns what is noticed.
  std::vector<std::string> with(const std::string& name, const std::string& old,
                                const std::string& fresh) const {
    std::string all = text(name);
    const auto at = all.find(old);
    REQUIRE(at != std::string::npos);
    std::ofstream(path / name, std::ios::binary) << all.replace(at, old.size(), fresh);
    return altered_tables(path);
  }
};

void check_only(const std::vector<std::string>& complaints, const std::string& about) {
  REQUIRE(complaints.size() == 1);
  CHECK(complaints[0].find(about) != std::string::npos);
}

}  // namespace

TEST_CASE("SHA-256 agrees with the examples of its standard", "[unit][checksum]") {
  CHECK(sha256_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256_of(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("every length up to three blocks has its own checksum", "[unit][checksum]") {
  std::map<std::string, std::size_t> seen;
  for (std::size_t n = 0; n <= 192; ++n) seen[sha256_of(std::string(n, '\0'))] = n;
  CHECK(seen.size() == 193);
}

TEST_CASE("a run leaves the checksums of its tables", "[unit][checksum]") {
  const Finished run;
  CHECK(altered_tables(run.path).empty());
  CHECK(read_checksums(run.path).size() == 2);
  CHECK(fs::last_write_time(run.path / checksums_name) <=
        fs::last_write_time(run.path / "results.ecsv"));
  const std::string command = "cd '" + run.path.string() +
                              "' && test \"$(for t in *.ecsv; do grep -v '^#' $t | sha256sum | "
                              "sed s/-/$t/; done | sort)\" = \"$(sort SHA256SUMS)\"";
  CHECK(std::system(command.c_str()) == 0);
}

TEST_CASE("what was done to a table is noticed", "[unit][checksum]") {
  check_only(Finished().with("speeds.ecsv", "2.5", "5"), "speeds.ecsv: not what");
  check_only(Finished().with("speeds.ecsv", "2.5,fast\n", ""), "speeds.ecsv: not what");
  check_only(Finished().with("speeds.ecsv", "speed,how", "grid,how"), "speeds.ecsv: not what");
  check_only(Finished().with("results.ecsv", "a.b,1", "a.b,0"), "results.ecsv: not what");
  CHECK(Finished().with("speeds.ecsv", "--speeds", "--other").empty());  // a header may differ
  const Finished lost;
  fs::remove(lost.path / "speeds.ecsv");
  check_only(altered_tables(lost.path), "speeds.ecsv: missing");
}

TEST_CASE("tables without a checksum are not trusted", "[unit][checksum]") {
  const Finished run;
  fs::copy(run.path / "speeds.ecsv", run.path / "old.ecsv");
  check_only(altered_tables(run.path), "old.ecsv: not a table of this run");
  fs::remove(run.path / "old.ecsv");
  fs::remove(run.path / checksums_name);
  CHECK(altered_tables(run.path).size() == 3);
}
