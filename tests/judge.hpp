#pragma once
// The second judge: the verdict on a claim from what is printed, its tolerance and an answer. The first one is
// lineage/claims.py, which writes what people read; the two share no line and have to agree (tests/published.cpp).

#include <array>
#include <cmath>
#include <optional>
#include <regex>

#include "answers.hpp"

namespace lattice {

/// What is printed: between which two numbers, and half a unit of its last digit.
struct Print {
  double low, high, half;
};

/// A number, `a to b`, `a to b orders`, or `3 pi/2`; nothing for words.
inline std::optional<Print> print_of(const std::string& text) {
  static const std::string number = "(-?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?)";
  static const std::regex simple(number), pi(number + " pi/" + number),
      range(number + " to " + number + "( orders)?"), orders(number + " orders");
  std::smatch m;
  if (!std::regex_match(text, m, simple) && !std::regex_match(text, m, range) &&
      !std::regex_match(text, m, pi) && !std::regex_match(text, m, orders))
    return {};
  const std::string first = m[1];
  const auto e = first.find_first_of("eE"), dot = first.find('.');
  const auto end = std::min(e, first.size());
  const double decimals = dot == std::string::npos ? 0 : double(end - dot - 1);
  const double exponent = e == std::string::npos ? 0 : std::stod(first.substr(e + 1));
  double a = std::stod(first), b = a;
  if (text.find(" pi/") != std::string::npos) a = b = a * std::acos(-1.0) / std::stod(m[2]);
  if (text.find(" to ") != std::string::npos) b = std::stod(m[2]);
  if (text.find(" orders") != std::string::npos) a = std::pow(10, a), b = std::pow(10, b);
  return Print{std::min(a, b), std::max(a, b), 0.5 * std::pow(10, exponent - decimals)};
}

/// The values that agree with the print.
inline std::array<double, 2> allowed(const Print& print, const std::string& tolerance) {
  const double size = std::max(std::abs(print.low), std::abs(print.high));
  double by = print.half;
  if (tolerance == "at most") return {-std::numeric_limits<double>::infinity(), print.high};
  if (tolerance == "order of magnitude") return {print.low / 10, 10 * print.high};
  if (tolerance == "exact") by = 1e-12 * size;
  if (tolerance.rfind("abs ", 0) == 0) by = std::stod(tolerance.substr(4));
  if (tolerance.rfind("rel ", 0) == 0) by = std::stod(tolerance.substr(4)) * size;
  return {print.low - by, print.high + by};
}

inline bool in_words(const Claim& claim) {
  return claim.kind == "claim" || !print_of(claim.printed);
}

/// The verdict on the row alone: an answer whose error bar straddles an edge has none.
inline std::string verdict(const Claim& claim, const Finding& answer) {
  if (!std::isfinite(answer.value) || !std::isfinite(answer.error)) return "unresolved";
  if (answer.unit == "claim") {
    const bool decided = in_words(claim) && answer.error == 0;
    return decided && answer.value == 1   ? "holds"
           : decided && answer.value == 0 ? "discrepant"
                                          : "unresolved";
  }
  if (in_words(claim)) return "measured";
  const auto [low, high] = allowed(*print_of(claim.printed), claim.tolerance);
  if (low <= answer.value - answer.error && answer.value + answer.error <= high)
    return "reproduced";
  return answer.value + answer.error < low || answer.value - answer.error > high ? "discrepant"
                                                                                 : "unresolved";
}

/// Does the article's own accuracy, by this fact of ours, cover the distance from what is printed?
inline bool is_within(const Claim& claim, const Finding& answer, const Finding& accuracy) {
  const Print print = *print_of(claim.printed);
  const double apart = std::max(print.low - answer.value, answer.value - print.high);
  return apart + answer.error <= accuracy.value - accuracy.error;
}

/// Is the number missed only because `other`, of which it is this power, is missed?
inline bool follows(const Claim& claim, const Finding& answer, const Claim& other,
                    const Finding& found, double power) {
  const double scale = std::pow(print_of(other.printed)->low / found.value, power);
  Finding theirs = answer;
  theirs.value *= scale, theirs.error *= scale;
  return verdict(other, found) == "discrepant" && verdict(claim, theirs) == "reproduced";
}

using Claims = std::map<std::string, Claim>;

/// The verdict on a row among all others, with what covers it.
inline std::string verdict(const std::string& id, const Claims& claims, const Findings& findings) {
  const Claim& claim = claims.at(id);
  const Finding& answer = findings.at({claim.program, id});
  const std::string plain = verdict(claim, answer);
  if (plain != "discrepant" || claim.covered_by.empty()) return plain;
  const auto hat = claim.covered_by.find('^');
  const std::string name = claim.covered_by.substr(0, hat);
  if (const auto other = claims.find(name); other != claims.end()) {
    const double power = hat == std::string::npos ? 1 : std::stod(claim.covered_by.substr(hat + 1));
    const Finding& found = findings.at({other->second.program, name});
    return follows(claim, answer, other->second, found, power) ? "follows" : plain;
  }
  const auto dot = name.find('.');
  const Finding& accuracy = findings.at({name.substr(0, dot), name.substr(dot + 1)});
  return is_within(claim, answer, accuracy) ? "within" : plain;
}

}  // namespace lattice
