// A job's coordinator writes what it has into a ledger on disk.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "grf/diagnostics.h"

namespace farm {

/// A file to which records are appended. Each has a check sum: when the machine fails while one is written,
/// the ledger ends before that record. One process at a time has a ledger open.
class Ledger {
 public:
  /// Opens or creates a ledger, and calls `take` with each record that it has. A file that is no ledger, one
  /// that cannot be written, and one that another process has open are errors, and so is that `take` returns
  /// false.
  static std::optional<Ledger> open(const std::string& path,
                                    const std::function<bool(std::string_view record)>& take,
                                    grf::Diagnostics& diagnostics);
  Ledger(Ledger&& other) noexcept;
  Ledger& operator=(Ledger&& other) noexcept;
  ~Ledger();

  /// Appends a record; false, with the ledger as before, if that failed.
  bool append(std::string_view record);
  /// Waits until the records are on disk.
  bool sync() const;
  /// Calls `take` with each record again, up to the first for which it returns false.
  bool read(const std::function<bool(std::string_view record)>& take) const;

  const std::string& path() const { return path_; }

 private:
  Ledger(std::string path, int file) : path_(std::move(path)), file_(file) {}

  std::string path_;
  int file_ = -1;
  std::uint64_t end_ = 0;  ///< behind the last whole record
};

}  // namespace farm
