#pragma once
// A program called as a reader calls it, through a shell, and what it answers.

#include <regex.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "support/check.hpp"
#include "support/scratch.hpp"

/// One word for the shell, whatever characters a path has.
inline std::string word(const std::filesystem::path& path) {
  std::string out = "'";
  for (char c : path.string()) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

struct Result {
  int code;
  std::string output;  ///< standard output
  std::string errors;
  std::size_t error_lines() const {
    return std::size_t(std::count(errors.begin(), errors.end(), '\n'));
  }
};

/// Runs a command whose first word is a program of ours, in a folder. One that hangs ends with code 124.
inline Result call_in(const std::filesystem::path& folder, const std::string& command) {
  namespace fs = std::filesystem;
  const auto errors = fs::temp_directory_path() / ("lattice_err_" + std::to_string(::getpid()));
  const std::string line = "cd " + word(folder) + " && timeout 300 " + word(BIN_DIR) + "/" +
                           command + " 2>" + word(errors);
  FILE* pipe = popen(line.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), n);
  const int status = pclose(pipe);
  std::ifstream in(errors);
  std::stringstream text;
  text << in.rdbuf();
  fs::remove(errors);
  return {WEXITSTATUS(status), output, text.str()};
}

/// The same where the tests are.
inline Result call(const std::string& command) {
  return call_in(".", command);
}

/// What a command answered; it must have succeeded.
inline report::Table table_of(const Result& answer) {
  CAPTURE(answer.errors);
  REQUIRE(answer.code == 0);
  std::istringstream in(answer.output);
  return report::from_text(in);
}
inline report::Table table_of(const std::string& command) {
  CAPTURE(command);
  return table_of(call(command));
}

/// The row of a quantity or of another word in the first column.
inline std::size_t row_of(const report::Table& t, const std::string& name) {
  const auto names = t.texts(t.columns.front().name);
  const auto found = std::find(names.begin(), names.end(), name);
  CAPTURE(name);
  REQUIRE(found != names.end());
  return std::size_t(found - names.begin());
}

/// What the table says in the row of a quantity.
inline double quantity(const Result& r, const std::string& name,
                       const std::string& column = "value") {
  const report::Table t = table_of(r);
  return t.numbers(column)[row_of(t, name)];
}

/// The same of a column of words.
inline std::string text_of(const Result& r, const std::string& name, const std::string& column) {
  const report::Table t = table_of(r);
  return t.texts(column)[row_of(t, name)];
}

/// Every match of an extended POSIX expression: the whole, then its groups. The compiler needs seconds for std::regex.
inline std::vector<std::vector<std::string>> matches(const std::string& text, const char* pattern) {
  regex_t compiled;
  REQUIRE(regcomp(&compiled, pattern, REG_EXTENDED) == 0);
  std::vector<std::vector<std::string>> all;
  std::array<regmatch_t, 6> groups{};
  for (const char* from = text.c_str();
       regexec(&compiled, from, groups.size(), groups.data(), 0) == 0; from += groups[0].rm_eo) {
    all.emplace_back();
    for (const auto& [begin, end] : groups)
      all.back().push_back(begin < 0 ? "" : std::string(from + begin, from + end));
  }
  regfree(&compiled);
  return all;
}

/// A text in one line.
inline std::string in_one_line(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  for (std::string each; in >> each;) out += each + " ";
  return out;
}

/// The rows of a table without its header, which tells the command.
inline std::string body(const std::string& text) {
  std::istringstream in(text);
  std::string line, out;
  while (std::getline(in, line))
    if (line.empty() || line[0] != '#') out += line + "\n";
  return out;
}

/// The rows that a command prints; it must succeed.
inline std::string rows(const std::string& command) {
  const Result answer = call(command);
  table_of(answer);
  return body(answer.output);
}

/// An answer must be a refusal: exit code 2, no table, and one line that contains `what`.
inline void check_refused(const Result& answer, const std::string& what) {
  CAPTURE(answer.errors);
  CHECK(answer.code == 2);
  CHECK(answer.error_lines() == 1);
  CHECK(answer.output.empty());
  CHECK(answer.errors.find(what) != std::string::npos);
}
inline void check_refused(const std::string& command, const std::string& what) {
  CAPTURE(command);
  check_refused(call(command), what);
}
