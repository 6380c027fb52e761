/**
# The words of a line

A line is read in two passes: first every word finds its place, then the values are checked and taken. So
nothing has happened when a line is refused. */

#include "report/command_line.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <numeric>

#include "lattice/model/potential.hpp"

namespace lattice {

/**
A misspelt name is answered with the nearest one. The distance of two words is the least number of letters
that must be inserted, removed or exchanged to make one out of the other (Levenshtein). */
static std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t before = row[0];  // of the shorter words, without both last letters
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = before + (a[i - 1] != b[j - 1]);
      before = row[j];
      row[j] = std::min({exchanged, row[j] + 1, row[j - 1] + 1});
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

/// Whether a word that follows an option cannot be meant as its value.
static bool looks_like_option(const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return false;
  const bool digits = std::isdigit(static_cast<unsigned char>(word[1])) != 0 || word[1] == '.';
  return !digits && !typed_number(word);
}

/**
## First pass: every word in its place */
namespace {

struct Reader {
  std::deque<Offer>& offers;
  const std::vector<std::string>& words;
  Offer* of = &offers.front();
  std::vector<std::pair<Option*, std::string>> values{};

  Asked run();
  void choose(const std::string& word);
  std::size_t option(std::size_t at);
  [[noreturn]] void unknown(const std::string& name) const;
  [[noreturn]] void no_value(const Option& p, const std::string& typed,
                             const std::string* next) const;
  void take() const;
};

/// A word without dashes is the name of a command, and comes first.
void Reader::choose(const std::string& word) {
  std::vector<std::string> names;
  for (Offer& offer : offers)
    if (!offer.name.empty()) names.push_back(offer.name);
  const bool inside = !of->name.empty();
  const bool command = std::find(names.begin(), names.end(), word) != names.end();
  if (inside && command)
    throw UsageError("'" + word + "': there is a command already, '" + of->name + "'" +
                     allowed("one command"));
  if (inside || names.empty())
    throw UsageError("'" + word + "': belongs to no option" +
                     (inside ? "" : ", and there are no commands") +
                     allowed(of->parameters.names()));
  if (!command)
    throw UsageError("'" + word + "': there is no such command" +
                     perhaps(nearest(word, names), "'", "'") + allowed(comma_list(names)));
  for (Offer& offer : offers)
    if (offer.name == word) of = &offer;
}

/// An option that is unknown here may belong elsewhere.
void Reader::unknown(const std::string& name) const {
  std::vector<std::string> names{"help"}, homes;
  for (const Option& p : of->parameters.all()) names.push_back(p.name);
  for (Offer& offer : offers)
    if (&offer != of && offer.parameters.find(name))
      homes.push_back(offer.name.empty() ? "a full run, without a command"
                                         : "'" + offer.name + "'");
  const std::string known = allowed(of->parameters.names());
  if (!homes.empty()) throw UsageError("--" + name + ": belongs to " + homes.front() + known);
  throw UsageError("--" + name + ": there is no such option" + perhaps(nearest(name, names), "--") +
                   known);
}

void Reader::no_value(const Option& p, const std::string& typed, const std::string* next) const {
  throw UsageError("--" + typed + ": needs a value" +
                   (next ? ", and '" + *next + "' is an option" : "") + allowed(p.check.allowed));
}

/// Places the option at a position, and returns the position after it and its value.
std::size_t Reader::option(std::size_t at) {
  const std::string& word = words[at];
  const auto equals = word.find('=');
  const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
  Option* const p = of->parameters.find(name);
  if (!p) unknown(name);
  std::string value;
  if (equals != std::string::npos) {
    value = word.substr(equals + 1);
    if (p->takes == Option::Takes::flag)
      throw UsageError("--" + name + ": takes no value, but got '" + value + "'" +
                       allowed("--" + name + " alone"));
    if (value.empty()) no_value(*p, name, nullptr);
  } else if (p->takes != Option::Takes::flag) {
    if (++at == words.size()) no_value(*p, name, nullptr);
    if (looks_like_option(words[at])) no_value(*p, name, &words[at]);
    value = words[at];
  }
  if (p->given() && p->takes != Option::Takes::flag)
    throw UsageError("--" + name + ": given twice, '" + *p->typed + "' and '" + value + "'" +
                     allowed("once"));
  p->typed = value;
  values.emplace_back(p, name);
  return at + 1;
}

/**
## Second pass: values are checked, and then taken

A complaint names the option as it was typed, also where it has another name today. */
void Reader::take() const {
  for (const auto& [p, name] : values) {
    const std::string wrong = p->check.complaint ? p->check.complaint(*p->typed) : "";
    if (!wrong.empty()) throw UsageError("--" + name + ": " + wrong);
    for (const std::string& rival : p->rivals)
      if (of->parameters.find(rival)->given())
        throw UsageError("--" + name + ": '" + *p->typed + "' cannot be together with --" + rival +
                         allowed("one of the two"));
  }
  for (const auto& [p, name] : values) p->take(*p->typed);
  of->parameters.finish();
}

Asked Reader::run() {
  for (std::size_t at = 0; at < words.size();) {
    const std::string& word = words[at];
    if (word == "--help" || word == "-h") return {Asked::What::help, of};
    if (word == "--version" && of->name.empty()) return {Asked::What::version, of};
    if (word.rfind("--", 0) == 0 && word.size() > 2)
      at = option(at);
    else if (looks_like_option(word))
      throw UsageError("'" + word + "': an option has two dashes and a name" +
                       allowed(of->parameters.names()));
    else
      choose(words[at++]);
  }
  take();
  return {Asked::What::run, of};
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
  for (const Option& p : of.parameters.all()) {
    const bool flag = p.takes == Option::Takes::flag;
    out += entry("--" + p.name + (flag ? "" : " " + p.check.allowed),
                 p.meaning + (flag || p.standard.empty() ? "" : " (default: " + p.standard + ")"));
  }
  if (commands) out += "\nCommands, each with its own --help:\n";
  for (const Offer& offer : offers)
    if (commands && !offer.name.empty()) out += entry(offer.name, offer.meaning);
  return out + (after.empty() ? "" : "\n" + after + "\n");
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
