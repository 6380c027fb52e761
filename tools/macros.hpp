#pragma once
/**
# Numbers in the paper

The paper in `paper/` types no result. It says `\num{pn.omega11}` and `\err{pn.omega11}` for a locked
value and its error, `\pub{pn.omega11}` for what the article prints, `\fig{07}` for a figure with the
first sentence of its caption, and `\tally{figures}` for what can be counted. This file writes the
definitions of all these and the table of claims, with the digits of refresh.hpp, and names every
reference that has nothing behind it.

A file that begins with `% chapter: <program>` is read only where that chapter exists. */

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "refresh.hpp"

namespace lattice {

namespace tex {

/// `1.62e-11` and `-3` as TeX sets them, `0.000162` as the former; words such as `holds` stay.
inline std::string value(const std::string& shown) {
  static const std::regex form("(-?)([0-9.]+)(?:e(-?[0-9]+))?"), small("0\\.(000+)([1-9])([0-9]*)");
  std::smatch m, digits;
  if (!std::regex_match(shown, m, form)) return shown;
  std::string mantissa = m.str(2), exponent = m.str(3);
  if (exponent.empty() && std::regex_match(mantissa, digits, small)) {
    exponent = std::to_string(-1 - int(digits.length(1)));
    mantissa = digits.str(2) + (digits.length(3) ? "." : "") + digits.str(3);
  }
  return "\\ensuremath{" + m.str(1) + mantissa +
         (exponent.empty() ? "" : "\\times10^{" + exponent + "}") + "}";
}

/// A name such as `omega` or `-E` in mathematics.
inline std::string name(const std::string& word) {
  static const std::set<std::string> greek{"pi",     "eps",  "omega", "tau",   "mu",   "phi",
                                           "lambda", "beta", "Phi",   "Gamma", "delta"};
  if (word.front() == '-') return "-" + name(word.substr(1));
  if (greek.count(word)) return word == "eps" ? "\\epsilon" : "\\" + word;
  return word.size() == 1 ? word : "\\mathrm{" + word + "}";
}

/// `(n+1)` without its parentheses.
inline std::string bare(const std::string& group) {
  return group.front() == '(' ? group.substr(1, group.size() - 2) : group;
}

inline std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += std::string_view("%&#_$").find(c) != std::string_view::npos ? std::string("\\") + c
           : c == '^'                                                  ? "\\^{}"
           : c == '~'                                                  ? "\\~{}"
                                                                       : std::string(1, c);
  return out;
}

/// A unit of a table as TeX sets it.
inline std::string unit(const std::string& name) {
  return name == "um" ? "$\\mu$m" : escaped(name);
}

/**
The list of claims is written for every reader, `E_PN for omega_b = 1.1`. Subscripts, powers, Greek
names, numbers with a sign or an exponent and inequalities become mathematics, the rest stays text. */
inline std::string text(const std::string& plain) {
  static const std::regex form(
      R"((-?[A-Za-z]+)_(\([^)]*\)|[A-Za-z0-9]+))"                  // 1, 2: a subscript
      R"(|\^(\([^)]*\)|-[0-9/]+|[A-Za-z0-9]+))"                    // 3: a power
      R"(|(-?\d+(?:\.\d+)?e-?\d+|-\d+(?:\.\d+)?))"                 // 4: a number
      R"(|\b(pi|eps|omega|tau|mu|lambda|beta|Phi|Gamma|delta)\b)"  // 5: a Greek name
      R"(|(>=|<=|\+-)|(= | )-(?= |i\b))");                         // 6: a relation, 7: a minus
  std::string out;
  auto done = plain.cbegin();
  for (std::sregex_iterator m(plain.begin(), plain.end(), form), end; m != end; ++m) {
    out += escaped(std::string(done, (*m)[0].first));
    done = (*m)[0].second;
    if ((*m)[1].matched) {
      const std::string sub = bare(m->str(2));
      const bool word = sub.size() > 1 && std::all_of(sub.begin(), sub.end(), ::isalpha);
      out += "$" + name(m->str(1)) + "_{" + (word ? name(sub) : sub) + "}$";
    } else if ((*m)[3].matched) {
      out += "$^{" + bare(m->str(3)) + "}$";
    } else if ((*m)[4].matched) {
      out += value(m->str(4));
    } else if ((*m)[5].matched) {
      out += "$" + name(m->str(5)) + "$";
    } else if ((*m)[7].matched) {
      out += m->str(7) + "$-$";
    } else {
      out += m->str(6) == ">=" ? "$\\ge$" : m->str(6) == "<=" ? "$\\le$" : "$\\pm$";
    }
  }
  return out + escaped(std::string(done, plain.cend()));
}

}  // namespace tex

