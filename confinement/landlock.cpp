#include "confinement/landlock.h"

#include <array>
#include <cstdint>
#include <utility>

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace confinement {
namespace {

// Debian 12 has the header of version 2, and kernels that are newer than its own have more.
constexpr std::uint64_t Truncate = 1U << 14U;           // since version 3
constexpr std::uint64_t ControlDevices = 1U << 15U;     // since version 5
constexpr std::uint64_t TcpBindAndConnect = 3;          // since version 4
constexpr std::uint64_t AbstractSocketsAndSignals = 3;  // since version 6

/// The newest form of landlock_ruleset_attr; older kernels take the first part.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scoped = 0;
};

constexpr std::uint64_t Read = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t Write = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_REFER | Truncate;
constexpr std::uint64_t OfFiles = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE | Truncate;
constexpr std::uint64_t Never = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM | ControlDevices;

/// What libraries open later than at the start: other libraries, locales and conversions of text; the number
/// of processors; the limits of the stack.
constexpr std::array SystemPaths = {
    "/usr", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/localtime", "/proc/self", "/sys/devices/system/cpu"};

RulesetAttributes attributes_of(int version) {
  RulesetAttributes attributes;
  attributes.files = Read | Write | Never;
  if (version < 2) attributes.files &= ~std::uint64_t(LANDLOCK_ACCESS_FS_REFER);
  if (version < 3) attributes.files &= ~Truncate;
  if (version < 5) attributes.files &= ~ControlDevices;
  if (version >= 4) attributes.network = TcpBindAndConnect;
  if (version >= 6) attributes.scoped = AbstractSocketsAndSignals;
  return attributes;
}

std::size_t size_of(int version) {
  if (version < 4) return sizeof(std::uint64_t);
  return version < 6 ? 2 * sizeof(std::uint64_t) : sizeof(RulesetAttributes);
}

void allow(int ruleset, const char* path, std::uint64_t access) {
  const int place = ::open(path, O_PATH | O_CLOEXEC);
  if (place < 0) return;
  struct stat status = {};
  if (::fstat(place, &status) == 0) {
    landlock_path_beneath_attr rule = {};
    rule.allowed_access = S_ISDIR(status.st_mode) ? access : access & OfFiles;
    rule.parent_fd = place;
    static_cast<void>(::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0));
  }
  ::close(place);
}

}  // namespace

int landlock_version() {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

int confine_files(const Policy& policy) {
  const int version = landlock_version();
  if (version == 0) return 0;
  const RulesetAttributes attributes = attributes_of(version);
  const auto ruleset =
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, size_of(version), 0));
  if (ruleset < 0) return 0;
  for (const char* path : SystemPaths) allow(ruleset, path, Read);
  for (const std::string& path : policy.readable) allow(ruleset, path.c_str(), Read);
  for (const std::string& path : policy.writable) allow(ruleset, path.c_str(), Write & attributes.files);
  const bool is_confined = ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  ::close(ruleset);
  return is_confined ? version : 0;
}

}  // namespace confinement
