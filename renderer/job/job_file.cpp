#include "renderer/job/job_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include "grf/text_file.h"

namespace job {
namespace {

namespace fs = std::filesystem;

/// A file of a job.
struct PackedFile {
  std::string name;  ///< in the archive
  std::string bytes;
};

fs::path absolute(const std::string& path) { return fs::absolute(path).lexically_normal(); }

/// Returns the deepest folder that all of these files are in.
fs::path common_folder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  for (const fs::path& file : files) {
    const fs::path folder = file.parent_path();
    const auto [end, ignored] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    fs::path shorter;
    for (auto part = common.begin(); part != end; ++part) shorter /= *part;
    common = shorter;
  }
  return common;
}

bool is_scene(const fs::path& file) { return file.extension() == ".grf" || file.extension() == ".igrf"; }

/// Replaces absolute names of files, which are in quotes in GRF, by names relative to the file that names
/// them.
std::string with_relative_names(std::string text, const fs::path& naming,
                                const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    const std::string absolute_name = "\"" + file.string() + "\"";
    const std::string relative_name =
        "\"" + file.lexically_relative(naming.parent_path()).generic_string() + "\"";
    for (std::size_t at = 0; (at = text.find(absolute_name, at)) != std::string::npos;
         at += relative_name.size()) {
      text.replace(at, absolute_name.size(), relative_name);
    }
  }
  return text;
}

/// Sets the options that name files relative to the OP file, and removes those of outputs and of the machine.
void make_portable(const fs::path& op_path, options::OpText& op_text) {
  for (const options::OptionInfo& option : options::option_table()) {
    const auto* path = std::get_if<options::PathOption>(&option.value);
    const bool is_input = names_input(option);
    const bool is_of_machine = (path != nullptr && !is_input) || option.key == "BPT_DisplayWindow" ||
                               option.key == "BPT_DisplayServer" || option.key == "BPT_Threads";
    if (is_of_machine) op_text.remove(option);
    const auto words = op_text.words_of(option);
    if (!is_input || !words || words->size() != 1) continue;
    const fs::path file = absolute(grf::path_beside(op_path.string(), words->front()));
    op_text.set(option, {file.lexically_relative(op_path.parent_path()).generic_string()});
  }
}

struct FreeWriter {
  void operator()(archive* a) const { archive_write_free(a); }
};
struct FreeReader {
  void operator()(archive* a) const { archive_read_free(a); }
};
struct FreeEntry {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

la_ssize_t append(archive* /*unused*/, void* bytes, const void* block, std::size_t size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(block), size);
  return static_cast<la_ssize_t>(size);
}

/// Returns a tar archive without times and owners. Empty if that failed.
std::string archive_of(const std::vector<PackedFile>& files) {
  std::string bytes;
  const std::unique_ptr<archive, FreeWriter> writer(archive_write_new());
  archive_write_set_format_pax_restricted(writer.get());
  if (archive_write_open(writer.get(), &bytes, nullptr, append, nullptr) != ARCHIVE_OK) return {};
  for (const PackedFile& file : files) {
    const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
    archive_entry_set_pathname(entry.get(), file.name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), 0, 0);
    if (archive_write_header(writer.get(), entry.get()) != ARCHIVE_OK) return {};
    const la_ssize_t written = archive_write_data(writer.get(), file.bytes.data(), file.bytes.size());
    if (written != static_cast<la_ssize_t>(file.bytes.size())) return {};
  }
  return archive_write_close(writer.get()) == ARCHIVE_OK ? bytes : std::string();
}

/// Whether a name of an archive stays in the folder.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() && name.lexically_normal() == name &&
         std::ranges::find(name, fs::path("..")) == name.end();
}

/// Writes the current entry of an archive to a file; returns whether it is whole.
bool unpack_entry(archive* reader, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (fs::exists(to)) return false;
  std::ofstream file(to, std::ios::binary);
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  int result = ARCHIVE_OK;
  while ((result = archive_read_data_block(reader, &block, &size, &offset)) == ARCHIVE_OK) {
    file.seekp(offset);
    file.write(static_cast<const char*>(block), static_cast<std::streamsize>(size));
  }
  file.close();
  return result == ARCHIVE_EOF && file.good();
}

/// Whether a name in a file leads out of a folder that the file is in.
bool leads_outside(const fs::path& naming, std::string_view name, const fs::path& folder) {
  const fs::path file = absolute(grf::path_beside(naming.string(), name)).lexically_relative(folder);
  return file.empty() || *file.begin() == "..";
}

