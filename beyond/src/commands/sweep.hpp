#pragma once
/**
# Maps in parts

A map consists of points that know nothing of each other, and a large one takes long. This file keeps each row as soon
as it is known, so that an interrupted map goes on where it stopped, and lets a part of the points be computed alone:
the jobs of an array each take one part `k/n`, and the run of the whole map collects what the parts have left and
computes what is missing. A row has the same bits wherever it was computed, hence the tables have the same bytes.

Rows wait in files `.NAME.rows-k-of-n` of the folder. Their first line is a key that names the parameters and the
program, down to the bytes of its executable; rows under another key are ignored. Each line ends with a checksum of its
own, and one that was cut short by an interruption or changed by hand is computed again. Without a folder nothing is
kept. */

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/parameters.hpp"
#include "report/table.hpp"

namespace lattice {
using namespace report;

/// The points i with i = index - 1 modulo count.
struct Part {
  std::size_t index = 1, count = 1;
  /// Whether point `i`, from 0, belongs to it.
  bool holds(std::size_t i) const { return i % count == index - 1; }
};

/// Reads "k/n"; throws std::invalid_argument unless 1 <= k <= n <= 100000.
Part parse_part(const std::string& text);

/// What a command that computes a map is told: which part of it, and where rows wait for each other.
struct MapPart {
  std::string part = "1/1", folder{};

  void parameters(Parameters& p);
  /// Throws std::invalid_argument where `part` is none.
  Part mine() const { return parse_part(part); }
};

/// The rows of a map.
class Sweep {
 public:
  /// Takes over the rows that wait in `folder`, if that is not empty; `name` is in the names of its files, and
  /// `parameters`, one line, is everything on which a row depends.
  Sweep(std::filesystem::path folder, std::string name, const Columns& columns, std::size_t points,
        const std::string& parameters);

  /// Computes `row(i)` for those points of the part that are not known yet, and keeps each before the next begins.
  void compute(Part part, const std::function<Cells(std::size_t)>& row);
  /// The known rows of the part, in their order.
  Table table(Part part = {}) const;
  /// Removes the rows that wait in files, once the table is safe.
  void forget() const;

 private:
  std::vector<std::filesystem::path> files() const;

  std::filesystem::path folder_;
  std::string name_, key_;
  std::vector<Column> columns_;
  std::vector<Cells> rows_;
};

}  // namespace lattice
