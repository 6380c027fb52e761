// A potential of one's own is checked when it is made: what is wrong is refused, what is right passes.

#include <functional>

#include "lattice/model/chain.hpp"
#include "support/check_potential.hpp"

using namespace lattice;

namespace {

/// Any three functions, of one number.
struct Functions {
  std::function<double(double)> e, f, k;
  double energy(double x) const { return e(x); }
  double force(double x) const { return f(x); }
  double stiffness(double x) const { return k(x); }
};

struct OneWell : Functions {
  double edge = std::numeric_limits<double>::infinity();
  double rim() const { return edge; }
};

struct OneContact : Functions {
  double open = 0, exponent = 1.5;
  double opening() const { return open; }
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// What is said of a potential when it is made; nothing if it is taken.
template <class Own, class P>
std::string said_of(const P& potential) {
  return refusal<std::invalid_argument>([&] { Own{potential}; });
}

/// W = a^2 (cosh(y/a) - 1) times `k`, with factors by which its three functions may be wrong.
OneWell cosh_well(double a, double k = 1, double e = 1, double f = 1, double s = 1) {
  return {[=](double y) { return e * k * 2 * std::pow(a * std::sinh(y / a / 2), 2); },
          [=](double y) { return -f * k * a * std::sinh(y / a); },
          [=](double y) { return s * k * std::cosh(y / a); }};
}

/// (d - r)^alpha times `k`, in the same way, without the force at rest.
OneContact power_contact(double alpha, double d = 0, double k = 1, double e = 1, double f = 1,
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

/// A spring that is `hard` times stiffer beyond the displacement `knee`.
OneWell bilinear(double knee, double hard) {
  const auto beyond = [=](double y) { return std::max(std::abs(y) - knee, 0.0); };
  return {[=](double y) { return y * y / 2 + (hard - 1) * std::pow(beyond(y), 2) / 2; },
          [=](double y) { return -y - (hard - 1) * std::copysign(beyond(y), y); },
          [=](double y) { return std::abs(y) < knee ? 1 : hard; }};
}

}  // namespace

TEST_CASE("honest wells are taken, steep or flat, large or small", "[unit][potential]") {
  const auto taken = [](const auto& well) { CHECK(said_of<OwnWell>(well) == ""); };
  for_each_potential<Well>(taken);
  for (const double s : {10.0, 1e8, -1.0 / 6, -10.0, -1e6}) taken(Quartic{s});
  for (const double a : {1e-8, 1e-3, 1.0, 1e3, 1e8})
    for (const double k : {1e-12, 1.0, 1e12}) taken(cosh_well(a, k));
  for (const double knee : {1e-3, 0.3, 0.31, 0.8, 0.835, 5.0})
    for (const double hard : {0.0, 0.9, 1.1, 1e6}) taken(bilinear(knee, hard));
  for (const double a : {1e-4, 1.0, 1e4})  // written so that digits are lost
    taken(OneWell{{[=](double y) { return a * a * (std::exp(-y / a) - 1 + y / a); },
                   [=](double y) { return a * (std::exp(-y / a) - 1); },
                   [=](double y) { return std::exp(-y / a); }}});
  // One that ends in walls, one that is stiff on one side only, and two wells with a hill between
  taken(OneWell{{[](double y) { return -std::log(1 - 100 * y * y) / 200; },
                 [](double y) { return -y / (1 - 100 * y * y); },
                 [](double y) { return (1 + 100 * y * y) / std::pow(1 - 100 * y * y, 2); }},
                0.1});
  taken(OneWell{{[](double y) { return y * y * (y > 0 ? 2 : 0.5); },
                 [](double y) { return -y * (y > 0 ? 4 : 1); },
                 [](double y) { return y > 0 ? 4 : 1; }}});
  taken(
      OneWell{{[](double y) { return y * y * (y * y / 2 - 1) / 2; },
               [](double y) { return y * (1 - y * y); }, [](double y) { return 3 * y * y - 1; }}});
  taken(OneWell{{[](double y) { return y * y / 2 + 1e-5 * (1 - std::cos(1e4 * y)); },
                 [](double y) { return -y - 0.1 * std::sin(1e4 * y); },
                 [](double y) { return 1 + 1e3 * std::cos(1e4 * y); }}});
  // Structure that is finer than the first steps of the check
  for (const double a : {1e-4, 3e-5, 1e-5, 1e-6})
    taken(OneWell{{[=](double y) { return 2 * std::pow(a * std::sin(y / a / 2), 2); },
                   [=](double y) { return -a * std::sin(y / a); },
                   [=](double y) { return std::cos(y / a); }}});
}

TEST_CASE("honest contacts are taken, and a chain of links that never open", "[unit][potential]") {
  const auto taken = [](const auto& contact) { CHECK(said_of<OwnContact>(contact) == ""); };
  for_each_potential<Contact>(taken);
  for (const double d : {1e-9, 0.25, 1.0, 10.0, 1e3}) taken(CompressedHertz{d});
  for (const double alpha : {1.0, 1.2, 2.0, 10.0, 40.0})
    for (const double d : {0.0, 1e-3, 0.5, 10.0})
      for (const double k : {1e-9, 1.0, 1e9}) {
        taken(PowerContact{alpha, d});
        taken(power_contact(alpha, d, k));
      }
  taken(OneContact{{[](double r) { return std::exp(-r) - 1 + r; },
                    [](double r) { return std::exp(-r) - 1; },
                    [](double r) { return std::exp(-r); }}});
  // Links that pull when they are pressed too far, and those of Lennard-Jones, beyond their centre as well
  for (const double k : {-2.0, 1.3, 2.0})
    taken(OneContact{
        {[=](double r) { return r * r / 2 + k * r * r * r / 3; },
         [=](double r) { return -r - k * r * r; }, [=](double r) { return 1 + 2 * k * r; }},
        0,
        1});
  for (const double a : {0.1, 0.3, 0.5, 0.7, 0.8, 2.0}) {
    const auto power = [=](double r, int n) { return std::pow(1 + r / a, -n); };
    taken(OneContact{{[=](double r) { return a * a * (power(r, 12) - 2 * power(r, 6) + 1) / 72; },
                      [=](double r) { return a * (power(r, 13) - power(r, 7)) / 6; },
                      [=](double r) { return (13 * power(r, 14) - 7 * power(r, 8)) / 6; }},
                     0,
                     1});
  }
}

TEST_CASE("a well whose functions do not belong together is refused", "[unit][potential]") {
  const auto refused = [](const OneWell& well, const std::string& part) {
    check_line(said_of<OwnWell>(well), part);
  };
  for (const double a : {1e-6, 1e-2, 1.0, 1e3})
    for (const double wrong : {1.01, 0.99, 2.0, -1.0, 0.0}) {
      CAPTURE(a, wrong);
      refused(cosh_well(a, 1, wrong), "minus the slope of its energy is");
      refused(cosh_well(a, 1, 1, wrong), "minus the slope of its");
      refused(cosh_well(a, 1, 1, 1, wrong), "minus the slope of its force is");
    }
  const auto half = [](double y) { return y * y / 2; };
  const auto pull = [](double y) { return -y; };
  const auto one = [](double) { return 1; };
  CHECK(said_of<OwnWell>(OneWell{{half, pull, one}}) == "");
  CHECK(said_of<OwnWell>(OneWell{{half, pull, [](double) { return 2; }}}) ==
        "the well's stiffness(-0.83541) is 2, and minus the slope of its force is 1 there");
  refused({{pull, half, one}}, "the well's force(-0.83541) is 0.348955");
  refused({{half, pull, pull}}, "the well's stiffness(-0.83541)");
  refused({{half, [](double y) { return y; }, one}}, "is -0.83541, and minus the slope");
  // Wrong on one side, in a small term, and only close to rest
  refused({{half, [](double y) { return -std::abs(y); }, one}}, "the well's force(-0.83541)");
  refused({{half, [](double y) { return -y - 0.01 * y * y * y; }, one}}, "force(-0.83541)");
  refused({{[](double y) { return y * y / 2 + 1e8 * std::pow(y, 4) / 4; },
            [](double y) { return -y - 1e8 * y * y * y; }, [](double y) { return 3e8 * y * y; }}},
          "stiffness(-0.00061343)");
}

TEST_CASE("a well must rest at zero, be finite and have a rim beyond it", "[unit][potential]") {
  const auto refused = [](const OneWell& well, const std::string& part) {
    check_line(said_of<OwnWell>(well), part);
  };
  const OneWell good = cosh_well(1);
  refused({{[](double y) { return std::cosh(y); }, good.f, good.k}},
          "energy(0) is 1 and must be 0");
  refused({{[](double y) { return y + y * y / 2; }, [](double y) { return -1 - y; },
            [](double) { return 1; }}},
          "force(0) is -1 and must be 0: count displacements from the place of rest");
  for (const double bad : {none, inf, -inf}) {
    const auto broken = [=](double) { return bad; };
    refused({{broken, good.f, good.k}}, "energy(0) is");
    refused({{good.e, broken, good.k}}, "force(0) is");
    refused({{good.e, good.f, broken}}, "stiffness(0) is");
  }
  // A root that is not real on one side
  refused(
      {{[](double y) { return 0.4 * std::pow(y, 2.5); }, [](double y) { return -std::pow(y, 1.5); },
        [](double y) { return 1.5 * std::pow(y, 0.5); }}},
      "nan, not a finite number");
  for (const double rim : {0.0, -1.0, -inf, none}) {
    OneWell well = good;
    well.edge = rim;
    refused(well, "the well's rim is ");
  }
  // Beyond its rim a well is not looked at
  OneWell cut = cosh_well(0.1);
  cut.edge = 0.05;
  cut.f = [f = cut.f](double y) { return std::abs(y) < 0.05 ? f(y) : 7; };
  CHECK(said_of<OwnWell>(cut) == "");
}

TEST_CASE("a contact whose functions do not belong together is refused", "[unit][potential]") {
  const auto refused = [](const OneContact& contact, const std::string& part) {
    check_line(said_of<OwnContact>(contact), part);
  };
  for (const double alpha : {1.0, 1.5, 2.5, 10.0})
    for (const double d : {0.0, 0.1, 10.0})
      for (const double wrong : {1.01, 0.99, 2.0, -1.0, 0.0}) {
        CAPTURE(alpha, d, wrong);
        refused(power_contact(alpha, d, 1, wrong), "minus the slope of its energy is");
        refused(power_contact(alpha, d, 1, 1, wrong), "minus the slope of its");
        refused(power_contact(alpha, d, 1, 1, 1, wrong), "minus the slope of its force is");
      }
  // Attraction, an opening that is none, and exponents
  refused(power_contact(1.5, 0, -1), "it pulls");
  OneContact odd = power_contact(1.5);
  for (const double open : {none, inf}) {
    odd.open = open;
    refused(odd, "the contact's opening is ");
  }
  odd = power_contact(1.5);
  for (const double exponent : {none, inf, 0.5, -1.0}) {
    odd.exponent = exponent;
    refused(odd, "the contact's exponent is ");
  }
  odd = power_contact(1.5);
  refused({{odd.e, [f = odd.f](double r) { return f(r) + 1; }, odd.k}},
          "force(0) is 1 and must be 0");
  refused(
      {{[](double r) { return 0.4 * std::pow(-r, 2.5); },
        [](double r) { return std::pow(-r, 1.5); }, [](double r) { return 1.5 * std::sqrt(-r); }}},
      "nan, not a finite number");
}

TEST_CASE("the check is made once, and what a potential throws passes", "[unit][potential]") {
  int calls = 0;
  OneWell well = cosh_well(1);
  well.f = [&calls, f = well.f](double y) { return ++calls, f(y); };
  const OwnWell own(well);
  const int made = calls;
  CHECK(made > 0);
  CHECK(made < 1000);
  const OwnWell copy = own;
  Chain chain{4, copy};
  chain.well = own;
  const Chain other = chain;
  CHECK(calls == made);
  CHECK(other.well.force(0.5) == -std::sinh(0.5));
  struct Mine {};
  well.f = [](double) -> double { throw Mine{}; };
  CHECK_THROWS_AS(OwnWell(well), Mine);
}

TEST_CASE("a well that loses digits near zero is known", "[unit][potential]") {
  const auto loses = [](const OneWell& well) { return loses_digits(Well(well)); };
  for (const double a : {1e-3, 1.0, 1e3}) {
    CAPTURE(a);
    const auto stiffness = [=](double y) { return std::exp(-y / a); };
    CHECK(loses({{[=](double y) { return a * a * (std::exp(-y / a) - 1 + y / a); },
                  [=](double y) { return -a * (1 - std::exp(-y / a)); }, stiffness}}));
    CHECK_FALSE(loses({{[=](double y) { return a * a * (std::expm1(-y / a) + y / a); },
                        [=](double y) { return a * std::expm1(-y / a); }, stiffness}}));
    CHECK_FALSE(loses(cosh_well(a)));
  }
  CHECK_FALSE(loses(bilinear(0.3, 2)));
  CHECK_FALSE(loses({{[](double y) { return y * y * y * y / 4; },
                      [](double y) { return -y * y * y; }, [](double y) { return 3 * y * y; }}}));
  CHECK_FALSE(loses(
      {{[](double y) { return y * y * (y > 0 ? 2 : 0.5); },
        [](double y) { return -y * (y > 0 ? 4 : 1); }, [](double y) { return y > 0 ? 4 : 1; }}}));
  for_each_potential<Well>([](const auto& well) {
    CHECK_FALSE(loses_digits(Well(well)));
    CHECK_FALSE(loses_digits(OwnWell(well)));
  });
}
