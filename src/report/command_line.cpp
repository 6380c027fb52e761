/**
# The words of a line

A line is read in two passes: first every word finds its place, then the values are checked and taken. */

#include "report/command_line.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "lattice/model/potential_names.hpp"

namespace report {

/**
A misspelt name is answered with the nearest one. The distance of two words is the least number of letters
that must be inserted, removed or replaced to make one out of the other (Levenshtein), where two neighbours that
have changed places count once (Damerau). */
static std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1), above, highest;  // of words shorter by one and by two
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    highest = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j - 1] + (a[i - 1] != b[j - 1]), above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], highest[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& names) {
  std::optional<std::string> best;
  std::size_t least = std::min(word.size(), 1 + std::max<std::size_t>(1, word.size() / 3));
  for (const std::string& name : names) {
    const bool begun = word.size() > 1 && name.rfind(word, 0) == 0;
    if (const std::size_t d = begun ? 1 : distance(word, name); d < least) best = name, least = d;
  }
  return best;
}

/**
Every complaint ends with what is allowed. */
[[noreturn]] static void refuse(const std::string& what, const std::string& why,
                                const std::string& allowed) {
  throw UsageError(what + ": " + why + " (allowed: " + allowed + ")");
}

static std::string perhaps(const std::optional<std::string>& name, const std::string& mark) {
  return name ? "; did you mean " + mark + *name + (mark == "'" ? mark : "") + "?" : "";
}

/// What can be asked instead of a run: of a command only for help.
struct Question {
  const char *word, *meaning;
  Asked::What what;
};
static std::vector<Question> questions(const Offer& of) {
  std::vector<Question> all{
      {"help", "this text", Asked::What::help},
      {"version", "version and build of the program", Asked::What::version},
      {"describe", "all commands and options as a table", Asked::What::describe}};
  if (!of.name.empty()) all.resize(1);
  return all;
}

/**
## Every word in its place

A word with two dashes is an option, and the next word its value unless that is an option itself: a negative number
is none. Any other word is the command, or one too many. A line is read from the left to the right, so that a
complaint is about the first word that is wrong. */
namespace {

/// Whether a word is an option, or was meant to be one.
bool like_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !typed_number(word);
}

struct Reader {
  std::deque<Offer>& offers;
  const std::vector<std::string>& words;
  Offer* at = &offers.front();
  std::vector<Option*> given{};  ///< in the order of the line

  /// The command of this name; null if there is none.
  Offer* command(const std::string& word) const {
    for (Offer& offer : offers)
      if (!offer.name.empty() && offer.name == word) return &offer;
    return nullptr;
  }

  /// The option of this name. One that is unknown here may belong elsewhere.
  Option& option(const std::string& name) const {
    if (Option* const found = at->parameters.find(name)) return *found;
    const std::string known = at->parameters.names();
    for (Offer& offer : offers)
      if (offer.parameters.find(name))
        refuse("--" + name,
               offer.name.empty() ? "belongs to a full run, without a command"
                                  : "belongs to '" + offer.name + "'",
               known);
    std::vector<std::string> names;
    for (const auto& [word, meaning, what] : questions(*at)) names.push_back(word);
    for (const Option& p : at->parameters.all()) names.push_back(p.name);
    refuse("--" + name, "unknown option" + perhaps(nearest(name, names), "--"), known);
  }

  /// Takes the option at word `k`, and goes on to its value.
  void place_option(std::size_t& k) {
    const auto equals = words[k].find('=');
    const bool joined = equals != std::string::npos;
    const std::string typed = words[k].substr(0, equals);
    Option& found = option(typed.substr(2));
    std::string value = joined ? words[k].substr(equals + 1) : "";
    if (found.is_flag()) {
      if (joined) refuse(typed, "takes no value, but got '" + value + "'", typed + " alone");
    } else {
      const bool next = !joined && k + 1 < words.size();
      if (next && like_option(words[k + 1]))
        refuse(typed, "needs a value, but '" + words[k + 1] + "' is an option",
               found.check.allowed);
      if (!next && value.empty()) refuse(typed, "needs a value", found.check.allowed);
      if (next) value = words[++k];
      if (found.given())
        refuse(typed, "given twice, '" + *found.typed + "' and '" + value + "'", "once");
    }
    found.typed = value;
    given.push_back(&found);
  }

  /// A word that is no option is the command, or one too many.
  void place_command(const std::string& word) {
    const std::string quoted = "'" + word + "'", inside = at->name;
    Offer* const found = command(word);
    if (found && inside.empty()) {
      at = found;
      if (!given.empty())
        refuse("--" + given.front()->name, "belongs to a full run, without " + quoted,
               at->parameters.names());
      return;
    }
    if (found) refuse(quoted, "the command is already '" + inside + "'", "one command");
    std::vector<std::string> names;
    for (const Offer& offer : offers)
      if (!offer.name.empty()) names.push_back(offer.name);
    if (inside.empty() && !names.empty())
      refuse(quoted, "unknown command" + perhaps(nearest(word, names), "'"), comma_list(names));
    refuse(quoted,
           names.empty() ? "belongs to no option, and this program has no commands"
                         : "belongs to no option",
           at->parameters.names());
  }

