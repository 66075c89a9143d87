// Bounds-checked access to the numbers of a glTF file: tinygltf does not validate accessors, views and
// buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "converters/gltf/gltf_file.h"
#include "grf/diagnostics.h"

namespace convert {

/// Reads accessors (glTF 2.0, section 3.6.2), with strides, sparse values and normalised integers. Functions
/// return nothing after an error, which names the accessor.
class GltfAccessors {
 public:
  GltfAccessors(const GltfFile& file, grf::Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  /// Reads the elements of an accessor of type SCALAR, VEC2, VEC3, VEC4 or MAT4, with that number of
  /// components, concatenated. Values must be finite unless `infinite` is set.
  std::optional<std::vector<float>> floats(int accessor, std::size_t components, bool infinite = false);

  /// Reads the elements as vectors of floats.
  template <class Vector>
  std::optional<std::vector<Vector>> vectors(int accessor, bool infinite = false) {
    std::optional<std::size_t> count = checked_count(accessor, sizeof(Vector) / sizeof(float), false);
    if (!count) return std::nullopt;
    std::vector<Vector> values(*count);
    if (!fill(accessor, reinterpret_cast<float*>(values.data()), infinite)) return std::nullopt;
    return values;
  }

  /// Reads unsigned integers, one per element.
  std::optional<std::vector<std::uint32_t>> integers(int index);

  /// Returns the number of elements of an accessor; 0 if it does not exist.
  std::size_t count(int accessor) const;

  bool has_components(int accessor, std::size_t components) const;

  /// Returns the bytes of a buffer view, or nothing after an error.
  std::optional<std::span<const unsigned char>> view(int index);

  /// Adds to the work that the file causes, in elements read or generated. Returns false, after an error,
  /// once it is out of proportion to the size of the file: a few bytes can name one accessor again and again.
  bool spend(std::size_t elements);

  std::nullopt_t fail(std::string_view message);

 private:
  /// A validated run of elements in a buffer; without bytes all elements are 0.
  struct Run {
    const unsigned char* bytes = nullptr;
    std::size_t stride = 0;
  };

  const tinygltf::Accessor* find(int accessor) const;
  std::optional<std::size_t> checked_count(int index, std::size_t components, bool integers);
  std::optional<Run> run_of(int index, std::size_t offset, std::size_t count, std::size_t element,
                            bool may_have_stride);
  std::optional<Run> run_of(const tinygltf::Accessor& accessor);
  bool fill(int index, float* values, bool infinite);
  template <class Put>
  bool for_sparse(const tinygltf::Accessor& accessor, const Put& put);
  std::optional<std::vector<std::uint32_t>> sparse_indices(const tinygltf::Accessor& accessor);

  const GltfFile& file_;
  grf::Diagnostics& diagnostics_;
  int current_ = -1;  ///< index of the current accessor, for messages
  std::size_t spent_ = 0;
};

}  // namespace convert
