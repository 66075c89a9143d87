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
  const QUndoCommand* last = before > 0 ? command(index() - 1) : nullptr;
  is_pushing_ = true;
  QUndoStack::push(step);
  is_pushing_ = false;
  const auto now = static_cast<std::size_t>(index());
  if (now == before && command(index() - 1) != last) {
    revisions_.erase(revisions_.begin());  // the oldest step was dropped
  } else if (now == before) {
    revisions_[now] = latest_;  // it was merged into the former step
  }
  revisions_.resize(now + 1);
  emit revision_changed();
}

void EditStack::set_limit(int steps) {
  limit_ = steps;
  if (count() == 0) setUndoLimit(limit_);
}

void EditStack::clear() {
  is_pushing_ = true;
  QUndoStack::clear();
  setUndoLimit(limit_);
  is_pushing_ = false;
  revisions_ = {++latest_};
}

}  // namespace editor
