/**
# The words of a line

A line is read in two passes: first every word finds its place, then the values are checked and taken. */

#include "report/command_line.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <numeric>
#include <utility>

#include "lattice/model/potential.hpp"

namespace lattice {

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
static std::string allowed(const std::string& what) {
  return " (allowed: " + what + ")";
}

static std::string perhaps(const std::optional<std::string>& name, const std::string& before = "",
                           const std::string& behind = "") {
  return name ? "; did you mean " + before + *name + behind + "?" : "";
}

/**
## Every word in its place

CLI11 finds the places. It is told of no type and no range: an option has any number of values, none included,
and what belongs nowhere is handed back. So nothing is refused in words that are not ours, and no option takes
the next one for its value. */
namespace {

/// An option under one of its names: it may have an earlier one.
struct Name {
  Option* option;
  std::string text;
  CLI::Option* place;
};

/// What a line says to one offer: the full run, or a command.
struct Place {
  Offer* offer;
  CLI::App* app;
  CLI::Option* help;
  std::vector<Name> names{};

  Place(Offer& to, CLI::App& root)
      : offer(&to), app(to.name.empty() ? &root : root.add_subcommand(to.name)) {
    app->set_help_flag();
    help = app->add_flag("-h,--help");
    app->allow_extras();
    for (const Option& option : to.parameters.all()) {
      introduce(option.name);
      for (const std::string& old : option.old_names) introduce(old);
    }
  }
  void introduce(const std::string& name) {
    Option& option = *offer->parameters.find(name);
    CLI::Option* const place = option.takes == Option::Takes::flag
                                   ? app->add_flag("--" + name)
                                   : app->add_option("--" + name)->expected(0, 1);
    place->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    names.push_back({&option, name, place});
  }
};

struct Reader {
  std::deque<Offer>& offers;
  const std::vector<std::string>& words;
  CLI::App root{};
  CLI::Option* version = root.add_flag("--version");
  std::deque<Place> places{};
  Place* at = nullptr;

