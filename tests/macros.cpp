// What the paper quotes: numbers as TeX sets them, the plain words of the list of claims in mathematics,
// and references with nothing behind them.

#include "../tools/macros.hpp"

#include "check.hpp"

using namespace lattice;

namespace {

Claim claim(std::string id, std::string printed, std::string status) {
  Claim c;
  c.program = "p";
  c.id = std::move(id);
  c.printed = std::move(printed);
  c.status = std::move(status);
  return c;
}

Table one_figure() {
  std::istringstream rows(
      "# %ECSV 1.0\n# ---\n# delimiter: ','\n# datatype:\n"
      "# - {name: 'id', unit: '', datatype: string, description: 'd'}\n"
      "# - {name: 'script', unit: '', datatype: string, description: 'd'}\n"
      "# - {name: 'caption', unit: '', datatype: string, description: 'd'}\n"
      "# schema: astropy-2.0\nid,script,caption\n07,fig07_barrier.gp,\"A, b & c.\"\n");
  return from_text(rows);
}

}  // namespace

TEST_CASE("numbers and words become TeX", "[unit]") {
  CHECK(tex::value("1.62422e-11") == "\\ensuremath{1.62422\\times10^{-11}}");
  CHECK(tex::value("-0.000544490") == "\\ensuremath{-5.44490\\times10^{-4}}");
  CHECK(tex::value("0.0002") == "\\ensuremath{2\\times10^{-4}}");
  CHECK(tex::value("0.006542") == "\\ensuremath{0.006542}");
  CHECK(tex::value("0.000") == "\\ensuremath{0.000}");
  CHECK(tex::value("-0.53") == "\\ensuremath{-0.53}");
  CHECK(tex::value("does not hold") == "does not hold");
  CHECK(tex::text("E_PN for omega_b = 1.1") == "$E_{\\mathrm{PN}}$ for $\\omega_{b}$ = 1.1");
  CHECK(tex::text("y_(1-n) = -y_n") == "$y_{1-n}$ = $-y_{n}$");
  CHECK(tex::text("W = 1 - cos y, A(0) = -i well-known") ==
        "W = 1 $-$ cos y, A(0) = $-$i well-known");
  CHECK(tex::unit("um") == "$\\mu$m");
  CHECK(tex::text("c_c^2/2") == "$c_{c}$$^{2}$/2");
  CHECK(tex::text("O(eps^-1/2), s >= 5 %") == "O($\\epsilon$$^{-1/2}$), s $\\ge$ 5 \\%");
  CHECK(tex::text("1e-14 to 1e-15") ==
        "\\ensuremath{1\\times10^{-14}} to \\ensuremath{1\\times10^{-15}}");
}

TEST_CASE("a reference to nothing is named", "[unit]") {
  const Findings lock{{{"p", "a.b"}, {1.5, 0.01, "", "value"}},
                      {{"p", "fact"}, {3, 0, "", "value"}}};
  const auto texts = paper_texts({claim("a.b", "1.6", "discrepant")}, lock, one_figure());
  CHECK(texts.at({"num", "a.b"}) == "\\ensuremath{1.50}");
  CHECK(texts.at({"num", "p.fact"}) == "\\ensuremath{3}");
  CHECK(texts.at({"err", "p.fact"}) == "exact");
  CHECK(texts.at({"pub", "a.b"}) == "1.6");
  CHECK(texts.at({"fig", "07"}) == "fig07_barrier");
  CHECK(texts.at({"tally", "discrepant"}) == "1");
  const std::string good = "\\num{a.b} \\err{a.b} \\pub{a.b} \\num{p.fact} \\fig{07} \\tally{open}";
  CHECK(dangling(good, texts).empty());
  CHECK(dangling("% \\num{x}\n\\newcommand\\q[1]{\\num{#1}} 5\\% of \\num{a.b}", texts).empty());
  CHECK(dangling("\\num{a.c} 5\\% of \\pub{p.fact}\n\\fig{08} \\num{a.c}", texts) ==
        std::vector<std::string>{"\\fig{08}", "\\num{a.c}", "\\pub{p.fact}"});
}

TEST_CASE("the paper leaves out what has no chapter", "[unit]") {
  CHECK(chapter_needed("% chapter: sec5_x\ntext") == "sec5_x");
  CHECK(chapter_needed("text % chapter: sec5_x\n").empty());
}

TEST_CASE("the table of claims has a row for each, and none without a number", "[unit]") {
  const auto reproduced = claim("a_b", "1.5", "reproduced"), open = claim("c", "2", "open");
  const Findings lock{{{"p", "a_b"}, {1, 0, "claim", "value"}}};
  const std::string rows = claim_rows({reproduced, open}, lock);
  CHECK(rows.find("\\claim{a\\_b}{}{1.5}{holds}{}{") != std::string::npos);
  CHECK(rows.find("\\claim{c}{}{2}{}{}{open}") != std::string::npos);
  CHECK_THROWS_AS(claim_rows({reproduced}, {}), std::runtime_error);
}
