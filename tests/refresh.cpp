// The lock and the numbers in prose: what moved is seen, what is shown has the digits that its error
// allows, and a reference that dangles is refused.

#include "../tools/refresh.hpp"

#include <unistd.h>

#include "check.hpp"

using namespace lattice;

namespace {

Finding finding(double value, double error, std::string unit = "", std::string kind = "value") {
  return {value, error, std::move(unit), std::move(kind)};
}

}  // namespace

TEST_CASE("a value is locked within the sum of the errors", "[unit]") {
  const double eps = 1e-16;
  CHECK(distance(finding(1, 1e-3), finding(1.0019, 1e-3)) < 1);
  CHECK(distance(finding(1, 1e-3), finding(1.0021, 1e-3)) > 1);
  CHECK(distance(finding(1.62e-11, 1e-20), finding(1.77e-11, 1e-20)) > 1e7);
  CHECK(distance(finding(1, 0), finding(1 + 5 * eps, 0)) < 1);
  CHECK(distance(finding(1, 0), finding(1 + 1e-11, 0)) > 1);
  CHECK(distance(finding(1, 0, "claim"), finding(0, 0, "claim")) > 1);
  CHECK(distance(finding(1, 0, "claim"), finding(1, 0, "")) > 1);
  CHECK(distance(finding(1, 1), finding(std::nan(""), 1)) > 1);
  CHECK(distance(finding(1, 1), finding(1.5, std::nan(""))) > 1);
  CHECK(distance(finding(std::nan(""), 1), finding(std::nan(""), 1)) == 0);
  CHECK(distance(finding(3e-16, 0, "", "residue"), finding(2e-15, 0)) < 1);
  CHECK(distance(finding(3e-16, 0, "", "residue"), finding(-4e-15, 0)) > 1);
  CHECK(distance(finding(0, 0, "", "residue"), finding(3e-16, 0)) < 1);
}

TEST_CASE("a discrepant row with another discrepant value is seen", "[unit]") {
  const Findings locked{{{"p", "pn.omega11"}, finding(1.6242247200089819e-11, 4e-20)},
                        {{"p", "gone"}, finding(1, 0)}};
  const Findings fresh{{{"p", "pn.omega11"}, finding(1.5e-11, 4e-20)},
                       {{"p", "new"}, finding(2, 0)}};
  const auto changes = differences(locked, fresh);
  REQUIRE(changes.size() == 3);
  CHECK(changes[0].what == Difference::What::missing);
  CHECK(changes[1].what == Difference::What::moved);
  CHECK(changes[1].distance > 1);
  CHECK(changes[2].what == Difference::What::added);
  CHECK(differences(locked, locked).empty());
}

TEST_CASE("the lock survives its file and keeps what was not run", "[unit]") {
  const Findings locked{{{"a", "x"}, finding(1e-15, 0, "", "residue")},
                        {{"b", "y"}, finding(0.1, 1e-9, "site")},
                        {{"c", "z"}, finding(3, 0)}};
  const auto path = std::filesystem::temp_directory_path() /
                    ("lattice_lock_" + std::to_string(::getpid()) + ".ecsv");
  write(path, lock_table(locked));
  CHECK(differences(locked, read_lock(path)).empty());
  CHECK(read_lock(path).at({"a", "x"}).kind == "residue");
  std::filesystem::remove(path);
  // a was run again, b was not, c is no program any more.
  const Findings fresh{{{"a", "x"}, finding(2e-15, 0)}, {{"a", "w"}, finding(7, 0)}};
  const Findings now = renewed(locked, fresh, {"a", "b"});
  CHECK(now.size() == 3);
  CHECK(now.at({"a", "x"}).kind == "residue");
  CHECK(now.at({"a", "x"}).value == 2e-15);
  CHECK(now.count({"a", "w"}) == 1);
  CHECK(now.count({"b", "y"}) == 1);
}

