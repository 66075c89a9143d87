#pragma once

#include <QWidget>

#include "editor/panels/surface_facts.h"

namespace editor {

/// A row of the surface panel shows what selected faces have in common, and gives them something else.
class SurfaceRow : public QWidget {
 public:
  SurfaceRow(Document& document, QWidget* parent) : QWidget(parent), document_(document) {}

  virtual void show_facts(const SurfaceFacts& facts) = 0;
  /// What the row's label leads to.
  QWidget* field() const { return field_; }

 protected:
  Document& document_;
  QWidget* field_ = nullptr;
};

}  // namespace editor
