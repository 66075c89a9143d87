#include "renderer/transport/checkpoint_frame.h"

#include <bit>
#include <type_traits>

#include <fmt/format.h>
#include <zlib.h>

namespace transport {
namespace {

// The file consists of this start, the contents, and a check sum of both. Numbers are little-endian, as on
// the machines that we build for.
static_assert(std::endian::native == std::endian::little);

struct Start {
  std::array<char, 8> magic;
  Fingerprint fingerprint;
};
static_assert(std::is_trivially_copyable_v<Start> && sizeof(Start) == 8 + 3 * 32,
              "the file has no gaps of unknown content");

/// Returns why a file is not a valid checkpoint; empty if it is one.
std::string defect_of(std::string_view bytes, const CheckpointKind& kind) {
  const auto& magic = kind.magic;
  if (bytes.size() < magic.size() || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
    return fmt::format("it is not a {} of this version of bpt", kind.file);
  }
  if (bytes.size() < sizeof(Start) + sizeof(std::uint32_t)) return "it is damaged (unexpected end of file)";
  const std::size_t content = bytes.size() - sizeof(std::uint32_t);
  std::uint32_t expected = 0;
  std::memcpy(&expected, bytes.data() + content, sizeof(expected));
  return check_sum(0, bytes.substr(0, content)) == expected
             ? ""
             : "it is damaged (truncated, or bytes were changed)";
}

/// Returns why a checkpoint belongs to another result; empty if it does not.
std::string difference_between(const Fingerprint& found, const Fingerprint& expected,
                               const CheckpointKind& kind) {
  if (found.files != expected.files) return mismatch_reason(kind, "of a scene with other contents");
  if (found.options != expected.options) return mismatch_reason(kind, "with other options");
  if (found.program != expected.program) return mismatch_reason(kind, "by another build of bpt");
  return "";
}

/// Writes a checkpoint whose contents `fill` writes.
bool put_frame(const grf::FileWriter& write, const CheckpointKind& kind, const Fingerprint& fingerprint,
               const std::function<bool(const grf::FileWriter&)>& fill) {
  std::uint32_t sum = 0;
  const grf::FileWriter put = [&](std::string_view bytes) {
    sum = check_sum(sum, bytes);
    return write(bytes);
  };
  return put(bytes_of(Start{kind.magic, fingerprint})) && fill(put) && write(bytes_of(sum));
}

}  // namespace

std::uint32_t check_sum(std::uint32_t before, std::string_view bytes) {
  if (bytes.empty()) return before;  // crc32_z starts anew where there is no address
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

bool write_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                            const Fingerprint& fingerprint,
                            const std::function<bool(const grf::FileWriter&)>& fill,
                            grf::Diagnostics& diagnostics) {
  const auto fill_all = [&](const grf::FileWriter& write) {
    return put_frame(write, kind, fingerprint, fill);
  };
  return grf::replace_file(path, fill_all, diagnostics);
}

std::string checkpoint_frame(const CheckpointKind& kind, const Fingerprint& fingerprint,
                             const std::function<bool(const grf::FileWriter&)>& fill) {
  std::string bytes;
  const auto append = [&](std::string_view more) {
    bytes += more;
    return true;
  };
  put_frame(append, kind, fingerprint, fill);
  return bytes;
}

std::optional<CheckpointContents> read_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                                                        grf::Diagnostics& diagnostics) {
  auto file = grf::read_file(path, diagnostics);
  return file ? parse_checkpoint_frame(std::move(file), path, kind, diagnostics) : std::nullopt;
}

std::optional<CheckpointContents> parse_checkpoint_frame(std::shared_ptr<const std::string> file,
                                                         const std::string& path, const CheckpointKind& kind,
                                                         grf::Diagnostics& diagnostics) {
  std::string_view bytes = *file;
  const std::string defect = defect_of(bytes, kind);
  if (!defect.empty()) {
    refuse_checkpoint(path, kind, defect, diagnostics);
    return std::nullopt;
  }
  Start start = {};
  take(bytes, &start, 1);
  bytes.remove_suffix(sizeof(std::uint32_t));
  return CheckpointContents{start.fingerprint, std::move(file), bytes};
}

std::optional<CheckpointContents> read_checkpoint_frame(const std::string& path, const CheckpointKind& kind,
                                                        const Fingerprint& fingerprint,
                                                        grf::Diagnostics& diagnostics) {
  auto contents = read_checkpoint_frame(path, kind, diagnostics);
  if (!contents) return std::nullopt;
  const std::string difference = difference_between(contents->fingerprint, fingerprint, kind);
  if (difference.empty()) return contents;
  refuse_checkpoint(path, kind, difference, diagnostics);
  return std::nullopt;
}

void refuse_checkpoint(const std::string& path, const CheckpointKind& kind, const std::string& why,
                       grf::Diagnostics& diagnostics) {
  diagnostics.error(grf::whole_file(path), fmt::format("{}: {}", kind.failure, why));
}

std::string mismatch_reason(const CheckpointKind& kind, std::string_view what) {
  return fmt::format("it belongs to a {} {}; remove it, or name another file, to start over", kind.name,
                     what);
}

}  // namespace transport
