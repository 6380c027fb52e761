#pragma once
/**
# Parameters and their names

What a reader types is checked where it enters: a wrong value is answered by one line that names the
option, the value and what is allowed. Numbers are read in one way everywhere: in decimal (`031` is
31), whole ones also as `1e+06`, and all of them as fractions (`-1/6`). And what was not typed is said too:
help shows every default, and the header of a table records every parameter with the value that was used.

A command declares its parameters as a well does, each with a name, the variable that takes the value, a
meaning and what is allowed; what the variable holds before the line is read is the default.

    void parameters(Parameters& p) {
      p.add("velocity", velocity, "impact velocity", {1e-6, 100});
      p.add("sites", sites, "chain length (default: as long as needed)", {2, 1e6});
    } */

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "report/table.hpp"

namespace lattice {

/// The reader's input cannot be used: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
A check is told what was typed and answers with a complaint, or with nothing. */
struct Check {
  std::function<std::string(const std::string&)> complaint;  ///< empty if there is none
  std::string allowed;                                       ///< as complaints show it
  std::vector<std::string> names{};                          ///< if only some names are allowed

  /// As help shows it: names as {one|other}.
  std::string shown() const;
};

/// Numbers in [least, most], in the given unit. Where a reader may expect others, complaints end with the reason.
struct Allowed {
  double least, most;
  std::string unit = "", why = "";
};

/// A number of this range.
Check in_range(const Allowed& range);
/// A name that is not empty.
Check not_empty();
/// One of `names`.
Check one_of(const std::vector<std::string>& names);
/// A folder in which files can be made.
Check writable_folder();

/// The number that was typed, in decimal or as a fraction; nothing if it is none.
std::optional<double> typed_number(std::string_view text);

/**
An option is what help, complaints and headers know of a parameter. A default that is no plain value, such as
a length that follows from another parameter, is given at the end of the meaning, `(default: as long as needed)`, and
is shown and recorded like all the others. */
class Option {
 public:
  enum class Takes { flag, number, text };

  std::string name, meaning, standard;  ///< `standard` is the default as help shows it
  Takes takes = Takes::text;
  Check check{};
  std::function<void(const std::string&)> take{};  ///< hands a checked value to the variable
  std::vector<std::string> old_names{}, rivals{};  ///< see `formerly` and `excludes`
  std::optional<std::string> typed{};              ///< the value as it was typed; empty for a flag

  /// Whether it was typed.
  bool given() const { return typed.has_value(); }
  /// Whether `word` is its name or an earlier one.
  bool called(const std::string& word) const;

  /// What help and header show instead of the value of the variable.
  Option& shows(const std::string& value);
  /// An earlier name that is still accepted, and shown nowhere.
  Option& formerly(const std::string& old_name);
  /// Typing both is refused.
  Option& excludes(const Option& other);
  /// The value that was used, as a header records it.
  std::string used() const;
};

/**
The variables must live as long as the parameters that point to them. */
class Parameters {
 public:
  Parameters() = default;
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;

  /// A number, real or whole, with its range; the value of the variable is the default.
  Option& add(const std::string& name, double& value, const std::string& meaning,
              const Allowed& range);
  Option& add(const std::string& name, std::size_t& value, const std::string& meaning,
              const Allowed& range);
  /// The same where no number is an answer too: that is the default.
  Option& add(const std::string& name, std::optional<double>& value, const std::string& meaning,
              const Allowed& range);
  Option& add(const std::string& name, std::optional<std::size_t>& value,
              const std::string& meaning, const Allowed& range);
  /// One of some names, or a text that passes a check.
  Option& add(const std::string& name, std::string& value, const std::string& meaning,
              const std::vector<std::string>& names);
  Option& add(const std::string& name, std::string& value, const std::string& meaning,
              const Check& check);
  /// A flag: it takes no value and is off unless it is typed.
  Option& add(const std::string& name, bool& value, const std::string& meaning);

  /// One of some values that have names.
  template <class Value>
  requires std::is_enum_v<Value> Option& add(
      const std::string& name, Value& value, const std::string& meaning,
      const std::vector<std::pair<std::string, std::type_identity_t<Value>>>& choices) {
    std::vector<std::string> names;
    std::string standard;
    for (const auto& [word, choice] : choices) {
      names.push_back(word);
      if (choice == value) standard = word;
    }
    const auto take = [choices, &value](const std::string& typed) {
      for (const auto& [word, choice] : choices)
        if (word == typed) value = choice;
    };
    return keep({name, meaning, standard, Option::Takes::text, one_of(names), take});
  }

  /// Calls `then` when the whole line has been read.
  void when_read(std::function<void()> then) { then_.push_back(std::move(then)); }

  /**
  The reader of the line (command_line.hpp) looks a name up and tells when the line is complete. */
  /// The option of this name, present or earlier; null if there is none.
  Option* find(const std::string& name);
  /// Makes the calls of `when_read`. They may throw UsageError.
  void finish() const;
  /// The options in the order in which they were added.
  const std::deque<Option>& all() const { return all_; }
  /// The names with their dashes, separated by commas.
  std::string names() const;

 private:
  Option& keep(Option parameter);
  std::deque<Option> all_{};  ///< a chapter holds on to its parameters by address
  std::vector<std::function<void()>> then_{};
};

}  // namespace lattice
