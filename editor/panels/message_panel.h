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

/// Lists the diagnostics of reading the open file and of checking the current scene, and warnings about what
/// the view cannot show.
class MessagePanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  MessagePanel(Document& document, grf::Catalogue catalogue, QWidget* parent = nullptr);

  /// Shows diagnostics of another file, such as one that could not be opened, until the next one opens.
  void show_diagnostics(const grf::Diagnostics& diagnostics);
  /// Adds a warning that holds as long as this scene is shown, such as a limit of the graphics driver.
  /// Repeated warnings are listed once.
  void add_warning(const QString& message);

  const SceneCheck& check() const { return check_; }
  std::size_t error_count() const { return errors_; }
  std::size_t warning_count() const { return warnings_; }
  QListView* view() const { return view_; }
  QSize sizeHint() const override;

 signals:
  /// Emitted when a message is activated: show the file at this location.
  void place_requested(const grf::SourceLocation& location);
  /// Emitted with the path of what was written at the location, after its faces are selected.
  void chosen(const grf::ScenePath& path);
  /// Emitted when the messages differ from before.
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
