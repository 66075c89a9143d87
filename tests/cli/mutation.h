// Files that are damaged as storage, transfers and programs with errors damage them.
#pragma once

#include <random>
#include <string>

namespace test {

/// Bytes with one to three damages: bits flipped, runs overwritten, removed, repeated or swapped, the end cut
/// off, numbers made huge (decimal ones, and binary ones of either byte order). Text mostly stays text, or
/// every reader would refuse it at once. What comes out depends on the bytes and the state of `random` alone.
std::string mutated(std::string bytes, std::mt19937& random);

}  // namespace test
