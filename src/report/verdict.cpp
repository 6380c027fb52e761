/**
# The judge */

#include "report/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "report/table.hpp"

namespace lattice {

static const std::string number_pattern = R"((-?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))",
                         name_pattern = R"(([a-z]\w*\.\w+))";
static const double nan = std::nan("");

static bool is_name(const std::string& text) {
  return !text.empty() && text.find('.') != std::string::npos && std::isalpha(text[0]);
}

static Fact known(const Facts& facts, const std::string& name) {
  const auto at = facts.find(name);
  return at == facts.end() ? Fact{nan, nan} : at->second;
}

static bool is_finite(double value, double error) {
  return std::isfinite(value) && std::isfinite(error);
}

/**
## What is printed

It is a number, a range (`238 to 241`), a count of orders of magnitude (`3 to 4 orders`), a multiple of pi (`3 pi/2`), or words.
A number without a tolerance agrees within half a unit of its last digit. */
struct Print {
  double low, high, half_digit;
};

static std::optional<Print> print_of(const std::string& text) {
  static const std::regex form(number_pattern + "(?: pi/" + number_pattern + ")?(?: to " +
                               number_pattern + ")?( orders)?");
  std::smatch m;
  if (!std::regex_match(text, m, form)) return {};
  const std::string first = m[1];
  const auto e = std::min(first.find_first_of("eE"), first.size()), dot = first.find('.');
  const double decimals = dot == std::string::npos ? 0 : double(e - dot - 1);
  const double power = e == first.size() ? 0 : std::stod(first.substr(e + 1));
  double a = std::stod(first) * (m[2].matched ? std::acos(-1.0) / std::stod(m[2]) : 1);
  double b = m[3].matched ? std::stod(m[3]) : a;
  if (m[4].matched) a = std::pow(10, a), b = std::pow(10, b);
  return Print{std::min(a, b), std::max(a, b), 0.5 * std::pow(10, power - decimals)};
}

// Throws std::invalid_argument for a tolerance that is none
Range allowed(const Claim& claim) {
  static const std::regex form("(rel|abs) " + number_pattern);
  const auto print = print_of(claim.printed);
  if (!print) return {nan, nan};
  const double size = std::max(std::abs(print->low), std::abs(print->high));
  const std::string& tolerance = claim.tolerance;
  if (tolerance == "at most") return {-HUGE_VAL, print->high};
  if (tolerance == "order of magnitude") return {print->low / 10, 10 * print->high};
  std::smatch m;
  double by = print->half_digit;
  if (tolerance == "exact")
    by = 1e-12 * size;
  else if (std::regex_match(tolerance, m, form))
    by = std::stod(m[2]) * (m[1] == "rel" ? size : 1);
  if (by < 0 || (!tolerance.empty() && tolerance != "exact" && m.empty()))
    throw std::invalid_argument("the tolerance '" + tolerance +
                                "' is unknown (allowed: rel 1e-3, abs 1e-3, at most, exact, order "
                                "of magnitude, or nothing)");
  return {print->low - by, print->high + by};
}

/**
## The verdict on an answer

Where the error bar straddles an edge there is none. */
static std::string on_answer(const Claim& claim, const Fact& ours) {
  if (!is_finite(ours.value, ours.error)) return "unresolved";
  const bool in_words = claim.kind == "claim" || !print_of(claim.printed);
  const bool unknown = !claim.covered_by.empty() && !is_name(claim.covered_by);
  if (in_words || unknown) return "quantified";
  const auto [low, high] = allowed(claim);
  const double least = ours.value - ours.error, most = ours.value + ours.error;
  if (low <= least && most <= high)
    return claim.assumption.empty() ? "reproduced" : "reproduced, assuming";
  return most < low || least > high ? "discrepant" : "unresolved";
}

/**
A number that is missed is covered in two cases: if by a fact of ours the article's own accuracy is not better than the
distance, or if the number is a power of another printed one (`moving.c_threshold^2`) that is missed too, and ours is what
is printed with that number in the place of our own. A word in the place of the name (`method`, `memory`) says what is not
known, so that no verdict is passed at all. */
static std::string on_missed(const Claim& claim, const Claims& all, const Facts& facts) {
  const Fact ours = known(facts, claim.answer);
  const auto hat = claim.covered_by.find('^');
  const std::string name = claim.covered_by.substr(0, hat);
  const auto other =
      std::find_if(all.begin(), all.end(), [&](const Claim& c) { return c.id == name; });
  const Print print = *print_of(claim.printed);
  if (other == all.end()) {
    const Fact accuracy = known(facts, name);
    const double apart = std::max(print.low - ours.value, ours.value - print.high) + ours.error;
    return apart <= accuracy.value - accuracy.error ? "within its own accuracy" : "discrepant";
  }
  const Fact found = known(facts, other->answer);
  const double power = hat == std::string::npos ? 1 : std::stod(claim.covered_by.substr(hat + 1));
  const double scale = std::pow(print_of(other->printed)->low / found.value, power);
  const std::string theirs = on_answer(claim, {scale * ours.value, scale * ours.error, ours.unit});
  const bool follows = on_answer(*other, found) == "discrepant" && theirs.rfind("repro", 0) == 0;
  return follows ? "follows" : "discrepant";
}

static std::string on_criterion(const Claim& claim, const Facts& facts) {
  bool holds = true, decided = true;
  for (const Condition& c : conditions(claim)) {
    const Estimate left = c.left(facts);
    if (!is_finite(left.value, left.error)) return "unresolved";
    holds = holds && left.value > left.error;
    decided = decided && std::abs(left.value) > left.error;
  }
  return holds ? "holds" : decided ? "discrepant" : "unresolved";
}

Estimate Condition::left(const Facts& facts) const {
  const Fact value = known(facts, fact),
             other = is_name(limit) ? known(facts, limit) : Fact{std::stod(limit), 0};
  return {(value.value - other.value) * (above ? 1 : -1), value.error + other.error};
}

// A criterion is a list of conditions, `a.x > 1; a.y < b.z`
std::vector<Condition> conditions(const Claim& claim) {
  static const std::regex form(name_pattern + " ([<>]) (?:" + number_pattern + "|" + name_pattern +
                               ")");
  std::vector<Condition> out;
  std::istringstream all(claim.criterion);
  for (std::string one; std::getline(all >> std::ws, one, ';');) {
    std::smatch m;
    if (!std::regex_match(one, m, form))
      throw std::invalid_argument("'" + one +
                                  "' is not a condition (allowed: such as program.fact > 0.5)");
    out.push_back({m[1], m[2] == ">", m[3].matched ? m[3] : m[4]});
  }
  return out;
}

std::string verdict(const Claim& claim, const Claims& all, const Facts& facts) {
  if (claim.answer.empty()) return on_criterion(claim, facts);
  const std::string plain = on_answer(claim, known(facts, claim.answer));
  return plain == "discrepant" && is_name(claim.covered_by) ? on_missed(claim, all, facts) : plain;
}

// Six digits of a value, one of its error
std::string found(const Claim& claim, const Facts& facts) {
  std::ostringstream out;
  const auto print = [&](const Fact& f) {
    out.precision(6);
    out << f.value;
    out.precision(1);
    if (f.error != 0) out << " +- " << f.error;
    out << (f.unit.empty() ? "" : " ") << f.unit;
  };
  if (!claim.answer.empty()) print(known(facts, claim.answer));
  for (const Condition& c : conditions(claim)) {
    out << (out.tellp() > 0 ? "; " : "") << c.fact << " = ";
    print(known(facts, c.fact));
    out << (c.above ? " > " : " < ") << c.limit;
    if (is_name(c.limit)) out << " = ", print(known(facts, c.limit));
  }
  return out.str();
}

std::string program_of(const Claim& claim) {
  const std::string& decides = claim.answer.empty() ? claim.criterion : claim.answer;
  return decides.substr(0, decides.find('.'));
}

/**
## Reading

A list has the columns of its own kind. */
static const std::set<std::string> missed{"within its own accuracy", "follows", "discrepant"},
    met{"reproduced", "reproduced, assuming", "holds", "quantified"};

static std::string complaint(const Claim& c) try {
  allowed(c);
  if (conditions(c).empty() == c.answer.empty())
    return "either an answer or a criterion is needed, not both";
  if (!c.answer.empty() && !is_name(c.answer))
    return "'" + c.answer + "' is not the name of a fact";
  if (!met.count(c.status) && !missed.count(c.status))
    return "the status '" + c.status + "' is unknown";
  if (missed.count(c.status) == c.reason.empty() && !c.section.empty())
    return "a row needs a reason if it is missed, and only then";
  return "";
} catch (const std::invalid_argument& error) {
  return error.what();
}

Claims read_claims(const std::filesystem::path& path) {
  const std::map<std::string, std::string Claim::*> texts{{"id", &Claim::id},
                                                          {"section", &Claim::section},
                                                          {"where", &Claim::where},
                                                          {"quantity", &Claim::quantity},
                                                          {"printed", &Claim::printed},
                                                          {"unit", &Claim::unit},
                                                          {"class", &Claim::kind},
                                                          {"tolerance", &Claim::tolerance},
                                                          {"answer", &Claim::answer},
                                                          {"criterion", &Claim::criterion},
                                                          {"assumption", &Claim::assumption},
                                                          {"covered_by", &Claim::covered_by},
                                                          {"reason", &Claim::reason},
                                                          {"status", &Claim::status}};
  // Every row by itself, and no id twice
  const Table t = read(path);
  Claims out;
  std::set<std::string> ids;
  for (const auto& row : t.rows) {
    Claim& claim = out.emplace_back();
    for (std::size_t c = 0; c < row.size(); ++c)
      if (const auto text = texts.find(t.columns[c].name); text != texts.end())
        claim.*text->second = std::get<std::string>(row[c]);
    std::string wrong = complaint(claim);
    if (!ids.insert(claim.id).second) wrong = "two rows have this id";
    if (!wrong.empty())
      throw std::runtime_error(path.string() + ": row " + std::to_string(out.size()) + ": " +
                               claim.id + ": " + wrong);
  }
  return out;
}

// Reference values first; a program that has run replaces all of its own
Facts read_facts(const std::filesystem::path& data,
                 const std::vector<std::filesystem::path>& locks) {
  Facts out;
  const auto add = [&](const Table& t, const std::vector<std::string>& programs, const char* name) {
    const auto id = t.texts(name), unit = t.texts("unit");
    const auto value = t.numbers("value"), error = t.numbers("error");
    for (std::size_t i = 0; i < id.size(); ++i)
      out[programs[i] + "." + id[i]] = {value[i], error[i], unit[i]};
  };
  for (const auto& path : locks) {
    const Table t = read(path);
    add(t, t.texts("program"), "id");
  }
  for (const auto& folder : std::filesystem::directory_iterator(data)) {
    const std::string program = folder.path().filename().string();
    if (!std::filesystem::exists(folder.path() / "facts.ecsv")) continue;
    std::erase_if(out, [&](const auto& f) { return f.first.rfind(program + ".", 0) == 0; });
    const Table t = read(folder.path() / "facts.ecsv");
    add(t, std::vector(t.rows.size(), program), "quantity");
  }
  return out;
}

}  // namespace lattice
