#include "converters/gltf/gltf_accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

std::size_t component_bytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool is_index_type(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::size_t components_of(const tinygltf::Accessor& accessor) {
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  return components < 0 ? 0 : static_cast<std::size_t>(components);
}

std::size_t element_bytes(const tinygltf::Accessor& accessor) {
  return components_of(accessor) * component_bytes(accessor.componentType);
}

template <class Number>
Number number_at(const unsigned char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));
  return number;
}

// Section 3.6.2.3: the most negative integer and the next one are both -1.
template <class Integer>
float number_of(const unsigned char* bytes, bool normalised) {
  const auto value = static_cast<float>(number_at<Integer>(bytes));
  if (!normalised) return value;
  return std::max(value / static_cast<float>(std::numeric_limits<Integer>::max()), -1.0F);
}

float float_at(const unsigned char* bytes, int component_type, bool normalised) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_of<std::int8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_of<std::uint8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_of<std::int16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_of<std::uint16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_of<std::uint32_t>(bytes, normalised);
    default:
      return number_at<float>(bytes);
  }
}

std::uint32_t integer_at(const unsigned char* bytes, int component_type) {
  if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *bytes;
  if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return number_at<std::uint16_t>(bytes);
  return number_at<std::uint32_t>(bytes);
}

/// Reads the components of an element as floats.
void read_element(const tinygltf::Accessor& accessor, const unsigned char* bytes, float* values) {
  const std::size_t components = components_of(accessor);
  if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
    std::memcpy(values, bytes, components * sizeof(float));
    return;
  }
  const std::size_t size = component_bytes(accessor.componentType);
  for (std::size_t i = 0; i < components; ++i) {
    values[i] = float_at(bytes + i * size, accessor.componentType, accessor.normalized);
  }
}

}  // namespace

std::nullopt_t GltfAccessors::fail(std::string_view message) {
  diagnostics_.error(grf::whole_file(file_.path), message);
  return std::nullopt;
}

const tinygltf::Accessor* GltfAccessors::find(int accessor) const {
  const auto index = static_cast<std::size_t>(accessor);
  const auto& all = file_.model.accessors;
  return accessor < 0 || index >= all.size() ? nullptr : &all[index];
}

std::size_t GltfAccessors::count(int accessor) const {
  const tinygltf::Accessor* found = find(accessor);
  return found == nullptr ? 0 : found->count;
}

bool GltfAccessors::has_components(int accessor, std::size_t components) const {
  const tinygltf::Accessor* found = find(accessor);
  return found != nullptr && components_of(*found) == components;
}

std::optional<std::size_t> GltfAccessors::checked_count(int index, std::size_t components, bool integers) {
  current_ = index;
  const tinygltf::Accessor* accessor = find(index);
  if (accessor == nullptr) return fail(fmt::format("there is no accessor {}", index));
  const bool of_a_kind =
      integers ? is_index_type(accessor->componentType) : component_bytes(accessor->componentType) != 0;
  if (!of_a_kind) {
    return fail(fmt::format("accessor {}: components of type {} are not allowed here", index,
                            accessor->componentType));
  }
  if (components_of(*accessor) != components) {
    return fail(fmt::format("accessor {}: found {} per element, expected {}", index,
                            counted(components_of(*accessor), "number", "numbers"), components));
  }
  // Only sparse accessors may have no buffer; their other elements are zero.
  if (accessor->bufferView < 0 && accessor->count > file_.bytes) {
    return fail(fmt::format("accessor {}: {} elements without data", index, accessor->count));
  }
  if (accessor->bufferView < 0 && !accessor->sparse.isSparse) {
    return fail(fmt::format("accessor {} has no data", index));
  }
  if (!run_of(*accessor)) return std::nullopt;
  if (!spend(accessor->count)) return std::nullopt;
  return accessor->count;
}

std::optional<std::span<const unsigned char>> GltfAccessors::view(int index) {
  const auto& views = file_.model.bufferViews;
  if (index < 0 || static_cast<std::size_t>(index) >= views.size()) {
    return fail(fmt::format("there is no buffer view {}", index));
  }
  const tinygltf::BufferView& view = views[static_cast<std::size_t>(index)];
  const auto& buffers = file_.model.buffers;
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers.size()) {
    return fail(fmt::format("buffer view {}: there is no buffer {}", index, view.buffer));
  }
  const auto& data = buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
    return fail(fmt::format("buffer view {}: {} from byte {} of a buffer that has {}", index,
                            counted(view.byteLength, "byte", "bytes"), view.byteOffset, data.size()));
  }
  return std::span(data).subspan(view.byteOffset, view.byteLength);
}

std::optional<GltfAccessors::Run> GltfAccessors::run_of(int index, std::size_t offset, std::size_t count,
                                                        std::size_t element, bool may_have_stride) {
  const auto bytes = view(index);
  if (!bytes) return std::nullopt;
  const std::size_t stride = file_.model.bufferViews[static_cast<std::size_t>(index)].byteStride;
  Run run;
  run.stride = may_have_stride && stride != 0 ? stride : element;
  if (run.stride < element) {
    return fail(fmt::format("accessor {}: elements of {}, {} from one to the next", current_,
                            counted(element, "byte", "bytes"), counted(run.stride, "byte", "bytes")));
  }
  const std::size_t size = bytes->size();
  const bool fits = count == 0 || (element <= size && offset <= size - element &&
                                   count - 1 <= (size - element - offset) / run.stride);
  if (!fits) {
    return fail(fmt::format("accessor {}: {} from byte {} {} beyond the {} of buffer view {}", current_,
                            counted(count, "element", "elements"), offset, count == 1 ? "goes" : "go",
                            counted(size, "byte", "bytes"), index));
  }
  run.bytes = bytes->data() + offset;
  return run;
}

