#pragma once

#include <QUndoStack>
#include <cstdint>
#include <vector>

namespace editor {

/// An undo stack that gives each state a number of its own. Undo and redo bring back the numbers of the
/// states that they lead to, while an index means another state once a step was undone and another one made.
class EditStack : public QUndoStack {
  Q_OBJECT

 public:
  explicit EditStack(QObject* parent = nullptr);

  void push(QUndoCommand* step);
  /// Forgets all steps; what follows is another state.
  void clear();
  std::uint64_t revision() const { return revisions_[static_cast<std::size_t>(index())]; }

 signals:
  /// A step was made, undone or redone.
  void revision_changed();

 private:
  std::vector<std::uint64_t> revisions_ = {0};  ///< by index
  std::uint64_t latest_ = 0;
  bool is_pushing_ = false;
};

}  // namespace editor
