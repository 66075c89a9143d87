#include "tests/cli/mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace test {
namespace {

using Random = std::mt19937;

// The distributions of the standard library differ between implementations.
std::size_t below(std::size_t end, Random& random) { return end == 0 ? 0 : random() % end; }

/// A range of bytes.
struct Run {
  std::size_t begin = 0;
  std::size_t size = 0;
};

Run run_in(const std::string& bytes, std::size_t longest, Random& random) {
  const std::size_t begin = below(bytes.size(), random);
  return {begin, std::min(1 + below(longest, random), bytes.size() - begin)};
}

void flip_bits(std::string& bytes, Random& random) {
  for (std::size_t left = std::size_t{1} << below(5, random); left > 0; --left) {
    char& byte = bytes[below(bytes.size(), random)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(8, random)));
  }
}

void overwrite(std::string& bytes, Random& random) {
  const Run run = run_in(bytes, 64, random);
  const std::size_t kind = below(3, random);
  for (std::size_t i = 0; i < run.size; ++i) {
    bytes[run.begin + i] = static_cast<char>(kind == 0 ? 0U : kind == 1 ? 0xFFU : random());
  }
}

void cut_off(std::string& bytes, Random& random) { bytes.resize(below(bytes.size(), random)); }

void remove_run(std::string& bytes, Random& random) {
  const Run run = run_in(bytes, 256, random);
  bytes.erase(run.begin, run.size);
}

void repeat_run(std::string& bytes, Random& random) {
  const Run run = run_in(bytes, 256, random);
  const std::string copy = bytes.substr(run.begin, run.size);
  const std::size_t at = below(bytes.size(), random);
  for (std::size_t left = 1 + below(8, random); left > 0; --left) bytes.insert(at, copy);
}

void swap_runs(std::string& bytes, Random& random) {
  const Run run = run_in(bytes, 64, random);
  const std::string copy = bytes.substr(run.begin, run.size);
  bytes.erase(run.begin, run.size);
  bytes.insert(below(bytes.size() + 1, random), copy);
}

/// Overwrites a binary number by a huge one: counts, sizes and offsets are mostly at the beginning of files.
void inflate_binary(std::string& bytes, Random& random) {
  constexpr std::array<std::uint64_t, 8> Numbers = {0xFFFFFFFF,  0x7FFFFFFF, 0x80000000,         0x10000000,
                                                    100'000'000, 0xFFFF,     0x4000000000000000, 0x00FFFFFF};
  const std::uint64_t number = Numbers[below(Numbers.size(), random)];
  const std::size_t width = std::size_t{2} << below(3, random);
  const bool is_big_endian = below(2, random) == 0;
  const std::size_t reach = below(2, random) == 0 ? std::min<std::size_t>(bytes.size(), 512) : bytes.size();
  const std::size_t begin = below(reach, random);
  for (std::size_t i = 0; i < width && begin + i < bytes.size(); ++i) {
    const std::size_t shift = 8 * (is_big_endian ? width - 1 - i : i);
    bytes[begin + i] = static_cast<char>(number >> shift);
  }
}

void inflate_decimal(std::string& bytes, Random& random) {
  constexpr std::array<std::string_view, 10> Numbers = {
      "4294967295",           "2147483647", "-2147483648", "-1",  "99999999",
      "18446744073709551616", "1e38",       "-1e400",      "nan", "0"};
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size(), random));
  const auto begin = std::find_if(from, bytes.end(), is_digit);
  const auto end = std::find_if_not(begin, bytes.end(), is_digit);
  bytes.replace(begin, end, Numbers[below(Numbers.size(), random)]);
}

/// Returns whether a byte occurs in text files.
bool is_of_text(unsigned char c) { return c >= ' ' || c == '\n' || c == '\r' || c == '\t'; }

void make_text(std::string& bytes) {
  for (char& c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (!is_of_text(byte) || byte >= 0x7F) c = static_cast<char>(' ' + byte % 95);
  }
}

}  // namespace

std::string mutated(std::string bytes, Random& random) {
  constexpr std::array Damages = {flip_bits,       overwrite,      cut_off,        remove_run,
                                  repeat_run,      swap_runs,      inflate_binary, inflate_binary,
                                  inflate_decimal, inflate_decimal};
  constexpr std::array<std::size_t, 4> Counts = {1, 1, 2, 3};
  const bool stays_text = std::all_of(bytes.begin(), bytes.end(), is_of_text) && random() % 4 > 0;
  for (std::size_t left = Counts[below(Counts.size(), random)]; left > 0 && !bytes.empty(); --left) {
    Damages[below(Damages.size(), random)](bytes, random);
  }
  if (stays_text) make_text(bytes);
  return bytes;
}

}  // namespace test
