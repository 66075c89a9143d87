#include "editor/document/op_document.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <memory>
#include <vector>

#include "editor/document/op_files.h"
#include "grf/text_file.h"
#include "renderer/options/op_file.h"
#include "renderer/options/scheme_model.h"

namespace editor {

using options::OpText;
using options::OptionInfo;
using options::RenderOptions;

namespace {

/// The file to which the options' file names are relative; for an unsaved scene, in the current folder.
QString op_naming_path(const QString& path) { return path.isEmpty() ? QStringLiteral("untitled.op") : path; }

/// Makes the file names of a text relative to another folder.
std::string moved(const std::string& text, const QString& from_path, const QString& to_path) {
  const QString from = op_naming_path(from_path);
  const QString to = op_naming_path(to_path);
  if (QFileInfo(from).absolutePath() == QFileInfo(to).absolutePath()) return text;
  grf::Diagnostics ignored_diagnostics;  // unwritable values did not exist before
  return op_text_of(with_absolute_paths(OpText(text).options(), from), to, text, ignored_diagnostics)
      .value_or(text);
}

/// The first line that differs.
QString changed_line(const std::string& before, const std::string& after) {
  const auto first = std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first;
  return QString("line %1").arg(std::count(before.begin(), first, '\n'));
}

}  // namespace

/// An undo command. Option texts are short, so it stores both whole.
class OpDocument::Edit : public QUndoCommand {
 public:
  Edit(OpDocument& document, std::string after, const QString& title, QString key)
      : QUndoCommand(title),
        document_(document),
        before_(document.text_.text()),
        after_(std::move(after)),
        path_(document.path_),
        key_(std::move(key)),
        step_(document.step_) {}

  void undo() override {
    document_.finish_step();
    take(before_);
  }
  void redo() override { take(after_); }
  int id() const override { return 2; }  // 1 is that of a scene's steps

  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const Edit&>(*other);
    if (key_.isEmpty() || next.key_ != key_ || next.step_ != step_ || next.path_ != path_) return false;
    after_ = next.after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  void take(const std::string& text) {
    document_.is_edited_ = true;
    document_.take(moved(text, path_, document_.path_));
  }

