#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <optional>
#include <string>

#include "editor/document/editor_state.h"

class QAction;
class QKeySequence;
class QMenu;
class QWidget;

namespace editor {

class Document;
class SceneView;

/// Actions that hide, isolate and lock the selected faces, and keep selections as named sets.
class VisibilityActions : public QObject {
  Q_OBJECT

 public:
  VisibilityActions(Document& document, SceneView& view, QWidget& window);

  /// Adds the actions and the menu of the sets.
  void fill(QMenu& menu);

 private:
  using Change = std::function<void(EditorState& state)>;

  QAction* add(const QString& text, const QString& icon, const QKeySequence& keys, const QString& tip,
               const Change& change);
  void make_visibility(SceneView& view);
  void make_locks();
  void isolate(EditorState& state);
  void save_set();
  void rename_set(const std::string& name);
  void ask_name(const QString& title, const QString& name,
                const std::function<void(const std::string& name)>& named);
  void fill_sets();

  Document& document_;
  QWidget& window_;
  QMenu* sets_;
  QAction* save_set_;
  std::optional<FaceSelection> hidden_before_;  ///< isolating faces
  QList<QAction*> visibility_, locks_;
};

}  // namespace editor
