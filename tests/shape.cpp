// The rules about the shape of the sources see what they should see.

#include "shape.hpp"

#include "check.hpp"

namespace {

std::string lines(int count, const std::string& text) {
  std::string out;
  for (int i = 0; i < count; ++i) out += text + "\n";
  return out;
}

}  // namespace

TEST_CASE("prose and code are counted", "[unit]") {
  const std::string open = "/**\n", close = "*/\n";
  const auto block = [&](int n) { return open + lines(n, "words") + close; };
  CHECK(unreadable(block(20) + lines(40, "x;") + block(20) + lines(40, "y;")).empty());
  CHECK(unreadable(block(21) + lines(1, "x;")).size() == 1);
  CHECK(unreadable(block(1) + lines(41, "x;")).size() == 1);
  CHECK(unreadable(block(1) + lines(41, "x;") + block(1) + lines(1, "x;")).size() == 1);
  CHECK(unreadable(block(1) + lines(40, "x;") + "// A title\n" + lines(40, "y;")).empty());
  CHECK(unreadable(block(1) + lines(40, "x;") + "y;  // a remark\n").size() == 1);
  CHECK(unreadable(lines(41, "x;") + "  // Late\n" + lines(1, "y;")).size() == 1);
  CHECK(unreadable(block(1) + block(1) + lines(1, "x;")).size() == 1);
  CHECK(unreadable(block(1) + "\n#include <x>\n\n" + block(1) + lines(1, "x;")).size() == 1);
  CHECK(unreadable(lines(50, "#include <x>") + block(1) + lines(40, "x;\n")).empty());
  CHECK(unreadable("/** one line */\nx;\n/** another\n * line */\ny;\n").empty());
  CHECK(unreadable("/** one line */\n/** another */\ny;\n").size() == 1);
}

TEST_CASE("a long function is seen", "[unit]") {
  const auto function = [](const std::string& head, int count) {
    return head + " {\n" + lines(count / 2, "  x;") + "  // Half way\n" +
           lines(count - count / 2, "  y;") + "}\n";
  };
  CHECK(unreadable(function("void f()", 60)).empty());
  CHECK(unreadable(function("void f()", 61)).size() == 1);
  CHECK(unreadable(function("void f()", 36) + function("void g()", 36)).empty());
  CHECK(unreadable(function("struct S", 70)).empty());
}

TEST_CASE("an equation without its number is seen", "[unit]") {
  const std::string eq = "Eq", eqs = "Eqs";
  CHECK(misquoted("by " + eq + ". (24) and " + eqs + ". (1) and (39)").empty());
  CHECK(misquoted("by " + eq + ". eqm, and").size() == 1);
  CHECK(misquoted("by " + eqs + ".\nun1 and un2").size() == 1);
  CHECK(misquoted("by " + eq + ". (40)").size() == 1);
  CHECK(misquoted("by " + eq + ". (0)").size() == 1);
}

TEST_CASE("an arrow up, sideways, out or round is seen", "[unit]") {
  const auto arrows = [](const std::string& from, const std::string& to) {
    Includes headers{{"lattice/numbers/a.hpp", {}},  {"lattice/model/a.hpp", {}},
                     {"lattice/integrators/a.hpp", {}}, {"lattice/events/a.hpp", {}},
                     {"lattice/orbits/a.hpp", {}},   {"report/a.hpp", {}},
                     {"lattice/model/b.hpp", {}}};
    headers[from].push_back(to);
    return forbidden_arrows(headers).size();
  };
  CHECK(arrows("lattice/orbits/a.hpp", "\"lattice/numbers/a.hpp\"") == 0);
  CHECK(arrows("lattice/model/a.hpp", "\"lattice/model/b.hpp\"") == 0);
  CHECK(arrows("lattice/model/a.hpp", "<vector>") == 0);
  CHECK(arrows("report/a.hpp", "\"lattice/numbers/a.hpp\"") == 0);
  CHECK(arrows("report/a.hpp", "\"lattice/model/a.hpp\"") == 0);
  CHECK(arrows("report/a.hpp", "\"lattice/orbits/a.hpp\"") == 1);
  CHECK(arrows("report/a.hpp", "\"lattice/integrators/a.hpp\"") == 1);
  CHECK(arrows("report/a.hpp", "\"sec33/a.hpp\"") == 1);
  CHECK(arrows("lattice/numbers/a.hpp", "\"lattice/model/a.hpp\"") == 1);
  CHECK(arrows("lattice/integrators/a.hpp", "\"lattice/events/a.hpp\"") == 1);
  CHECK(arrows("lattice/orbits/a.hpp", "\"report/a.hpp\"") == 1);
  CHECK(arrows("lattice/orbits/a.hpp", "\"sec34_impact.cpp\"") == 1);
  CHECK(arrows("lattice/cellar/a.hpp", "<vector>") == 1);
  CHECK(circles({{"lattice/model/a.hpp", {"\"lattice/model/b.hpp\""}},
                 {"lattice/model/b.hpp", {"\"lattice/model/a.hpp\""}}})
            .size() == 2);
  CHECK(circles({{"lattice/model/a.hpp", {"\"lattice/model/b.hpp\""}}, {"lattice/model/b.hpp", {}}})
            .empty());
}

TEST_CASE("a shelf that uses another one is seen", "[unit]") {
  const auto foreign = [](const std::string& to) {
    return foreign_shelves({{"sec4/a.cpp", {to}}}).size();
  };
  CHECK(foreign("\"lattice/model/a.hpp\"") == 0);
  CHECK(foreign("\"report/b.hpp\"") == 0);
  CHECK(foreign("\"sec4/b.hpp\"") == 0);
  CHECK(foreign("<vector>") == 0);
  CHECK(foreign("\"sec5/b.hpp\"") == 1);
  CHECK(foreign("\"sec42_part.hpp\"") == 1);
  CHECK(foreign("\"commands/b.hpp\"") == 1);
  const auto asked = [](const std::string& to) {
    return foreign_shelves({{"commands/a.cpp", {to}}}).size();
  };
  CHECK(asked("\"sec5/b.hpp\"") == 0);
  CHECK(asked("\"commands/b.hpp\"") == 0);
  CHECK(asked("\"sec42_part.hpp\"") == 1);
}

TEST_CASE("one name for two types is seen", "[unit]") {
  const auto twice = [](const std::string& a, const std::string& b) {
    return defined_twice({{"a.hpp", a}, {"b.hpp", b}}).size();
  };
  CHECK(twice("struct Part {\n};\n", "struct Part {\n};\n") == 1);
  CHECK(twice("struct Part {\n};\n", "using Part = int;\n") == 1);
  CHECK(twice("enum class Part { a, b };\n", "class Part : Whole {\n};\n") == 1);
  CHECK(twice("struct Part {\n};\n", "struct Whole {\n  struct Part {\n  };\n};\n") == 0);
  CHECK(twice("struct Part {\n};\n", "struct Part;\nstruct Party {\n};\n") == 0);
  CHECK(twice("struct Part {\n};\nstruct Part {\n};\n", "") == 0);
}
