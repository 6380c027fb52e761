/**
# How parameters are checked

A complaint has one form, whatever is wrong: the value as it was typed, what is wrong with it, and what is
allowed. */

#include "report/parameters.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include "lattice/model/potential_names.hpp"

namespace report {

std::optional<double> typed_number(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return parse_number(text);
  const auto above = parse_number(text.substr(0, slash));
  const auto below = parse_number(text.substr(slash + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

/// A number, or a `whole` one, of this range.
static Check in_range(const Allowed& range, bool whole) {
  const std::string allowed = "[" + short_text(range.least) + ", " + short_text(range.most) + "]" +
                              (range.unit.empty() ? "" : " " + range.unit);
  const auto complaint = [range, whole, allowed](const std::string& value) -> std::string {
    const std::string is_not = "'" + value + "' is not ", but = " (allowed: " + allowed + ")";
    const auto x = typed_number(value);
    if (!x) return is_not + "a number" + but;
    if (whole && !(*x == std::floor(*x) && std::abs(*x) < 1e15))
      return is_not + "a whole number" + but;
    if (*x >= range.least && *x <= range.most) return "";
    return is_not + "in the allowed range " + allowed + (range.why.empty() ? "" : ": " + range.why);
  };
  return {complaint, allowed, {}, range, whole};
}

Check not_empty() {
  const auto complaint = [](const std::string& value) {
    if (value.find_first_of("\n\r") != std::string::npos) return "the name has a line break";
    return value.empty() ? "the name is empty" : "";
  };
  return {complaint, "a name"};
}

Check one_of(const std::vector<std::string>& names) {
  const auto complaint = [names](const std::string& value) {
    const bool known = std::find(names.begin(), names.end(), value) != names.end();
    return known ? "" : "'" + value + "' is not one of the allowed names " + comma_list(names);
  };
  return {complaint, comma_list(names), names};
}

// Names are shown as {one|other}
std::string Check::shown() const {
  if (allowed.rfind("a ", 0) == 0) return "<" + allowed.substr(2) + ">";
  if (names.empty()) return allowed;
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "{" : "|") + name;
  return out + "}";
}

Check writable_folder() {
  const auto complaint = [](const std::string& value) {
    if (value.empty()) return not_empty().complaint(value);
    const std::string reason = why_not_writable(value, ".lattice");
    return reason.empty()
               ? ""
               : "cannot write to '" + value + "': " + reason + " (allowed: a writable folder)";
  };
  return {complaint, "a folder"};
}

// A place is tried before anything is computed
std::string why_not_writable(const std::filesystem::path& folder, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  const fs::path path = folder / file, part = path.string() + ".part";
  if (!error && fs::exists(path, error) && !fs::is_regular_file(path, ignored)) return "";
  if (!error) {
    const bool known = fs::exists(part, ignored);
    errno = 0;
    if (!std::ofstream(part, std::ios::app)) error.assign(errno, std::generic_category());
    if (!known) fs::remove(part, ignored);
  }
  return error ? error.message() : "";
}

std::string Option::used() const {
  if (is_flag()) return given() ? "yes" : "no";
  if (!given()) return standard;
  return check.range ? short_text(*typed_number(*typed)) : *typed;
}

// Each kind of variable has its own way to take what was typed, which is good when it arrives there
Option& Parameters::add_number(const std::string& name, const std::string& meaning,
                               const std::string& standard, const Allowed& range, bool whole,
                               std::function<void(double)> take) {
  return keep({name, meaning, standard, in_range(range, whole),
               [take](const std::string& typed) { take(*typed_number(typed)); }});
}

Option& Parameters::add(const std::string& name, std::string& value, const std::string& meaning,
                        const Check& check) {
  return keep({name, meaning, value, check, [&value](const std::string& typed) { value = typed; }});
}

Option& Parameters::add(const std::string& name, bool& value, const std::string& meaning) {
  return keep({name, meaning, "", {}, [&value](const std::string&) { value = true; }});
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
    if (p.name == name) return &p;
  return nullptr;
}

std::string Parameters::names() const {
  std::vector<std::string> all;
  for (const Option& p : all_) all.push_back("--" + p.name);
  return comma_list(all);
}

}  // namespace report
