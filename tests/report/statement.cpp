// Statements on tables that are made here: keys, selections and reductions; what is compared, and what is no verdict.

#include "report/statement.hpp"

#include <cmath>
#include <fstream>

#include "report/sums.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

using namespace report;

namespace {

/// The tables of two programs, written as programs write them.
struct Written {
  Scratch scratch{};

  Written() {
    Table sweep{number("s", "well"),
                number("velocity", "of the impact"),
                estimate("speed", "of the packet", "site per unit of time"),
                count("width", "sites"),
                number("raw", "without an error"),
                label("kind", "of the well")};
    for (int k = 1; k <= 3; ++k)
      for (const double s : {0.0, -1.0 / 6})
        sweep.add(
            {s, 0.31 * k + 1e-16, Estimate(k + s, 0.01), 6 + k, 1.0, s < 0 ? "soft" : "linear"});
    Table coarse{estimate("threshold", "of a kick", "m"), estimate("lost", "no number")};
    coarse.add({Estimate(2.5, 0.1), undefined_value()});
    coarse.meta = {{"parameters", "quick = yes"}};
    for (const char* program : {"sec1_demo", "sec2_other"}) {
      const auto folder = scratch.path / program;
      std::filesystem::create_directory(folder);
      Sums sums;
      for (const auto& [name, table] : {std::pair{"sweep", sweep},
                                        {"edited", sweep},
                                        {"empty", {sweep.columns}},
                                        {"coarse", coarse}}) {
        write(folder / (name + std::string(".ecsv")), table);
        sums[name + std::string(".ecsv")] = sha256_of(folder / (name + std::string(".ecsv")));
      }
      write_sums(folder, sums);
      write(folder / "older.ecsv", sweep);
      sweep.rows.pop_back();
      write(folder / "edited.ecsv", sweep);
    }
  }
  static Estimate undefined_value() {
    Estimate none;
    none.value = none.error = std::nan("");
    return none;
  }
};

/// A statement whose body is given by a test, with the words that it may use.
struct Spoken : Statement {
  using Statement::accuracy, Statement::answer, Statement::bound, Statement::control,
      Statement::increases, Statement::less, Statement::near, Statement::not_more,
      Statement::reading, Statement::table, Statement::within;
  std::function<void(Spoken&)> body;
  double zero = 0;
  void judge() override { body(*this); }
};

Judged judged(const std::function<void(Spoken&)>& body) {
  const Written written;
  Tables tables(written.scratch.path);
  Spoken spoken;
  spoken.body = body;
  return spoken.judged(tables, "sec1_demo");
}

std::string lost(const std::function<void(Spoken&)>& body) {
  const Judged found = judged(body);
  CHECK_FALSE(found.lost.empty());
  return found.lost;
}

}  // namespace

TEST_CASE("rows are found by keys and ranges, however these were rounded", "[unit]") {
  judged([](Spoken& s) {
    const Data sweep = s.table("sweep");
    CHECK(sweep.size() == 6);
    CHECK(sweep.where("s", -1.0 / 6).size() == 3);
    CHECK(sweep.where("velocity", 0.31, 0.62).where("s", 0).size() == 2);
    CHECK(sweep.where("velocity", 0.62, HUGE_VAL).size() == 4);
    CHECK(sweep.where("kind", "soft").size() == 3);
    const auto row = sweep.at("s", -1.0 / 6, "velocity", 0.93);
    check_close(row["speed"].value, 3 - 1.0 / 6, 1e-15);
    CHECK(row["speed"].error == 0.01);
    CHECK(row["speed"].unit == "site per unit of time");
    CHECK(row["width"].is_exact);
    check_close(row("velocity"), 0.93, 1e-12);
    CHECK(s.table("sec2_other", "sweep").at("kind", "linear", "width", 7)("raw") == 1);
    CHECK(s.table("sec2_other", "coarse")["threshold"].unit == "m");
    s.less(1, 2);
  });
}

TEST_CASE("the least of some numbers is as uncertain as any of them may make it", "[unit]") {
  judged([](Spoken& s) {
    const Data sweep = s.table("sweep");
    check_close(least(sweep, "speed").value, 1 - 1.0 / 6, 1e-15);
    check_close(largest(sweep, "speed").value, 3, 1e-15);
    CHECK(largest(sweep, "width").is_exact);
    const Estimate doubled = largest(sweep, [](const auto& row) { return 2 * row["speed"]; });
    check_close(doubled.value, 6, 1e-15);
    check_close(doubled.error, 0.02, 1e-12);
    s.less(1, 2);
  });
  const Estimate spread = least_of({{1, 0.001}, {1.01, 0.1}});
  check_close(spread.value - spread.error, 0.91, 1e-12);
}

