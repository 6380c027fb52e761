// Every program with --quick: the same answers as the full run, coarser, and soon.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "answers.hpp"
#include "check.hpp"
#include "report/checksum.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const fs::path root = SOURCE_DIR, data = DATA_DIR, bin = BIN_DIR;

struct Called {
  int code = -1;
  double seconds = 0;  ///< processor time of all threads
};

/// Runs `program --quick --out folder` without a shell and measures the processor time, which other
/// processes on the machine hardly change.
Called quick_run(const fs::path& program, const fs::path& folder) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const int sink = open("/dev/null", O_WRONLY);
    dup2(sink, 1);
    dup2(sink, 2);
    alarm(300);  // a program that hangs is a failure, not a test without an end
    execl(program.c_str(), program.c_str(), "--quick", "--out", folder.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          seconds(used.ru_utime) + seconds(used.ru_stime)};
}

std::vector<std::string> answered(const fs::path& folder) {
  auto ids = read(folder / "results.ecsv").texts("id");
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// The rows of a table file, without its header of comments.
std::string body(const fs::path& path) {
  std::ifstream in(path);
  std::string out;
  for (std::string line; std::getline(in, line);)
    if (line.rfind("#", 0) != 0) out += line + "\n";
  return out;
}

/// Does any table of the quick run differ from the full run's?
bool coarser(const fs::path& quick, const fs::path& full) {
  for (const auto& entry : fs::directory_iterator(quick))
    if (entry.path().extension() == ".ecsv" &&
        body(entry.path()) != body(full / entry.path().filename()))
      return true;
  return false;
}

/// How many times longer the full runs have just taken than costs.ecsv says; one where they were faster.
double slowness() {
  const Table costs = read(root / "bench/costs.ecsv");
  const auto programs = costs.texts("program");
  const auto seconds = costs.numbers("seconds");
  double now = 0, then = 0;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    std::ifstream cost(data.parent_path() / "report" / "cost" / programs[i]);
    double today = 0;
    if (!(cost >> today)) continue;
    now += today, then += seconds[i];
  }
  return then > 0 ? std::max(1.0, now / then) : 1;
}

}  // namespace

TEST_CASE("a quick run of every program answers everything and soon", "[quick]") {
  // Five seconds on two cores; a build with checks may ask for more, and a slow machine has it.
  const char* text = std::getenv("LATTICE_SLACK");
  const double budget = 2 * 5 * slowness() * (text ? std::atof(text) : 1);
  const fs::path scratch =
      fs::temp_directory_path() / ("lattice_quick_" + std::to_string(::getpid()));
  for (const auto& program : programs_of(root / "src")) DYNAMIC_SECTION(program) {
      const Called run = quick_run(bin / program, scratch);
      CAPTURE(program, run.code, run.seconds, budget);
      CHECK(run.code == 0);
      if (run.code == 0) {
        CHECK(answered(scratch) == answered(data / program));
        for (const auto& entry : fs::directory_iterator(scratch))
          CHECK((entry.path().extension() == ".ecsv" || entry.path().filename() == checksums_name));
        for (const auto& complaint : altered_tables(scratch)) FAIL_CHECK(complaint);
        CHECK(run.seconds <= budget);
        CHECK(coarser(scratch, data / program));
      }
      fs::remove_all(scratch);
    }
}
