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
#include "renderer/transport/digest.h"

namespace transport {

/// Digests of all that a result depends on besides its samples. Two runs are parts of one if all three agree.
struct Fingerprint {
  Digest options = {};
  Digest files = {};    ///< contents of the scene's files
  Digest program = {};  ///< another build may round differently

  bool operator==(const Fingerprint&) const = default;
};

/// Extends a check sum (CRC-32) by bytes; the first call takes 0. It finds damage, and names nothing.
std::uint32_t check_sum(std::uint32_t before, std::string_view bytes);

/// A kind of checkpoint, such as that of a render or a bake.
struct CheckpointKind {
  std::array<char, 8> magic;             ///< first bytes of the file
  std::string_view name;                 ///< as messages call what it belongs to, such as `render`
  std::string_view file = "checkpoint";  ///< as they call the file
  std::string_view failure = "cannot resume from the checkpoint";  ///< how they begin
};

/// Returns a checkpoint whose contents `fill` writes, which cannot fail, as bytes.
std::string checkpoint_frame(const CheckpointKind& kind, const Fingerprint& fingerprint,
                             const std::function<bool(const grf::FileWriter&)>& fill);

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

/// Reads the bytes of a checkpoint of anything likewise; messages name where they come from.
std::optional<CheckpointContents> parse_checkpoint_frame(std::shared_ptr<const std::string> file,
                                                         const std::string& path, const CheckpointKind& kind,
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
