#pragma once
/**
# Which run a table is of

A full run writes its tables into one folder and last the list `SHA256SUMS`, in the format of `sha256sum`: without it the
folder is not complete. The tables have the same bytes on every machine of one kind. What differs between machines, the
program, the revision, the compiler and the libraries, is in `run.ecsv` beside them, which is not in the list. */

#include <filesystem>
#include <map>
#include <string>

#include "report/table.hpp"

namespace report {

/// SHA-256 of some bytes, as `sha256sum` prints it.
std::string sha256(const std::string& bytes);
/// The same of a file, such as the program that runs, `/proc/self/exe`; empty if it cannot be read.
std::string sha256_of(const std::filesystem::path& file);

/// The sums by the names of the files.
using Sums = std::map<std::string, std::string>;
/// Those that a folder lists; none if its run did not end.
Sums sums_in(const std::filesystem::path& folder);
/// Writes the list, whole.
void write_sums(const std::filesystem::path& folder, const Sums& sums);

/// Whether a table is of a run with `--quick`, as its header says.
bool is_quick(const Table& table);

}  // namespace report
