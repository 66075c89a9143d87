// What all checkpoints have in common: a file that says what it belongs to, and that shows if it was changed.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"
#include "grf/text_file.h"

namespace transport {

/// What a result depends on besides its samples: check sums that whoever asks for it makes. Two runs of which
/// all three agree are parts of one.
struct Fingerprint {
  std::uint32_t options = 0;
  std::uint32_t files = 0;    ///< what the scene's files hold
  std::uint32_t program = 0;  ///< another build may round differently

  bool operator==(const Fingerprint&) const = default;
};

/// Adds bytes to a check sum that started as 0.
std::uint32_t check_sum(std::uint32_t before, std::string_view bytes);

/// What a checkpoint is of.
struct CheckpointKind {
  std::array<char, 8> magic;  ///< its first bytes
  std::string_view name;      ///< as messages say it, `render`
};

/// Replaces the file by a checkpoint whose contents `fill` writes, or leaves it as it was and says why.
bool write_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                            const Fingerprint& fingerprint,
                            const std::function<bool(const grf::FileWriter&)>& fill,
                            grf::Diagnostics& diagnostics);

struct CheckpointContents {
  std::shared_ptr<const std::string> file;  ///< holds the bytes
  std::string_view bytes;                   ///< what `fill` wrote
};

/// What an existing checkpoint holds. One that is broken or belongs to something else is an error.
std::optional<CheckpointContents> read_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                                                        const Fingerprint& fingerprint,
                                                        grf::Diagnostics& diagnostics);

/// Reports why a checkpoint is of no use.
void refuse_checkpoint(const std::string& path, const std::string& why, grf::Diagnostics& diagnostics);

/// Why one of the same scene, but with other options, is refused.
std::string belongs_elsewhere(const CheckpointKind& kind, std::string_view what);

template <class T>
std::string_view bytes_of(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

/// Takes values off the front of bytes that are known to be long enough.
template <class T>
void take(std::string_view& bytes, T* values, std::size_t count) {
  std::memcpy(static_cast<void*>(values), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
}

}  // namespace transport
