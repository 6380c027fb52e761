#pragma once
/**
# Numbers in prose

Nobody types a result. The prose of the sources and the tables of the README quote the locked values
of `paper/converged.ecsv`: `[](num:pn.omega11)` names the answer to a claim and
`[](num:sec32_dps_profiles.norm_site)` a fact of a program, and the text of the link is the value. This
file writes those texts, rounded to the digits that the error allows. The tests call the same functions
and ask that nothing changes, so that what stands in the editor is what was found.

The quoted values are the locked ones and not the fresh ones, because another compiler may
change a digit of a rounding residue; that fresh and locked values agree is asserted on its own. */

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lock.hpp"
#include "report/claims.hpp"

namespace lattice {

/// `x` with `digits` significant digits, trailing zeros kept, and an exponent without plus and zeros.
inline std::string with_digits(double x, int digits) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "%#.*g", digits, x);
  std::string mantissa = buffer, exponent;
  if (const auto e = mantissa.find('e'); e != std::string::npos) {
    exponent.append(1, 'e').append(std::to_string(std::stoi(mantissa.substr(e + 1))));
    mantissa.erase(e);
  }
  if (!mantissa.empty() && mantissa.back() == '.') mantissa.pop_back();
  return mantissa + exponent;
}

/// Without the zeros at the end of the decimals: for values that are exact.
inline std::string without_zeros(const std::string& text) {
  const auto e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos) return text;
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') mantissa.pop_back();
  return mantissa + (e == std::string::npos ? "" : text.substr(e));
}

/**
The last digit shown is that of the error's leading one, and there are six digits at most. Whole
numbers without an error are counts; other values without one are shown as they are, up to six digits. A
residue has a size and no digits. Yes and no are spelled out. */
inline std::string shown(const Finding& f) {
  if (f.unit == "claim") return f.value == 1 ? "holds" : "does not hold";
  if (!std::isfinite(f.value)) return std::isnan(f.value) ? "nan" : f.value > 0 ? "inf" : "-inf";
  if (f.value == 0) return "0";
  if (f.kind == "residue") return with_digits(f.value, 1);
  if (f.error == 0 && f.value == std::floor(f.value) && std::abs(f.value) < 1e9)
    return std::to_string(std::int64_t(f.value));
  if (f.error == 0) return without_zeros(with_digits(f.value, 6));
  const double ratio =
      std::floor(std::log10(std::abs(f.value))) - std::floor(std::log10(std::abs(f.error)));
  return with_digits(f.value, int(std::clamp(ratio + 1, 1.0, 6.0)));
}

/// The error with one digit; empty for yes or no, `exact` where there is none.
inline std::string shown_error(const Finding& f) {
  if (f.unit == "claim") return "";
  return f.error == 0 ? "exact" : with_digits(f.error, 1);
}

/**
Every text that prose may quote, by its id: claims by their own, facts with the program before them. */
inline std::map<std::string, std::string> quotable(const Findings& findings,
                                                   const std::vector<Claim>& claims) {
  std::set<std::string> ids;
  for (const Claim& c : claims) ids.insert(c.id);
  std::map<std::string, std::string> out;
  for (const auto& [key, f] : findings)
    out[ids.count(key.second) ? key.second : key.first + "." + key.second] = shown(f);
  return out;
}

/// `text` with the text of every link `[...](num:id)` renewed; throws std::runtime_error for an id
/// that is not there, so that a reference that dangles cannot be written.
inline std::string with_numbers(const std::string& text,
                                const std::map<std::string, std::string>& numbers) {
  const std::string mark = "](num:";
  std::string out;
  std::size_t done = 0;
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
    const auto open = text.rfind('[', at), close = text.find(')', at);
    if (open == std::string::npos || open < done || close == std::string::npos)
      throw std::runtime_error("a link without brackets: " + text.substr(at, 40));
    const std::string id = text.substr(at + mark.size(), close - at - mark.size());
    if (id == "...") continue;  // the form itself, where a comment explains it
    const auto found = numbers.find(id);
    if (found == numbers.end())
      throw std::runtime_error("nothing is locked under '" + id + "' (a new one: make lock)");
    out += text.substr(done, open + 1 - done) + found->second;
    done = at;
  }
  return out + text.substr(done);
}

