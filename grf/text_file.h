// Functions that read and atomically replace whole files, and report errors as diagnostics.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace grf {

/// The UTF-8 byte-order mark, which some editors write before the text; it is no part of the text.
inline constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

/// Reads the bytes of a regular file. A diagnostic at `asked_for_at` (or, if that names no file, at the file
/// itself) says why it cannot be read: it is missing, a directory, a pipe or a device, lacks permission, or
/// was changed by another program meanwhile. Files are not memory-mapped: if one were truncated, the program
/// would crash.
std::shared_ptr<const std::string> read_file(const std::string& path, Diagnostics& diagnostics,
                                             const SourceLocation& asked_for_at = {});

/// Replaces the file's contents atomically, or leaves it unchanged and reports why: a temporary file beside
/// it is written, synced to disk and renamed over it.
bool replace_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics);

/// Appends bytes to a file that is being written; returns false if that failed.
using FileWriter = std::function<bool(std::string_view bytes)>;

/// Replaces a file too large for memory likewise: `fill` writes it in chunks, and returns false as soon as
/// that fails.
bool replace_file(const std::string& path, const std::function<bool(const FileWriter& write)>& fill,
                  Diagnostics& diagnostics);

enum class Creation { Done, Exists, Failed };  ///< What became of a file that was to be created.

/// Creates a file atomically. If it exists by then, it stays unchanged and nothing is reported.
Creation create_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics);

/// Removes the temporary files of a process that died while it was replacing or creating files in a folder.
void remove_temporary_files(const std::string& folder, int process);

/// A file to be written: its path, and the function that writes its bytes.
struct NewFile {
  std::string path;
  std::function<bool(const FileWriter& write)> fill;
};

/// Replaces several files together: all are written and synced to disk before the first one is renamed, so
/// that an error leaves all of them unchanged.
bool replace_files(const std::vector<NewFile>& files, Diagnostics& diagnostics);

/// Resolves a file name in another file: relative names start at that file's folder, and both `/` and `\` are
/// separators.
std::string path_beside(const std::string& naming_file, std::string_view name);

/// Returns the name of a file without its folders.
std::string file_name(const std::string& path);

/// Returns whether a file's name ends in `.igrf`: it carries irradiance.
bool is_igrf_name(const std::string& path);

/// Returns the canonical path of a file, whether or not it exists.
std::string canonical_path(const std::string& path);

}  // namespace grf
