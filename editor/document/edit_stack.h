#pragma once

#include <QUndoStack>
#include <cstdint>
#include <vector>

namespace editor {

/// An undo stack that numbers its states. Undo and redo restore the numbers of their states, while an index
/// is reused when a step is undone and another one made.
class EditStack : public QUndoStack {
  Q_OBJECT

 public:
  explicit EditStack(QObject* parent = nullptr);

  void push(QUndoCommand* step);
  /// Limits the number of steps, of which the oldest are dropped; 0: no limit. Qt allows that only while
  /// there are none: otherwise the limit holds from the next `clear`.
  void set_limit(int steps);
  /// Removes all steps; the current state gets a new number.
  void clear();
  std::uint64_t revision() const { return revisions_[static_cast<std::size_t>(index())]; }

 signals:
  /// Emitted when a step was made, undone or redone.
  void revision_changed();

 private:
  std::vector<std::uint64_t> revisions_ = {0};  ///< by index
  std::uint64_t latest_ = 0;
  int limit_ = 0;
  bool is_pushing_ = false;
};

}  // namespace editor
