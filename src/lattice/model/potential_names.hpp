#pragma once
/**
# Potentials by their names

The reader of a program picks potentials by name. From what each one says of itself (potential.hpp) the command line, its
help and its error messages follow. The lists of wells and of contacts are variants over types; to find a name we walk
through them. */

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lattice/model/potential.hpp"

namespace lattice {

/// A parameter without the type of its potential, as help and messages need it.
struct ParameterInfo {
  std::string name, meaning;
  double fallback, least, most;
};

/// Values of parameters by their names.
using Settings = std::map<std::string, double>;
/// Ranges that a program allows instead of those of the potentials, by the names of the parameters.
using Ranges = std::map<std::string, std::pair<double, double>>;

/// Calls `use` with every parameter of a potential; most have none.
template <class Potential, class Use>
void for_each_parameter(const Potential&, Use use) {
  if constexpr (requires { Potential::parameters(); })
    for (const Parameter<Potential>& p : Potential::parameters()) use(p);
}

/// Calls `use` with a default value of every type in the list `Any` that has a name of its own.
template <class Any, class Use>
void for_each_potential(Use use) {
  const auto one = [&]<class P>(const P*) {
    if constexpr (!std::is_base_of_v<OwnPotential, P>) use(P{});
  };
  [&]<class... Potential>(const std::variant<Potential...>*) {
    (one(static_cast<const Potential*>(nullptr)), ...);
  }(static_cast<const typename Any::List*>(nullptr));
}

/// The names in a list of potentials, each once.
template <class Any>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for_each_potential<Any>([&](const auto& p) {
    if (std::find(names.begin(), names.end(), p.name) == names.end()) names.push_back(p.name);
  });
  return names;
}

/// The parameters of the potentials called `name`, or of the whole list if the name is empty, each once and with the
/// widest range.
template <class Any>
std::vector<ParameterInfo> parameters_of(const std::string& name = "") {
  std::vector<ParameterInfo> all;
  for_each_potential<Any>([&](const auto& potential) {
    if (!name.empty() && name != potential.name) return;
    for_each_parameter(potential, [&](const auto& p) {
      const auto same = [&](const ParameterInfo& other) { return other.name == p.name; };
      const auto found = std::find_if(all.begin(), all.end(), same);
      if (found == all.end()) {
        all.push_back({p.name, p.meaning, potential.*p.value, p.least, p.most});
      } else {
        found->least = std::min(found->least, p.least);
        found->most = std::max(found->most, p.most);
      }
    });
  });
  return all;
}

/// The words in one line, with commas in between.
inline std::string comma_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Sets those of the given parameters that the potential has; whether it has them all. Throws std::invalid_argument
/// if a value is out of range, be it the potential's or one of `own`.
template <class Potential>
bool apply(Potential& potential, const Settings& given, const Ranges& own) {
  std::size_t used = 0;
  for_each_parameter(potential, [&](const Parameter<Potential>& p) {
    const auto found = given.find(p.name);
    if (found == given.end()) return;
    const auto range = own.find(p.name);
    const auto [least, most] = range == own.end() ? std::pair(p.least, p.most) : range->second;
    if (!(found->second >= least && found->second <= most)) {
      std::ostringstream text;
      text << p.name << " = " << found->second << " is not in the allowed range [" << least << ", "
           << most << "]";
      throw std::invalid_argument(text.str());
    }
    potential.*p.value = found->second;
    ++used;
  });
  return used == given.size();
}

/// Why no potential fits, in one line: the name is unknown, a parameter is not one of its own, or two exclude each other.
template <class Any>
std::string why_not_named(const std::string& name, const Settings& given) {
  const auto names = names_of<Any>();
  if (std::find(names.begin(), names.end(), name) == names.end())
    return "'" + name + "' is not one of " + comma_list(names);
  std::vector<std::string> has;
  for (const ParameterInfo& p : parameters_of<Any>(name)) has.push_back(p.name);
  for (const auto& [key, value] : given)
    if (std::find(has.begin(), has.end(), key) == has.end())
      return "'" + name + "' has no parameter " + key +
             (has.empty() ? "; it has none" : " (it has " + comma_list(has) + ")");
  return "'" + name + "' does not take these parameters together";
}

/// The first potential in the list that is called `name` and has all the given parameters: several types may share a
/// name, the plainest first. Throws std::invalid_argument if there is none, or if a value is out of range.
template <class Any>
Any named(const std::string& name, const Settings& given = {}, const Ranges& own = {}) {
  bool found = false;
  Any out;
  for_each_potential<Any>([&](auto potential) {
    if (found || name != potential.name) return;
    if (apply(potential, given, own)) out = potential, found = true;
  });
  if (!found) throw std::invalid_argument(why_not_named<Any>(name, given));
  return out;
}

/// Name and parameters in one line, such as `quartic, s = -0.5`.
template <class Any>
std::string describe(const Any& any) {
  std::ostringstream text;
  text.precision(17);
  const auto write = [&](const auto& potential) {
    text << potential.name;
    for_each_parameter(
        potential, [&](const auto& p) { text << ", " << p.name << " = " << potential.*p.value; });
  };
  std::visit(write, any.kind);
  return text.str();
}

}  // namespace lattice
