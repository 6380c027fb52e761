#include "report/model_options.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace report {

namespace {

template <class Any>
std::string name_of(const Any& any) {
  return std::visit([](const auto& p) { return std::string(p.name); }, any.kind);
}

/// The value of the parameter `name` in a potential, if it has one.
template <class Any>
std::optional<double> value_in(const Any& any, const std::string& name) {
  std::optional<double> value;
  const auto look = [&](const auto& potential) {
    for_each_parameter(potential, [&](const auto& p) {
      if (name == p.name) value = potential.*p.value;
    });
  };
  std::visit(look, any.kind);
  return value;
}

/// The names of all potentials with a parameter `name`: it is one option, and its help names them all.
template <class Any>
std::vector<std::string> owners(const std::string& name) {
  std::vector<std::string> out;
  for (const std::string& potential : names_of<Any>())
    for (const ParameterInfo& p : parameters_of<Any>(potential))
      if (p.name == name) out.push_back(potential);
  return out;
}

/**
A name brings its own defaults, and only the program's own choice keeps the program's. What the chosen
potential does not have is *none* in the header of a table. The complaint names what the reader typed: the parameter that
the potential lacks, or else the name of the potential. */
template <class Any>
void add_potential(Parameters& p, const std::string& option, const std::string& meaning, Any& any,
                   const Ranges& own) {
  struct Choice {
    std::string name;
    Settings values{};  // of the parameters of all potentials
  };
  const auto choice = std::make_shared<Choice>(Choice{name_of(any)});
  p.add(option, choice->name, meaning, names_of<Any>());
  for (const ParameterInfo& info : parameters_of<Any>()) {
    const auto range = own.find(info.name);
    const auto [least, most] =
        range == own.end() ? std::pair(info.least, info.most) : range->second;
    double& value = choice->values[info.name];
    value = value_in(any, info.name).value_or(info.fallback);
    const auto has = owners<Any>(info.name);
    p.add(info.name, value, info.meaning + " (" + comma_list(has) + ")", {least, most})
        .only_with(option, has);
  }
  // Once the line is complete
  p.when_read([&p, &any, choice, option, own] {
    const bool ours = choice->name == name_of(any);
    Settings typed, given;
    for (const auto& [name, value] : choice->values) {
      Option& parameter = *p.find(name);
      const auto has = owners<Any>(name);
      if (!std::count(has.begin(), has.end(), choice->name)) parameter.standard = "none";
      if (parameter.given()) typed[name] = value;
      if (parameter.given() || (ours && value_in(any, name))) given[name] = value;
    }
    try {
      const bool changed = !ours || !typed.empty();
      any = simplest(changed ? named<Any>(choice->name, given, own) : any);
    } catch (const std::invalid_argument& error) {
      throw UsageError("--" + (typed.empty() ? option : typed.begin()->first) + ": " +
                       error.what());
    }
  });
}

}  // namespace

// What programs call
void add_well(Parameters& p, Well& well, const Ranges& own) {
  add_potential(p, "well", "on-site potential (well) of every bead", well, own);
}

void add_contact(Parameters& p, Contact& contact, const Ranges& own) {
  add_potential(p, "contact", "contact law between neighbouring beads", contact, own);
}

void add_holding_well(Parameters& p, Well& well, const std::string& without) {
  add_well(p, well);
  p.when_read([&well, without] {
    const auto holds = [](const auto& w) { return w.stiffness(0.0) == 1; };
    if (well.stiffness(0.0) == 1) return;
    std::vector<std::string> allowed;
    for_each_potential<Well>([&](const auto& w) {
      if (holds(w)) allowed.push_back(w.name);
    });
    throw UsageError("--well: '" + name_of(well) + "' does not hold a bead, and without a well " +
                     without + " (allowed: " + comma_list(allowed) + ")");
  });
}

void add_ends(Parameters& p, Ends& ends) {
  std::vector<std::pair<std::string, Ends>> names;
  for (std::size_t k = 0; k < std::size(ends_names); ++k)
    names.emplace_back(ends_names[k], Ends(k));
  p.add("ends", ends, "boundary conditions of the chain", names);
}

}  // namespace report
