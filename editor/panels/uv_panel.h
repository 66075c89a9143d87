#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "editor/document/document.h"
#include "editor/document/texture_coordinates.h"

class QGridLayout;
class QLabel;
class QMenu;
class QStackedWidget;
class QToolButton;

namespace editor {

class NumberBox;
class UvView;

/// Shows and edits the texture coordinates of the selected faces: a view of them over their image, and the
/// centre and size of their bounds. Edits are applied while a control changes; in large scenes once, when it
/// is released.
class UvPanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  explicit UvPanel(Document& document, QWidget* parent = nullptr);

  /// Sets the menu of a button: projections and transforms. It outlives the panel's use of it.
  void set_menu(QMenu* menu);
  const UvView& view() const { return *view_; }

  QSize sizeHint() const override;

 signals:
  /// Requests an edit of the selected faces that takes a job.
  void edit_requested(const QString& text, const editor::UvTransform& transform);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  enum Row { Centre, Size };
  /// The state before a gesture, and the transform since then.
  struct Gesture {
    grf::Scene scene;
    std::shared_ptr<const SceneObjects> objects;
    FaceSelection selection;
    QString text;
    UvTransform transform;
  };

  QWidget* make_page();
  void add_row(QGridLayout& grid, Row row, const QString& name, const QString& help);
  void add_rotation(QGridLayout& grid);
  void show_selection();
  void show_faces();
  void show_numbers();
  void change(const QString& text, const UvTransform& transform);
  void finish();
  bool is_live() const { return document_.objects().faces < FewFaces; }

  Document& document_;
  QStackedWidget* pages_;
  QToolButton* menu_ = nullptr;
  QLabel* count_ = nullptr;
  QLabel* hint_ = nullptr;
  UvView* view_ = nullptr;
  std::array<std::array<NumberBox*, 2>, 2> boxes_ = {};
  NumberBox* rotation_ = nullptr;
  UvBounds bounds_;  ///< before the gesture
  std::optional<Gesture> gesture_;
  bool is_editing_ = false;
};

}  // namespace editor
