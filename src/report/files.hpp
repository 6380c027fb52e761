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

/**
A shell may close a program's channels (`2>&-`), and the first file that is opened then takes the place of one of
them: a complaint would be written into a table. And where the system limits the size of files, what is written
beyond it should fail like any other writing, with a word, rather than end the program. */
/// Fills the places of closed channels so that writing to them fails, and turns a file that grows too
/// large into a writing that fails. To be called before anything is opened.
void guard_channels();

/// Where the file that runs is, if the system shows it.
std::filesystem::path executable();

}  // namespace lattice