/// `text` with what stands between the marks of the table `name` replaced by `lines`.
inline std::string with_table(const std::string& text, const std::string& name,
                              const std::vector<std::string>& lines) {
  const std::string open = "<!-- " + name + " -->\n", close = "<!-- /" + name + " -->";
  const auto from = text.find(open), to = text.find(close);
  if (from == std::string::npos || to == std::string::npos || to < from)
    throw std::runtime_error("no place for the table '" + name + "'");
  std::string body;
  for (const auto& line : lines) body += line + "\n";
  return text.substr(0, from + open.size()) + body + text.substr(to);
}

/**
## The tables of README.md and ARTIFACT.md

A claim's row shows the printed value, ours with its error, and the verdict. */
inline std::vector<std::string> published_rows(const std::vector<Claim>& claims,
                                               const Findings& lock) {
  std::vector<std::string> out{"| claim | article | here | error | verdict |",
                               "|---|---|---|---|---|"};
  for (const Claim& c : claims) {
    const auto found = lock.find({c.program, c.id});
    if (c.status == "open" || found == lock.end()) continue;
    const Finding& f = found->second;
    const bool worded = !f.unit.empty() && f.unit != "claim";
    out.push_back("| `" + c.id + "` | " + c.printed + (c.unit.empty() ? "" : " " + c.unit) + " | " +
                  shown(f) + (worded ? " " + f.unit : "") + " | " + shown_error(f) + " | " +
                  verdict(c, {f.value, f.error, f.unit}) + " |");
  }
  return out;
}

/// How a reader calls a figure: `fig07`, `x03`.
inline std::string figure_name(const std::string& id) {
  return (id.rfind("x", 0) == 0 ? "" : "fig") + id;
}

/// Seconds as a reader wants them.
inline std::string shown_cost(double seconds) {
  if (std::isnan(seconds)) return "?";
  return seconds < 1 ? "< 1" : std::to_string(int(std::lround(seconds)));
}

/**
A figure's row says which command makes it, which program computes it and for how long, and from which
tables it is drawn. */
inline std::vector<std::string> figure_rows(const Table& figures) {
  const auto id = figures.texts("id"), program = figures.texts("program"),
             tables = figures.texts("data"), caption = figures.texts("caption");
  const auto seconds = figures.numbers("seconds");
  std::vector<std::string> out{"| figure | command | program | seconds | tables | shows |",
                               "|---|---|---|---|---|---|"};
  for (std::size_t i = 0; i < id.size(); ++i) {
    std::string drawn;
    std::istringstream names(tables[i]);
    for (std::string name; names >> name;) drawn += (drawn.empty() ? "`" : ", `") + name + "`";
    out.push_back("| " + id[i] + " | `make " + figure_name(id[i]) + "` | [`" + program[i] +
                  "`](src/" + program[i] + ".cpp) | " + shown_cost(seconds[i]) + " | " + drawn +
                  " | " + caption[i] + " |");
  }
  return out;
}

/**
The gallery shows every figure small, four in a row; a picture leads to the chapter that makes it. */
inline std::vector<std::string> gallery_rows(const Table& figures) {
  const auto id = figures.texts("id"), program = figures.texts("program"),
             script = figures.texts("script"), caption = figures.texts("caption");
  std::vector<std::string> out{"| | | | |", "|---|---|---|---|"};
  for (std::size_t i = 0; i < id.size(); ++i) {
    const std::string name = script[i].substr(0, script[i].rfind('.'));
    if (i % 4 == 0) out.emplace_back("|");
    out.back() += " [<img src=\"figures/gallery/" + name + ".png\" width=\"200\" alt=\"" +
                  caption[i] + "\">](src/" + program[i] + ".cpp)<br>" + id[i] + " |";
  }
  return out;
}

/**
Where the article and we differ, the list of claims says why. */
inline std::vector<std::string> discrepancy_rows(const std::vector<Claim>& claims,
                                                 const Findings& lock) {
  std::vector<std::string> out{"| claim | article | here | why |", "|---|---|---|---|"};
  for (const Claim& c : claims) {
    const auto found = lock.find({c.program, c.id});
    if (c.status != "discrepant" || found == lock.end()) continue;
    out.push_back("| `" + c.id + "` | " + c.printed + " | " + shown(found->second) + " | " +
                  c.reason + " |");
  }
  return out;
}

