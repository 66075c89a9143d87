#pragma once

#include <QWidget>

#include "editor/panels/selection_summary.h"

namespace editor {

/// A row of the surface panel shows what selected faces have in common, and gives them something else.
class SurfaceRow : public QWidget {
 public:
  SurfaceRow(Document& document, QWidget* parent) : QWidget(parent), document_(document) {}

  virtual void show_summary(const SelectionSummary& summary) = 0;
  /// The target of the link in the row's label.
  QWidget* field() const { return field_; }

 protected:
  Document& document_;
  QWidget* field_ = nullptr;
};

}  // namespace editor