  OpDocument& document_;
  std::string before_;
  std::string after_;
  QString path_;  ///< path to which the file names of both are relative
  QString key_;
  int step_;
};

OpDocument::OpDocument(EditStack* project, QObject* parent)
    : QObject(parent), stack_(project != nullptr ? project : &own_stack_) {
  check();
}

bool OpDocument::open(const QString& path, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(path.toStdString(), diagnostics);
  if (!text) return false;
  if (is_in_project()) {
    finish_step();
    push(OpText(moved(*text, path, path_)), tr("Open options"), {});
  } else {
    start(*text, path);
  }
  return true;
}

void OpDocument::open_beside(const QString& scene_path) {
  const QString path = scene_path.isEmpty() ? QString() : op_file_beside(scene_path);
  grf::Diagnostics problems;
  const auto text = QFileInfo::exists(path) ? grf::read_file(path.toStdString(), problems) : nullptr;
  start(text ? *text : std::string(), path, problems);
}

void OpDocument::start(const std::string& text, const QString& path, const grf::Diagnostics& problems) {
  own_stack_.clear();
  valid_options_ = with_absolute_paths(OpText(text).options(), op_naming_path(path));
  take_file(text, path);
  if (problems.error_count() > 0) diagnostics_ = problems;
  emit path_changed();
}

void OpDocument::take_file(const std::string& text, const QString& path) {
  path_ = path;
  read_text_ = text;
  is_edited_ = false;
  own_stack_.setClean();
  finish_step();
  take(text);
}

bool OpDocument::save(const QString& path, grf::Diagnostics& diagnostics) {
  const std::string text = is_in_project() ? moved(text_.text(), path_, path) : text_.text();
  if (!grf::replace_file(path.toStdString(), text, diagnostics)) return false;
  const bool is_other = path != path_;
  if (is_other && is_in_project()) return true;  // a copy
  take_file(text, path);
  if (is_other) emit path_changed();
  return true;
}

bool OpDocument::save_beside(const QString& scene_path, grf::Diagnostics& diagnostics) {
  const Snapshot now = snapshot();
  const auto text = write_beside(now, scene_path, diagnostics);
  if (text) take_written(now, scene_path, *text);
  return text.has_value();
}

std::optional<std::string> OpDocument::write_beside(const Snapshot& snapshot, const QString& scene_path,
                                                    grf::Diagnostics& diagnostics) {
  const QString path = op_file_beside(scene_path);
  std::string before = moved(snapshot.text, snapshot.path, path);
  if (QFileInfo::exists(path)) {
    const auto there = grf::read_file(path.toStdString(), diagnostics);
    if (!there) return std::nullopt;
    if (path != snapshot.path || *there != snapshot.read_text) before = *there;
  }
  RenderOptions wanted = snapshot.options;
  wanted.scene = QFileInfo(scene_path).absoluteFilePath().toStdString();
  auto text = op_text_of(wanted, path, before, diagnostics);
  if (text && !grf::replace_file(path.toStdString(), *text, diagnostics)) text.reset();
  return text;
}

void OpDocument::take_written(const Snapshot& snapshot, const QString& scene_path, const std::string& text) {
  const QString path = op_file_beside(scene_path);
  const bool is_other = path != path_;
  const std::string edited = text_.text() == snapshot.text ? std::string() : moved(text_.text(), path_, path);
  take_file(text, path);
  if (!edited.empty()) {
    is_edited_ = true;
    take(edited);
  }
  if (is_other) emit path_changed();
}

void OpDocument::set_words(const OptionInfo& option, const QStringList& words) {
  std::vector<std::string> plain;
  for (const QString& word : words) plain.push_back(word.toStdString());
  OpText text = text_;
  const QString key = QString::fromUtf8(option.key.data(), qsizetype(option.key.size()));
  if (text.set(option, plain)) push(text, tr("Change %1").arg(key), key);
}

void OpDocument::set_plain_text(const QString& plain) {
  OpText text = text_;
  text.set_plain_text(plain.toStdString());
  push(text, tr("Edit the text"), changed_line(text_.text(), text.text()));
}

void OpDocument::set_options(const QString& title, const RenderOptions& wanted, const QString& key) {
  if (const auto text = text_with(wanted)) push(*text, title, key);
}

void OpDocument::follow(const RenderOptions& wanted) {
  const auto text = text_with(wanted);
  if (text && text->text() != text_.text()) take(text->text());
}

/// Updates the text; options whose values cannot be written in an OP file are unchanged.
std::optional<OpText> OpDocument::text_with(const RenderOptions& wanted) const {
  grf::Diagnostics ignored_diagnostics;
  const auto text = op_text_of(wanted, op_naming_path(path_), text_.text(), ignored_diagnostics);
  return text ? std::optional(OpText(*text)) : std::nullopt;
}

void OpDocument::push(const OpText& text, const QString& title, const QString& key) {
  std::string after = text.text();
  if (after != text_.text()) return stack_->push(new Edit(*this, std::move(after), title, key));
  // What followed an edit so far, such as the camera of the view, is set by the author now.
  is_edited_ = is_edited_ || after != read_text_;
}

void OpDocument::take(const std::string& text) {
  text_ = OpText(text);
  check();
  emit changed();
}

/// Checks a project's options, which need not name a scene: they are checked as if they did, without
/// renumbering lines.
void OpDocument::check() {
  const std::string path = QFileInfo(op_naming_path(path_)).absoluteFilePath().toStdString();
  const auto read = [&](const char* behind) {
    diagnostics_ = {};
    return options::read_op_text(path, std::make_shared<const std::string>(text_.text() + behind),
                                 diagnostics_);
  };
  const bool names_scene = text_.words_of(*options::find_option("BPT_Scene")).has_value();
  render_options_ = read(names_scene ? "" : "\nBPT_Scene untitled.grf\n");
  if (render_options_ && !names_scene) render_options_->scene.clear();
  if (render_options_) valid_options_ = *render_options_;
  if (!names_scene && !is_in_project()) render_options_ = read("");
  if (render_options_) options::warn_of_unused_options(*render_options_, diagnostics_);
}

}  // namespace editor
