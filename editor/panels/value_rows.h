// These rows of the Surface dock edit colours, emission, irradiance and normals.
#pragma once

#include "editor/panels/surface_row.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class ColourFields;
class NumberBox;

/// Edits the colour that multiplies the BRDF: a named one, or RGB values.
class ColourRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit ColourRow(Document& document, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  void choose(int index);
  void assign(const AttributeEdit<grf::ColourAttribute>& colour, const QString& key);

  QComboBox* choice_;
  ColourFields* fields_;
  QToolButton* reset_;
};

/// Edits the emission that makes the faces an area light, by radiance or total power.
class EmissionRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit EmissionRow(Document& document, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  ColourFields* radiance_;
  NumberBox* power_;
  QToolButton* reset_;
};

/// Edits a vertex attribute of the faces: colour or irradiance.
class VertexRow : public SurfaceRow {
  Q_OBJECT

 public:
  enum class Kind { Colour, Irradiance };

  VertexRow(Document& document, Kind kind, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 signals:
  void bake_requested();

 private:
  void put(const std::optional<grf::Colour>& value);

  Kind kind_;
  ColourFields* fields_;
  QToolButton* clear_;
  QToolButton* bake_ = nullptr;
};

/// Recomputes or flips vertex normals.
class NormalsRow : public SurfaceRow {
  Q_OBJECT

 public:
  explicit NormalsRow(Document& document, QWidget* parent = nullptr);
  void show_summary(const SelectionSummary& summary) override;

 private:
  enum class Change { Smooth, Flat, Flip };
  void apply(Change change);

  NumberBox* angle_;
  QLabel* state_;
};

}  // namespace editor
