#pragma once

#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "renderer/transport/camera.h"

class QGridLayout;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace editor {

class Document;
class NumberBox;
struct NumberInfo;

/// Lists the cameras of a scene, and edits the selected one: the render options' own camera, which is the
/// first, and those with names.
class CameraPanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  explicit CameraPanel(Document& document, QWidget* parent = nullptr);

  /// Adds a camera with this view, and selects it.
  void add(const transport::View& view);
  /// Moves the selected camera to this view; its lens stays.
  void place(const transport::View& view);
  /// Focuses the selected camera on a point in world space.
  void focus_on(const grf::Vec3d& point);
  /// The view of the selected camera.
  transport::View view() const;

  QSize sizeHint() const override;

 signals:
  /// Emitted when a camera shall be added from the 3D view.
  void add_requested();
  /// Emitted when the selected camera shall be moved to the 3D view.
  void place_requested();
  /// Emitted when the 3D view shall look through a camera.
  void look_requested(const transport::View& view);
  /// Emitted when the point in focus shall be picked.
  void focus_requested();
  /// Emitted when the author selects a camera to render.
  void render_camera_chosen();

 private:
  struct Field;

  QWidget* make_buttons();
  QWidget* make_form();
  void add_row(QGridLayout& grid, const QString& label, const std::vector<Field>& fields);
  void show_cameras();
  void show_form();
  void change(const transport::View& view, const QString& title, const QString& key);
  void rename(QTreeWidgetItem* item, int column);
  void choose_for_render(QTreeWidgetItem* item);
  void remove();
  QString free_name() const;

  Document& document_;
  QTreeWidget* list_;
  QToolButton* remove_ = nullptr;
  int row_ = 0;  ///< the selected camera: 0 is the one without a name
  std::vector<std::pair<NumberBox*, std::function<double(const transport::View&)>>> boxes_;
};

}  // namespace editor
