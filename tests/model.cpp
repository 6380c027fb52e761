// The model as a value: the chain that it stands for, and the options with which a reader asks.

#include "lattice/model/model.hpp"

#include <string>
#include <type_traits>

#include "check.hpp"
#include "run.hpp"

using namespace lattice;

namespace {

Result impact(const std::string& options) {
  return call("sec34_impact run --time 20 " + options);
}

/// The table without its header, which tells the command.
std::string rows(const std::string& options) {
  const Result answer = impact(options);
  CAPTURE(options, answer.errors);
  REQUIRE(answer.code == 0);
  return body(answer.output);
}

/// Exit code 2 and one line that contains `what`.
void check_refused(const std::string& options, const std::string& what) {
  const Result answer = impact(options);
  CAPTURE(options, answer.errors);
  CHECK(answer.code == 2);
  CHECK(answer.error_lines() == 1);
  CHECK(answer.errors.find(what) != std::string::npos);
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
  const std::string plain = rows("");
  CHECK(rows("--onsite quartic --s 0") == plain);
  CHECK(rows("--onsite harmonic") == plain);  // the same well by another type
  CHECK(rows("--contact hertz --precompression 0") == plain);
  CHECK(rows("--contact power --alpha 1.5") == plain);
  CHECK(rows("--onsite pendulum") != plain);
  CHECK(rows("--onsite none") != plain);
  CHECK(rows("--contact power --alpha 2") != plain);
  CHECK(rows("--precompression 0.5") == rows("--contact power --precompression 0.5"));
  CHECK(rows("--precompression 0.5") != plain);
}

TEST_CASE("what a model does not have is refused", "[cli][model]") {
  check_refused("--onsite cubic", "none, harmonic, quartic, pendulum");
  check_refused("--contact glue", "hertz, power");
  check_refused("--onsite pendulum --s 0.1", "--s");
  check_refused("--onsite harmonic --s 0", "'harmonic' has no parameter s");
  check_refused("--alpha 2", "'hertz' has no parameter alpha");
  check_refused("--contact power --alpha 0.5", "[1, 10]");
  check_refused("--s nan", "[-10, 10]");
}
