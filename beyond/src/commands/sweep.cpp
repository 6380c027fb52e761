#include "commands/sweep.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "lattice/numerics/parallel.hpp"
#include "report/sums.hpp"

namespace lattice {
using namespace report;

Part parse_part(const std::string& text) {
  unsigned long k = 0, n = 0;
  char rest = 0;
  const bool digits = text.find_first_not_of("0123456789/") == std::string::npos;
  if (!digits || text.size() > 13 || std::sscanf(text.c_str(), "%lu/%lu%c", &k, &n, &rest) != 2 ||
      k < 1 || k > n || n > 100000)
    throw std::invalid_argument(text + " is not k/n with 1 <= k <= n <= 100000");
  return {k, n};
}

/// The check of an option: a part as k/n.
static Check part_text() {
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

void MapPart::parameters(Parameters& p) {
  p.add("part", part, "part k of n: every n-th point, starting at the k-th", part_text());
  p.add("folder", folder,
        "folder that keeps finished rows, shared by all parts (default: nothing is kept)",
        writable_folder());
}

static std::string line(std::size_t i, const Cells& cells) {
  std::string text = std::to_string(i);
  for (const Cell& cell : cells) text.append(1, ',').append(ecsv::cell_text(cell));
  return text + "," + sha256(text) + "\n";
}

// Takes over all whole rows under our key; they come back bit for bit
Sweep::Sweep(std::filesystem::path folder, std::string name, const Columns& columns,
             std::size_t points, const std::string& parameters)
    : folder_(std::move(folder)),
      name_(std::move(name)),
      key_("# " + parameters + "; executable " + sha256_of("/proc/self/exe")),
      columns_(columns.all),
      rows_(points) {
  std::replace(key_.begin(), key_.end(), '\n', ' ');
  for (const auto& path : files()) {
    std::ifstream in(path);
    std::string text;
    if (!std::getline(in, text) || text != key_) continue;
    while (std::getline(in, text) && !in.eof()) {
      const std::string row = text.substr(0, text.rfind(','));
      if (text != row + "," + sha256(row)) continue;
      const auto fields = ecsv::fields(row);
      if (fields.size() != columns_.size() + 1) continue;
      const std::size_t i = std::stoul(fields[0]);
      Cells cells;
      for (std::size_t c = 0; c < columns_.size(); ++c)
        cells.push_back(ecsv::parse(fields[c + 1], columns_[c].kind));
      if (i < rows_.size()) rows_[i] = std::move(cells);
    }
  }
}

void Sweep::compute(Part part, const std::function<Cells(std::size_t)>& row) {
  std::vector<std::size_t> open;
  std::string known = key_ + "\n";
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!part.holds(i)) continue;
    if (rows_[i].empty())
      open.push_back(i);
    else
      known += line(i, rows_[i]);
  }
  if (open.empty()) return;
  // The file is rewritten when work begins, so that no half line stays in it
  std::ofstream kept;
  if (!folder_.empty()) {
    const auto path = folder_ / ("." + name_ + ".rows-" + std::to_string(part.index) + "-of-" +
                                 std::to_string(part.count));
    std::filesystem::create_directories(folder_);
    write_whole(path, known);
    kept.open(path, std::ios::app | std::ios::binary);
  }
  std::mutex guard;
  parallel_for(name_, open.size(), [&](std::size_t j) {
    Cells cells = row(open[j]);
    Table{columns_}.add(cells);  // throws unless the row fits the columns
    const std::lock_guard lock(guard);
    if (!folder_.empty() && !(kept << line(open[j], cells) << std::flush))
      throw std::runtime_error("cannot write the rows of " + name_ + " to " + folder_.string());
    rows_[open[j]] = std::move(cells);
  });
}

Table Sweep::table(Part part) const {
  Table out{columns_};
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (part.holds(i) && !rows_[i].empty()) out.add(rows_[i]);
  return out;
}

void Sweep::forget() const {
  for (const auto& path : files()) std::filesystem::remove(path);
}

std::vector<std::filesystem::path> Sweep::files() const {
  std::vector<std::filesystem::path> found;
  std::error_code none;
  if (folder_.empty()) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none))
    if (entry.path().filename().string().rfind("." + name_ + ".rows-", 0) == 0)
      found.push_back(entry.path());
  return found;
}

}  // namespace lattice