TEST_CASE("errors of both sides add up", "[unit]") {
  const Estimate a{2, 0.1}, b{4, 0.2};
  check_close((a + b).error, 0.3, 1e-12);
  check_close((a - b).value, -2, 1e-12);
  check_close((a * b).error, 0.82, 0.03);
  check_close((a / b).error, 2.1 / 3.8 - 0.5, 1e-12);
  check_close(abs(a - b).value, 2, 1e-12);
  CHECK((exact(3) - exact(1)).is_exact);
  CHECK_FALSE((exact(3) * a).is_exact);
}

TEST_CASE("what is compared is kept with what was read for it", "[unit]") {
  const Judged found = judged([](Spoken& s) {
    const Data sweep = s.table("sweep");
    for (const auto& soft : sweep.where("s", -1.0 / 6).where("velocity", 0.62, 0.93))
      s.less(soft["speed"], sweep.at("s", 0, "velocity", soft("velocity"))["speed"]);
    s.within(s.table("coarse")["threshold"], 2, 3);
    s.near(1, 1.05, 0.1);
    s.not_more(Estimate(0.9, 0.001), 1);
    s.increases(sweep.where("s", 0), "velocity", "speed");
  });
  CHECK_FALSE(Comparison{"", Estimate(0, 3), Estimate(1, 3), true}.is_decided());
  REQUIRE(found.comparisons.size() == 8);
  for (const Comparison& c : found.comparisons) CHECK(c.holds());
  CHECK(found.comparisons[0].what ==
        "sweep.speed (s = 0, velocity = 0.62), (s = -0.166667, velocity = 0.62)");
  CHECK(found.comparisons[3].text() == "coarse.threshold: 2.5 +- 0.1 < 3");
  check_close(found.closest()->margin().value, 1.0 / 18, 1e-9);  // 3 - 1/6 < 3
  CHECK(found.cells.size() == 6);
  CHECK_FALSE(Comparison{"", Estimate(1, 0.1), Estimate(1.1, 0.1)}.is_decided());
  for (Comparison c : found.comparisons) {
    c.is_flipped = true;
    CHECK_FALSE(c.holds());
    CHECK(c.is_decided());
  }
}

TEST_CASE("nothing passes by having nothing to compare", "[unit]") {
  check_line(lost([](Spoken& s) { s.table("sweep").where("s", 7); }), "has no row with s = 7");
  check_line(lost([](Spoken& s) { s.table("sweep").where("velocity", 0.62 * (1 + 1e-6)); }),
             "has no row");
  check_line(lost([](Spoken& s) { s.table("sweep").where("s", 1, 2); }), "has no row with s = 1");
  check_line(lost([](Spoken& s) { s.table("sweep").at("s", 0); }), "has 3 rows instead of one");
  check_line(lost([](Spoken& s) { s.table("sweep")["speed"]; }), "has 6 rows instead of one");
  check_line(lost([](Spoken& s) { s.table("sweep").where("t", 0); }), "has no column 't'");
  check_line(lost([](Spoken& s) { (*s.table("sweep").begin())["raw"]; }), "no column 'raw_error'");
  check_line(lost([](Spoken& s) { (*s.table("sweep").begin())["kind"]; }), "'kind' holds texts");
  check_line(lost([](Spoken& s) { s.table("speeds"); }), "sec1_demo has no table 'speeds'");
  check_line(lost([](Spoken& s) { s.table("coarse")["lost"]; }),
             "lost is not a number, or has no error");
  check_line(lost([](Spoken& s) { s.table("empty"); }), "sec1_demo/empty has no rows");
  check_line(lost([](Spoken& s) { s.table("older"); }), "has no table 'older'");
  check_line(lost([](Spoken& s) { s.table("edited"); }), "is not the table that its program wrote");
  check_line(lost([](Spoken& s) { (*s.table("sweep").begin())("speed"); }),
             "was read as a given number");
  check_line(lost([](Spoken& s) { s.less(1, 1 / Estimate(1, 1)); }), "a denominator may be zero");
  check_line(lost([](Spoken& s) {
               s.less(1, largest_of({1, Estimate(0.0 / s.zero)}));
             }),
             "not a number");
  check_line(lost([](Spoken&) {}), "nothing is compared");
  check_line(lost([](Spoken& s) { s.less(1, 2), s.answer(s.table("coarse")["threshold"]); }),
             "both an answer");
  CHECK(judged([](Spoken& s) { s.table("sec3_none", "x"); }).not_run == "sec3_none");
}