/// Programs in the order of their names, each once, and their sum.
inline std::vector<std::string> cost_rows(const Table& figures) {
  const auto program = figures.texts("program");
  const auto seconds = figures.numbers("seconds");
  std::map<std::string, double> costs;
  for (std::size_t i = 0; i < program.size(); ++i) costs[program[i]] = seconds[i];
  std::vector<std::string> out{"| program | seconds |", "|---|---|"};
  double total = 0;
  for (const auto& [name, cost] : costs) {
    out.push_back("| `" + name + "` | " + shown_cost(cost) + " |");
    if (!std::isnan(cost)) total += cost;
  }
  out.push_back("| together | " + shown_cost(total) + " |");
  return out;
}

/**
## The index of figures

`figures/figures.ecsv` is written by hand but for its last column, the seconds that the program takes. A row
without it (a figure that is new) gets one. A measured time is renewed when it has moved by
more than a fifth and by more than half a second: who refreshes the page should not see noise. */
inline std::string with_costs(const std::string& text, const std::map<std::string, double>& costs) {
  std::istringstream in(text);
  std::string line, out;
  std::size_t columns = 0, at = 0;
  for (bool named = false; std::getline(in, line); out += line + "\n") {
    if (line.empty() || line.front() == '#') continue;
    const auto cells = ecsv::fields(line);
    if (!named) {
      named = true;
      at = std::size_t(std::find(cells.begin(), cells.end(), "program") - cells.begin());
      columns = cells.size();
      if (cells.back() != "seconds") throw std::runtime_error("the last column is not 'seconds'");
      continue;
    }
    if (cells.size() + 1 < columns || cells.size() > columns)
      throw std::runtime_error("a row with a wrong number of cells: " + line);
    if (cells.size() + 1 == columns) line += ",nan";
    const auto found = costs.find(cells.at(at));
    if (found == costs.end()) continue;
    const auto comma = line.rfind(',');
    const double was = std::strtod(line.c_str() + comma + 1, nullptr), now = found->second;
    if (std::abs(now - was) < std::max(0.5, 0.2 * now)) continue;
    line.erase(comma + 1);
    line += without_zeros(with_digits(now, 2));
  }
  return out;
}

/**
Who runs the two commands wants to know what they end with. The words are those of the summary, the
counts are those of the locked values. */
inline std::vector<std::string> summary_rows(const std::vector<Claim>& claims,
                                             const Table& figures) {
  std::map<std::string, int> tally;
  for (const Claim& c : claims) ++tally[c.status];
  const auto count = [&](const char* status, const char* word) {
    return std::to_string(tally[status]) + " " + word;
  };
  return {
      "```",
      "figures    : " + std::to_string(figures.rows.size()) + " in build/figures (svg, pdf, png)",
      "claims     : " + count("reproduced", "reproduced, ") + count("holds", "hold, ") +
          count("measured", "measured, ") + count("discrepant", "discrepant, ") + "0 unresolved, " +
          count("open", "open"),
      "```"};
}

/// Every table that a page may show, by the name in its marks.
inline std::map<std::string, std::vector<std::string>> generated_tables(
    const std::vector<Claim>& claims, const Findings& lock, const Table& figures) {
  return {{"gallery", gallery_rows(figures)},
          {"summary", summary_rows(claims, figures)},
          {"discrepant", discrepancy_rows(claims, lock)},
          {"published", published_rows(claims, lock)},
          {"figures", figure_rows(figures)},
          {"costs", cost_rows(figures)}};
}

/// README.md or ARTIFACT.md as it has to look: those tables renewed for which it has marks.
inline std::string fresh_page(std::string text,
                              const std::map<std::string, std::vector<std::string>>& tables) {
  for (const auto& [name, lines] : tables)
    if (text.find("<!-- " + name + " -->") != std::string::npos)
      text = with_table(text, name, lines);
  return text;
}

}  // namespace lattice
