// Whole files in and out, with what can go wrong said in words.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grf/diagnostics.h"

namespace grf {

/// Some editors put this before UTF-8 text; it is no part of the text.
inline constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

/// Reads the bytes of a regular file. A diagnostic at `asked_for_at` (or, if that names no file, at the file
/// itself) says why it cannot be read: it is missing, a directory, a pipe or a device, may not be read, or
/// was changed by another program meanwhile. Files are not mapped into memory: one that became shorter would
/// end the program.
std::shared_ptr<const std::string> read_file(const std::string& path, Diagnostics& diagnostics,
                                             const SourceLocation& asked_for_at = {});

/// Replaces the file by the bytes, or leaves it as it was and says why: a temporary file beside it is
/// filled, forced to the disk and renamed over it.
bool replace_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics);

/// Appends bytes to a file that is being filled; false if that failed.
using FileWriter = std::function<bool(std::string_view bytes)>;

/// The same for a file too large to be held in memory: `fill` writes it in parts, and returns false as soon
/// as that fails.
bool replace_file(const std::string& path, const std::function<bool(const FileWriter& write)>& fill,
                  Diagnostics& diagnostics);

enum class Creation { Done, Exists, Failed };

/// Makes a file that did not exist, as a whole or not at all. If it exists, it stays as it is, whoever made
/// it in the meantime, and nothing is said.
Creation create_file(const std::string& path, std::string_view bytes, Diagnostics& diagnostics);

/// Removes what a process left in a folder that died while it was replacing or creating files there.
void remove_temporary_files(const std::string& folder, int process);

/// A file to be written: where, and what fills it.
struct NewFile {
  std::string path;
  std::function<bool(const FileWriter& write)> fill;
};

/// Replaces files that belong together: all are filled and forced to the disk before the first one takes its
/// place, so that what goes wrong leaves all of them as they were.
bool replace_files(const std::vector<NewFile>& files, Diagnostics& diagnostics);

/// The path of a file that is named in another one: relative names start at that one's folder, and both
/// kinds of separators are understood.
std::string path_beside(const std::string& naming_file, std::string_view name);

/// Whether a file's name says that it carries irradiance.
bool is_igrf_name(const std::string& path);

/// One spelling for each file, whether or not it exists.
std::string canonical_path(const std::string& path);

}  // namespace grf