  Asked run();
  void refuse_stranger(const std::string& word) const;
  [[noreturn]] void unknown(const std::string& name) const;
  std::vector<const Name*> given() const;
  void complete(const Name& name) const;
  void take() const;
};

/// A negative number belongs to the option before it, as `--s=-1/6` would say.
std::vector<std::string> joined(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const std::string& word : words) {
    const bool follows =
        !out.empty() && out.back().rfind("--", 0) == 0 && out.back().find('=') == std::string::npos;
    if (follows && word.size() > 1 && word[0] == '-' && typed_number(word))
      out.back() += "=" + word;
    else
      out.push_back(word);
  }
  return out;
}

/// An option that is unknown here may belong elsewhere.
void Reader::unknown(const std::string& name) const {
  std::vector<std::string> names{"help"}, homes;
  for (const Option& p : at->offer->parameters.all()) names.push_back(p.name);
  for (Offer& offer : offers)
    if (&offer != at->offer && offer.parameters.find(name))
      homes.push_back(offer.name.empty() ? "a full run, without a command"
                                         : "'" + offer.name + "'");
  const std::string known = allowed(at->offer->parameters.names());
  if (!homes.empty()) throw UsageError("--" + name + ": belongs to " + homes.front() + known);
  throw UsageError("--" + name + ": there is no such option" + perhaps(nearest(name, names), "--") +
                   known);
}

/// A word that has no place is a misspelt option or command, or one too many.
void Reader::refuse_stranger(const std::string& word) const {
  const bool number = typed_number(word).has_value(), inside = !at->offer->name.empty();
  if (word.size() > 2 && word.rfind("--", 0) == 0) unknown(word.substr(2, word.find('=') - 2));
  const std::string options = allowed(at->offer->parameters.names());
  if (word.size() > 1 && word[0] == '-' && !number)
    throw UsageError("'" + word + "': an option has two dashes and a name" + options);
  std::vector<std::string> names;
  for (const Offer& offer : offers)
    if (!offer.name.empty()) names.push_back(offer.name);
  if (inside && std::find(names.begin(), names.end(), word) != names.end())
    throw UsageError("'" + word + "': there is a command already, '" + at->offer->name + "'" +
                     allowed("one command"));
  if (inside || names.empty())
    throw UsageError("'" + word + "': belongs to no option" +
                     (inside ? "" : ", and there are no commands") + options);
  throw UsageError("'" + word + "': there is no such command" +
                   perhaps(nearest(word, names), "'", "'") + allowed(comma_list(names)));
}

/// Where the option `--name` is in the words, with or without a value.
static bool says(const std::string& word, const std::string& name) {
  return word == "--" + name || word.rfind("--" + name + "=", 0) == 0;
}

[[noreturn]] static void twice(const Name& name, const std::string& first,
                               const std::string& second) {
  throw UsageError("--" + name.text + ": given twice, '" + first + "' and '" + second + "'" +
                   allowed("once"));
}

/// The options that are given, in the order of the line.
std::vector<const Name*> Reader::given() const {
  std::vector<const Name*> out;
  for (const std::string& word : words)
    for (const Name& name : at->names)
      if (name.place->count() > 0 && says(word, name.text) &&
          std::find(out.begin(), out.end(), &name) == out.end())
        out.push_back(&name);
  return out;
}

/// An option that is given has one value, and a flag none.
void Reader::complete(const Name& name) const {
  const std::string typed = "--" + name.text;
  const std::vector<std::string> values = name.place->results();
  const auto word = std::find_if(words.begin(), words.end(),
                                 [&](const std::string& w) { return says(w, name.text); });
  if (name.option->takes == Option::Takes::flag) {
    const auto equals = std::find_if(words.begin(), words.end(), [&](const std::string& w) {
      return w.rfind(typed + "=", 0) == 0;
    });
    if (equals != words.end())
      throw UsageError(typed + ": takes no value, but got '" + equals->substr(typed.size() + 1) +
                       "'" + allowed(typed + " alone"));
    return;
  }
  const auto next = word == words.end() ? word : word + 1;
  if (word != words.end() && *word == typed + "=")
    throw UsageError(typed + ": needs a value" + allowed(name.option->check.allowed));
  if (values.front().empty() && (next == words.end() || !next->empty()))
    throw UsageError(typed + ": needs a value" +
                     (next != words.end() ? ", and '" + *next + "' is an option" : "") +
                     allowed(name.option->check.allowed));
  if (values.size() > 1) twice(name, values[0], values[1]);
}

/**
## Values are checked, and then taken

Nothing has happened when a line is refused. A complaint names the option as it was typed, also where it has
another name today. */
void Reader::take() const {
  const std::vector<const Name*> named = given();
  for (const Name* name : named) {
    const bool flag = name->option->takes == Option::Takes::flag;
    const std::string value = flag ? "" : name->place->results().front();
    if (!flag && name->option->given()) twice(*name, *name->option->typed, value);
    name->option->typed = value;
  }
  for (const Name* name : named) {
    const Option& p = *name->option;
    const std::string wrong = p.check.complaint ? p.check.complaint(*p.typed) : "";
    if (!wrong.empty()) throw UsageError("--" + name->text + ": " + wrong);
    for (const std::string& rival : p.rivals)
      if (at->offer->parameters.find(rival)->given())
        throw UsageError("--" + name->text + ": '" + *p.typed + "' cannot be together with --" +
                         rival + allowed("one of the two"));
  }
  for (const Name* name : named) name->option->take(*name->option->typed);
  at->offer->parameters.finish();
}

/// `help` and `help COMMAND` are other words for `--help` and `COMMAND --help`.
std::vector<std::string> help_as_option(std::vector<std::string> words) {
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return words;
}

Asked Reader::run() {
  for (Offer& offer : offers) places.emplace_back(offer, root);
  root.require_subcommand(0, 1);
  std::vector<std::string> line = help_as_option(joined(words));
  std::reverse(line.begin(), line.end());  // as CLI11 wants them
  root.parse(std::move(line));

  // Who is spoken to, and are there strangers?
  at = &places.front();
  const Place& full = places.front();
  for (Place& place : places)
    if (&place != &full && place.app->parsed()) at = &place;
  if (at->help->count() > 0 || full.help->count() > 0) return {Asked::What::help, at->offer};
  if (version->count() > 0) return {Asked::What::version, at->offer};
  if (std::find(words.begin(), words.end(), "--") != words.end()) refuse_stranger("--");
  for (const Name* name : given()) complete(*name);
  for (const Place* place : {&full, static_cast<const Place*>(at)})
    for (const std::string& word : place->app->remaining()) refuse_stranger(word);
  for (const Name& name : full.names)
    if (at != &full && name.place->count() > 0)
      throw UsageError("--" + name.text + ": belongs to a full run, without '" + at->offer->name +
                       "'" + allowed(at->offer->parameters.names()));
  take();
  return {Asked::What::run, at->offer};
}

}  // namespace

