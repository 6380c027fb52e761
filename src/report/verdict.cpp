/**
# The judge */

#include "report/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <set>

#include "report/table.hpp"

namespace lattice {

static const std::string number_pattern = R"((-?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))";
static const double nan = std::nan("");

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
static std::string on_answer(const Claim& claim, const Estimate& ours) {
  if (!std::isfinite(ours.value) || !std::isfinite(ours.error)) return "unresolved";
  const bool unknown = claim.covered_by == "method" || claim.covered_by == "memory";
  if (!print_of(claim.printed) || unknown) return "quantified";
  const auto [low, high] = allowed(claim);
  const double least = ours.value - ours.error, most = ours.value + ours.error;
  if (low <= least && most <= high)
    return claim.assumption.empty() ? "reproduced" : "reproduced, assuming";
  return most < low || least > high ? "discrepant" : "unresolved";
}

/**
A number that is missed is covered in two cases: if the article's own `accuracy` is not better than the distance, or if the
number is a power of another printed one (`moving.c_threshold^2`) that is missed too, and ours is what is printed with that
number in the place of our own. `method` and `memory` say what is not known, so that no verdict is passed at all. */
static std::string on_missed(const Case& one, const Cases& all) {
  const auto& [claim, found] = one;
  const Estimate ours = *found.answer;
  const Print print = *print_of(claim.printed);
  if (found.accuracy) {
    const double apart = std::max(print.low - ours.value, ours.value - print.high) + ours.error;
    return apart <= found.accuracy->value - found.accuracy->error ? "within its own accuracy"
                                                                  : "discrepant";
  }
  const auto hat = claim.covered_by.find('^');
  const auto other = std::find_if(all.begin(), all.end(), [&](const Case& c) {
    return c.claim.id == claim.covered_by.substr(0, hat);
  });
  if (other == all.end() || !other->found.answer) return "discrepant";
  const Estimate theirs = *other->found.answer;
  const double power = hat == std::string::npos ? 1 : std::stod(claim.covered_by.substr(hat + 1));
  const double scale = std::pow(print_of(other->claim.printed)->low / theirs.value, power);
  const std::string then = on_answer(claim, {scale * ours.value, scale * ours.error});
  const bool follows =
      on_answer(other->claim, theirs) == "discrepant" && then.rfind("repro", 0) == 0;
  return follows ? "follows" : "discrepant";
}

static std::string on_comparisons(const std::vector<Comparison>& all) {
  const auto fails = [](const Comparison& c) { return c.is_decided() && !c.holds(); };
  if (std::ranges::all_of(all, &Comparison::holds)) return "holds";
  return std::ranges::any_of(all, fails) ? "discrepant" : "unresolved";
}

std::string verdict(const Case& one, const Cases& all) {
  const auto& [claim, found] = one;
  if (!found.not_run.empty()) return claim.status;
  if (!found.lost.empty()) return "unresolved";
  if (!found.answer) return on_comparisons(found.comparisons);
  const std::string plain = on_answer(claim, *found.answer);
  return plain == "discrepant" ? on_missed(one, all) : plain;
}

/**
## Reading

A list has the columns of its own kind. */
static const std::set<std::string> missed{"within its own accuracy", "follows", "discrepant"},
    met{"reproduced", "reproduced, assuming", "holds", "quantified"};

bool is_met(const std::string& verdict) {
  return met.count(verdict) > 0;
}

static std::string complaint(const Claim& c) try {
  allowed(c);
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
                                                          {"tolerance", &Claim::tolerance},
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
    claim.list = path.stem().string();
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

// All lists of a volume, and the statement of every row
static Cases all_rows(const std::filesystem::path& volume) {
  Cases out;
  for (const char* list : {"claims", "findings", "literature"}) {
    const auto path = volume / "paper" / (std::string(list) + ".ecsv");
    if (!std::filesystem::exists(path)) continue;
    for (Claim& claim : read_claims(path)) out.push_back({std::move(claim), {}});
  }
  return out;
}

Cases judge(const std::filesystem::path& volume, Tables& tables) {
  Cases out = all_rows(volume);
  std::set<std::string> ids;
  for (auto& [claim, found] : out) {
    const auto statement = statements().find(claim.id);
    if (statement == statements().end())
      throw std::runtime_error("paper/" + claim.list + ".ecsv: " + claim.id +
                               ": no statement in src/statements judges it");
    found = statement->second.judge(tables);
    ids.insert(claim.id);
  }
  for (const auto& [id, statement] : statements())
    if (!ids.count(id))
      throw std::runtime_error("src/statements/" + statement.program + ".cpp: " + id +
                               ": no list has such a row");
  return out;
}

}  // namespace lattice
