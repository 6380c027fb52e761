// Well and contact as values, and the options with which a reader asks.

#include "lattice/model/chain.hpp"

#include <string>
#include <type_traits>

#include "check.hpp"
#include "run.hpp"

using namespace lattice;

namespace {

/// The command of a short impact.
std::string impact(const std::string& options) {
  return "sec34_impact run --time 20 " + options;
}

}  // namespace

TEST_CASE("a well and a contact are what they were made from", "[unit][model]") {
  const Chain chain{7, Quartic{-0.5}, CompressedHertz{0.5}, Ends::periodic};
  CHECK(chain.well.as<Quartic>().s == -0.5);
  CHECK(chain.contact.as<CompressedHertz>().d == 0.5);
  CHECK(std::holds_alternative<Harmonic>(Chain{}.well));
  CHECK(std::holds_alternative<Hertz>(Chain{}.contact));
  CHECK_THROWS_AS(chain.well.as<Pendulum>(), std::bad_variant_access);
  check_close(chain.well.rim(), std::sqrt(2.0), 1e-15);
  CHECK(chain.contact.opening() == 0.5);
  CHECK(chain.contact.exponent() == 1.5);
}

TEST_CASE("options choose well and contact by name", "[cli][model]") {
  const std::string plain = rows(impact(""));
  CHECK(rows(impact("--onsite quartic --s 0")) == plain);
  CHECK(rows(impact("--onsite harmonic")) == plain);  // the same well by another type
  CHECK(rows(impact("--contact hertz --precompression 0")) == plain);
  CHECK(rows(impact("--contact power --alpha 1.5")) == plain);
  CHECK(rows(impact("--onsite pendulum")) != plain);
  CHECK(rows(impact("--onsite none")) != plain);
  CHECK(rows(impact("--contact power --alpha 2")) != plain);
  CHECK(rows(impact("--precompression 0.5")) ==
        rows(impact("--contact power --precompression 0.5")));
  CHECK(rows(impact("--precompression 0.5")) != plain);
}

TEST_CASE("what a model does not have is refused", "[cli][model]") {
  check_refused(impact("--onsite cubic"), "none, harmonic, quartic, pendulum");
  check_refused(impact("--contact glue"), "hertz, power");
  check_refused(impact("--onsite pendulum --s 0.1"), "--s");
  check_refused(impact("--onsite harmonic --s 0"), "'harmonic' has no parameter s");
  check_refused(impact("--alpha 2"), "'hertz' has no parameter alpha");
  check_refused(impact("--contact power --alpha 0.5"), "[1, 10]");
  check_refused(impact("--s nan"), "[-10, 10]");
}
