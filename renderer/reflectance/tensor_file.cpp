#include "renderer/reflectance/tensor_file.h"

#include <bit>
#include <cassert>
#include <cstring>
#include <filesystem>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"

namespace reflectance {
namespace {

static_assert(std::endian::native == std::endian::little, "tensor files are little-endian");

constexpr std::string_view Magic("tensor_file\0", 12);

/// Takes values off the front of a file's bytes, each only if the bytes suffice.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  std::optional<Number> number() {
    const auto bytes = text(sizeof(Number));
    if (!bytes) return std::nullopt;
    Number value = 0;
    std::memcpy(&value, bytes->data(), sizeof(value));
    return value;
  }

  std::optional<std::string_view> text(std::size_t size) {
    if (size > rest_.size()) return std::nullopt;
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

 private:
  std::string_view rest_;
};

/// Returns the bytes of an array, or nothing if it is not within the file. No product can overflow: each is
/// checked against the file's size by division.
std::optional<std::string_view> array_bytes(std::string_view file, const Tensor& tensor,
                                            std::uint64_t offset) {
  if (offset > file.size()) return std::nullopt;
  const std::size_t most = file.size() - offset;
  std::size_t size = size_of(tensor.type);
  for (const std::size_t extent : tensor.shape) {
    if (extent != 0 && size > most / extent) return std::nullopt;
    size *= extent;
  }
  if (size > most) return std::nullopt;
  return file.substr(offset, size);
}

struct NamedTensor {
  std::string name;
  Tensor tensor;
};

/// Returns a name for messages: whatever is not printable ASCII becomes a question mark.
std::string printable(std::string name) {
  for (char& c : name) {
    if (c < ' ' || c > '~') c = '?';
  }
  return name;
}

/// Reads the description of one array, or returns nothing and says in `error` what is wrong with it.
std::optional<NamedTensor> read_tensor(ByteReader& reader, std::string_view file, std::string& error) {
  const auto fail = [&](std::string what) {
    error = std::move(what);
    return std::nullopt;
  };
  constexpr const char* Truncated = "it ends within its table of arrays";
  const auto name_length = reader.number<std::uint16_t>();
  const auto name = name_length ? reader.text(*name_length) : std::nullopt;
  const auto rank = name ? reader.number<std::uint16_t>() : std::nullopt;
  const auto type = rank ? reader.number<std::uint8_t>() : std::nullopt;
  const auto offset = type ? reader.number<std::uint64_t>() : std::nullopt;
  if (!offset) return fail(Truncated);
  NamedTensor named{std::string(*name), {}};
  if (*type < std::uint8_t(ElementType::UInt8) || *type > std::uint8_t(ElementType::Float64))
    return fail(fmt::format("its array '{}' has the unknown element type {}", printable(named.name), *type));
  if (*rank > TensorFile::MostDimensions)
    return fail(fmt::format("its array '{}' has {} dimensions", printable(named.name), *rank));
  named.tensor.type = ElementType(*type);
  for (int i = 0; i < *rank; ++i) {
    const auto extent = reader.number<std::uint64_t>();
    if (!extent) return fail(Truncated);
    named.tensor.shape.push_back(*extent);
  }
  const auto bytes = array_bytes(file, named.tensor, *offset);
  if (!bytes) return fail(fmt::format("its array '{}' is not within the file", printable(named.name)));
  named.tensor.bytes = *bytes;
  return named;
}

/// Returns the size of a regular file; 0 for others, which read_file reports.
std::uintmax_t size_of_file(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

}  // namespace

std::size_t size_of(ElementType type) {
  constexpr std::size_t Sizes[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};
  return Sizes[static_cast<std::size_t>(type)];
}

std::vector<float> Tensor::floats() const {
  if (type != ElementType::Float32) return {};
  std::vector<float> values(count());
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

const Tensor* TensorFile::find(std::string_view name) const {
  const auto found = tensors_.find(name);
  return found == tensors_.end() ? nullptr : &found->second;
}

std::optional<TensorFile> TensorFile::parse(std::shared_ptr<const std::string> bytes, std::string& error) {
  const auto fail = [&](std::string what) {
    error = std::move(what);
    return std::nullopt;
  };
  ByteReader reader(*bytes);
  if (reader.text(Magic.size()) != Magic) return fail("it does not start with 'tensor_file'");
  const auto major = reader.number<std::uint8_t>();
  const auto minor = reader.number<std::uint8_t>();
  const auto count = reader.number<std::uint32_t>();
  if (!major || !minor || !count) return fail("it ends within its header");
  if (*major != 1 || *minor != 0)
    return fail(fmt::format("its version is {}.{}, expected 1.0", *major, *minor));
  if (*count > MostTensors) return fail(fmt::format("it has {} arrays", *count));
  TensorFile file;
  for (std::uint32_t i = 0; i < *count; ++i) {
    auto named = read_tensor(reader, *bytes, error);
    if (!named) return std::nullopt;
    const auto [entry, is_new] = file.tensors_.try_emplace(named->name, std::move(named->tensor));
    if (!is_new) return fail(fmt::format("it has two arrays '{}'", printable(entry->first)));
  }
  file.bytes_ = std::move(bytes);
  return file;
}

std::optional<TensorFile> TensorFile::load(const std::string& path, grf::Diagnostics& diagnostics,
                                           const grf::SourceLocation& asked_for_at) {
  const auto fail = [&](const std::string& what) {
    diagnostics.error(asked_for_at.file ? asked_for_at : grf::whole_file(path),
                      fmt::format("'{}' is not an RGL BRDF file: {}", path, what));
    return std::nullopt;
  };
  const std::uintmax_t size = size_of_file(path);
  if (size > MostBytes) return fail(fmt::format("it has {} bytes, and at most {} are read", size, MostBytes));
  auto bytes = grf::read_file(path, diagnostics, asked_for_at);
  if (!bytes) return std::nullopt;
  std::string error;
  auto file = parse(std::move(bytes), error);
  if (!file) return fail(error);
  return file;
}

void TensorFileMaker::add(const std::string& name, const std::vector<std::size_t>& shape,
                          const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  entries_.push_back({name, ElementType::Float32, shape, std::move(bytes)});
}

void TensorFileMaker::add(const std::string& name, const std::string& bytes) {
  entries_.push_back({name, ElementType::UInt8, {bytes.size()}, bytes});
}

std::string TensorFileMaker::bytes() const {
  std::string file(Magic);
  const auto put = [&file](auto number) {
    file.append(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  put(std::uint8_t{1});
  put(std::uint8_t{0});
  put(static_cast<std::uint32_t>(entries_.size()));
  std::uint64_t offset = file.size();
  for (const Entry& entry : entries_) {
    constexpr std::size_t NumbersOfAnArray = 2 + 2 + 1 + 8;
    offset += NumbersOfAnArray + entry.name.size() + 8 * entry.shape.size();
  }
  for (const Entry& entry : entries_) {
    put(static_cast<std::uint16_t>(entry.name.size()));
    file += entry.name;
    put(static_cast<std::uint16_t>(entry.shape.size()));
    put(static_cast<std::uint8_t>(entry.type));
    put(offset);
    for (const std::size_t extent : entry.shape) put(std::uint64_t{extent});
    offset += entry.bytes.size();
  }
  for (const Entry& entry : entries_) file += entry.bytes;
  return file;
}

}  // namespace reflectance