TEST_CASE("whoever reads a coarse table is told", "[unit]") {
  CHECK(judged([](Spoken& s) { s.less(1, s.table("coarse")["threshold"]); }).is_quick);
  CHECK_FALSE(judged([](Spoken& s) { s.less(1, least(s.table("sweep"), "width")); }).is_quick);
}

TEST_CASE("a bound of ours is halved and doubled, one at a time", "[unit]") {
  const Judged found = judged([](Spoken& s) {
    for (const double x : {0.5, 0.7}) s.less(x, s.bound(1));
    s.less(0.1, s.bound(1));
  });
  CHECK(outcome_of(found.comparisons) == Outcome::holds);
  REQUIRE(found.readings.size() == 4);
  CHECK(found.readings[0].name == "0.5 in the place of 1");
  const std::vector<Outcome> expected{Outcome::fails, Outcome::holds, Outcome::holds,
                                      Outcome::holds};
  for (std::size_t k = 1; k < 4; ++k) CHECK(*found.readings[k].outcome == expected[k]);
  // 0.5 < 0.5 and 0.7 < 0.5 fail, 0.1 < 1 holds
  CHECK(*found.readings[0].outcome != Outcome::holds);
  CHECK(found.is_sensitive());
  CHECK_FALSE(judged([](Spoken& s) { s.less(0.1, s.bound(1)); }).is_sensitive());
  const Judged in_a_line = judged([](Spoken& s) { s.within(0, -s.bound(1), s.bound(1)); });
  CHECK(in_a_line.readings.size() == 4);
}

TEST_CASE("controls and readings claim nothing", "[unit]") {
  const Judged found = judged([](Spoken& s) {
    s.less(1, 2);
    s.control([&] { s.less(3, 4), s.less(6, 5); });
    s.reading("the other way round", [&] { s.less(2, 1); });
  });
  CHECK(found.comparisons.size() == 1);
  CHECK(found.controls.size() == 2);
  REQUIRE(found.lost_control() != nullptr);
  CHECK(found.text() == "a control fails: : 6 < 5");
  REQUIRE(found.readings.size() == 1);
  CHECK(*found.readings[0].outcome == Outcome::fails);
  CHECK(found.is_sensitive());
  const Judged number = judged([](Spoken& s) {
    s.answer(s.table("coarse")["threshold"]);
    s.reading("another definition", s.table("sec2_other", "coarse")["threshold"]);
  });
  CHECK(number.readings.at(0).value->value == 2.5);
  check_line(lost([](Spoken& s) { s.less(1, 2), s.control([] {}); }), "nothing is compared");
}

TEST_CASE("what holds in part says where it fails first, and where by most", "[unit]") {
  const Judged found = judged([](Spoken& s) { s.less(1, 2), s.less(3, 2.9), s.less(9, 2); });
  CHECK(outcome_of(found.comparisons) == Outcome::in_part);
  CHECK(found.failures() == 2);
  CHECK(found.text() == "fails 2 of 3 comparisons; first : 3 < 2.9; by most : 9 < 2");
}

TEST_CASE("failures are only what fails for certain", "[unit]") {
  const auto open = [](Spoken& s) { s.less(1, 2), s.less(3, 2), s.less(1, Estimate(1, 1)); };
  CHECK(judged(open).failures() == 1);
  CHECK(judged([](Spoken& s) { s.less(exact(3), exact(3)); }).failures() == 1);
  CHECK(judged([](Spoken& s) { s.near(1, 3, 1), s.near(3, 1, 1); }).failures() == 2);
  CHECK_FALSE(Comparison{"", Estimate(1, 0.1), Estimate(std::nan("")), true}.is_decided());
  CHECK_FALSE(Comparison{"", Estimate(1.9, 0.9), 1, true}.is_decided());
  CHECK(Comparison{"", Estimate(1.005, 0.009), 1, true}.holds());
}

TEST_CASE("a control that a changed bound loses, or that is undecided", "[unit]") {
  const auto with = [](const Estimate& side) {
    return judged([&](Spoken& s) { s.less(1, 2), s.control([&] { s.less(side, s.bound(1)); }); });
  };
  CHECK(with(0.6).is_sensitive());
  CHECK_FALSE(with(0.4).is_sensitive());
  CHECK(with(Estimate(1, 0.5)).lost_control() != nullptr);
  check_line(lost([](Spoken& s) {
               s.answer(s.table("coarse")["threshold"]);
               s.control([&] { s.less(0.6, s.bound(1)); });
             }),
             "cannot be measured: 0.5 in the place of 1");
}

TEST_CASE("readings have the kind of their statement", "[unit]") {
  const auto mixed = [] { judged([](Spoken& s) { s.less(1, 2), s.reading("x", Estimate(1)); }); };
  check_line(refusal<std::logic_error>(mixed), "of another kind");
}
