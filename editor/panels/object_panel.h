#pragma once

#include <QWidget>
#include <array>

#include "editor/document/document.h"

class QLabel;
class QStackedWidget;

namespace editor {

class NumberBox;
class ShapeForm;
struct PrimitiveShape;

/// Shows and edits position, rotation and scale of the active object relative to its parent.
class ObjectPanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  explicit ObjectPanel(Document& document, QWidget* parent = nullptr);

  /// Shows the parameters of a shape that was just added and selected, until another edit is made.
  void show_new_shape(const PrimitiveShape& shape);
  /// Shows lengths in a unit: m, cm, mm or in.
  void show_lengths_in(const QString& unit);

  QSize sizeHint() const override;

 private:
  enum Row { Position, Rotation, Scale };

  QWidget* make_form();
  void show_object();
  void take(Row row, int axis, double number);
  QString name_of(const grf::ScenePath& path) const;

  Document& document_;
  QString length_unit_ = "m";
  ObjectTransform shown_;
  ShapeForm* shape_;
  QStackedWidget* pages_;
  QLabel* name_ = nullptr;
  QLabel* size_ = nullptr;
  QLabel* note_ = nullptr;
  QLabel* problem_;
  std::array<std::array<NumberBox*, 3>, 3> boxes_ = {};
};

}  // namespace editor
