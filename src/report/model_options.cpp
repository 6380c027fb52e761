/**
# How potentials are chosen on the command line

Each list of potentials, `Well` and `Contact`, says which names and which parameters there are, so
nothing is listed here. */

#include "report/model_options.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lattice {

namespace {

/**
The two groups of options, for wells and for contacts, work alike: a name, and the
parameters of all that are in the list. What was given is kept until the line is complete. */
template <class Any>
class PotentialOptions {
 public:
  PotentialOptions(Parameters& p, const std::string& option, const std::string& meaning,
                   const Any& fallback, const Ranges& own)
      : option_(option), name_(name_of(fallback)), fallback_(fallback), own_(own) {
    p.add(option, name_, meaning, names_of<Any>());
    const auto all = parameters_of<Any>();
    values_.reserve(all.size());
    for (const ParameterInfo& info : all) {
      const auto range = own.find(info.name);
      const auto [least, most] =
          range == own.end() ? std::pair(info.least, info.most) : range->second;
      const std::optional<double> usual = value_in(fallback, info.name);
      values_.push_back({info.name, usual.value_or(info.fallback), usual, nullptr});
      values_.back().option =
          &p.add(info.name, values_.back().value,
                 info.meaning + " (" + comma_list(owners(info.name)) + ")", {least, most});
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
      throw UsageError("--" + (typed.empty() ? option_ : typed.begin()->first) + ": " +
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
};

}  // namespace

/**
The options must live as long as the parameters, since the values are written into them; so the parameters
themselves keep them, in the call that they make when the line is complete. */
void add_well(Parameters& p, Well& well, const Ranges& own) {
  const auto options =
      std::make_shared<PotentialOptions<Well>>(p, "well", "well of every bead", well, own);
  p.find("well")->formerly("onsite");
  p.when_read([options, &well] { well = simplest(options->chosen()); });
}

void add_contact(Parameters& p, Contact& contact, const Ranges& own) {
  const auto options = std::make_shared<PotentialOptions<Contact>>(
      p, "contact", "contact of two beads", contact, own);
  p.when_read([options, &contact] { contact = simplest(options->chosen()); });
}

/**
The same for a well that must hold its bead. */
void add_holding_well(Parameters& p, Well& well, const std::string& without) {
  add_well(p, well);
  p.when_read([&well, without] {
    const auto holds = [](const auto& w) { return w.stiffness(0.0) == 1; };
    std::vector<std::string> allowed;
    for_each_potential<Well>([&](const auto& w) {
      if (holds(w)) allowed.push_back(w.name);
    });
    const auto name = [](const auto& w) { return std::string(w.name); };
    if (!std::visit(holds, well))
      throw UsageError("--well: '" + std::visit(name, well) +
                       "' holds no bead, and without a well " + without +
                       " (allowed: " + comma_list(allowed) + ")");
  });
}

void add_ends(Parameters& p, Ends& ends) {
  std::vector<std::pair<std::string, Ends>> names;
  for (std::size_t k = 0; k < std::size(ends_names); ++k)
    names.emplace_back(ends_names[k], Ends(k));
  p.add("ends", ends, "ends of the chain", names);
}

}  // namespace lattice
