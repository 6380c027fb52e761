// What we found beyond the article: each row of paper/findings.ecsv is judged on the files from which the figures are
// drawn. lineage/findings.py judges for the pages; the two share no line.

#include <sstream>

#include "answers.hpp"
#include "check.hpp"
#include "lattice/numerics/criterion.hpp"

using namespace lattice;
namespace fs = std::filesystem;

namespace {

const fs::path data = DATA_DIR;

/// Our numbers by the names that prose gives them, and claims by their ids.
class Named {
 public:
  explicit Named(const Findings& findings)
      : claims_(read_claims(SOURCE_DIR "/paper/published.ecsv")) {
    for (const auto& [key, f] : findings)
      found_[claims_.count(key.second) ? key.second : key.first + "." + key.second] = f;
  }
  const Finding& operator[](const std::string& name) const {
    const auto found = found_.find(name);
    if (found == found_.end()) throw std::runtime_error("nothing is known of " + name);
    return found->second;
  }

 private:
  std::map<std::string, Claim> claims_;
  std::map<std::string, Finding> found_;
};

/// The criterion of a row: `a.x > 1; b.y < b.z`, a difference where both sides are numbers of ours.
Criterion criterion_of(const std::string& text, const Named& named) {
  Criterion out;
  std::istringstream conditions(text);
  for (std::string one; std::getline(conditions, one, ';');) {
    std::istringstream words(one);
    std::string name, side, limit;
    words >> name >> side >> limit;
    Estimate value{named[name].value, named[name].error};
    double least = 0;
    if (std::isalpha(static_cast<unsigned char>(limit.front())))
      value = {value.value - named[limit].value, value.error + named[limit].error};
    else
      least = std::stod(limit);
    out.push_back(side == ">" ? above(name, value, least) : below(name, value, least));
  }
  return out;
}

/// The same with one condition missed by as much as it is met.
Criterion with_wrong(Criterion criterion, std::size_t k) {
  Condition& c = criterion[k];
  c.value.value = 2 * c.limit - c.value.value;
  return criterion;
}

}  // namespace

TEST_CASE("findings", "[published]") {
  const Named fresh(read_findings(data));
  const Table rows = read(VOLUME_DIR "/paper/findings.ecsv");
  const auto id = rows.texts("id"), kind = rows.texts("kind"), criterion = rows.texts("criterion"),
             sentence = rows.texts("sentence"), range = rows.texts("range");
  REQUIRE(id.size() <= 30);
  for (std::size_t i = 0; i < id.size(); ++i) DYNAMIC_SECTION(id[i]) {
      const Criterion conditions = criterion_of(criterion[i], fresh);
      for (const Condition& c : conditions) {
        CAPTURE(c.name, c.value.value, c.value.error, c.limit);
        REQUIRE(std::isfinite(c.margin().value));
        CHECK(c.holds());
      }
      CHECK(holds(conditions));
      for (std::size_t k = 0; k < conditions.size(); ++k)
        CHECK_FALSE(holds(with_wrong(conditions, k)));
      // What was observed names its range in the sentence itself
      if (kind[i] == "observed")
        CHECK(sentence[i].find(range[i].substr(0, range[i].find(';'))) != std::string::npos);
    }
}
