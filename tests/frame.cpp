// What programs share beneath their options: headers, threads, and GSL that reports instead of aborting.

#include "report/program.hpp"

#include <set>
#include <thread>

#include "check.hpp"
#include "lattice/numbers/gsl_ode.hpp"

using namespace lattice;

TEST_CASE("a chapter can say which value was used", "[unit][frame]") {
  const Provenance provenance{{{"command", "c"}, {"seed", "none"}},
                              {{"omega", "1.1"}, {"sites", "as long as needed"}}};
  Table table{{number("x", "a number")}};
  table.meta = {{"sites", "33"}, {"tolerance", "1e-13"}, {"seed", "7"}};
  const Meta expected{{"command", "c"},
                      {"parameters", "omega = 1.1, sites = 33"},
                      {"seed", "7"},
                      {"tolerance", "1e-13"}};
  CHECK(provenance.sign(table).meta == expected);
}

TEST_CASE("a command is recorded as a shell would read it, without its threads", "[unit][frame]") {
  const char* argv[] = {"/somewhere/bin/p", "--threads", "3", "run",     "--s", "-0.5",
                        "--threads=2",      "two words", "",  "it's \\", "a\nb"};
  CHECK(command_text("p", 11, argv) == "p run --s -0.5 'two words' '' $'it\\'s \\\\' $'a\\x0ab'");
}

TEST_CASE("work is shared by as many threads as were asked for", "[unit][frame]") {
  for (std::size_t count : {1, 2, 5}) {
    set_threads(count);
    CHECK(threads() == count);
    std::set<std::thread::id> seen;
    std::mutex guard;
    parallel_for(200, [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      const std::lock_guard lock(guard);
      seen.insert(std::this_thread::get_id());
    });
    CHECK(seen.size() <= count);
    CHECK(seen.size() >= std::min<std::size_t>(count, 2));
  }
  set_threads(0);
  CHECK(threads() == granted_cores());
}

TEST_CASE("GSL reports and never aborts", "[unit][frame]") {
  const auto decay = [](double, const double* x, double* dx) { dx[0] = -x[0]; };
  CHECK_THROWS_AS(Reference(decay, 1, -1.0), std::invalid_argument);
  CHECK_THROWS_AS(Reference(decay, 0, 1e-8), std::invalid_argument);
  const auto never = [](double, const double*, double* dx) { dx[0] = std::nan(""); };
  Reference lost(never, 1, 1e-8);
  double t = 0;
  std::vector<double> x{1};
  CHECK_THROWS_AS(lost.advance(t, 1, x), std::runtime_error);
}
