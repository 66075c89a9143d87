#pragma once

#include <QGroupBox>
#include <cstdint>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/primitive_shapes.h"

class QFormLayout;

namespace editor {

class NumberBox;

/// The parameters of the primitive shape that was added last. They can be changed until another edit is made
/// or the scene is saved; together with the addition they are one undo step.
class ShapeForm : public QGroupBox {
  Q_OBJECT

 public:
  /// The document outlives the form, which is hidden until a shape is added.
  explicit ShapeForm(Document& document, QWidget* parent = nullptr);

  /// Shows the parameters of a shape that was just added and selected.
  void begin(const PrimitiveShape& shape);

 private:
  struct Field {
    NumberBox* box;
    double PrimitiveShape::*length;           ///< null for the number of segments
    std::vector<PrimitiveShape::Kind> kinds;  ///< that have it
  };

  void add_field(const QString& label, const QString& name, const QString& help,
                 double PrimitiveShape::*length, std::vector<PrimitiveShape::Kind> kinds);
  void take(const Field& field, double value);
  void end_if_edited();
  void show_if_selected();

  Document& document_;
  QFormLayout* rows_;
  std::vector<Field> fields_;
  PrimitiveShape shape_;
  grf::ScenePath path_;         ///< of the shape's mesh; empty if there is none
  std::uint64_t revision_ = 0;  ///< of the document with the shape
  bool is_amending_ = false;
};

}  // namespace editor
