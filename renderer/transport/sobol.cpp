#include "renderer/transport/sobol.h"

#include <cstring>

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

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fU) << 4U) | ((x >> 4U) & 0x0f0f0f0fU);
  x = ((x & 0x33333333U) << 2U) | ((x >> 2U) & 0x33333333U);
  return ((x & 0x55555555U) << 1U) | ((x >> 1U) & 0x55555555U);
}

/// For each dimension and each byte of a bit-reversed index, the XOR of the direction numbers of its bits,
/// also reversed: four look-ups replace 32 steps, and scrambling needs reversed bits.
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
          if ((value >> bit) & 1U) sum ^= directions[31 - (8 * byte + bit)];
        }
        table[byte][value][dimension] = reverse_bits(sum);
      }
    }
  }
  return table;
}

alignas(16) constexpr ByteTable Table = byte_table();

// All dimensions at once, one per SIMD lane: of one sample, or of two.
using Lanes4 = std::uint32_t __attribute__((vector_size(16)));
using Lanes8 = std::uint32_t __attribute__((vector_size(32)));
using Floats4 = float __attribute__((vector_size(16)));
using Floats8 = float __attribute__((vector_size(32)));

// Converts via signed integers, for which the processor has an instruction.
Floats4 converted(Lanes4 x) {
  using Signed = std::int32_t __attribute__((vector_size(16)));
  return __builtin_convertvector((Signed)x, Floats4);
}
Floats8 converted(Lanes8 x) {
  using Signed = std::int32_t __attribute__((vector_size(32)));
  return __builtin_convertvector((Signed)x, Floats8);
}

/// Owen's nested uniform scrambling flips each bit by a hash of the more significant ones: a permutation of
/// the reversed bits (Laine and Karras 2011) with the constants of Burley 2020.
template <class Lanes>
Lanes scramble_reversed(Lanes x, Lanes seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return x;
}

/// The seeds of the dimensions, by a 32-bit hash (Wellons 2018, "Prospecting for hash functions", lowbias32).
template <class Lanes>
Lanes mixed(Lanes x) {
  x ^= x >> 16U;
  x *= 0x7feb352dU;
  x ^= x >> 15U;
  x *= 0x846ca68bU;
  return x ^ (x >> 16U);
}

/// Reverses bits, and keeps the 24 that a float in [0,1) holds; truncates, since rounding could give 1.
template <class Lanes>
auto to_unit(Lanes x) {
  x = (x << 24U) | ((x & 0xff00U) << 8U) | ((x >> 8U) & 0xff00U) | (x >> 24U);
  x = ((x & 0x0f0f0f0fU) << 4U) | ((x >> 4U) & 0x0f0f0f0fU);
  x = ((x & 0x33333333U) << 2U) | ((x >> 2U) & 0x33333333U);
  x = ((x & 0x55555555U) << 1U) | ((x >> 1U) & 0x55555555U);
  x >>= 8U;
  return converted(x) * 0x1p-24F;
}

Lanes4 reversed_point(std::uint32_t reversed_index, std::uint32_t seed) {
  const std::uint32_t shuffled = scramble_reversed(reversed_index, seed);
  Lanes4 sum = {};
  for (int byte = 0; byte < 4; ++byte) {
    Lanes4 entry;
    std::memcpy(&entry, Table[byte][(shuffled >> (8 * byte)) & 255U].data(), sizeof(entry));
    sum ^= entry;
  }
  return sum;
}

constexpr std::uint32_t Step = 0x9e3779b9U;  // of the dimensions' seeds
constexpr Lanes4 Steps = {Step, 2 * Step, 3 * Step, 4 * Step};

Uniform4 point_of(std::uint32_t reversed_index, std::uint32_t seed) {
  const auto unit = to_unit(scramble_reversed(reversed_point(reversed_index, seed), mixed(seed + Steps)));
  return {unit[0], unit[1], unit[2], unit[3]};
}

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

Uniform4 sobol_point(std::uint32_t index, std::uint32_t seed) { return point_of(reverse_bits(index), seed); }

// The first samples of independently scrambled sequences are independent: so paths do the same work with
// either pattern.
PathSampler::PathSampler(std::uint32_t sequence_seed, std::uint32_t sample, SamplePattern pattern)
    : seed_(pattern == SamplePattern::Sobol ? sequence_seed : hash(sequence_seed, sample)),
      sample_(pattern == SamplePattern::Sobol ? sample : 0),
      reversed_sample_(reverse_bits(sample_)),
      pattern_(pattern) {}

Uniform4 PathSampler::next() { return point_of(reversed_sample_, hash(seed_, dimension_++)); }

SamplePair PathSampler::next_two() {
  const std::uint32_t first = hash(seed_, dimension_++);
  const std::uint32_t second = hash(seed_, dimension_++);
  const Lanes4 a = reversed_point(reversed_sample_, first);
  const Lanes4 b = reversed_point(reversed_sample_, second);
  const Lanes4 seed_a = first + Steps;
  const Lanes4 seed_b = second + Steps;
  const Lanes8 pattern = {a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]};
  const Lanes8 seeds = {seed_a[0], seed_a[1], seed_a[2], seed_a[3],
                        seed_b[0], seed_b[1], seed_b[2], seed_b[3]};
  const auto unit = to_unit(scramble_reversed(pattern, mixed(seeds)));
  return {{unit[0], unit[1], unit[2], unit[3]}, {unit[4], unit[5], unit[6], unit[7]}};
}

}  // namespace transport
