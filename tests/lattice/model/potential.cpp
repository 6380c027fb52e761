// Each potential: force and stiffness are the derivatives they claim to be, and known values.

#include "support/check_potential.hpp"

using namespace lattice;

namespace {

template <class Any>
std::string refusal(const std::string& name, const Settings& given) {
  try {
    named<Any>(name, given);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("wells: force is minus the gradient, stiffness its slope", "[unit][potential]") {
  for (double s : {1.0, -1.0 / 6, -0.7}) {
    CAPTURE(s);
    check_well(Quartic{s});
  }
  for_each_potential<Well>([](const auto& well) {
    CAPTURE(well.name);
    check_well(well);
  });
}

TEST_CASE("contacts: the same, and where they open", "[unit][potential]") {
  for_each_potential<Contact>([](const auto& contact) {
    CAPTURE(contact.name);
    check_contact(contact);
  });
  check_contact(CompressedHertz{0.5});
  check_contact(PowerContact{2, 0});
  check_contact(PowerContact{1.5, 0.5});
  check_contact(PowerContact{1.2, 0.25});
}

TEST_CASE("contacts push and never pull", "[unit][potential]") {
  CHECK(Hertz{}.force(-0.25) == 0.125);  // (1/4)^(3/2)
  CHECK(Hertz{}.force(0.25) == 0);
  CHECK(Hertz{}.force(-1e-61) == 0);  // below the floor
  CHECK(Hertz{.floor = 0}.force(-1e-61) > 0);
  CHECK(Hertz{}.stiffness(0.1) == 0);
  CHECK(CompressedHertz{0.25}.force(0.3) == -0.125);  // open: only the compression is missing
}

TEST_CASE("little strains of a compressed contact have an energy too", "[unit][potential]") {
  for (double alpha : {1.0, 1.2, 1.5, 2.0, 7.3})
    for (double d : {1e-3, 0.5, 10.0}) {
      CAPTURE(alpha, d);
      for (double u : {-1e-5, -1e-11, 1e-20, 1e-8, 1e-5}) {
        const double few = 1 - (alpha - 1) / 3 * u * (1 - (alpha - 2) / 4 * u),
                     energy = alpha / 2 * std::pow(d, alpha + 1) * u * u * few;
        check_close(PowerContact{alpha, d}.energy(u * d), energy, 0, 3e-14);
        if (alpha == 1.5) check_close(CompressedHertz{d}.energy(u * d), energy, 0, 3e-14);
      }
      for (double u : {-2.0, -0.126, -0.124, 0.01, 0.124, 0.126, 1.0, 3.0}) {
        const long double x = std::max(1 - u, 0.0), more = alpha + 1;
        check_close(PowerContact{alpha, d}.energy(u * d) / std::pow(d, alpha + 1),
                    double((std::pow(x, more) - 1) / more + u), 1e-16, 2e-13);
      }
    }
}

TEST_CASE("the power 3/2 takes the root of the 3/2 law", "[unit][potential]") {
  for (double r : {-2.0, -0.3, -1e-3, 0.1}) {
    CHECK(PowerContact{}.force(r) == Hertz{}.force(r));
    CHECK(PowerContact{}.stiffness(r) == Hertz{}.stiffness(r));
    check_close(PowerContact{}.energy(r), Hertz{}.energy(r), 1e-300, 1e-15);
    CHECK(PowerContact{1.5, 0.5}.force(r) == CompressedHertz{0.5}.force(r));
    // The general power is another computation of nearly the same law.
    check_close(PowerContact{1.5 + 1e-13}.force(r), Hertz{}.force(r), 1e-300, 1e-11);
  }
}

TEST_CASE("potentials work in extended precision", "[unit][potential]") {
  const long double x = -0.3L;
  check_close(double(Hertz{}.force(x) - 0.3L * sqrtl(0.3L)), 0, 1e-19);
  check_close(double(Quartic{1}.force(x) - (0.3L + 0.027L)), 0, 1e-18);
}

TEST_CASE("potentials are found by name and parameters", "[unit][potential]") {
  const std::string wells = comma_list(names_of<Well>());
  const std::string contacts = comma_list(names_of<Contact>());
  CHECK(wells.find("none, harmonic, quartic, pendulum") == 0);
  CHECK(contacts.find("hertz, power") == 0);  // each name once
  CHECK(std::get<Quartic>(named<Well>("quartic", {{"s", -0.5}})).s == -0.5);
  CHECK(std::holds_alternative<Hertz>(named<Contact>("hertz")));
  CHECK(std::get<CompressedHertz>(named<Contact>("hertz", {{"precompression", 0.5}})).d == 0.5);
  const auto power = named<Contact>("power", {{"alpha", 2}, {"precompression", 0.5}});
  CHECK(std::get<PowerContact>(power).exponent == 2);
  CHECK(std::get<PowerContact>(power).d == 0.5);
  CHECK(describe(named<Well>("quartic", {{"s", -0.5}})) == "quartic, s = -0.5");
}

TEST_CASE("a law that is Hertz's becomes Hertz", "[unit][potential]") {
  CHECK(std::holds_alternative<Hertz>(simplest(Contact{CompressedHertz{0}})));
  CHECK(std::holds_alternative<Hertz>(simplest(Contact{PowerContact{1.5, 0}})));
  CHECK(std::get<CompressedHertz>(simplest(Contact{PowerContact{1.5, 0.3}})).d == 0.3);
  CHECK(std::holds_alternative<PowerContact>(simplest(Contact{PowerContact{2, 0}})));
}

TEST_CASE("what is not known is refused in one line that says what is", "[unit][potential]") {
  const std::string wells = comma_list(names_of<Well>());
  CHECK(refusal<Well>("cubic", {}) == "'cubic' is not one of " + wells);
  CHECK(refusal<Well>("pendulum", {{"s", 0}}) == "'pendulum' has no parameter s, nor any other");
  CHECK(refusal<Well>("quartic", {{"s", 11}}) == "s = 11 is not in the allowed range [-10, 10]");
  CHECK(refusal<Well>("quartic", {{"s", std::nan("")}}).find("allowed range") != std::string::npos);
  CHECK(refusal<Contact>("hertz", {{"alpha", 2}}) ==
        "'hertz' has no parameter alpha (it has precompression)");
}
