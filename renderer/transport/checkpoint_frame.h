// Checkpoints and part files share a file format: a fingerprint of what the file belongs to, and a check sum
// of its contents.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/text_file.h"

namespace transport {

/// Check sums of all that a result depends on besides its samples. Two runs are parts of one if all three
/// agree.
struct Fingerprint {
  std::uint32_t options = 0;
  std::uint32_t files = 0;    ///< contents of the scene's files
  std::uint32_t program = 0;  ///< another build may round differently

  bool operator==(const Fingerprint&) const = default;
};

/// Extends a check sum by bytes; the first call takes 0.
std::uint32_t check_sum(std::uint32_t before, std::string_view bytes);

/// A kind of checkpoint, such as that of a render or a bake.
struct CheckpointKind {
  std::array<char, 8> magic;             ///< first bytes of the file
  std::string_view name;                 ///< as messages call what it belongs to, such as `render`
  std::string_view file = "checkpoint";  ///< as they call the file
  std::string_view failure = "cannot resume from the checkpoint";  ///< how they begin
};

/// Replaces the file with a checkpoint whose contents `fill` writes, or leaves it unchanged and reports why.
bool write_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                            const Fingerprint& fingerprint,
                            const std::function<bool(const grf::FileWriter&)>& fill,
                            grf::Diagnostics& diagnostics);

struct CheckpointContents {
  Fingerprint fingerprint;
  std::shared_ptr<const std::string> file;  ///< holds the bytes
  std::string_view bytes;                   ///< the bytes that `fill` wrote
};

/// Reads an existing checkpoint. A damaged one, or one of something else, is an error.
std::optional<CheckpointContents> read_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                                                        const Fingerprint& fingerprint,
                                                        grf::Diagnostics& diagnostics);

/// Reads a checkpoint of anything. A damaged one is an error.
std::optional<CheckpointContents> read_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                                                        grf::Diagnostics& diagnostics);

/// Reports why a checkpoint cannot be used.
void refuse_checkpoint(const std::string& path, const CheckpointKind& kind, const std::string& why,
                       grf::Diagnostics& diagnostics);

/// Returns why a checkpoint of the same scene, but with other options, cannot be used.
std::string mismatch_reason(const CheckpointKind& kind, std::string_view what);

template <class T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

template <class T>
std::string_view bytes_of_all(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Moves values from the front of bytes that are known to be long enough.
template <class T>
void take(std::string_view& bytes, T* values, std::size_t count) {
  if (count == 0) return;  // an empty vector has no address, which memcpy asks for
  std::memcpy(static_cast<void*>(values), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
}

}  // namespace transport
