#pragma once
/**
# Checksums of tables

A table that was edited by hand, cut short or mixed with another run looks like any other, and a figure
drawn from it is wrong without a sign. So every full run leaves a list `SHA256SUMS` beside its tables, in
the format of `sha256sum`: a checksum and a name in each line. Checksums leave out the header of a table,
which tells the command and the build, and cover all lines that do not begin with `#`; hence

    grep -v '^#' speeds.ecsv | sha256sum

prints the checksum that the list has for `speeds.ecsv`. */

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace lattice {

/// SHA-256 of `text` as 64 hexadecimal digits.
std::string sha256_of(std::string text);

/// The checksum of a table: of its text without the lines that begin with `#`.
std::string table_checksum(std::istream& in);

/**
Whoever reads tables asks first whether they are what the program wrote. */
/// Name of the list.
constexpr const char* checksums_name = "SHA256SUMS";

/// The checksum of every name in the list of `folder`; empty if there is no list.
std::map<std::string, std::string> read_checksums(const std::filesystem::path& folder);

/// One line for each table of `folder` that is not what its program wrote, is missing or is unknown.
std::vector<std::string> altered_tables(const std::filesystem::path& folder);

}  // namespace lattice
