#include "editor/document/edit_stack.h"

namespace editor {

EditStack::EditStack(QObject* parent) : QUndoStack(parent) {
  connect(this, &QUndoStack::indexChanged, this, [this] {
    if (!is_pushing_) emit revision_changed();
  });
}

void EditStack::push(QUndoCommand* step) {
  const auto before = static_cast<std::size_t>(index());
  revisions_.resize(before + 1);
  revisions_.push_back(++latest_);
  is_pushing_ = true;
  QUndoStack::push(step);
  is_pushing_ = false;
  const auto now = static_cast<std::size_t>(index());
  if (now == before) revisions_[now] = latest_;  // it was merged into the former step
  revisions_.resize(now + 1);
  emit revision_changed();
}

void EditStack::clear() {
  is_pushing_ = true;
  QUndoStack::clear();
  is_pushing_ = false;
  revisions_ = {++latest_};
}

}  // namespace editor