/// What the paper may refer to: the kind of reference (`num`, `err`, `pub`, `fig`, `tally`), the id and
/// the text in TeX; for a figure the text is the name of its file without extension.
using PaperTexts = std::map<std::pair<std::string, std::string>, std::string>;

inline PaperTexts paper_texts(const std::vector<Claim>& claims, const Findings& lock,
                              const Table& figures) {
  PaperTexts out;
  std::set<std::string> ids;
  std::map<std::string, int> counts{{"figures", int(figures.rows.size())},
                                    {"claims", int(claims.size())},
                                    {"reproduced", 0},
                                    {"holds", 0},
                                    {"measured", 0},
                                    {"discrepant", 0},
                                    {"open", 0}};
  for (const Claim& c : claims) {
    ids.insert(c.id);
    out[{"pub", c.id}] = tex::text(c.printed);
    ++counts[c.status];
  }
  for (const auto& [key, f] : lock) {
    const std::string id = ids.count(key.second) ? key.second : key.first + "." + key.second;
    out[{"num", id}] = tex::value(shown(f));
    out[{"err", id}] = tex::value(shown_error(f));
  }
  const auto id = figures.texts("id"), script = figures.texts("script");
  for (std::size_t i = 0; i < id.size(); ++i)
    out[{"fig", id[i]}] = script[i].substr(0, script[i].rfind('.'));
  for (const auto& [name, n] : counts) out[{"tally", name}] = std::to_string(n);
  return out;
}

/**
References that would stay empty, each once, as they stand in the paper. A comment refers to nothing, and
`#1` is the parameter of a macro. */
inline std::vector<std::string> dangling(const std::string& paper, const PaperTexts& texts) {
  static const std::regex form(R"(\\(num|err|pub|fig|tally)\{([^}#]*)\})");
  std::set<std::string> out;
  std::istringstream lines(paper);
  for (std::string line; std::getline(lines, line);) {
    for (auto at = line.find('%'); at != std::string::npos; at = line.find('%', at + 1))
      if (at == 0 || line[at - 1] != '\\') {
        line.erase(at);
        break;
      }
    for (std::sregex_iterator m(line.begin(), line.end(), form), end; m != end; ++m)
      if (!texts.count({m->str(1), m->str(2)})) out.insert(m->str(0));
  }
  return {out.begin(), out.end()};
}

/// The program without which this file of the paper is left out; empty if it is always read.
inline std::string chapter_needed(const std::string& paper) {
  const std::string mark = "% chapter: ";
  if (paper.rfind(mark, 0) != 0) return "";
  return paper.substr(mark.size(), paper.find('\n') - mark.size());
}

/**
The definitions, one to a line: `\define{num}{pn.omega11}{...}`, and `\caption...` of a figure. */
inline std::string paper_macros(const PaperTexts& texts, const Table& figures,
                                const std::set<std::string>& programs) {
  std::string out = "% Written by `report macros`; do not edit.\n";
  for (const auto& [key, text] : texts)
    out += "\\define{" + key.first + "}{" + key.second + "}{" + text + "}\n";
  const auto id = figures.texts("id"), caption = figures.texts("caption");
  for (std::size_t i = 0; i < id.size(); ++i)
    out += "\\define{caption}{" + id[i] + "}{" + tex::escaped(caption[i]) + "}\n";
  for (const auto& program : programs) out += "\\define{chapter}{" + program + "}{}\n";
  return out;
}

/**
A row of the table of claims: what is claimed, what is printed, what we found with its error, and the
verdict. Only a claim that is open has no number. */
inline std::string claim_rows(const std::vector<Claim>& claims, const Findings& lock) {
  std::string out = "% Written by `report macros`; do not edit.\n";
  for (const Claim& c : claims) {
    const auto found = lock.find({c.program, c.id});
    const bool open = c.status == "open";
    if (!open && found == lock.end())
      throw std::runtime_error("nothing is locked for the claim '" + c.id + "' (make lock)");
    const Finding f = open ? Finding{} : found->second;
    const bool worded = !f.unit.empty() && f.unit != "claim";
    out += "\\claim{" + tex::escaped(c.id) + "}{" + tex::text(c.quantity) + "}{" +
           tex::text(c.printed) + (c.unit.empty() ? "" : " " + tex::unit(c.unit)) + "}{" +
           (open ? "" : tex::value(shown(f))) + (worded ? " " + tex::unit(f.unit) : "") + "}{" +
           (open ? "" : tex::value(shown_error(f))) + "}{" +
           (open ? "open" : verdict(c, {f.value, f.error, f.unit})) + "}\n";
  }
  return out;
}

}  // namespace lattice
