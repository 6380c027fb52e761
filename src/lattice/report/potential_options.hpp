#pragma once
/**
# How potentials are chosen on the command line

The options of model_options.hpp at work. Each list of potentials, `Well` and `Contact`, says which
names and which parameters there are, so nothing is listed here. A program that defines LATTICE_ONCE_COMPILED
does not include this file, which like frame.hpp is then compiled once for all. */

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/report/model_options.hpp"

namespace lattice {

/**
The two groups of options, for wells and for contacts, work alike: a name, and the
parameters of all that are in the list. What was given is kept until the line is complete. */
template <class Any>
class PotentialOptions {
 public:
  PotentialOptions(Command& app, const std::string& option, const std::string& meaning,
                   const Any& fallback, const Ranges& own = {})
      : option_(option),
        name_(name_of(fallback)),
        fallback_(fallback),
        own_(own),
        choice_(app.add_option(option, name_, meaning)->check(one_of(names_of<Any>()))) {
    const auto all = parameters_of<Any>();
    values_.reserve(all.size());
    for (const ParameterInfo& p : all) {
      const auto range = own.find(p.name);
      const auto [least, most] = range == own.end() ? std::pair(p.least, p.most) : range->second;
      const std::optional<double> usual = value_in(fallback, p.name);
      values_.push_back({p.name, usual.value_or(p.fallback), usual, nullptr});
      values_.back().option = app.add_option("--" + p.name, values_.back().value,
                                             p.meaning + " (" + comma_list(owners(p.name)) + ")")
                                  ->check(in_range(least, most));
    }
  }
  PotentialOptions(const PotentialOptions&) = delete;
  PotentialOptions& operator=(const PotentialOptions&) = delete;

  const std::string& name() const { return name_; }

  /**
  A name brings its own defaults, and only the program's own choice keeps the program's. What the chosen
  potential does not have is said in the header of a table, which would otherwise show a default that
  nobody used.

  The complaint names what the reader typed: the parameter that the potential lacks, or else the
  name of the potential. */

  /// The potential that was asked for; the default where nothing was. Throws UsageError.
  Any chosen() const {
    const bool ours = name_ == name_of(fallback_);
    Settings typed, given;
    for (const Value& v : values_) {
      const auto has = owners(v.name);
      if (std::find(has.begin(), has.end(), name_) == has.end()) v.option->shows("none");
      if (ours && v.usual) given[v.name] = *v.usual;
      if (v.option->given()) typed[v.name] = given[v.name] = v.value;
    }
    if (ours && typed.empty()) return fallback_;
    try {
      return named<Any>(name_, given, own_);
    } catch (const std::invalid_argument& error) {
      throw UsageError((typed.empty() ? option_ : "--" + typed.begin()->first) + ": " +
                       error.what());
    }
  }

 private:
  struct Value {
    std::string name;
    double value;
    std::optional<double> usual;  ///< of the program's own potential, if it has the parameter
    Option* option;
  };

  /**
  One parameter may belong to several potentials. It is one option then, and its help names all
  owners; the default shown is that of the program's potential where this has the parameter. */

  /// The names of all potentials with a parameter `name`.
  static std::vector<std::string> owners(const std::string& name) {
    std::vector<std::string> out;
    for (const std::string& potential : names_of<Any>())
      for (const ParameterInfo& p : parameters_of<Any>(potential))
        if (p.name == name) out.push_back(potential);
    return out;
  }

  /**
  The program's own potential is asked in the same way, by the name of a parameter, for the value that it has
  before the line is read. */
  static std::optional<double> value_in(const Any& any, const std::string& name) {
    std::optional<double> value;
    const auto look = [&](const auto& potential) {
      for_each_parameter(potential, [&](const auto& p) {
        if (name == p.name) value = potential.*p.value;
      });
    };
    std::visit(look, any);
    return value;
  }
  static std::string name_of(const Any& any) {
    return std::visit([](const auto& p) { return std::string(p.name); }, any);
  }

  std::string option_, name_;
  Any fallback_;
  Ranges own_;
  std::vector<Value> values_;  ///< never grows after construction: the options point into it
  Option* choice_;
};

/**
The options must live as long as the command, since the values are written into them; so the command itself
keeps them, in the call that it makes when the line is complete. */
LATTICE_ONCE void add_model_options(Command& app, Chain& model, const Ranges& own) {
  struct Options {
    PotentialOptions<Well> onsite;
    PotentialOptions<Contact> contact;
  };
  auto options = std::shared_ptr<Options>(
      new Options{{app, "--onsite", "well of every bead", model.well, own},
                  {app, "--contact", "contact of two beads", model.contact}});
  app.when_read([options, &model] {
    model.well = options->onsite.chosen();
    model.contact = simplest(options->contact.chosen());
  });
}

/**
The same for the well alone, which must hold its bead. */
LATTICE_ONCE void add_well_options(Command& app, Well& well, const std::string& without) {
  const auto options =
      std::make_shared<PotentialOptions<Well>>(app, "--onsite", "well of every bead", well);
  app.when_read([options, &well, without] {
    const auto holds = [](const auto& w) { return w.stiffness(0.0) == 1; };
    std::vector<std::string> allowed;
    for_each_potential<Well>([&](const auto& w) {
      if (holds(w)) allowed.push_back(w.name);
    });
    well = options->chosen();
    if (!std::visit(holds, well))
      throw UsageError("--onsite: '" + options->name() + "' holds no bead, and without a well " +
                       without + " (allowed: " + comma_list(allowed) + ")");
  });
}

/**
The names of the ends are those of boundary.hpp. */
LATTICE_ONCE void add_ends_option(Command& app, Chain& model) {
  const std::vector<std::string> names(std::begin(ends_names), std::end(ends_names));
  const auto choose = [&model, names](const std::string& name) {
    model.ends = Ends(std::find(names.begin(), names.end(), name) - names.begin());
  };
  app.add_option("--ends", choose, "ends of the chain")
      ->check(one_of(names))
      ->shows(ends_names[int(model.ends)]);
}

}  // namespace lattice
