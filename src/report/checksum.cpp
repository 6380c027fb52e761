/**
# SHA-256

The checksum of checksum.hpp is that of the standard FIPS 180-4, whose examples the tests repeat. */

#include "report/checksum.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>

namespace lattice {

/**
The constants are the first 32 binary digits after the point of the square roots of the first eight primes,
from which the state starts, and of the cube roots of the first sixty-four, one for each round. A `double`
has digits enough for them. */
namespace sha256 {

using Word = std::uint32_t;

struct Constants {
  std::array<Word, 8> start{};
  std::array<Word, 64> rounds{};
};

Constants from_primes() {
  const auto digits = [](double root) { return Word((root - std::floor(root)) * 0x1p32); };
  Constants out;
  unsigned p = 2;
  for (std::size_t k = 0; k < 64; ++p) {
    bool prime = true;
    for (unsigned q = 2; q * q <= p; ++q) prime = prime && p % q != 0;
    if (!prime) continue;
    if (k < 8) out.start[k] = digits(std::sqrt(double(p)));
    out.rounds[k++] = digits(std::cbrt(double(p)));
  }
  return out;
}

/**
Sixteen words of a block are stretched to sixty-four, and each of them stirs the state once; the letters are
those of the standard. */
void stir(std::array<Word, 8>& state, const unsigned char* block,
          const std::array<Word, 64>& rounds) {
  std::array<Word, 64> w;
  for (std::size_t t = 0; t < 16; ++t)
    w[t] = Word(block[4 * t]) << 24 | Word(block[4 * t + 1]) << 16 | Word(block[4 * t + 2]) << 8 |
           Word(block[4 * t + 3]);
  for (std::size_t t = 16; t < 64; ++t) {
    const Word early = w[t - 15], late = w[t - 2];
    w[t] = w[t - 16] + (std::rotr(early, 7) ^ std::rotr(early, 18) ^ early >> 3) + w[t - 7] +
           (std::rotr(late, 17) ^ std::rotr(late, 19) ^ late >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < 64; ++t) {
    const Word choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
    const Word one =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + choice + rounds[t] + w[t];
    const Word two = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
    h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
  }
  const std::array<Word, 8> stirred{a, b, c, d, e, f, g, h};
  for (std::size_t k = 0; k < 8; ++k) state[k] += stirred[k];
}

}  // namespace sha256

/**
The text is filled up to whole blocks of 64 bytes, with its length in bits at the end. */
std::string sha256_of(std::string text) {
  static const sha256::Constants constants = sha256::from_primes();
  const std::uint64_t bits = 8 * std::uint64_t(text.size());
  text += '\x80';
  while (text.size() % 64 != 56) text += '\0';
  for (int shift = 56; shift >= 0; shift -= 8) text += char(bits >> shift & 255);
  auto state = constants.start;
  const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
  for (std::size_t at = 0; at < text.size(); at += 64)
    sha256::stir(state, bytes + at, constants.rounds);
  std::string out;
  for (const sha256::Word word : state) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", unsigned(word));
    out += digits;
  }
  return out;
}

std::string table_checksum(std::istream& in) {
  std::string rows;
  for (std::string line; std::getline(in, line);)
    if (line.empty() || line.front() != '#') rows += line + '\n';
  return sha256_of(std::move(rows));
}

std::map<std::string, std::string> read_checksums(const std::filesystem::path& folder) {
  std::map<std::string, std::string> out;
  std::ifstream in(folder / checksums_name);
  for (std::string line; std::getline(in, line);)
    if (line.size() > 66) out[line.substr(66)] = line.substr(0, 64);
  return out;
}

/**
Every table must be on the list, and the list holds nothing else: a table that an earlier program left in the
folder could still be drawn. */
std::vector<std::string> altered_tables(const std::filesystem::path& folder) {
  auto sums = read_checksums(folder);
  std::vector<std::string> out;
  if (sums.empty()) out.push_back((folder / checksums_name).string() + ": no checksums");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ecsv") continue;
    const auto found = sums.find(entry.path().filename().string());
    std::ifstream in(entry.path());
    if (found == sums.end())
      out.push_back(entry.path().string() + ": not a table of this run");
    else if (table_checksum(in) != found->second)
      out.push_back(entry.path().string() + ": not what the program wrote");
    if (found != sums.end()) sums.erase(found);
  }
  for (const auto& [name, sum] : sums) out.push_back((folder / name).string() + ": missing");
  return out;
}

}  // namespace lattice
