// The model as a value: the chain that it stands for, and the options with which a reader asks.

#include "lattice/model/model.hpp"

#include <array>
#include <cstdio>
#include <string>
#include <type_traits>

#include "check.hpp"

using namespace lattice;

namespace {

struct Answer {
  int code;
  std::string text;  ///< both streams
};

Answer call(const std::string& options) {
  const std::string command = "'" BIN_DIR "/sec34_impact' run --time 20 " + options + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Answer out{0, ""};
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    out.text.append(buffer.data(), n);
  out.code = pclose(pipe) / 256;
  return out;
}

/// The table without its header, which tells the command.
std::string body(const std::string& options) {
  const Answer answer = call(options);
  CAPTURE(options, answer.text);
  REQUIRE(answer.code == 0);
  return answer.text.substr(answer.text.find("\nquantity"));
}

/// Exit code 2 and one line that contains `what`.
void check_refused(const std::string& options, const std::string& what) {
  const Answer answer = call(options);
  CAPTURE(options, answer.text);
  CHECK(answer.code == 2);
  CHECK(std::count(answer.text.begin(), answer.text.end(), '\n') == 1);
  CHECK(answer.text.find(what) != std::string::npos);
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
  const std::string plain = body("");
  CHECK(body("--onsite quartic --s 0") == plain);
  CHECK(body("--onsite harmonic") == plain);  // the same well by another type
  CHECK(body("--contact hertz --precompression 0") == plain);
  CHECK(body("--contact power --alpha 1.5") == plain);
  CHECK(body("--onsite pendulum") != plain);
  CHECK(body("--onsite none") != plain);
  CHECK(body("--contact power --alpha 2") != plain);
  CHECK(body("--precompression 0.5") == body("--contact power --precompression 0.5"));
  CHECK(body("--precompression 0.5") != plain);
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
