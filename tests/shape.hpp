#pragma once
// The shape of the sources: lengths of prose and code, how equations are cited, and which room may
// include which. Each rule is a function from text to a list of complaints, so that a test can
// show it a text that is wrong.

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// No block of prose has more than 20 lines, no page of code is without a title (40 lines without a comment
/// of their own), and no function has more than 60 lines. Empty lines, the lines that only open or close a
/// block, rows of a table, and preprocessor lines are not counted.
inline std::vector<std::string> unreadable(const std::string& text) {
  constexpr int most_prose = 20, most_code = 40, most_function = 60;
  std::vector<std::string> out;
  std::istringstream in(text);
  int number = 0, started = 0, prose = 0, code = 0, function = -1;
  bool inside = false, seen = false;
  const auto complain = [&](const std::string& what, int count) {
    out.push_back("line " + std::to_string(started) + ": " + std::to_string(count) + what);
  };
  const auto end_code = [&] {
    if (code > most_code) complain(" lines of code without a title", code);
    if (seen && code == 0) complain(" lines of code between two blocks of prose", 0);
  };
  static const std::regex type(
      "(struct|class|enum|union|namespace|extern|using|static_assert)\\b.*");
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto from = line.find_first_not_of(" \t");
    if (from == std::string::npos) continue;
    std::string body = line.substr(from);
    if (!inside && body.rfind("/**", 0) == 0) {
      end_code();
      inside = seen = true;
      prose = code = 0;
      started = number;
      body.erase(0, 3);
    } else if (!inside && body.rfind("//", 0) == 0) {
      if (code > most_code) complain(" lines of code without a title", code);
      code = 0;
      seen = false;
    } else if (!inside && body.front() != '#') {
      // A function begins and ends at the margin
      if (from == 0 && body.back() == '{' && !std::regex_match(body, type)) function = 0;
      if (function >= 0 && ++function > most_function + 2 && from == 0 && body.front() == '}')
        out.push_back("line " + std::to_string(number) + ": a function of " +
                      std::to_string(function - 2) + " lines");
      if (from == 0 && body.front() == '}') function = -1;
      if (++code == 1) started = number;
    }
    if (!inside) continue;
    const auto close = body.find("*/");
    const std::string words = body.substr(0, close);
    const bool table = words.find_first_not_of(" \t") != std::string::npos &&
                       words[words.find_first_not_of(" \t")] == '|';
    prose += !table && std::any_of(words.begin(), words.end(),
                                   [](unsigned char c) { return !std::isspace(c); });
    if (close == std::string::npos) continue;
    if (prose > most_prose) complain(" lines of prose", prose);
    inside = false;
    started = number;
  }
  if (code > most_code) complain(" lines of code without a title", code);
  return out;
}

/// Citations of an equation by anything but a number that the article has.
inline std::vector<std::string> misquoted(const std::string& text) {
  constexpr int last = 39;
  static const std::regex label("\\bEqs?\\.\\s+[a-z]\\w*"), number("\\bEqs?\\.\\s+\\((\\d+)\\)");
  std::vector<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), label), end; it != end; ++it)
    out.push_back(it->str());
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    if (std::stoi((*it)[1]) < 1 || std::stoi((*it)[1]) > last) out.push_back(it->str());
  return out;
}

/// The rooms of the library and their floors: an arrow goes down or stays in its room, and rooms of
/// one floor do not know each other.
inline const std::map<std::string, int>& floors() {
  static const std::map<std::string, int> all{{"numbers", 0}, {"model", 1},   {"stepping", 2},
                                              {"landing", 2}, {"packets", 3}, {"dps", 4},
                                              {"orbits", 5}};
  return all;
}

/// The floor of a room, -1 for a room that is not planned.
inline int floor_of(const std::string& room) {
  const auto found = floors().find(room);
  return found == floors().end() ? -1 : found->second;
}

/// Headers by their path from `src`, each with what it includes, brackets or quotes kept.
using Includes = std::map<std::string, std::vector<std::string>>;

inline std::string room_of(const std::string& header) {
  const auto from = header.find('/');
  const auto to = header.find('/', from + 1);
  return to == std::string::npos ? "" : header.substr(from + 1, to - from - 1);
}

/// Includes that go up or sideways or leave the library. The room `report` is outside the library and
/// knows numbers and models only.
inline std::vector<std::string> forbidden_arrows(const Includes& includes) {
  std::vector<std::string> out;
  for (const auto& [header, targets] : includes) {
    const std::string room = room_of(header);
    const bool reports = header.rfind("report/", 0) == 0;
    if (!reports && floor_of(room) < 0) out.push_back(header + " is in no room");
    for (const auto& quoted : targets) {
      if (quoted.front() != '"') continue;
      const std::string target = quoted.substr(1, quoted.size() - 2), other = room_of(target);
      const bool known = includes.count(target) > 0;
      const bool down =
          reports ? target.rfind("report/", 0) == 0 || floor_of(other) <= floor_of("model")
                  : other == room || floor_of(other) < floor_of(room);
      const bool library = target.rfind("lattice/", 0) == 0 || reports;
      if (!known || !library || !down) out.push_back(header + " -> " + target);
    }
  }
  return out;
}

/// Includes by which a file on a section's shelf reaches for another section's shelf or for a chapter. Commands
/// may take from every shelf.
inline std::vector<std::string> foreign_shelves(const Includes& includes) {
  std::vector<std::string> out;
  for (const auto& [file, targets] : includes)
    for (const auto& quoted : targets) {
      const std::string target = quoted.substr(1, quoted.size() - 2);
      const std::string shelf = file.substr(0, file.find('/') + 1);
      const bool from_shelf = target.rfind("sec", 0) == 0 && target.find('/') != std::string::npos;
      const bool allowed = target.rfind("lattice/", 0) == 0 || target.rfind("report/", 0) == 0 ||
                           target.rfind(shelf, 0) == 0 || (shelf == "commands/" && from_shelf);
      if (quoted.front() == '"' && !allowed) out.push_back(file + " -> " + target);
    }
  return out;
}

/// Headers that include themselves through others.
inline std::vector<std::string> circles(const Includes& includes) {
  std::vector<std::string> out;
  for (const auto& [header, targets] : includes) {
    std::set<std::string> reached;
    std::vector<std::string> todo{header};
    while (!todo.empty()) {
      const auto here = includes.find(todo.back());
      todo.pop_back();
      if (here == includes.end()) continue;
      for (const auto& quoted : here->second) {
        const std::string target = quoted.substr(1, quoted.size() - 2);
        if (reached.insert(target).second) todo.push_back(target);
      }
    }
    if (reached.count(header)) out.push_back(header + " includes itself");
  }
  return out;
}

/// Types that two headers define under one name. The library is one namespace, so that whoever includes
/// both could not compile; most chapters include only one, and nobody notices. `texts` by header.
inline std::vector<std::string> defined_twice(const std::map<std::string, std::string>& texts) {
  static const std::regex type(
      "(?:(?:struct|class|enum class|enum) (\\w+)(?: [^<]*)?|using (\\w+) =.*)");
  std::map<std::string, std::string> home;
  std::vector<std::string> out;
  for (const auto& [header, text] : texts) {
    std::istringstream in(text);
    std::smatch found;
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_match(line, found, type)) continue;
      const std::string name = found[1].matched ? found[1] : found[2];
      const auto [at, fresh] = home.emplace(name, header);
      if (!fresh && at->second != header)
        out.push_back(name + " in " + at->second + " and " + header);
    }
  }
  return out;
}
