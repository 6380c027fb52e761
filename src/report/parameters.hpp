#pragma once
/**
# Parameters and their names

What a reader types is checked where it enters: a wrong value is answered by one line that names the
option, the value and what is allowed. Numbers are read in one way everywhere: in decimal (`031` is
31), whole ones also as `1e+06`, and all of them as fractions (`-1/6`). Help shows every default, and the header of a
table records every parameter with the value that was used.

A command declares each parameter with a name, the variable that takes the value, a meaning and what is allowed,
`p.add("velocity", velocity, "impact velocity", {1e-6, 100})`; what the variable holds before the line is read is the
default. A default that is no plain value stands at the end of the meaning, `(default: as long as needed)`. */

#include <concepts>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "report/table.hpp"

namespace report {

/// The reader's input cannot be used: exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Numbers in [least, most], in the given unit. Where a reader may expect others, complaints end with the reason.
struct Allowed {
  double least, most;
  std::string unit = "", why = "";
};

/// A check is told what was typed and answers with a complaint, or with nothing.
struct Check {
  std::function<std::string(const std::string&)> complaint;
  std::string allowed;               ///< as complaints show it
  std::vector<std::string> names{};  ///< if only some names are allowed
  std::optional<Allowed> range{};    ///< if it is a number
  bool whole = false;                ///< whether only whole numbers are allowed

  /// As help shows it: names as {one|other}.
  std::string shown() const;
};

/// A name that is not empty.
Check not_empty();
/// One of `names`.
Check one_of(const std::vector<std::string>& names);
/// A folder in which files can be made.
Check writable_folder();

/// The number that was typed, in decimal or as a fraction; nothing if it is none.
std::optional<double> typed_number(std::string_view text);

/// Makes `folder` and tries to write `file` in it under a temporary name; the system's reason where that fails, and
/// nothing where it works. What exists and is no ordinary file (a device, a pipe) is taken as it is.
std::string why_not_writable(const std::filesystem::path& folder, const std::string& file);

/// What help, complaints and headers know of a parameter.
struct Option {
  std::string name, meaning, standard;  ///< `standard` is the default as help and header show it
  Check check{};                        ///< none of a flag
  std::function<void(const std::string&)> take{};  ///< hands a checked value to the variable
  std::vector<std::string> rivals{};               ///< see `excludes`
  std::string chosen_by{};                         ///< see `only_with`
  std::vector<std::string> choices{};              ///< the same
  std::optional<std::string> typed{};              ///< the value as it was typed; empty for a flag

  /// Whether it is off unless it is typed, and takes no value.
  bool is_flag() const { return !check.complaint; }
  /// Whether it was typed.
  bool given() const { return typed.has_value(); }
  /// The value that was used, as a header records it.
  std::string used() const;
  /// Typing both is refused.
  Option& excludes(const Option& other) {
    rivals.push_back(other.name);
    return *this;
  }
  /// It has a meaning for these names that the option `other` takes, and for no others.
  Option& only_with(const std::string& other, const std::vector<std::string>& names) {
    chosen_by = other, choices = names;
    return *this;
  }
};

/// The options of a program or a command. The variables must live as long as the parameters that point to them.
class Parameters {
 public:
  Parameters() = default;
  Parameters(const Parameters&) = delete;
  Parameters& operator=(const Parameters&) = delete;

  /// A number, real or whole, with its range.
  template <class Number>
  requires std::is_arithmetic_v<Number> Option& add(const std::string& name, Number& value,
                                                    const std::string& meaning,
                                                    const Allowed& range) {
    return add_number(name, meaning, short_text(double(value)), range, std::integral<Number>,
                      [&value](double x) { value = Number(x); });
  }
  /// The same where no number is an answer too: that is the default.
  template <class Number>
  Option& add(const std::string& name, std::optional<Number>& value, const std::string& meaning,
              const Allowed& range) {
    return add_number(name, meaning, "none", range, std::integral<Number>,
                      [&value](double x) { value = Number(x); });
  }
  /// A text that passes a check, or one of some names.
  Option& add(const std::string& name, std::string& value, const std::string& meaning,
              const Check& check);
  Option& add(const std::string& name, std::string& value, const std::string& meaning,
              const std::vector<std::string>& names) {
    return add(name, value, meaning, one_of(names));
  }
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
    return keep({name, meaning, standard, one_of(names), take});
  }

  /// Calls `then` when the whole line has been read; it may throw UsageError.
  void when_read(std::function<void()> then) { then_.push_back(std::move(then)); }
  /// Makes these calls.
  void finish() const {
    for (const auto& then : then_) then();
  }

  /// The option of this name; null if there is none.
  Option* find(const std::string& name);
  /// The options in the order in which they were added.
  const std::deque<Option>& all() const { return all_; }
  /// The names with their dashes, separated by commas.
  std::string names() const;

 private:
  Option& add_number(const std::string& name, const std::string& meaning,
                     const std::string& standard, const Allowed& range, bool whole,
                     std::function<void(double)> take);
  Option& keep(Option parameter);
  std::deque<Option> all_{};  ///< options are known by their addresses
  std::vector<std::function<void()>> then_{};
};

}  // namespace report
