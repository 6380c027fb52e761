#pragma once
/**
# Potentials and their names

A chain needs two kinds of energy: the well $W(y)$ that holds each bead (well.hpp) and the
contact $V(r)$ that couples neighbours (contact.hpp), with $r = y_{n+1} - y_n$. Both are small
value types with the same three members, so that a chain is composed at compile
time and its inner loop vectorises:

| member | meaning | well | contact |
|---|---|---|---|
| `energy(x)` | potential energy | $W(y)$ | $V(r)$ |
| `force(x)` | minus its derivative | $-W'(y)$ | $-V'(r) \ge 0$ where beads repel |
| `stiffness(x)` | second derivative | $W''(y)$ | $V''(r)$ |

Every member is a template on the scalar, so the same text serves `double`,
`long double` and 128-bit arithmetic. All quantities are dimensionless: the unit
of time is that of the linear well, the unit of length makes the contact
coefficient one. A bead at rest feels nothing: `force(0)` is exactly zero, and so is `energy(0)`.

A reader picks potentials by name. So each one that stands in the list of its file says what it
is called and which parameters it has, and the command line, its help and its errors follow. */

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace lattice {

/// A number that a potential has: its name, its meaning, the allowed range, and where it is kept.
/// The default is its value in a potential that nobody has touched.
template <class Potential>
struct Parameter {
  const char* name;
  const char* meaning;
  double least, most;
  double Potential::*value;
};

/// The same without the type: what help and messages need.
struct ParameterInfo {
  std::string name, meaning;
  double fallback, least, most;
};

/// Numbers given by name.
using Settings = std::map<std::string, double>;

/// Calls `use` with every parameter of a potential; most have none.
template <class Potential, class Use>
void for_each_parameter(const Potential&, Use use) {
  if constexpr (requires { Potential::parameters(); })
    for (const Parameter<Potential>& p : Potential::parameters()) use(p);
}

/// Calls `use` with a default value of every type in a list of potentials.
template <class Any, class Use>
void for_each_potential(Use use) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (use(std::variant_alternative_t<i, Any>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Any>>{});
}

/// The names in a list, each once.
template <class Any>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for_each_potential<Any>([&](const auto& p) {
    if (std::find(names.begin(), names.end(), p.name) == names.end()) names.push_back(p.name);
  });
  return names;
}

/// The parameters of the potentials called `name`, or with an empty name those of the whole list;
/// each once, with the widest range.
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

inline std::string comma_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Sets the parameters of `potential` as far as they are given; whether it has all that are given.
/// Throws std::invalid_argument for a value out of its range.
template <class Potential>
bool apply(Potential& potential, const Settings& given) {
  std::size_t used = 0;
  for_each_parameter(potential, [&](const Parameter<Potential>& p) {
    const auto found = given.find(p.name);
    if (found == given.end()) return;
    if (!(found->second >= p.least && found->second <= p.most)) {
      std::ostringstream text;
      text << p.name << " = " << found->second << " is not in the allowed range [" << p.least
           << ", " << p.most << "]";
      throw std::invalid_argument(text.str());
    }
    potential.*p.value = found->second;
    ++used;
  });
  return used == given.size();
}

/// The potential called `name` with the given parameters: the first one in the list that has them all.
/// Throws std::invalid_argument, in one line, for an unknown name, a parameter that it lacks or a
/// value out of range.
template <class Any>
Any named(const std::string& name, const Settings& given = {}) {
  bool known = false, found = false;
  Any out;
  for_each_potential<Any>([&](auto potential) {
    if (found || name != potential.name) return;
    known = true;
    if (apply(potential, given)) out = potential, found = true;
  });
  if (found) return out;
  if (!known)
    throw std::invalid_argument("'" + name + "' is not one of " + comma_list(names_of<Any>()));
  std::vector<std::string> has;
  for (const ParameterInfo& p : parameters_of<Any>(name)) has.push_back(p.name);
  for (const auto& [key, value] : given)
    if (std::find(has.begin(), has.end(), key) == has.end())
      throw std::invalid_argument("'" + name + "' has no parameter " + key + " (it has " +
                                  (has.empty() ? "none" : comma_list(has)) + ")");
  throw std::invalid_argument("'" + name + "' does not have all these parameters at once");
}

/// Name and parameters in a line, such as `quartic, s = -0.5`.
template <class Any>
std::string describe(const Any& any) {
  std::ostringstream text;
  text.precision(17);
  const auto write = [&](const auto& potential) {
    text << potential.name;
    for_each_parameter(
        potential, [&](const auto& p) { text << ", " << p.name << " = " << potential.*p.value; });
  };
  std::visit(write, any);
  return text.str();
}

}  // namespace lattice
