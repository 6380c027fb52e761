#pragma once
/**
# Choosing a model on the command line

Every program that computes with wells and contacts of the reader's choice offers the same
options: `--onsite` and `--contact` with the names that the potentials give themselves, and
one option for every parameter that any of them has. Nothing is listed here. A parameter that
the chosen potential does not have is refused rather than ignored. */

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/model/model.hpp"
#include "lattice/report/program.hpp"

namespace lattice {

/**
The two groups of options, for wells and for contacts, work alike: a name, and the
parameters of all that are in the list. What was given is kept until the line is complete. */
template <class Any>
class PotentialOptions {
 public:
  PotentialOptions(Command& app, const std::string& option, const std::string& meaning,
                   const Any& fallback)
      : option_(option),
        name_(std::visit([](const auto& p) { return std::string(p.name); }, fallback)),
        fallback_(fallback),
        choice_(app.add_option(option, name_, meaning)->check(one_of(names_of<Any>()))) {
    const auto all = parameters_of<Any>();
    values_.reserve(all.size());
    for (const ParameterInfo& p : all) {
      values_.push_back({p.name, value_in(fallback, p), nullptr});
      values_.back().option = app.add_option("--" + p.name, values_.back().value,
                                             p.meaning + " (" + comma_list(owners(p.name)) + ")")
                                  ->check(in_range(p.least, p.most));
    }
  }
  PotentialOptions(const PotentialOptions&) = delete;
  PotentialOptions& operator=(const PotentialOptions&) = delete;

  /**
  A name brings its own defaults: once a potential or a parameter is typed, the others are those of
  the potential, not those of the program, whose default may be another potential altogether. Only
  a line that says nothing keeps the program's choice as it is.

  The complaint names what the reader typed: the parameter that the potential lacks, or else the
  name of the potential. */

  /// The potential that was asked for; the default where nothing was. Throws UsageError.
  Any chosen() const {
    Settings given;
    for (const Value& v : values_)
      if (v.option->given()) given[v.name] = v.value;
    if (given.empty() && !choice_->given()) return fallback_;
    try {
      return named<Any>(name_, given);
    } catch (const std::invalid_argument& error) {
      const bool lacks = !given.empty();
      throw UsageError((lacks ? "--" + given.begin()->first : option_) + ": " + error.what());
    }
  }

 private:
  struct Value {
    std::string name;
    double value;
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
  static double value_in(const Any& any, const ParameterInfo& info) {
    double value = info.fallback;
    std::visit(
        [&](const auto& potential) {
          for_each_parameter(potential, [&](const auto& p) {
            if (info.name == p.name) value = potential.*p.value;
          });
        },
        any);
    return value;
  }

  std::string option_, name_;
  Any fallback_;
  std::vector<Value> values_;  ///< never grows after construction: the options point into it
  Option* choice_;
};

/**
A program has a model with its own values before the line is read, and the reader's model after
it. The options in between must live as long as the command, since the values are written into them; so the
command itself keeps them, in the call that it makes when the line is complete. */

/// Adds `--onsite`, `--contact` and their parameters to a command; `model` holds the defaults and,
/// once the command line is read, the choice. It must live as long as `app`.
inline void add_model_options(Command& app, Model& model) {
  struct Options {
    PotentialOptions<AnyOnsite> onsite;
    PotentialOptions<AnyContact> contact;
  };
  auto options = std::shared_ptr<Options>(
      new Options{{app, "--onsite", "well of every bead", model.onsite},
                  {app, "--contact", "contact of two beads", model.contact}});
  app.when_read([options, &model] {
    model.onsite = options->onsite.chosen();
    model.contact = options->contact.chosen();
  });
}

/**
What lies beyond the first and the last bead is a choice among few, and a name again. */

/// Adds `--ends`; as above, `model` holds the default and must live as long as `app`.
inline void add_ends_option(Command& app, Model& model) {
  const std::vector<std::string> names(std::begin(ends_names), std::end(ends_names));
  const auto choose = [&model, names](const std::string& name) {
    model.ends = Ends(std::find(names.begin(), names.end(), name) - names.begin());
  };
  app.add_option("--ends", choose, "ends of the chain")
      ->check(one_of(names))
      ->shows(ends_names[int(model.ends)]);
}

}  // namespace lattice