std::optional<GltfAccessors::Run> GltfAccessors::run_of(const tinygltf::Accessor& accessor) {
  if (accessor.bufferView < 0) return Run();
  return run_of(accessor.bufferView, accessor.byteOffset, accessor.count, element_bytes(accessor), true);
}

std::optional<std::vector<std::uint32_t>> GltfAccessors::sparse_indices(const tinygltf::Accessor& accessor) {
  const auto& sparse = accessor.sparse;
  if (!is_index_type(sparse.indices.componentType) || sparse.count < 0 || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0) {
    return fail(fmt::format("accessor {}: its sparse values have no places", current_));
  }
  const std::size_t size = component_bytes(sparse.indices.componentType);
  const auto count = static_cast<std::size_t>(sparse.count);
  const auto run = run_of(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                          count, size, false);
  if (!run || !spend(count)) return std::nullopt;
  std::vector<std::uint32_t> indices(count);
  for (std::size_t i = 0; i < count; ++i) {
    indices[i] = integer_at(run->bytes + i * size, sparse.indices.componentType);
    if (indices[i] >= accessor.count) {
      return fail(fmt::format("accessor {}: a sparse value for element {} of {}", current_, indices[i],
                              accessor.count));
    }
  }
  return indices;
}

template <class Put>
bool GltfAccessors::for_sparse(const tinygltf::Accessor& accessor, const Put& put) {
  if (!accessor.sparse.isSparse) return true;
  const auto indices = sparse_indices(accessor);
  if (!indices) return false;
  const auto run =
      run_of(accessor.sparse.values.bufferView, static_cast<std::size_t>(accessor.sparse.values.byteOffset),
             indices->size(), element_bytes(accessor), false);
  if (!run) return false;
  for (std::size_t i = 0; i < indices->size(); ++i) put((*indices)[i], run->bytes + i * run->stride);
  return true;
}

// The accessor was validated.
bool GltfAccessors::fill(int index, float* values, bool infinite) {
  const tinygltf::Accessor& accessor = *find(index);
  const std::size_t components = components_of(accessor);
  const auto run = run_of(accessor);
  if (!run) return false;
  if (accessor.count == 0) return true;
  const bool is_packed =
      run->stride == components * sizeof(float) && accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (run->bytes == nullptr) {
    std::fill_n(values, accessor.count * components, 0.0F);
  } else if (is_packed) {
    std::memcpy(values, run->bytes, accessor.count * run->stride);
  } else {
    for (std::size_t i = 0; i < accessor.count; ++i) {
      read_element(accessor, run->bytes + i * run->stride, values + i * components);
    }
  }
  const bool filled = for_sparse(accessor, [&](std::uint32_t element, const unsigned char* bytes) {
    read_element(accessor, bytes, values + element * components);
  });
  if (!filled) return false;
  const float* end = values + accessor.count * components;
  const float* bad =
      infinite ? end : std::find_if<const float*>(values, end, [](float x) { return !std::isfinite(x); });
  if (bad == end) return true;
  fail(fmt::format("accessor {}: element {} is infinite or not a number", index,
                   static_cast<std::size_t>(bad - values) / components));
  return false;
}

std::optional<std::vector<float>> GltfAccessors::floats(int accessor, std::size_t components, bool infinite) {
  const auto count = checked_count(accessor, components, false);
  if (!count) return std::nullopt;
  std::vector<float> values(*count * components);
  if (!fill(accessor, values.data(), infinite)) return std::nullopt;
  return values;
}

std::optional<std::vector<std::uint32_t>> GltfAccessors::integers(int index) {
  const auto count = checked_count(index, 1, true);
  if (!count) return std::nullopt;
  const tinygltf::Accessor& accessor = *find(index);
  const auto run = run_of(accessor);
  if (!run) return std::nullopt;
  std::vector<std::uint32_t> values(*count);
  if (run->bytes != nullptr) {
    for (std::size_t i = 0; i < *count; ++i) {
      values[i] = integer_at(run->bytes + i * run->stride, accessor.componentType);
    }
  }
  const bool filled = for_sparse(accessor, [&](std::uint32_t element, const unsigned char* bytes) {
    values[element] = integer_at(bytes, accessor.componentType);
  });
  if (!filled) return std::nullopt;
  return values;
}

bool GltfAccessors::spend(std::size_t elements) {
  // Meshes share accessors, and some files have many small equal ones; no valid file is near this limit.
  constexpr std::size_t MostPerByte = 256;
  constexpr std::size_t AlwaysAllowed = std::size_t{1} << 27U;
  const std::size_t limit = std::min(MostPerByte * file_.bytes, std::max(AlwaysAllowed, 8 * file_.bytes));
  if (elements <= limit && spent_ <= limit - elements) {
    spent_ += elements;
    return true;
  }
  fail(fmt::format("the file expands to more than {} vertices and corners, too many for its {} bytes", limit,
                   file_.bytes));
  return false;
}

}  // namespace convert
