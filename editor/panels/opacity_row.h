#pragma once

#include "editor/panels/surface_row.h"

class QComboBox;
class QToolButton;

namespace editor {

class NumberBox;

/// Edits the opacity of the faces: a number, or one that the alpha of their texture decides.
class OpacityRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit OpacityRow(Document& document, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  void choose(int index);
  void assign(const AttributeEdit<grf::Opacity>& opacity, const QString& key);

  grf::Opacity shown_;
  QComboBox* choice_;
  NumberBox* value_;
  QToolButton* reset_;
};

}  // namespace editor
