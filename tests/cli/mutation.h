// Mutations damage files as storage, transfers and faulty programs do.
#pragma once

#include <random>
#include <string>

namespace test {

/// Applies one to three damages: bits flipped, ranges overwritten, removed, repeated or swapped, the end cut
/// off, numbers made huge (decimal, or binary in either byte order). Text mostly stays text, or every reader
/// would refuse it at once. The result depends only on the bytes and the state of `random`.
std::string mutated(std::string bytes, std::mt19937& random);

}  // namespace test
