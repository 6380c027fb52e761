// What programs share beneath their options: headers, threads, and GSL that reports instead of aborting.

#include "report/program.hpp"

#include <pthread.h>

#include <thread>

#include "lattice/gsl/reference.hpp"
#include "report/command_line.hpp"
#include "support/check.hpp"

using namespace report;

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

TEST_CASE("a command is recorded as a shell would read it, without threads and folder",
          "[unit][frame]") {
  const char* argv[] = {"/somewhere/bin/p", "--threads", "3",         "run", "--s", "-0.5", "--out",
                        "a folder",         "--out=b",   "two words", "",    "it's"};
  CHECK(command_text("p", 12, argv) == "p run --s -0.5 'two words' '' 'it'\\''s'");
}

namespace {

/// As long as it lives a thread would need a stack that no memory holds, and none starts.
struct NoThreads {
  pthread_attr_t usual;
  NoThreads() {
    pthread_getattr_default_np(&usual);
    pthread_attr_t huge = usual;
    pthread_attr_setstacksize(&huge, std::size_t(1) << 47);
    pthread_setattr_default_np(&huge);
  }
  ~NoThreads() { pthread_setattr_default_np(&usual); }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;
};

}  // namespace

TEST_CASE("where no thread can start one does all the work", "[unit][frame]") {
  const NoThreads none;
  CHECK_THROWS_AS(std::thread([] {}).join(), std::system_error);
  set_threads(3);
  std::vector<std::thread::id> by(9);
  parallel_for(by.size(), [&](std::size_t i) { by[i] = std::this_thread::get_id(); });
  CHECK(by == std::vector<std::thread::id>(9, std::this_thread::get_id()));
  const auto fails = [](std::size_t i) {
    if (i == 5) throw std::invalid_argument("the fifth");
  };
  CHECK_THROWS_AS(parallel_for(9, fails), std::invalid_argument);
  set_threads(0);
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

TEST_CASE("a row that has headings makes the columns, and no other row comes among them",
          "[unit][frame]") {
  Table said{number("x", "a place", "m"), count("n", "how many"), label("name", "in words"),
             estimate("y", "a number", "s", "two steps")};
  said.add({0.5, 3, "a", Estimate{1, 0.1}});
  Table made;
  made.add({{"x", "a place", 0.5, "m"},
            {"n", "how many", 3},
            {"name", "in words", "a"},
            {"y", "a number", Estimate{1, 0.1}, "s", "two steps"}});
  CHECK(to_text(made) == to_text(said));
  CHECK_THROWS_AS(made.add(Row{{"x", "a place", 0.5, "m"}}), std::invalid_argument);
  CHECK_THROWS_AS(said.add({0.5, 3, "a", 1.0}), std::invalid_argument);
  CHECK_THROWS_AS(said.add({3, 3, "a", Estimate{1, 0.1}}), std::invalid_argument);
  CHECK_THROWS_AS(
      said.add({{"x", "", 0.5}, {"m", "", 3}, {"name", "", "a"}, {"y", "", Estimate{}}}),
      std::invalid_argument);
}

TEST_CASE("an answer that is nan has a reason, and one that is smaller than its error is none",
          "[unit][frame]") {
  const double nan = std::nan(""), least = std::numeric_limits<double>::min();
  Answers q{"less time"};
  q.add("speed", {nan, nan}, "", "of the packet", "no packet left");
  q.add("centre", {3, nan}, "site", "of the packet");
  q.add("width", {5, 5}, "site", "of the packet", "not said of a number");
  CHECK_THROWS_AS(q.add("centre", {1, 0.1}, "site", ""), std::invalid_argument);  // no meaning
  q.add("count", with_error(0.0, 0.0), "", "of packets");  // with the error of a rounding
  q.add_small("drift", {1e-9, 2e-9}, "", "of the energy");
  CHECK(q.table.columns.back().name == "reason");
  CHECK(q.table.texts("reason") ==
        std::vector<std::string>{"no packet left", "only the finer of two runs has a value", "", "",
                                 ""});
  CHECK(std::isnan(q.table.numbers("value")[1]));
  CHECK(q.table.numbers("error")[3] == least);
  CHECK_THROWS_AS(q.add("speed", {nan, nan}, "", "of the packet"), std::logic_error);
  CHECK_THROWS_AS(q.add_small("speed", {nan, nan}, "", "of the packet"), std::logic_error);
  const auto vague = [&] { q.add("width", {5.62, 28.96}, "site", "of the packet"); };
  CHECK(
      refusal<Failure>(vague) ==
      "width: the error 28.96 exceeds the value 5.62, so the result is unresolved; try less time");
  CHECK_THROWS_AS(q.add("speed", {-1, 1.1}, "", "of the packet"), Failure);
  CHECK(q.table.rows.size() == 5);
}

TEST_CASE("a word is answered with the nearest one", "[unit][frame]") {
  const std::vector<std::string> names{"velocity", "time", "sites", "well", "s"};
  CHECK(nearest("velocty", names) == "velocity");
  CHECK(nearest("vel", names) == "velocity");
  CHECK(nearest("tmie", names) == "time");  // letters that have changed places count once
  CHECK(nearest("teim", names) == std::nullopt);
  CHECK(nearest("site", names) == "sites");
  CHECK(nearest("well", names) == "well");
  CHECK(nearest("x", names) == std::nullopt);
  CHECK(nearest("bogus", names) == std::nullopt);
}

TEST_CASE("numbers are typed in decimal or as fractions", "[unit][frame]") {
  CHECK(typed_number("-1/6") == -1.0 / 6);
  CHECK(typed_number("1/3") == 1.0 / 3);
  CHECK(typed_number("+1/-2") == -0.5);
  CHECK(typed_number("1.5e1/3") == 5);
  CHECK(typed_number("-0.25") == -0.25);
  for (const char* text : {"1/0", "/", "1/", "/1", "1//2", "1/2/3", "0x1/2", "1/ 2", ""})
    CHECK_FALSE(typed_number(text));
  CHECK_FALSE(parse_number("1/2"));  // tables hold decimals
}