Asked read_line(std::deque<Offer>& offers, const std::vector<std::string>& words) {
  return Reader{offers, words}.run();
}

/**
## Help

Each name has a line, with what is allowed, the meaning and the default; long lines are broken. */
static std::string entry(const std::string& name, const std::string& meaning) {
  constexpr std::size_t indent = 30, width = 100;
  std::string out = "  " + name + " ", line;
  out.resize(std::max(out.size() + 1, indent), ' ');
  std::size_t column = out.size();
  std::size_t from = 0;
  while (from < meaning.size()) {
    const auto to = std::min(meaning.find(' ', from), meaning.size());
    if (column + to - from > width && column > indent) {
      out.pop_back();  // the blank before the word
      out += "\n" + std::string(indent, ' ');
      column = indent;
    }
    out += meaning.substr(from, to - from) + (to < meaning.size() ? " " : "");
    column += to - from + 1;
    from = to + 1;
  }
  while (out.back() == ' ') out.pop_back();
  return out + "\n";
}

std::string help_text(const std::string& program, const std::deque<Offer>& offers, const Offer& of,
                      const std::string& after) {
  const bool whole = of.name.empty(), commands = whole && offers.size() > 1;
  std::string out = of.meaning + "\nUsage: " + program + (whole ? "" : " " + of.name) +
                    " [options]" + (commands ? "\n       " + program + " COMMAND [options]" : "") +
                    "\n\nOptions:\n" + entry("--help", "this text");
  if (whole) out += entry("--version", "version and build");
  bool numbers = false;
  for (const Option& p : of.parameters.all()) {
    const bool flag = p.takes == Option::Takes::flag;
    numbers = numbers || (p.takes == Option::Takes::number && p.name != "threads");
    out += entry("--" + p.name + (flag ? "" : " " + p.check.shown()),
                 p.meaning + (flag || p.standard.empty() ? "" : " (default: " + p.standard + ")"));
  }
  if (commands) out += "\nCommands, each with its own --help:\n";
  for (const Offer& offer : offers)
    if (commands && !offer.name.empty()) out += entry(offer.name, offer.meaning);
  if (numbers) out += "\nA number may be a fraction, such as -1/6.\n";
  return out + (after.empty() ? "" : (numbers ? "" : "\n") + after + "\n");
}

/**
## The line in a header */
std::string shell_quoted(const std::string& argument) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("-_=+./,:@%").find(char(c)) != std::string::npos;
  };
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), plain)) return argument;
  std::string out;
  bool strange = false;
  for (unsigned char c : argument) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", unsigned(c));
    strange = strange || c < 32 || c == 127;
    out += c < 32 || c == 127       ? code
           : c == '\'' || c == '\\' ? "\\" + std::string(1, char(c))
                                    : std::string(1, char(c));
  }
  if (strange || argument.find('\'') != std::string::npos) return "$'" + out + "'";
  return "'" + argument + "'";
}

std::string command_text(const std::string& program, int argc, const char* const* argv) {
  std::string out = program;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads") ++i;
    if (argument.rfind("--threads", 0) == 0) continue;
    out += " " + shell_quoted(argument);
  }
  return out;
}

}  // namespace lattice
