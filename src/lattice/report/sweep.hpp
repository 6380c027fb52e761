#pragma once
/**
# Maps in parts

A map consists of points that know nothing of each other, and a large one takes long. This
file keeps each row as soon as it is known, so that an interrupted map goes on where it stopped,
and lets a part of the points be computed alone: the jobs of an array each take one part
`k/n`, and whoever wants the whole map collects what the parts have left and computes what is
missing. A row has the same bits wherever it was computed, hence the tables have the same bytes.

Rows wait in files `.NAME.rows-k-of-n` of the folder. Their first line is a key that names the
parameters and the program, down to the bytes of its executable; rows under another key are
ignored. Each line ends with a checksum of its own, and one that was cut short by an interruption or
changed by hand is computed again. Without a folder nothing is kept. */

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/parallel.hpp"
#include "lattice/report/options.hpp"
#include "lattice/report/table.hpp"

namespace lattice {

/// The points i with i = index - 1 modulo count.
struct Part {
  std::size_t index = 1, count = 1;
  bool holds(std::size_t i) const { return i % count == index - 1; }
};

/// Reads "k/n"; throws std::invalid_argument unless 1 <= k <= n <= 100000.
inline Part parse_part(const std::string& text) {
  unsigned long k = 0, n = 0;
  char rest = 0;
  const bool digits = text.find_first_not_of("0123456789/") == std::string::npos;
  if (!digits || text.size() > 13 || std::sscanf(text.c_str(), "%lu/%lu%c", &k, &n, &rest) != 2 ||
      k < 1 || k > n || n > 100000)
    throw std::invalid_argument(text + " is not k/n with 1 <= k <= n <= 100000");
  return {k, n};
}

/**
On a command line a part is an option like others. */
/// Option check: a part as k/n.
inline Check part_text() {
  const auto complaint = [](const std::string& value) {
    try {
      parse_part(value);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  return {complaint, "k/n"};
}

/**
Rows and programs are told apart by a short hash of their bytes (FNV-1a). */
inline std::string fingerprint(std::istream& bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (char c; bytes.get(c);) hash = (hash ^ std::uint8_t(c)) * 1099511628211ULL;
  return std::to_string(hash);
}

/// A number that changes with the program that runs: of its executable where the system shows it.
inline std::string executable_fingerprint() {
  std::ifstream self("/proc/self/exe", std::ios::binary);
  return fingerprint(self);
}

/**
A sweep is told how its columns look, how many points there are, and everything on which a row
depends, as one line of text. */
class Sweep {
 public:
  using Row = std::vector<Cell>;

  Sweep(std::filesystem::path folder, std::string name, std::vector<Column> columns,
        std::size_t points, const std::string& parameters)
      : folder_(std::move(folder)),
        name_(std::move(name)),
        key_("# " + parameters + "; executable " + executable_fingerprint()),
        columns_(std::move(columns)),
        rows_(points) {
    for (char& c : key_)
      if (c == '\n') c = ' ';
    collect();
  }

  /**
  A row that has been computed is safe before the next one begins. */
  /// Computes `row(i)` for those points of the part that are not known yet, and keeps each.
  template <class Of>
  void compute(Part part, Of row) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (part.holds(i) && rows_[i].empty()) open.push_back(i);
    if (open.empty()) return;
    std::ofstream kept;
    if (!folder_.empty()) kept = reopen(part);
    std::mutex guard;
    Progress progress(name_, open.size());
    parallel_for(open.size(), [&](std::size_t j) {
      Row cells = row(open[j]);
      Table{columns_}.add(cells);  // throws unless the row fits the columns
      const std::lock_guard lock(guard);
      kept << line(open[j], cells) << std::flush;
      rows_[open[j]] = std::move(cells);
      progress.tick();
    });
  }

  /**
  What is known is told point by point. */
  /// How many points the part has.
  std::size_t size(Part part = {}) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) count += part.holds(i);
    return count;
  }

  /// How many of them are known.
  std::size_t known(Part part = {}) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) count += part.holds(i) && !rows_[i].empty();
    return count;
  }

  /// The known rows of the part, in their order.
  Table table(Part part = {}) const {
    Table out{columns_};
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (part.holds(i) && !rows_[i].empty()) out.add(rows_[i]);
    return out;
  }

  /// Removes the rows that wait in files, once the table is safe.
  void forget() const {
    for (const auto& path : files()) std::filesystem::remove(path);
  }

  /**
  Everything else is about files. */
 private:
  std::string prefix() const { return "." + name_ + ".rows-"; }

  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> found;
    std::error_code none;
    if (folder_.empty()) return found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, none))
      if (entry.path().filename().string().rfind(prefix(), 0) == 0) found.push_back(entry.path());
    return found;
  }

  static std::string line(std::size_t i, const Row& cells) {
    std::string text = std::to_string(i);
    for (const Cell& cell : cells) text.append(1, ',').append(ecsv::cell_text(cell));
    return text + "," + sum_of(text) + "\n";
  }

  static std::string sum_of(const std::string& text) {
    std::istringstream bytes(text);
    return fingerprint(bytes);
  }

  /**
  Rows come back as they went, bit for bit. */
  /// Takes over all whole rows that stand under our key.
  void collect() {
    for (const auto& path : files()) {
      std::ifstream in(path);
      std::string text;
      if (!std::getline(in, text) || text != key_) continue;
      while (std::getline(in, text) && !in.eof()) {
        const auto end = text.rfind(',');
        if (end == std::string::npos || text.substr(end + 1) != sum_of(text.substr(0, end)))
          continue;
        const auto fields = ecsv::fields(text.substr(0, end));
        if (fields.size() != columns_.size() + 1) continue;
        const std::size_t i = std::stoul(fields[0]);
        Row cells;
        for (std::size_t c = 0; c < columns_.size(); ++c)
          cells.push_back(ecsv::parse(fields[c + 1], columns_[c].kind));
        if (i < rows_.size()) rows_[i] = std::move(cells);
      }
    }
  }

  /**
  A file is rewritten when work begins, so that no half line stays in it. */
  /// The file of the part with what is known of it, open for more.
  std::ofstream reopen(Part part) const {
    const auto path =
        folder_ / (prefix() + std::to_string(part.index) + "-of-" + std::to_string(part.count));
    std::string text = key_ + "\n";
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (part.holds(i) && !rows_[i].empty()) text += line(i, rows_[i]);
    std::filesystem::create_directories(folder_);
    write_whole(path, text);
    return std::ofstream(path, std::ios::app | std::ios::binary);
  }

  std::filesystem::path folder_;
  std::string name_, key_;
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace lattice
