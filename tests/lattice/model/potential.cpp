// Wells and contacts: force and stiffness are the derivatives they claim to be, known values, names. One's own are
// checked when they are made: what is wrong is refused, what is right passes.

#include <functional>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/model/potential_names.hpp"
#include "lattice/orbits/breather.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// Force and stiffness are the derivatives that they claim to be, a bead at rest feels exactly
/// nothing, and higher precision gives the same function with more digits.
template <class Potential>
void check_potential(const Potential& p, const std::vector<double>& at) {
  for (double x : at) {
    CAPTURE(x);
    const auto wide = (long double)x;
    check_close(double(p.energy(wide)), p.energy(x), 1e-15, 1e-14);
    check_close(double(p.force(wide)), p.force(x), 1e-15, 1e-14);
    check_close(double(p.stiffness(wide)), p.stiffness(x), 1e-15, 1e-14);
    // Central differences with one Richardson step, whose error is of the order h^4, to more digits than double has
    const auto slope = [&](auto f) {
      const auto d = [&](long double k) { return (f(wide + k) - f(wide - k)) / (2 * k); };
      return (4 * d(0.5e-4L) - d(1e-4L)) / 3;
    };
    const auto energy = slope([&](long double u) { return p.energy(u); });
    const auto force = slope([&](long double u) { return p.force(u); });
    check_close(double(p.force(wide) + energy), 0, 2e-13 * (1 + std::abs(p.force(x))));
    check_close(p.stiffness(x), -double(force), 1e-8, 1e-8);
  }
  CHECK(p.energy(0.0) == 0);
  CHECK(p.force(0.0) == 0);
  CHECK(p.force(0.0L) == 0);
}

/// Up to its rim, if it has one, a well also pulls a bead back from either side; at the rim the force vanishes
/// and the well is unstable.
template <class Onsite>
void check_well(const Onsite& well) {
  check_potential(well, {-1.3, -0.4, -0.1, 0.2, 0.9, 1.7});
  const double rim = rim_of(well);
  CHECK(rim > 0);
  if (!std::isfinite(rim)) return;
  for (double share : {0.1, 0.5, 0.99}) {
    CHECK(well.force(share * rim) < 0);
    CHECK(well.force(-share * rim) > 0);
  }
  check_close(well.force(rim), 0, 1e-14);
  CHECK(well.stiffness(rim) < 0);
}

/// A contact also never pulls more than its compression, is open beyond `opening`, and begins there with its
/// exponent.
template <class Contact>
void check_contact(const Contact& contact) {
  check_potential(contact, {-1.3, -0.4, -0.1, 0.2, 0.9, 1.7});
  const double d = contact.opening(), open = contact.force(d);
  CHECK(contact.force(d + 0.1) == open);
  CHECK(contact.force(d + 7) == open);
  CHECK(contact.stiffness(d + 0.1) == 0);
  CHECK(contact.force(d - 0.1) > open);
  const double ratio = (contact.force(d - 2e-3) - open) / (contact.force(d - 1e-3) - open);
  check_close(std::log2(ratio), contact.exponent, 1e-9);
}

}  // namespace

