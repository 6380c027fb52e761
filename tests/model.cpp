// The model as a value: the chain that it stands for, and the options with which a reader asks.

#include "lattice/model/model.hpp"

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

TEST_CASE("a model becomes the chain of its types", "[unit][model]") {
  const auto is = [](const Model& model, auto onsite, auto contact) {
    return with_chain(model, 7, [&](const auto& chain) {
      CHECK(chain.sites == 7);
      CHECK(chain.ends == model.ends);
      using Expected = Chain<decltype(onsite), decltype(contact)>;
      return std::is_same_v<std::decay_t<decltype(chain)>, Expected>;
    });
  };
  CHECK(is({}, Quartic{}, Hertz{}));
  CHECK(is(-0.5, Quartic{}, Hertz{}));
  CHECK(is(Pendulum{}, Pendulum{}, Hertz{}));
  CHECK(is({None{}, CompressedHertz{0.5}, Ends::periodic}, None{}, CompressedHertz{}));
  CHECK(is({Harmonic{}, CompressedHertz{0}}, Harmonic{}, Hertz{}));
  CHECK(is({Harmonic{}, PowerContact{1.5, 0.5}}, Harmonic{}, CompressedHertz{}));
  CHECK(is({Harmonic{}, PowerContact{2, 0}}, Harmonic{}, PowerContact{}));
  const auto rim = [](const auto& chain) { return rim_of(chain.onsite); };
  check_close(with_chain(Model(-0.5), 3, rim), std::sqrt(2.0), 1e-15);
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
