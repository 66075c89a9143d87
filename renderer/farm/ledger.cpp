#include "renderer/farm/ledger.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "renderer/transport/checkpoint_frame.h"

namespace farm {
namespace {

constexpr std::string_view LedgerMagic = "GRFLGR01";
constexpr std::uint64_t LargestRecord = std::uint64_t{1} << 32U;

/// What precedes each record.
struct RecordStart {
  std::uint64_t bytes = 0;
  std::uint32_t check_sum = 0;  ///< of the record
  std::uint32_t unused = 0;
};

/// Reads bytes at an offset; false if there are not so many.
bool read_at(int file, std::uint64_t offset, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t read = ::pread(file, bytes, count, static_cast<off_t>(offset));
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    bytes += read;
    offset += static_cast<std::uint64_t>(read);
    count -= static_cast<std::size_t>(read);
  }
  return true;
}

bool write_at(int file, std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    offset += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Reads the record at an offset, and moves the offset behind it; false if there is no whole one.
bool read_record(int file, std::uint64_t& offset, std::string& record) {
  RecordStart start;
  if (!read_at(file, offset, reinterpret_cast<char*>(&start), sizeof(start))) return false;
  const off_t size = ::lseek(file, 0, SEEK_END);
  const std::uint64_t from = offset + sizeof(start);
  if (start.bytes > LargestRecord || size < 0 || from + start.bytes > static_cast<std::uint64_t>(size)) {
    return false;
  }
  record.resize(static_cast<std::size_t>(start.bytes));
  if (!read_at(file, from, record.data(), record.size())) return false;
  if (transport::check_sum(0, record) != start.check_sum) return false;
  offset = from + start.bytes;
  return true;
}

}  // namespace

std::optional<Ledger> Ledger::open(const std::string& path,
                                   const std::function<bool(std::string_view record)>& take,
                                   grf::Diagnostics& diagnostics) {
  const auto fail = [&](std::string_view why) {
    diagnostics.error(grf::whole_file(path), why);
    return std::nullopt;
  };
  const auto reason = [] { return std::generic_category().message(errno); };
  Ledger ledger(path, ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (ledger.file_ < 0) return fail(fmt::format("cannot open the ledger: {}", reason()));
  if (::flock(ledger.file_, LOCK_EX | LOCK_NB) != 0) {
    return fail("another process has the ledger open: the image is being rendered");
  }
  ledger.end_ = LedgerMagic.size();
  std::array<char, LedgerMagic.size()> magic = {};
  const bool is_new = ::lseek(ledger.file_, 0, SEEK_END) == 0;
  if (is_new && !write_at(ledger.file_, 0, LedgerMagic)) {
    return fail(fmt::format("cannot write the ledger: {}", reason()));
  }
  if (!read_at(ledger.file_, 0, magic.data(), magic.size()) ||
      std::string_view(magic.data(), magic.size()) != LedgerMagic) {
    return fail("it is no ledger of this version of bpt; remove it, or name another output");
  }
  std::string record;
  while (read_record(ledger.file_, ledger.end_, record)) {
    if (!take(record)) return std::nullopt;
  }
  // What follows was being written when the machine or the process failed.
  if (::ftruncate(ledger.file_, static_cast<off_t>(ledger.end_)) != 0) {
    return fail(fmt::format("cannot write the ledger: {}", reason()));
  }
  return ledger;
}

Ledger::Ledger(Ledger&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), end_(other.end_) {}

Ledger& Ledger::operator=(Ledger&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(file_, other.file_);
  std::swap(end_, other.end_);
  return *this;
}

Ledger::~Ledger() {
  if (file_ >= 0) ::close(file_);
}

bool Ledger::append(std::string_view record) {
  const RecordStart start{record.size(), transport::check_sum(0, record), 0};
  const bool is_written =
      write_at(file_, end_, transport::bytes_of(start)) && write_at(file_, end_ + sizeof(start), record);
  if (is_written) end_ += sizeof(start) + record.size();
  return is_written;
}

bool Ledger::sync() const { return ::fdatasync(file_) == 0; }

bool Ledger::read(const std::function<bool(std::string_view record)>& take) const {
  std::string record;
  std::uint64_t offset = LedgerMagic.size();
  while (offset < end_) {
    if (!read_record(file_, offset, record) || !take(record)) return false;
  }
  return true;
}

}  // namespace farm
