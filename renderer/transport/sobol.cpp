#include "renderer/transport/sobol.h"

namespace transport {
namespace {

constexpr int Dimensions = 4;

/// Primitive polynomial and first direction numbers of a dimension
/// (Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional projections").
struct Generator {
  int degree;
  std::uint32_t polynomial;
  std::array<std::uint32_t, 3> numbers;
};
constexpr std::array<Generator, Dimensions - 1> Generators = {
    Generator{1, 0, {1, 0, 0}}, Generator{2, 1, {1, 3, 0}}, Generator{3, 1, {1, 3, 1}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions directions_of(const Generator& generator) {
  Directions directions = {};
  const int degree = generator.degree;
  for (int i = 0; i < degree; ++i) directions[i] = generator.numbers[i] << (31 - i);
  for (int i = degree; i < 32; ++i) {
    directions[i] = directions[i - degree] ^ (directions[i - degree] >> degree);
    for (int k = 1; k < degree; ++k) {
      if ((generator.polynomial >> (degree - 1 - k)) & 1U) directions[i] ^= directions[i - k];
    }
  }
  return directions;
}

constexpr Directions van_der_corput() {
  Directions directions = {};
  for (int i = 0; i < 32; ++i) directions[i] = 1U << (31 - i);
  return directions;
}

/// For each byte of an index and each dimension, the sum of the directions of its bits: four look-ups
/// instead of 32 steps.
using ByteTable = std::array<std::array<std::array<std::uint32_t, Dimensions>, 256>, 4>;

constexpr ByteTable byte_table() {
  ByteTable table = {};
  for (int dimension = 0; dimension < Dimensions; ++dimension) {
    const Directions directions =
        dimension == 0 ? van_der_corput() : directions_of(Generators[dimension - 1]);
    for (int byte = 0; byte < 4; ++byte) {
      for (unsigned value = 0; value < 256; ++value) {
        std::uint32_t sum = 0;
        for (int bit = 0; bit < 8; ++bit) {
          if ((value >> bit) & 1U) sum ^= directions[8 * byte + bit];
        }
        table[byte][value][dimension] = sum;
      }
    }
  }
  return table;
}

constexpr ByteTable Table = byte_table();

std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fU) << 4U) | ((x >> 4U) & 0x0f0f0f0fU);
  x = ((x & 0x33333333U) << 2U) | ((x >> 2U) & 0x33333333U);
  return ((x & 0x55555555U) << 1U) | ((x >> 1U) & 0x55555555U);
}

/// Flips each bit by a hash of the more significant ones: Owen's nested uniform scrambling, by the
/// permutation of Laine and Karras 2011 on the reversed bits, with the constants of Burley 2020.
std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
  x = reverse_bits(x);
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reverse_bits(x);
}

// The 24 bits that a float in [0,1) holds; the rest is cut, since rounding could give 1.
float to_unit(std::uint32_t x) { return static_cast<float>(x >> 8U) * 0x1p-24F; }

}  // namespace

std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  // The finaliser of MurmurHash3 (Appleby), on 64 bits.
  std::uint64_t x = (static_cast<std::uint64_t>(a) << 32U | b) + 0x9e3779b97f4a7c15ULL;
  x ^= x >> 33U;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33U;
  x *= 0xc4ceb9fe1a85ec53ULL;
  x ^= x >> 33U;
  return static_cast<std::uint32_t>(x >> 32U);
}

Uniform4 sobol_point(std::uint32_t index, std::uint32_t seed) {
  const std::uint32_t shuffled = owen_scramble(index, seed);
  std::array<std::uint32_t, Dimensions> bits = {};
  for (int byte = 0; byte < 4; ++byte) {
    const auto& entry = Table[byte][(shuffled >> (8 * byte)) & 255U];
    for (int d = 0; d < Dimensions; ++d) bits[d] ^= entry[d];
  }
  for (int d = 0; d < Dimensions; ++d) bits[d] = owen_scramble(bits[d], hash(seed, d + 1U));
  return {to_unit(bits[0]), to_unit(bits[1]), to_unit(bits[2]), to_unit(bits[3])};
}

}  // namespace transport
