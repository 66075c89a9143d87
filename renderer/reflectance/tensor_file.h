#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace reflectance {

/// The element types of a tensor file, by their numbers in it.
enum class ElementType : std::uint8_t {
  UInt8 = 1,
  Int8,
  UInt16,
  Int16,
  UInt32,
  Int32,
  UInt64,
  Int64,
  Float16,
  Float32,
  Float64
};

/// Returns the size of an element in bytes.
std::size_t size_of(ElementType type);

/// An array of a tensor file, whose elements follow each other with the last index fastest.
struct Tensor {
  ElementType type = ElementType::UInt8;
  std::vector<std::size_t> shape;
  std::string_view bytes;  ///< the elements in little-endian order, at any alignment, kept by the file

  std::size_t count() const { return bytes.size() / size_of(type); }  ///< Returns the number of elements.

  /// Returns the elements of a Float32 array, or nothing for another type.
  std::vector<float> floats() const;
};

/// A file of named arrays, the container of the RGL material data base (Dupuy and Jakob 2018): the text
/// "tensor_file" and a 0, version 1.0, the number of arrays, and for each its name, element type, offset and
/// shape.
class TensorFile {
 public:
  static constexpr std::size_t MostBytes = std::size_t(1) << 30U;
  static constexpr std::size_t MostTensors = 256;
  static constexpr std::size_t MostDimensions = 16;

  /// Loads a file of at most MostBytes, or returns nothing after an error: missing file, wrong header or
  /// version, an unknown type, a name twice, or an array that is not within the file. Memory beyond the
  /// file's own size is needed for the table of arrays only.
  static std::optional<TensorFile> load(const std::string& path, grf::Diagnostics& diagnostics,
                                        const grf::SourceLocation& asked_for_at = {});

  /// Reads a file's bytes, or returns nothing and says in `error` what is wrong with them.
  static std::optional<TensorFile> parse(std::shared_ptr<const std::string> bytes, std::string& error);

  /// Finds an array by its name; null if there is none.
  const Tensor* find(std::string_view name) const;

 private:
  std::shared_ptr<const std::string> bytes_;
  std::map<std::string, Tensor, std::less<>> tensors_;
};

/// Makes the bytes of a tensor file from arrays.
class TensorFileMaker {
 public:
  /// Adds an array of numbers, the last index fastest; the shape must have as many elements.
  void add(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<float>& values);
  /// Adds an array of bytes.
  void add(const std::string& name, const std::string& bytes);

  std::string bytes() const;  ///< Returns the file's bytes.

 private:
  struct Entry {
    std::string name;
    ElementType type = ElementType::UInt8;
    std::vector<std::size_t> shape;
    std::string bytes;
  };
  std::vector<Entry> entries_;
};

}  // namespace reflectance
