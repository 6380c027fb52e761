#pragma once
/**
# Places to write

Nobody wants to learn after hours of work that a file cannot be written, so a place is tried before anything
is computed. */

#include <filesystem>
#include <string>

namespace lattice {

/// Makes `folder` and tries to write `file` in it under a temporary name; the system's reason where that
/// fails, and nothing where it works. What exists and is no ordinary file (a device, a pipe) is taken as it
/// is.
std::string why_not_writable(const std::filesystem::path& folder, const std::string& file);

/// Where the file that runs is, if the system shows it.
std::filesystem::path executable();

}  // namespace lattice