TEST_CASE("wells: force is minus the gradient, stiffness its slope", "[unit][potential]") {
  const auto check = [](const auto& well) {
    CAPTURE(well.name);
    check_well(well);
    // Chosen at run time it has the same bits
    const Well chosen{well};
    for (double y : {-1.7, -1e-3, 0.0, 2.5}) {
      CHECK(chosen.energy(y) == well.energy(y));
      CHECK(chosen.force(y) == well.force(y));
      CHECK(chosen.stiffness(y) == well.stiffness(y));
      CHECK(chosen.force((long double)y) == well.force((long double)y));
    }
    CHECK(chosen.rim() == rim_of(well));
  };
  for_each_potential<Well>(check);
  for (double s : {1.0, -1.0 / 6, -0.7}) check(Quartic{s});
  check_close(Quartic{-0.5}.rim(), std::sqrt(2.0), 1e-15);
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

TEST_CASE("wells and contacts by hand", "[unit][potential]") {
  CHECK(Harmonic{}.energy(-3.0) == 4.5);
  CHECK(Quartic{-0.5}.energy(2.0) == 0);
  CHECK(Quartic{2}.energy(-1.0) == 1);
  check_close(Pendulum{}.energy(M_PI / 3), 0.5, 1e-15);
  check_close(Hertz{}.energy(-4.0), 12.8, 1e-14);
  check_close(CompressedHertz{4}.energy(-5.0), 44.4, 1e-13);
  check_close(CompressedHertz{4}.energy(5.0), 0.4 * -32 + 40, 1e-13);
  CHECK(Hertz{}.force(-0.25) == 0.125);  // (1/4)^(3/2)
  CHECK(Hertz{}.force(0.25) == 0);
  CHECK(Hertz{}.force(-1e-61) == 0);  // negligible
  CHECK(Hertz{.negligible = 0}.force(-1e-61) > 0);
  CHECK(CompressedHertz{0.25}.force(0.3) == -0.125);  // open: only the compression is missing
  CHECK(CompressedHertz{0.25}.force(-1e-61) == 0);
  check_close(CompressedHertz{0.25, 0}.force(-1e-61), 0.75e-61, 0, 1e-15);
}

TEST_CASE("little strains of a compressed contact have an energy and a force too",
          "[unit][potential]") {
  for (double alpha : {1.0, 1.2, 1.5, 2.0, 7.3})
    for (double d : {1e-3, 0.5, 10.0}) {
      CAPTURE(alpha, d);
      for (double u : {-1e-5, -1e-11, 1e-20, 1e-8, 1e-5}) {
        const double few = 1 - (alpha - 1) / 3 * u * (1 - (alpha - 2) / 4 * u),
                     energy = alpha / 2 * std::pow(d, alpha + 1) * u * u * few;
        check_close(PowerContact{alpha, d}.energy(u * d), energy, 0, 3e-14);
        if (alpha == 1.5) check_close(CompressedHertz{d}.energy(u * d), energy, 0, 3e-14);
        const long double power = std::pow((long double)d, (long double)alpha),
                          force = power * std::expm1(alpha * std::log1p(-(long double)u));
        check_close(PowerContact{alpha, d}.force(u * d), double(force), 0, 2e-15);
        if (alpha == 1.5) check_close(CompressedHertz{d}.force(u * d), double(force), 0, 2e-15);
      }
      for (double u : {-2.0, -0.126, -0.124, 0.01, 0.124, 0.126, 1.0, 3.0}) {
        const long double x = std::max(1 - u, 0.0), more = alpha + 1;
        check_close(PowerContact{alpha, d}.energy(u * d) / std::pow(d, alpha + 1),
                    double((std::pow(x, more) - 1) / more + u), 1e-16, 2e-13);
        check_close(PowerContact{alpha, d}.force(u * d) / std::pow(d, alpha),
                    double(std::pow(x, (long double)alpha) - 1), 1e-16, 4e-15);
      }
    }
}

TEST_CASE("the power 3/2 takes the root of the 3/2 law", "[unit][potential]") {
  for (double r : {-2.0, -1e-3, 0.1}) {
    CHECK(PowerContact{}.force(r) == Hertz{}.force(r));
    CHECK(PowerContact{}.stiffness(r) == Hertz{}.stiffness(r));
    check_close(PowerContact{}.energy(r), Hertz{}.energy(r), 1e-300, 1e-15);
    CHECK(PowerContact{1.5, 0.5}.force(r) == CompressedHertz{0.5}.force(r));
    // The general power is another computation of nearly the same law.
    check_close(PowerContact{1.5 + 1e-13}.force(r), Hertz{}.force(r), 1e-300, 1e-11);
  }
  check_close(double(Hertz{}.force(-0.3L) - 0.3L * sqrtl(0.3L)), 0, 1e-19);
}

TEST_CASE("potentials are found by name and parameters", "[unit][potential]") {
  const std::string wells = comma_list(names_of<Well>());
  CHECK(wells.find("none, harmonic, quartic, pendulum") == 0);
  CHECK(comma_list(names_of<Contact>()).find("hertz, power") == 0);  // each name once
  CHECK(named<Well>("quartic", {{"s", -0.5}}).get_if<Quartic>()->s == -0.5);
  CHECK(named<Contact>("hertz").is<Hertz>());
  CHECK(named<Contact>("hertz", {{"precompression", 0.5}}).get_if<CompressedHertz>()->d == 0.5);
  const auto power = named<Contact>("power", {{"alpha", 2}, {"precompression", 0.5}});
  CHECK(power.get_if<PowerContact>()->exponent == 2);
  CHECK(power.get_if<PowerContact>()->d == 0.5);
  CHECK(describe(named<Well>("quartic", {{"s", -0.5}})) == "quartic, s = -0.5");
  const auto refused = []<class Any>(const Any*, const char* name, const Settings& given) {
    return refusal<std::invalid_argument>([&] { named<Any>(name, given); });
  };
  const Well* well = nullptr;
  CHECK(refused(well, "cubic", {}) == "'cubic' is not one of " + wells);
  CHECK(refused(well, "pendulum", {{"s", 0}}) == "'pendulum' has no parameter s; it has none");
  CHECK(refused(well, "quartic", {{"s", 11}}) == "s = 11 is not in the allowed range [-10, 10]");
  check_line(refused(well, "quartic", {{"s", std::nan("")}}), "allowed range");
  CHECK(refused(static_cast<const Contact*>(nullptr), "hertz", {{"alpha", 2}}) ==
        "'hertz' has no parameter alpha (it has precompression)");
}

TEST_CASE("a law that is Hertz's becomes Hertz", "[unit][model]") {
  CHECK(simplest(Contact{CompressedHertz{0}}).is<Hertz>());
  CHECK(simplest(Contact{PowerContact{1.5, 0}}).is<Hertz>());
  CHECK(simplest(Contact{PowerContact{1.5, 0.3}}).get_if<CompressedHertz>()->d == 0.3);
  CHECK(simplest(Contact{PowerContact{2, 0}}).is<PowerContact>());
}

namespace {

/// Any three functions, of one number.
struct Functions {
  std::function<double(double)> e, f, k;
  double energy(double x) const { return e(x); }
  double force(double x) const { return f(x); }
  double stiffness(double x) const { return k(x); }
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

struct MyWell : Functions {
  static constexpr const char* name = "mine";
  double edge = inf;
  double rim() const { return edge; }
};

struct MyContact : Functions {
  double open = 0, exponent = 1.5;
  double opening() const { return open; }
};

/// What is said of a potential when it is made; nothing if it is taken.
std::string said_of(const MyWell& well) {
  return refusal<std::invalid_argument>([&] { OwnWell{well}; });
}
std::string said_of(const MyContact& contact) {
  return refusal<std::invalid_argument>([&] { OwnContact{contact}; });
}

template <class Mine>
void refused(const Mine& mine, const std::string& part) {
  check_line(said_of(mine), part);
}

/// W = a^2 (cosh(y/a) - 1) times `k`, with factors by which its three functions may be wrong.
MyWell cosh_well(double a, double k = 1, double e = 1, double f = 1, double s = 1) {
  return {[=](double y) { return e * k * 2 * std::pow(a * std::sinh(y / a / 2), 2); },
          [=](double y) { return -f * k * a * std::sinh(y / a); },
          [=](double y) { return s * k * std::cosh(y / a); }};
}

/// (d - r)^alpha times `k`, in the same way, without the force at rest.
MyContact power_contact(double alpha, double d = 0, double k = 1, double e = 1, double f = 1,
                        double s = 1) {
  const auto overlap = [=](double r) { return std::max(d - r, 0.0); };
  const double rest = std::pow(d, alpha);
  return {{[=](double r) {
             const double all = std::pow(overlap(r), alpha + 1) - std::pow(d, alpha + 1);
             return e * k * (all / (alpha + 1) + rest * r);
           },
           [=](double r) { return f * k * (std::pow(overlap(r), alpha) - rest); },
           [=](double r) { return r < d ? s * k * alpha * std::pow(overlap(r), alpha - 1) : 0; }},
          d,
          alpha};
}

/// Toda's well, written so that digits are lost.
MyWell losing(double a) {
  return {[=](double y) { return a * a * (std::exp(-y / a) - 1 + y / a); },
          [=](double y) { return a * (std::exp(-y / a) - 1); },
          [=](double y) { return std::exp(-y / a); }};
}

/// Stiff on one side only.
const MyWell lopsided{{[](double y) { return y * y * (y > 0 ? 2 : 0.5); },
                       [](double y) { return -y * (y > 0 ? 4 : 1); },
                       [](double y) { return y > 0 ? 4 : 1; }}};

}  // namespace

TEST_CASE("honest wells are taken, steep or flat, large or small", "[unit][potential]") {
  const auto taken = [](const auto& well) { CHECK(said_of(well) == ""); };
  for_each_potential<Well>([](const auto& well) { CHECK_NOTHROW(OwnWell(well)); });
  for (const double a : {1e-8, 1.0, 1e8})
    for (const double k : {1e-12, 1e12}) taken(cosh_well(a, k));
  for (const double a : {1e-4, 1e4}) taken(losing(a));
  taken(lopsided);
  // One that ends in walls
  taken(MyWell{{[](double y) { return -std::log(1 - 100 * y * y) / 200; },
                [](double y) { return -y / (1 - 100 * y * y); },
                [](double y) { return (1 + 100 * y * y) / std::pow(1 - 100 * y * y, 2); }},
               0.1});
}

TEST_CASE("honest contacts are taken, and a chain of links that never open", "[unit][potential]") {
  for_each_potential<Contact>([](const auto& contact) { CHECK_NOTHROW(OwnContact(contact)); });
  for (const double alpha : {1.0, 1.2, 40.0})
    for (const double d : {0.0, 1e-3, 10.0}) CHECK(said_of(power_contact(alpha, d, 1e9)) == "");
  const auto force = [](double r) { return std::exp(-r) - 1; };
  CHECK(said_of(MyContact{
            {[=](double r) { return force(r) + r; }, force, [](double r) { return std::exp(-r); }},
            0,
            1}) == "");
}

TEST_CASE("a well whose functions do not belong together is refused", "[unit][potential]") {
  for (const double a : {1e-6, 1e3})
    for (const double wrong : {1.01, -1.0}) {
      CAPTURE(a, wrong);
      refused(cosh_well(a, 1, wrong), "minus the slope of its energy is");
      refused(cosh_well(a, 1, 1, wrong), "minus the slope of its");
      refused(cosh_well(a, 1, 1, 1, wrong), "minus the slope of its force is");
    }
  const auto half = [](double y) { return y * y / 2; };
  const auto pull = [](double y) { return -y; };
  const auto one = [](double) { return 1; };
  CHECK(said_of(MyWell{{half, pull, one}}) == "");
  CHECK(said_of(MyWell{{half, pull, [](double) { return 2; }}}) ==
        "the well's stiffness(-0.83541) is 2, but minus the slope of its force is 1 there");
  // In a small term, and only close to rest
  refused(MyWell{{half, [](double y) { return -y - 0.01 * y * y * y; }, one}}, "force(-0.83541)");
  refused(
      MyWell{{[](double y) { return y * y / 2 + 1e8 * std::pow(y, 4) / 4; },
              [](double y) { return -y - 1e8 * y * y * y; }, [](double y) { return 3e8 * y * y; }}},
      "stiffness(-0.00061343)");
}

TEST_CASE("a well must rest at zero, be finite and have a rim beyond it", "[unit][potential]") {
  const MyWell good = cosh_well(1);
  refused(MyWell{{[](double y) { return std::cosh(y); }, good.f, good.k}},
          "energy(0) is 1 and must be 0");
  refused(MyWell{{[](double y) { return y + y * y / 2; }, [](double y) { return -1 - y; },
                  [](double) { return 1; }}},
          "force(0) is -1 and must be 0: measure displacements from the rest position");
  for (const double bad : {none, inf}) {
    const auto broken = [=](double) { return bad; };
    refused(MyWell{{broken, good.f, good.k}}, "energy(0) is");
    refused(MyWell{{good.e, broken, good.k}}, "force(0) is");
    refused(MyWell{{good.e, good.f, broken}}, "stiffness(0) is");
  }
  for (const double rim : {0.0, none}) {
    MyWell well = good;
    well.edge = rim;
    refused(well, "the well's rim is ");
  }
  // Beyond its rim a well is not looked at
  MyWell cut = cosh_well(0.1);
  cut.edge = 0.05;
  cut.f = [f = cut.f](double y) { return std::abs(y) < 0.05 ? f(y) : 7; };
  CHECK(said_of(cut) == "");
}

TEST_CASE("a contact whose functions do not belong together is refused", "[unit][potential]") {
  for (const double alpha : {1.0, 1.5, 10.0})
    for (const double d : {0.0, 10.0})
      for (const double wrong : {1.01, -1.0}) {
        CAPTURE(alpha, d, wrong);
        refused(power_contact(alpha, d, 1, wrong), "minus the slope of its energy is");
        refused(power_contact(alpha, d, 1, 1, wrong), "minus the slope of its");
        refused(power_contact(alpha, d, 1, 1, 1, wrong), "minus the slope of its force is");
      }
  // Attraction, an opening that is none, and exponents
  refused(power_contact(1.5, 0, -1), "the contact pulls");
  const MyContact good = power_contact(1.5);
  refused(MyContact{good, none}, "the contact's opening is ");
  for (const double exponent : {inf, 0.5})
    refused(MyContact{good, 0, exponent}, "the contact's exponent is ");
  refused(MyContact{{good.e, [&](double r) { return good.f(r) + 1; }, good.k}},
          "force(0) is 1 and must be 0");
  refused(MyContact{{[](double r) { return 0.4 * std::pow(-r, 2.5); },
                     [](double r) { return std::pow(-r, 1.5); },
                     [](double r) { return 1.5 * std::sqrt(-r); }}},
          "nan, not a finite number");
}

TEST_CASE("a well that loses digits near zero is known", "[unit][potential]") {
  for (const double a : {1e-3, 1.0, 1e3}) {
    CAPTURE(a);
    CHECK(loses_digits(Well(losing(a))));
    CHECK_FALSE(loses_digits(Well(cosh_well(a))));
  }
  for_each_potential<Well>([](const auto& well) { CHECK_FALSE(loses_digits(OwnWell(well))); });
}

TEST_CASE("a well of one's own needs a place in a list for its name, no more",
          "[unit][potential]") {
  using Wells = OneOf<OwnWell, NoWell, Harmonic, Quartic, Pendulum, MyWell>;
  CHECK(named<Wells>("mine").is<MyWell>());
  CHECK(comma_list(names_of<Wells>()) == "none, harmonic, quartic, pendulum, mine");
}

TEST_CASE("a chain of potentials of one's own has the bits of the same ones in the list",
          "[unit][potential]") {
  const auto copied = [](const auto& p) {
    return Functions{[=](double x) { return p.energy(x); }, [=](double x) { return p.force(x); },
                     [=](double x) { return p.stiffness(x); }};
  };
  const Chain listed{60, Quartic{0.5}};
  const Chain own{60, MyWell{copied(Quartic{0.5})}, MyContact{copied(Hertz{})}};
  State<double> one = struck(60, 1.5), other = one;
  const Run run = evolve(EventCorrected{0.05}, listed, one, 60);
  CHECK(evolve(EventCorrected{0.05}, own, other, 60).energy_drift == run.energy_drift);
  CHECK(one.y == other.y);
  CHECK(one.v == other.v);
}
