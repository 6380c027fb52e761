#pragma once
// A fresh folder for what a test writes.

#include <unistd.h>

#include <filesystem>
#include <string>

/// It goes away again.
struct Scratch {
  inline static int count = 0;
  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("lattice cli " + std::to_string(::getpid()) + " " + std::to_string(++count));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
  bool empty() const { return std::filesystem::is_empty(path); }
};
