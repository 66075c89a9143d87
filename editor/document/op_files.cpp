#include "editor/document/op_files.h"

#include <QDir>
#include <QFileInfo>
#include <vector>

#include <fmt/format.h>

#include "grf/relocate.h"
#include "grf/text_file.h"
#include "renderer/options/op_text.h"

namespace editor {
namespace {

using options::OptionInfo;
using options::RenderOptions;

const options::PathOption* path_option(const OptionInfo& option) {
  return std::get_if<options::PathOption>(&option.value);
}

/// Whether the text sets the option to another value, or to an unreadable one.
bool has_other(const options::OpText& text, const RenderOptions& there, const RenderOptions& wanted,
               const OptionInfo& option) {
  if (option_words(there, option) != option_words(wanted, option)) return true;
  RenderOptions unused;
  const auto words = text.words_of(option);
  return words && set_option(unused, option, *words);
}

/// Returns an absolute path relative to a folder, so that both can be moved together; paths that climb far
/// stay.
std::string short_path(const QDir& folder, const std::string& path) {
  if (!QDir::isAbsolutePath(QString::fromStdString(path))) return path;
  const QString relative = folder.relativeFilePath(QString::fromStdString(path));
  return relative.startsWith(QStringLiteral("../../../")) ? path : relative.toStdString();
}

}  // namespace

QString op_file_beside(const QString& scene_path) {
  const QFileInfo scene(scene_path);
  return scene.dir().filePath(scene.completeBaseName() + ".op");
}

RenderOptions with_absolute_paths(RenderOptions render_options, const QString& scene_path) {
  const std::string beside = QFileInfo(scene_path).absoluteFilePath().toStdString();
  for (const OptionInfo& option : options::option_table()) {
    const auto* path = path_option(option);
    if (path == nullptr) continue;
    std::string& name = render_options.*(path->field);
    if (!name.empty()) name = grf::path_beside(beside, name);
  }
  return render_options;
}

std::optional<std::string> op_text_of(const RenderOptions& render_options, const QString& op_path,
                                      const std::string& before, grf::Diagnostics& diagnostics) {
  const QDir folder = QFileInfo(op_path).absoluteDir();
  options::OpText text(before);
  const RenderOptions there = with_absolute_paths(text.options(), op_path);
  for (const OptionInfo& option : options::option_table()) {
    if (!has_other(text, there, render_options, option)) continue;
    std::vector<std::string> words = option_words(render_options, option);
    for (std::string& word : words) {
      if (path_option(option) != nullptr) word = short_path(folder, word);
    }
    if (text.set(option, words)) continue;
    diagnostics.error(grf::whole_file(op_path.toStdString()),
                      fmt::format("{}: cannot write '{}' in an OP file", option.key, words.front()));
    return std::nullopt;
  }
  return text.text();
}

bool write_op_file(const RenderOptions& render_options, const QString& op_path,
                   grf::Diagnostics& diagnostics) {
  const std::string path = op_path.toStdString();
  std::string before;
  if (QFileInfo::exists(op_path)) {
    const auto bytes = grf::read_file(path, diagnostics);
    if (!bytes) return false;
    before = *bytes;
  }
  const auto text = op_text_of(render_options, op_path, before, diagnostics);
  return text && grf::replace_file(path, *text, diagnostics);
}

}  // namespace editor
