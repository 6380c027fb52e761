#pragma once
/**
# What a page offers

The library, compiled for the browser, knows five functions of the page. `page_fail` does not return,
because it throws on the other side: an instance is thrown away after one run. That is how every
exception ends here, with the words that the programs would print, so that code that catches one
to go on another way must not be called. */

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "lattice/numerics/estimate.hpp"

#define PAGE(name) __attribute__((import_module("page"), import_name(name)))
extern "C" {
/// A row of a map, or a point of a path, in the run whose step was halved `halvings` times.
PAGE("row") void page_row(int halvings, double t, const double* values, std::size_t n);
PAGE("list")
void page_list(const char* name, std::size_t length, const double* values, std::size_t n);
PAGE("fact") void page_fact(const char* name, std::size_t length, double value, double error);
[[noreturn]] PAGE("fail") void page_fail(const char* text, std::size_t length);

[[noreturn]] void __cxa_throw(void* thrown, void*, void (*)(void*)) {
  const std::string_view text = static_cast<std::exception*>(thrown)->what();
  page_fail(text.data(), text.size());
}
void* __cxa_allocate_exception(std::size_t size) {
  return std::malloc(size);
}
void __cxa_free_exception(void*) {}
[[noreturn]] void __cxa_rethrow() {
  __builtin_trap();
}
}

/**
A page writes what it asks for into a struct of plain numbers, `asked`, at the address that the exported
`request` gives it, and then calls `run`. */
#define PAGE_REQUEST(Request)                                             \
  Request asked;                                                          \
  extern "C" __attribute__((export_name("request"))) Request* request() { \
    return &asked;                                                        \
  }

namespace page {

inline void fact(std::string_view name, const lattice::Estimate& e) {
  page_fact(name.data(), name.size(), e.value, e.error);
}
inline void list(std::string_view name, const std::vector<double>& values) {
  page_list(name.data(), name.size(), values.data(), values.size());
}

}  // namespace page
