/**
# How parameters are checked

A complaint has one form, whatever is wrong: the value as it was typed, what is wrong with it, and what is
allowed. */

#include "report/parameters.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/model/potential_names.hpp"
#include "report/files.hpp"

namespace lattice {

/**
The numerator and the denominator of a fraction are decimal numbers. */
std::optional<double> typed_number(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return parse_number(text);
  const auto above = parse_number(text.substr(0, slash));
  const auto below = parse_number(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

Check in_range(const Allowed& range) {
  const std::string allowed = "[" + short_text(range.least) + ", " + short_text(range.most) + "]" +
                              (range.unit.empty() ? "" : " " + range.unit);
  const auto complaint = [range, allowed](const std::string& value) {
    const auto x = typed_number(value);
    if (!x) return "'" + value + "' is not a number (allowed: " + allowed + ")";
    const bool good = *x >= range.least && *x <= range.most;
    const std::string why = range.why.empty() ? "" : ": " + range.why;
    return good ? "" : "'" + value + "' is not in the allowed range " + allowed + why;
  };
  return {complaint, allowed};
}

/// The same for whole numbers.
static Check whole_in_range(const Allowed& range) {
  const Check number = in_range(range);
  const auto complaint = [number](const std::string& value) {
    const auto x = typed_number(value);
    if (x && !(*x == std::floor(*x) && std::abs(*x) < 1e15))
      return "'" + value + "' is not a whole number (allowed: " + number.allowed + ")";
    return number.complaint(value);
  };
  return {complaint, number.allowed};
}

Check not_empty() {
  return {[](const std::string& value) { return value.empty() ? "'' is not a name" : ""; },
          "a name"};
}

Check one_of(const std::vector<std::string>& names) {
  const auto complaint = [names](const std::string& value) {
    const bool known = std::find(names.begin(), names.end(), value) != names.end();
    return known ? "" : "'" + value + "' is not one of the allowed names " + comma_list(names);
  };
  return {complaint, comma_list(names), names};
}

std::string Check::shown() const {
  if (names.empty()) return allowed;
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "{" : "|") + name;
  return out + "}";
}

Check writable_folder() {
  const auto complaint = [](const std::string& value) {
    if (value.empty()) return not_empty().complaint(value);
    const std::string reason = why_not_writable(value, ".lattice");
    return reason.empty() ? ""
                          : "cannot write to '" + value + "': " + reason +
                                " (allowed: a folder in which you may write)";
  };
  return {complaint, "a folder"};
}

/**
A parameter says of itself what was typed, or what holds if nothing was. */
bool Option::called(const std::string& word) const {
  return word == name || std::find(old_names.begin(), old_names.end(), word) != old_names.end();
}

Option& Option::shows(const std::string& value) {
  standard = value;
  return *this;
}

Option& Option::formerly(const std::string& old_name) {
  old_names.push_back(old_name);
  return *this;
}

Option& Option::excludes(const Option& other) {
  rivals.push_back(other.name);
  return *this;
}

std::string Option::used() const {
  if (takes == Takes::flag) return given() ? "yes" : "no";
  if (!given()) return standard;
  return takes == Takes::number ? short_text(*typed_number(*typed)) : *typed;
}

/**
Each kind of variable has its own way to take what was typed, which is good when it arrives there. */
Option& Parameters::add(const std::string& name, double& value, const std::string& meaning,
                        const Allowed& range) {
  return keep({name, meaning, short_text(value), Option::Takes::number, in_range(range),
               [&value](const std::string& typed) { value = *typed_number(typed); }});
}

Option& Parameters::add(const std::string& name, std::size_t& value, const std::string& meaning,
                        const Allowed& range) {
  return keep({name, meaning, std::to_string(value), Option::Takes::number, whole_in_range(range),
               [&value](const std::string& typed) { value = std::size_t(*typed_number(typed)); }});
}

Option& Parameters::add(const std::string& name, std::optional<double>& value,
                        const std::string& meaning, const Allowed& range) {
  return keep({name, meaning, "none", Option::Takes::number, in_range(range),
               [&value](const std::string& typed) { value = *typed_number(typed); }});
}

Option& Parameters::add(const std::string& name, std::optional<std::size_t>& value,
                        const std::string& meaning, const Allowed& range) {
  return keep({name, meaning, "none", Option::Takes::number, whole_in_range(range),
               [&value](const std::string& typed) { value = std::size_t(*typed_number(typed)); }});
}

Option& Parameters::add(const std::string& name, std::string& value, const std::string& meaning,
                        const std::vector<std::string>& names) {
  return add(name, value, meaning, one_of(names));
}

Option& Parameters::add(const std::string& name, std::string& value, const std::string& meaning,
                        const Check& check) {
  return keep({name, meaning, value, Option::Takes::text, check,
               [&value](const std::string& typed) { value = typed; }});
}

Option& Parameters::add(const std::string& name, bool& value, const std::string& meaning) {
  return keep(
      {name, meaning, "", Option::Takes::flag, {}, [&value](const std::string&) { value = true; }});
}

/// Keeps an option, whose default may be given at the end of its meaning.
Option& Parameters::keep(Option parameter) {
  const std::string mark = " (default: ";
  std::string& meaning = parameter.meaning;
  if (const auto at = meaning.find(mark); at != std::string::npos && meaning.back() == ')') {
    parameter.standard = meaning.substr(at + mark.size(), meaning.size() - at - mark.size() - 1);
    meaning.resize(at);
  }
  return all_.emplace_back(std::move(parameter));
}

Option* Parameters::find(const std::string& name) {
  for (Option& p : all_)
    if (p.called(name)) return &p;
  return nullptr;
}

void Parameters::finish() const {
  for (const auto& then : then_) then();
}

std::string Parameters::names() const {
  std::vector<std::string> all;
  for (const Option& p : all_) all.push_back("--" + p.name);
  return comma_list(all);
}

}  // namespace lattice
