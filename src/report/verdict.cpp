/**
# The judge */

#include "report/verdict.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "report/table.hpp"

namespace report {

static const double nan = std::nan("");
/// A number that is printed as about so much, or that is cut instead of rounded, agrees within one unit of its last digit.
static constexpr std::string_view hedges[] = {"",        "about", "cut", "order of magnitude",
                                              "at most", "exact"};

/**
## What is printed

It is a number, a range (`238 to 241`), a count of orders of magnitude (`3 to 4 orders`), a multiple of pi (`3 pi/2`),
or words. A number agrees within half a unit of its last digit, one with a hedge within what the hedge allows. */
struct Print {
  double low, high, unit;  // of the last digit
  int digits;
};

static std::optional<Print> print_of(const std::string& text) {
  // Take off, from the end, what follows a word
  std::string first = text;
  const auto after = [&](const std::string& word) -> std::optional<std::string> {
    const auto at = first.find(word);
    if (at == std::string::npos) return {};
    const std::string rest = first.substr(at + word.size());
    first.resize(at);
    return rest;
  };
  const bool orders = first.ends_with(" orders");
  if (orders) first.resize(first.size() - 7);
  const std::optional<std::string> to = after(" to "), over = after(" pi/");
  const auto one = parse_number(first), other = parse_number(to.value_or("0")),
             divisor = parse_number(over.value_or("1"));
  if (!one || !other || !divisor) return {};
  // The unit of the last digit, and the ends of the range
  const auto e = std::min(first.find_first_of("eE"), first.size()), dot = first.find('.');
  const double decimals = dot == std::string::npos ? 0 : double(e - dot - 1);
  const double power = e == first.size() ? 0 : std::stod(first.substr(e + 1));
  double a = *one * (over ? std::acos(-1.0) / *divisor : 1), b = to ? *other : a;
  if (orders) a = std::pow(10, a), b = std::pow(10, b);
  const std::string plain = first.substr(0, e);
  const auto begin = plain.find_first_of("123456789");
  const auto digits = begin == std::string::npos
                          ? 0
                          : std::count_if(plain.begin() + std::ptrdiff_t(begin), plain.end(),
                                          [](unsigned char c) { return std::isdigit(c) != 0; });
  return Print{std::min(a, b), std::max(a, b), std::pow(10, power - decimals), int(digits)};
}

// Throws std::invalid_argument for a hedge that is none
Range allowed(const Claim& claim) {
  const std::string& hedge = claim.tolerance;
  if (std::ranges::find(hedges, hedge) == std::end(hedges))
    throw std::invalid_argument("the tolerance '" + hedge +
                                "' is unknown (allowed: the name of a hedge: about, cut, order of "
                                "magnitude, at most, exact, or nothing)");
  const auto print = print_of(claim.printed);
  if (!print) return {nan, nan};
  const double size = std::max(std::abs(print->low), std::abs(print->high));
  if (hedge == "at most") return {-HUGE_VAL, print->high};
  if (hedge == "order of magnitude") {
    const double factor = std::sqrt(10.0);
    return {std::min(print->low / factor, print->low * factor),
            std::max(print->high / factor, print->high * factor)};
  }
  const double by = hedge == "exact" ? 1e-12 * size : (hedge.empty() ? 0.5 : 1) * print->unit;
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
A number of three digits or more that is missed by no more than two units of the last one is reproduced *in part*. It is
covered in two cases: if the article's own `accuracy` is not better than the distance, or if the number is a power of
another printed one (`moving.c_threshold^2`) that is missed too, and ours is what is printed with that number in the
place of our own. `method` and `memory` say what is not known, so that no verdict is passed at all. And where other
readings spread as far as the number is missed, what is not printed decides. */
/// What is not farther than so much: yes or no, or nothing where the error bar straddles the edge.
static std::optional<bool> is_within(const Estimate& apart, const Estimate& edge) {
  const double error = apart.error + edge.error;
  const double left = edge.value - apart.value;
  if (!std::isfinite(left + error) || std::abs(left) < error) return {};
  return left >= 0;
}

static bool follows(const Case& one, const Cases& all) {
  const auto& [claim, found] = one;
  const auto hat = claim.covered_by.find('^');
  const auto other = std::find_if(all.begin(), all.end(), [&](const Case& c) {
    return c.claim.id == claim.covered_by.substr(0, hat);
  });
  if (other == all.end() || !other->found.answer) return false;
  if (!other->found.lost.empty() || other->found.lost_control()) return false;
  const Estimate theirs = *other->found.answer, ours = *found.answer;
  const double power = hat == std::string::npos ? 1 : std::stod(claim.covered_by.substr(hat + 1));
  const double scale = std::pow(print_of(other->claim.printed)->low / theirs.value, power);
  const double relative = power * theirs.error / std::abs(theirs.value);
  const std::string then = on_answer(
      claim, {scale * ours.value, scale * (ours.error + relative * std::abs(ours.value))});
  return on_answer(other->claim, theirs) == "discrepant" && then.rfind("repro", 0) == 0;
}

/// How far the readings are from each other and from the answer.
static Estimate spread(const Judged& found) {
  std::vector<Estimate> all{*found.answer};
  for (const OtherReading& other : found.readings)
    if (other.value) all.push_back(*other.value);
  const Estimate low = least_of(all), high = largest_of(all);
  return {high.value - low.value, high.error + low.error};
}

// Of a number that is missed for certain
static std::string on_missed(const Case& one, const Cases& all) {
  const auto& [claim, found] = one;
  const Estimate ours = *found.answer;
  const Print print = *print_of(claim.printed);
  const Estimate apart(std::max(print.low - ours.value, ours.value - print.high), ours.error);
  if (found.accuracy) {
    const auto is_covered = is_within(apart, *found.accuracy);
    if (!is_covered) return "unresolved";
    if (*is_covered) return "within its own accuracy";
  }
  if (print.digits >= 3) {
    const auto is_near = is_within(apart, exact(2 * print.unit));
    if (!is_near) return "unresolved";
    if (*is_near) return "in part";
  }
  if (follows(one, all)) return "follows";
  const auto [low, high] = allowed(claim);
  const auto is_reached =
      is_within({std::max(low - ours.value, ours.value - high), ours.error}, spread(found));
  return !is_reached ? "unresolved" : *is_reached ? "quantified" : "discrepant";
}

/**
## The verdict on comparisons

An assertion that holds assumes something if another reading, or half or twice a bound of ours, has another outcome. One
that fails is discrepant only if it fails in every reading, and where only a bound of ours speaks against it, it is
quantified. */
// By the outcome of its comparisons
static std::string on_comparisons(const Judged& found) {
  const bool assumes = found.is_sensitive();
  const auto by_bound = [](const OtherReading& other) {
    return other.is_bound && other.outcome == Outcome::holds;
  };

  const auto holds_anywhere = [](const OtherReading& other) {
    return other.outcome == Outcome::holds || other.outcome == Outcome::in_part;
  };
  switch (outcome_of(found.comparisons)) {
    case Outcome::holds:
      return assumes ? "holds, assuming" : "holds";
    case Outcome::in_part:
      return std::ranges::any_of(found.readings, by_bound) ? "quantified" : "in part";
    case Outcome::fails:
      return std::ranges::any_of(found.readings, holds_anywhere) ? "quantified" : "discrepant";
    default:
      return "unresolved";
  }
}

// Of any row
std::string verdict(const Case& one, const Cases& all) {
  const auto& [claim, found] = one;
  if (!found.not_run.empty()) return claim.status;
  if (!found.lost.empty() || found.lost_control()) return "unresolved";
  if (!found.answer) return on_comparisons(found);
  const std::string plain = on_answer(claim, *found.answer);
  return plain == "discrepant" ? on_missed(one, all) : plain;
}

std::string outcome(const OtherReading& reading, const Claim& claim) {
  if (!reading.outcome && !print_of(claim.printed)) return "";
  if (!reading.outcome) {
    Claim plain = claim;
    plain.covered_by.clear();
    const std::string word = on_answer(plain, *reading.value);
    return word == "discrepant" ? "missed" : word == "unresolved" ? "undecided" : "met";
  }
  switch (*reading.outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::in_part:
      return "in part";
    case Outcome::fails:
      return "fails";
    default:
      return "undecided";
  }
}

/**
## Reading

A list has the columns of its own kind. */
static const std::set<std::string> missed{"in part", "within its own accuracy", "follows",
                                          "discrepant"},
    met{"reproduced", "reproduced, assuming", "holds", "holds, assuming", "quantified"};

bool is_met(const std::string& verdict) {
  return met.count(verdict) > 0;
}

static std::string complaint(const Claim& c) try {
  allowed(c);
  if (!c.tolerance.empty() && !print_of(c.printed)) return "words have no tolerance";
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

Choices read_choices(const std::filesystem::path& volume) {
  Choices out;
  const auto path = volume / "paper/readings.ecsv";
  if (!std::filesystem::exists(path)) return out;
  const Table t = read(path);
  const auto id = t.texts("id"), reading = t.texts("reading"), choice = t.texts("choice");
  for (std::size_t i = 0; i < id.size(); ++i)
    if (!out.insert({{id[i], reading[i]}, choice[i]}).second)
      throw std::runtime_error(path.string() + ": " + id[i] + ": two rows of '" + reading[i] + "'");
  return out;
}

// All readings that are listed, and no others
static void check_readings(const Cases& rows, Choices left) {
  const auto fault = [](const std::string& id, const std::string& what) {
    throw std::runtime_error("paper/readings.ecsv: " + id + ": " + what);
  };
  const Choices listed = left;
  for (const auto& [claim, found] : rows) {
    for (const OtherReading& reading : found.readings)
      if (!reading.is_bound && !listed.count({claim.id, reading.name}))
        fault(claim.id, "the reading '" + reading.name + "' is not listed");
    const bool is_judged = found.lost.empty() && found.not_run.empty();
    std::erase_if(left, [&](const auto& row) {
      const auto is_it = [&](const OtherReading& r) { return r.name == row.first.second; };
      return row.first.first == claim.id &&
             (!is_judged || std::ranges::any_of(found.readings, is_it));
    });
  }
  if (!left.empty())
    fault(left.begin()->first.first,
          "the reading '" + left.begin()->first.second + "' is not computed");
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
  check_readings(out, read_choices(volume));
  return out;
}

}  // namespace report
