#pragma once

#include <QWidget>

#include "editor/document/document.h"
#include "editor/panels/scene_check.h"
#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/scene_path.h"

class QLabel;
class QListView;
class QModelIndex;
class QStackedWidget;

namespace editor {

class MessageModel;

/// The panel lists what reading the open file said, what is wrong with the scene as it is now, and what
/// cannot be shown of it.
class MessagePanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  MessagePanel(Document& document, grf::Catalogue catalogue, QWidget* parent = nullptr);

  /// Shows what was said about another file, such as one that could not be opened, until the next one opens.
  void show_diagnostics(const grf::Diagnostics& diagnostics);
  /// Adds what holds as long as this scene is shown, such as what the screen cannot do; once, if it is said
  /// several times.
  void add_warning(const QString& message);

  const SceneCheck& check() const { return check_; }
  std::size_t error_count() const { return errors_; }
  std::size_t warning_count() const { return warnings_; }
  QListView* view() const { return view_; }
  QSize sizeHint() const override;

 signals:
  /// A message was chosen: the file is to be shown there.
  void place_requested(const grf::SourceLocation& location);
  /// What was written there; its faces are selected.
  void chosen(const grf::ScenePath& path);
  /// There are other messages.
  void messages_changed();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_all();
  void go_to(const QModelIndex& index);

  Document& document_;
  SceneCheck check_;
  grf::Diagnostics of_file_;
  grf::Diagnostics of_display_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  MessageModel* model_;
  QLabel* summary_;
  QStackedWidget* pages_;
  QListView* view_;
};

}  // namespace editor