/// Returns a name in a scene that leads out of a folder; empty if there is none. Names are in quotes. As a
/// quote in a comment makes it uncertain which quotes begin names, whatever is between two of them counts.
std::string name_outside(std::string_view text, const fs::path& naming, const fs::path& folder) {
  std::size_t from = text.find('"');
  while (from != std::string_view::npos) {
    const std::size_t end = text.find('"', from + 1);
    if (end == std::string_view::npos) break;
    const std::string_view name = text.substr(from + 1, end - from - 1);
    const bool is_line = name.find('\n') == std::string_view::npos;
    if (is_line && leads_outside(naming, name, folder)) return std::string(name);
    from = end;
  }
  return "";
}

/// Returns a name in an OP file that leads out of a folder, of those files that a render reads; empty if
/// there is none.
std::string input_outside(const options::OpText& op_text, const fs::path& op, const fs::path& folder) {
  for (const options::OptionInfo& option : options::option_table()) {
    const auto words = names_input(option) ? op_text.words_of(option) : std::nullopt;
    if (words && words->size() == 1 && leads_outside(op, words->front(), folder)) return words->front();
  }
  return "";
}

}  // namespace

bool names_input(const options::OptionInfo& option) {
  return option.key == "BPT_Scene" || option.key == "BPT_EM_Background";
}

bool pack_job(const std::string& op_path, options::OpText op_text, const std::set<std::string>& files,
              const std::string& output, grf::Diagnostics& diagnostics) {
  const fs::path op = absolute(op_path);
  std::vector<fs::path> paths = {op};
  for (const std::string& file : files) {
    if (!file.ends_with(".op")) paths.push_back(absolute(file));
  }
  std::ranges::sort(paths.begin() + 1, paths.end());
  const fs::path folder = common_folder(paths);
  make_portable(op, op_text);
  std::vector<PackedFile> packed = {{op.lexically_relative(folder).generic_string(), op_text.text()}};
  for (auto path = paths.begin() + 1; path != paths.end(); ++path) {
    const auto bytes = grf::read_file(path->string(), diagnostics);
    if (!bytes) return false;
    packed.push_back({path->lexically_relative(folder).generic_string(),
                      is_scene(*path) ? with_relative_names(*bytes, *path, paths) : *bytes});
  }
  const std::string bytes = archive_of(packed);
  if (!bytes.empty()) return grf::replace_file(output, bytes, diagnostics);
  diagnostics.error(grf::whole_file(output),
                    "cannot pack the job: a file has a name that no archive can have");
  return false;
}

std::optional<std::string> unpack_job(const std::string& path, const std::string& folder,
                                      grf::Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(grf::whole_file(path), "cannot unpack the job file: " + why);
    return std::nullopt;
  };
  const auto bytes = grf::read_file(path, diagnostics);
  if (!bytes) return std::nullopt;
  const std::unique_ptr<archive, FreeReader> reader(archive_read_new());
  archive_read_support_format_tar(reader.get());
  if (archive_read_open_memory(reader.get(), bytes->data(), bytes->size()) != ARCHIVE_OK) {
    return refuse("it is no archive");
  }
  std::optional<std::string> op_path;
  std::vector<fs::path> scenes;
  archive_entry* entry = nullptr;
  int result = ARCHIVE_OK;
  while ((result = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK) {
    const char* name = archive_entry_pathname(entry);
    if (name == nullptr || !stays_inside(name)) return refuse("it names a file outside of its folder");
    const bool is_link = archive_entry_hardlink(entry) != nullptr || archive_entry_symlink(entry) != nullptr;
    if (is_link || archive_entry_filetype(entry) != AE_IFREG) {
      return refuse(fmt::format("'{}' is not a regular file", name));
    }
    const fs::path to = fs::path(folder) / name;
    if (!unpack_entry(reader.get(), to))
      return refuse(fmt::format("'{}' is damaged, or cannot be written", name));
    if (!op_path) op_path = to.string();
    if (is_scene(to)) scenes.push_back(to);
  }
  if (result != ARCHIVE_EOF || !op_path || !op_path->ends_with(".op"))
    return refuse("it is damaged, or no job file");
  const fs::path top = absolute(folder);
  const auto op_text = grf::read_file(*op_path, diagnostics);
  if (!op_text) return std::nullopt;
  std::string outside = input_outside(options::OpText(*op_text), *op_path, top);
  for (auto scene = scenes.begin(); scene != scenes.end() && outside.empty(); ++scene) {
    const auto text = grf::read_file(scene->string(), diagnostics);
    if (!text) return std::nullopt;
    outside = name_outside(*text, *scene, top);
  }
  if (!outside.empty()) return refuse(fmt::format("its scene names '{}', outside of its folder", outside));
  return op_path;
}

bool are_inside(const std::set<std::string>& files, const std::string& folder) {
  std::error_code error;
  const fs::path top = fs::canonical(folder, error);
  return std::ranges::all_of(files, [&](const std::string& path) {
    const fs::path file = fs::canonical(path, error).lexically_relative(top);
    return !error && !file.empty() && *file.begin() != "..";
  });
}

}  // namespace job