  void take() const {
    for (const Option* option : given) {
      const std::string &value = *option->typed, typed = "--" + option->name;
      const std::string wrong = option->check.complaint ? option->check.complaint(value) : "";
      if (!wrong.empty()) throw UsageError(typed + ": " + wrong);
      for (const std::string& rival : option->rivals)
        if (at->parameters.find(rival)->given())
          refuse(typed, "'" + value + "' cannot be combined with --" + rival, "one of the two");
      option->take(value);
    }
    at->parameters.finish();
  }
};

}  // namespace

Asked read_line(std::deque<Offer>& offers, const std::vector<std::string>& words) {
  Reader reader{offers, words};
  // `help` and `help COMMAND` are other words for `--help` and `COMMAND --help`
  const auto asks = [](const auto& word) { return word == "--help" || word == "-h"; };
  if ((!words.empty() && words.front() == "help") ||
      std::any_of(words.begin(), words.end(), asks)) {
    for (const std::string& word : words)
      if (Offer* const named = reader.command(word)) return {Asked::What::help, named};
    return {Asked::What::help, reader.at};
  }
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    for (const auto& [asked, meaning, what] : questions(*reader.at))
      if (word == std::string("--") + asked) return {what, reader.at};
    if (word.size() > 2 && word.rfind("--", 0) == 0)
      reader.place_option(k);
    else if (like_option(word))
      refuse("'" + word + "'", "an option is two dashes and a name", reader.at->parameters.names());
    else
      reader.place_command(word);
  }
  reader.take();
  return {Asked::What::run, reader.at};
}

/**
## Help

Each name has a line, with what is allowed, the meaning and the default; long lines are broken. */
static std::string entry(const std::string& name, const std::string& meaning) {
  constexpr std::size_t indent = 30, width = 100;
  std::string out, line = "  " + name + " ";
  line.resize(std::max(line.size() + 1, indent), ' ');
  const auto end_line = [&] { out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n"; };
  std::istringstream words(meaning);
  for (std::string word; words >> word; line += word + " ")
    if (line.size() + word.size() > width) end_line(), line.assign(indent, ' ');
  end_line();
  return out;
}

std::string help_text(const std::string& program, const std::deque<Offer>& offers,
                      const Offer& of) {
  const bool whole = of.name.empty(), commands = whole && offers.size() > 1;
  std::string out = of.meaning + "\nUsage: " + program + (whole ? "" : " " + of.name) +
                    " [options]" + (commands ? "\n       " + program + " COMMAND [options]" : "") +
                    "\n\nOptions:\n";
  for (const auto& [word, meaning, what] : questions(of))
    out += entry(std::string("--") + word, meaning);
  bool numbers = false;
  for (const Option& p : of.parameters.all()) {
    numbers = numbers || (p.check.range && p.name != "threads");
    out += entry("--" + p.name + (p.is_flag() ? "" : " " + p.check.shown()),
                 p.meaning + (p.standard.empty() ? "" : " (default: " + p.standard + ")"));
  }
  if (commands) out += "\nCommands, each with its own --help:\n";
  for (const Offer& offer : offers)
    if (commands && !offer.name.empty()) out += entry(offer.name, offer.meaning);
  if (numbers) out += "\nA number may be a fraction, such as -1/6.\n";
  return out + (of.note.empty() ? "" : (numbers ? "" : "\n") + of.note + "\n");
}

/**
The same as a table. */
static std::string kind_of(const Option& p) {
  if (p.is_flag()) return "flag";
  if (p.check.range) return p.check.whole ? "whole number" : "number";
  return p.check.names.empty() ? "text" : "name";
}

Table description(const std::string& program, const std::deque<Offer>& offers) {
  Table out;
  const auto add = [&](const Offer& offer, const Option& p, const std::string& takes) {
    const Allowed range = p.check.range.value_or(Allowed{std::nan(""), std::nan("")});
    out.add({{"command", "command; empty for the program without one", offer.name},
             {"option", "option, without its dashes; empty where the command is told", p.name},
             {"meaning", "what the option or the command means", p.meaning},
             {"takes", "what follows: flag (nothing), number, whole number, name, text", takes},
             {"lowest", "least number; nan where none is taken", range.least},
             {"highest", "largest number; nan where none is taken", range.most},
             {"unit", "unit of the number", range.unit},
             {"words", "the names of which one is taken; of a text what it is",
              p.check.range ? "" : p.check.allowed},
             {"default", "value without the option, or what takes its place", p.standard},
             {"chosen_by", "option that decides whether this one has a meaning", p.chosen_by},
             {"choices", "those of its names with which it has", comma_list(p.choices)}});
  };
  for (const Offer& offer : offers) {
    add(offer, {"", offer.meaning, ""}, "");
    for (const auto& [word, meaning, what] : questions(offer))
      add(offer, {word, meaning, ""}, "flag");
    for (const Option& p : offer.parameters.all()) add(offer, p, kind_of(p));
  }
  out.meta = {{"program", program}};
  return out;
}

/**
## The line in a header

An argument that a shell would not take as it is stands between quotes. */
static std::string shell_quoted(const std::string& argument) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("-_=+./,:@%").find(char(c)) != std::string::npos;
  };
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), plain)) return argument;
  std::string out = "'";
  for (const char c : argument) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string command_text(const std::string& program, int argc, const char* const* argv) {
  std::string out = program;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::string option = argument.substr(0, argument.find('='));
    if (option == "--threads" || option == "--out") {
      if (option == argument) ++i;
      continue;
    }
    out += " " + shell_quoted(argument);
  }
  return out;
}

}  // namespace report
