#pragma once
// The judge of the tests: what the article prints, an answer, and the verdict. lineage/claims.py, which writes
// the summary, the README and the book, judges on its own; a test asks that both agree. The verdicts:
//
//   reproduced   a printed number, met within its tolerance
//   holds        a yes-or-no statement that our criterion confirms
//   discrepant   a printed number missed, or a statement that fails
//   measured     the article uses a word without a number; we give the number and pass no judgement
//   unresolved   the error bar does not allow a verdict, which no test accepts
//   open         not answered yet

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/report/table.hpp"

namespace lattice {

/// One row of `paper/published.ecsv`.
struct Claim {
  std::string id, section, where, quantity, printed, unit, kind, tolerance, note, program, status,
      reason;
};

/// A computed answer.
struct Answer {
  double value = 0, error = 0;
  std::string unit;
};

// Claims come from one table, a row each, whose columns have the names of the fields. Throws like `read` and
// `Table::texts`.
inline std::vector<Claim> read_claims(const std::filesystem::path& path) {
  const Table t = read(path);
  std::vector<Claim> claims(t.rows.size());
  const std::pair<const char*, std::string Claim::*> fields[] = {
      {"id", &Claim::id},           {"section", &Claim::section},
      {"where", &Claim::where},     {"quantity", &Claim::quantity},
      {"printed", &Claim::printed}, {"unit", &Claim::unit},
      {"class", &Claim::kind},      {"tolerance", &Claim::tolerance},
      {"note", &Claim::note},       {"program", &Claim::program},
      {"status", &Claim::status},   {"reason", &Claim::reason}};
  for (const auto& [name, member] : fields) {
    const auto column = t.texts(name);
    for (std::size_t i = 0; i < column.size(); ++i) claims[i].*member = column[i];
  }
  return claims;
}

// Answers come from the `results.ecsv` that each program leaves in its folder under `data`. The keys are
// program and id; an answer given twice is refused.
inline std::map<std::pair<std::string, std::string>, Answer> read_answers(
    const std::filesystem::path& data) {
  std::map<std::pair<std::string, std::string>, Answer> answers;
  for (const auto& folder : std::filesystem::directory_iterator(data)) {
    const auto file = folder.path() / "results.ecsv";
    if (!std::filesystem::exists(file)) continue;
    const Table t = read(file);
    const auto id = t.texts("id"), unit = t.texts("unit");
    const auto value = t.numbers("value"), error = t.numbers("error");
    for (std::size_t i = 0; i < id.size(); ++i)
      if (!answers
               .emplace(std::pair(folder.path().filename().string(), id[i]),
                        Answer{value[i], error[i], unit[i]})
               .second)
        throw std::runtime_error(file.string() + ": two answers for " + id[i]);
  }
  return answers;
}

// What the article prints is a number, a range ("1e-14 to 1e-15"), a count of orders of magnitude ("3 to 4
// orders") or a multiple of $\pi$. Anything else is a statement, which an answer of one confirms.
struct Printed {
  double low = 0, high = 0;
  double half_digit = 0;  ///< half a unit in the last printed digit
};

/// The number at the start of `text`, its last digit's half unit, and what follows; empty if none.
struct Numeral {
  double value, half_digit;
  std::string rest;
};

inline std::optional<Numeral> leading_number(const std::string& text) {
  double value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc()) return std::nullopt;
  const std::string digits(text.data(), end);
  const auto e = digits.find_first_of("eE");
  const std::string mantissa = digits.substr(0, e);
  const auto point = mantissa.find('.');
  const double decimals = point == std::string::npos ? 0 : double(mantissa.size() - point - 1);
  const double power = e == std::string::npos ? 0 : std::stod(digits.substr(e + 1));
  return Numeral{value, 0.5 * std::pow(10, power - decimals),
                 std::string(end, text.data() + text.size())};
}

// `parse_printed` accepts a number and the few words that the list of claims puts behind one; any other word
// makes it a statement, and nothing is returned.
inline std::optional<Printed> parse_printed(const std::string& text) {
  const auto first = leading_number(text);
  if (!first) return std::nullopt;
  Printed p{first->value, first->value, first->half_digit};
  std::string rest = first->rest;
  if (rest.rfind(" pi/", 0) == 0) {
    p.low = p.high = first->value * std::numbers::pi / std::stod(rest.substr(4));
    return p;
  }
  if (rest.rfind(" to ", 0) == 0) {
    const auto second = leading_number(rest.substr(4));
    if (!second) return std::nullopt;
    p.high = second->value;
    rest = second->rest;
  }
  if (rest == " orders") {
    p.low = std::pow(10, p.low);
    p.high = std::pow(10, p.high);
    rest.clear();
  }
  if (!rest.empty()) return std::nullopt;
  if (p.low > p.high) std::swap(p.low, p.high);
  return p;
}

// The tolerance of the row turns the printed number into an interval of values that agree with it. Without a
// tolerance the printed digits must be met. Throws std::runtime_error for a tolerance that is none of
// these.
inline std::pair<double, double> agreement(const Printed& p, const std::string& tolerance) {
  if (tolerance == "at most") return {-std::numeric_limits<double>::infinity(), p.high};
  if (tolerance == "order of magnitude") return {p.low / 10, p.high * 10};
  if (tolerance.empty()) return {p.low - p.half_digit, p.high + p.half_digit};
  double amount = 1e-12 * std::max(std::abs(p.low), std::abs(p.high));
  if (tolerance != "exact") {
    amount = std::stod(tolerance.substr(4));
    if (tolerance.rfind("rel ", 0) == 0)
      amount *= std::max(std::abs(p.low), std::abs(p.high));
    else if (tolerance.rfind("abs ", 0) != 0)
      throw std::runtime_error("unknown tolerance '" + tolerance + "'");
  }
  return {p.low - amount, p.high + amount};
}

// The row and the answer decide together. An answer with the unit `claim` is a yes or a no, which is no
// answer to a printed number; a number that answers a word is a measurement. Only a printed number is
// compared with the answer, and if the error bar straddles an edge of the interval of agreement there is no
// verdict.
inline std::string verdict(const Claim& claim, const Answer& answer) {
  if (!std::isfinite(answer.value) || !std::isfinite(answer.error)) return "unresolved";
  const auto printed = parse_printed(claim.printed);
  const bool in_words = claim.kind == "claim" || !printed;
  if (answer.unit == "claim") {
    if (!in_words || answer.error != 0) return "unresolved";
    return answer.value == 1 ? "holds" : answer.value == 0 ? "discrepant" : "unresolved";
  }
  if (in_words) return "measured";
  const auto [low, high] = agreement(*printed, claim.tolerance);
  const bool in_low = answer.value - answer.error >= low && answer.value - answer.error <= high;
  const bool in_high = answer.value + answer.error >= low && answer.value + answer.error <= high;
  if (in_low && in_high) return "reproduced";
  const bool misses = answer.value + answer.error < low || answer.value - answer.error > high;
  return misses ? "discrepant" : "unresolved";
}

}  // namespace lattice