TEST_CASE("a number shows the digits that its error allows", "[unit]") {
  CHECK(shown(finding(1.6242247200089819e-11, 4e-20)) == "1.62422e-11");
  CHECK(shown(finding(-7.5714e-08, 1e-10)) == "-7.57e-8");
  CHECK(shown(finding(0.00091771471, 1.17e-06)) == "0.000918");
  CHECK(shown(finding(1.4978440800419035, 0.0057)) == "1.498");
  CHECK(shown(finding(857.52737275438153, 0.0036)) == "857.527");
  CHECK(shown(finding(24934.60966977202, 0.104)) == "24934.6");
  CHECK(shown(finding(2.0000000000000004, 5e-17)) == "2.00000");
  CHECK(shown(finding(7e-15, 4e-14)) == "7e-15");
  CHECK(shown(finding(14, 0)) == "14");
  CHECK(shown(finding(-3, 0)) == "-3");
  CHECK(shown(finding(0, 0)) == "0");
  CHECK(shown(finding(1.5, 0)) == "1.5");
  CHECK(shown(finding(1.0009999999999999, 0)) == "1.001");
  CHECK(shown(finding(1753921.9, 0)) == "1.75392e6");
  CHECK(shown(finding(4.3822562009170496e-16, 0, "", "residue")) == "4e-16");
  CHECK(shown(finding(1, 0, "claim")) == "holds");
  CHECK(shown(finding(0, 0, "claim")) == "does not hold");
  CHECK(shown(finding(std::nan(""), 1)) == "nan");
  CHECK(shown_error(finding(1, 3.7e-9)) == "4e-9");
  CHECK(shown_error(finding(1, 0)) == "exact");
}

TEST_CASE("links show the value and dangle nowhere", "[unit]") {
  const std::map<std::string, std::string> numbers{{"pn.omega11", "1.62e-11"}, {"p.x", "3"}};
  const std::string prose = "is [](num:pn.omega11), and [17](num:p.x) of [these](fig:07).";
  const std::string ought = "is [1.62e-11](num:pn.omega11), and [3](num:p.x) of [these](fig:07).";
  CHECK(with_numbers(prose, numbers) == ought);
  CHECK(with_numbers(ought, numbers) == ought);
  CHECK(with_numbers("nothing [here]", numbers) == "nothing [here]");
  CHECK_THROWS_AS(with_numbers("[](num:pn.omega12)", numbers), std::runtime_error);
  CHECK_THROWS_AS(with_numbers("](num:p.x)", numbers), std::runtime_error);
  CHECK_THROWS_AS(with_numbers("[](num:p.x", numbers), std::runtime_error);
}

TEST_CASE("claims are quoted by their id, facts with their program", "[unit]") {
  Claim claim;
  claim.id = "pn.omega11";
  const auto texts =
      quotable({{{"p", "pn.omega11"}, finding(2, 0)}, {{"p", "fact"}, finding(5, 0)}}, {claim});
  CHECK(texts == std::map<std::string, std::string>{{"pn.omega11", "2"}, {"p.fact", "5"}});
}

TEST_CASE("tables of the README are replaced between their marks", "[unit]") {
  const std::string text = "a\n<!-- t -->\nold\n<!-- /t -->\nb\n";
  CHECK(with_table(text, "t", {"x", "y"}) == "a\n<!-- t -->\nx\ny\n<!-- /t -->\nb\n");
  CHECK_THROWS_AS(with_table(text, "u", {}), std::runtime_error);
}

TEST_CASE("a page gets the tables for which it has marks", "[unit]") {
  const std::string text = "a\n<!-- t -->\n<!-- /t -->\nb\n";
  CHECK(fresh_page(text, {{"t", {"x"}}, {"u", {"y"}}}) == "a\n<!-- t -->\nx\n<!-- /t -->\nb\n");
  Claim missed, met;
  missed.id = "m";
  missed.printed = "4";
  missed.status = "discrepant";
  missed.reason = "a factor of two";
  met.id = "n";
  met.status = "reproduced";
  const Findings lock{{{"", "m"}, finding(2, 0)}, {{"", "n"}, finding(1, 0)}};
  CHECK(discrepancy_rows({missed, met}, lock).back() == "| `m` | 4 | 2 | a factor of two |");
  CHECK(discrepancy_rows({missed, met}, lock).size() == 3);
  const Table none;
  CHECK(summary_rows({missed, met}, none)[2] ==
        "claims     : 1 reproduced, 0 hold, 0 measured, 1 discrepant, 0 unresolved, 0 open");
}

TEST_CASE("a figure's cost is renewed when it has really moved", "[unit]") {
  const std::string head = "# x\nid,program,caption,seconds\n";
  const std::string text = head + "02,p,\"A, b.\",10\n03,q,C.,0.4\n04,p,\"New.\"\n";
  const std::string fresh = head + "02,p,\"A, b.\",10\n03,q,C.,3\n04,p,\"New.\",11\n";
  CHECK(with_costs(text, {{"p", 11.0}, {"q", 3.0}}) == fresh);
  CHECK(with_costs(fresh, {{"p", 10.0}, {"q", 3.2}}) == fresh);
  CHECK(with_costs(text, {}) == head + "02,p,\"A, b.\",10\n03,q,C.,0.4\n04,p,\"New.\",nan\n");
  CHECK_THROWS_AS(with_costs(head + "02,p\n", {}), std::runtime_error);
}
