#pragma once

#include <QSortFilterProxyModel>
#include <QWidget>
#include <vector>

#include "editor/document/document.h"
#include "grf/scene_path.h"

class QAction;
class QLabel;
class QLineEdit;
class QStackedWidget;
class QTreeView;

namespace editor {

class SceneModel;
struct SceneEntry;

/// The scene outliner: a searchable tree of the scene's contents. Selecting an item selects its faces; items
/// with selected faces are bold. Its last columns hide and lock faces. BRDFs can be dragged from it.
class SceneTree : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the tree.
  explicit SceneTree(Document& document, QWidget* parent = nullptr);

  /// Makes the item at a path the current one, and selects its faces.
  void choose(grf::ScenePathView path);

  QTreeView* view() const { return view_; }
  QSize sizeHint() const override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// Emitted with the path of the selected item; empty for none or a group.
  void chosen(const grf::ScenePath& path);

 private:
  void make_view();
  void make_actions();
  QAction* add_action(const QString& icon, const QString& text, const QKeySequence& shortcut,
                      const QString& tool_tip, void (SceneTree::*triggered)());
  void update_actions();
  void select_faces_of_chosen();
  void show_selection();
  void show_selected_objects();
  void show_search();
  void rename_chosen();
  void duplicate_chosen();
  void remove_chosen();
  void remove_unused();
  void toggle_hidden() { toggle(&EditorState::hidden, chosen_entries()); }
  void toggle_locked() { toggle(&EditorState::locked, chosen_entries()); }
  void toggle(FaceSelection EditorState::*set, const std::vector<const SceneEntry*>& entries);
  std::vector<const SceneEntry*> chosen_entries() const;
  void put(const QString& text, std::optional<grf::Scene> scene, const grf::Diagnostics& diagnostics);

  Document& document_;
  SceneModel* model_;
  QSortFilterProxyModel* filter_;
  QLineEdit* search_;
  QStackedWidget* pages_;
  QTreeView* view_;
  QLabel* problem_;
  QAction* rename_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* remove_unused_ = nullptr;
  QAction* hide_ = nullptr;
  QAction* lock_ = nullptr;
  bool is_selecting_ = false;  // of this tree's own accord
};

}  // namespace editor
