#include "editor/options/op_document.h"

#include <QUndoCommand>
#include <memory>
#include <string>
#include <vector>

#include "grf/text_file.h"
#include "renderer/options/op_file.h"
#include "renderer/options/scheme_model.h"

namespace editor {

using options::OpText;
using options::OptionInfo;

/// Texts of options are short: a step keeps them whole.
class OpDocument::Edit : public QUndoCommand {
 public:
  Edit(OpDocument& document, std::string after, const QString& title, const void* subject)
      : QUndoCommand(title),
        document_(document),
        before_(document.text_.text()),
        after_(std::move(after)),
        subject_(subject),
        step_(document.step_) {}

  void undo() override {
    document_.finish_step();
    document_.take(before_);
  }
  void redo() override { document_.take(after_); }
  int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = dynamic_cast<const Edit&>(*other);
    if (next.subject_ != subject_ || next.step_ != step_) return false;
    after_ = next.after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  OpDocument& document_;
  std::string before_;
  std::string after_;
  const void* subject_;  ///< the option that was edited; null: the text
  int step_;
};

OpDocument::OpDocument(QObject* parent) : QObject(parent) { check(); }

bool OpDocument::open(const QString& path, grf::Diagnostics& diagnostics) {
  const auto text = grf::read_file(path.toStdString(), diagnostics);
  if (!text) return false;
  start(*text, path);
  return true;
}

void OpDocument::start(const std::string& text, const QString& path) {
  path_ = path;
  take(text);
  stack_.clear();
  emit path_changed();
}

bool OpDocument::save(const QString& path, grf::Diagnostics& diagnostics) {
  if (!grf::replace_file(path.toStdString(), text_.text(), diagnostics)) return false;
  path_ = path;
  stack_.setClean();
  finish_step();
  check();
  emit path_changed();
  emit changed();
  return true;
}

void OpDocument::set_words(const OptionInfo& option, const QStringList& words) {
  std::vector<std::string> plain;
  for (const QString& word : words) plain.push_back(word.toStdString());
  OpText text = text_;
  if (text.set(option, plain)) push(text, tr("Change %1").arg(QString::fromUtf8(option.key.data())), &option);
}

void OpDocument::set_plain_text(const QString& plain) {
  OpText text = text_;
  text.set_plain_text(plain.toStdString());
  push(text, tr("Edit the text"), nullptr);
}

void OpDocument::push(const OpText& text, const QString& title, const void* subject) {
  std::string after = text.text();
  if (after != text_.text()) stack_.push(new Edit(*this, std::move(after), title, subject));
}

void OpDocument::take(const std::string& text) {
  text_ = OpText(text);
  check();
  emit changed();
}

void OpDocument::check() {
  diagnostics_ = {};
  const std::string name = path_.isEmpty() ? tr("untitled.op").toStdString() : path_.toStdString();
  render_options_ =
      options::read_op_text(name, std::make_shared<const std::string>(text_.text()), diagnostics_);
  if (render_options_) options::warn_of_unused_options(*render_options_, diagnostics_);
}

}  // namespace editor
