// The rows of the Surface dock for colours, emission, irradiance and normals.
#pragma once

#include <QWidget>

#include "editor/panels/surface_facts.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class ColourFields;
class NumberBox;

/// Edits the colour that multiplies the BRDF: a named one, or RGB values.
class ColourRow : public QWidget {
  Q_OBJECT

 public:
  explicit ColourRow(Document& document, QWidget* parent = nullptr);
  void show_facts(const SurfaceFacts& facts);
  /// The control that the row's label focuses.
  QWidget* field() const;

 private:
  void choose(int index);
  void assign(const AttributeEdit<grf::ColourAttribute>& colour, const QString& key);

  Document& document_;
  QComboBox* choice_;
  ColourFields* fields_;
  QToolButton* reset_;
};

/// Edits the emission that makes the faces an area light, by radiance or total power.
class EmissionRow : public QWidget {
  Q_OBJECT

 public:
  explicit EmissionRow(Document& document, QWidget* parent = nullptr);
  void show_facts(const SurfaceFacts& facts);
  /// The control that the row's label focuses.
  QWidget* field() const;

 private:
  Document& document_;
  ColourFields* radiance_;
  NumberBox* power_;
  QToolButton* reset_;
};

/// Edits a vertex attribute of the faces: colour or irradiance.
class VertexRow : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { Colour, Irradiance };

  VertexRow(Document& document, Kind kind, QWidget* parent = nullptr);
  void show_facts(const SurfaceFacts& facts);
  /// The control that the row's label focuses.
  QWidget* field() const;

 signals:
  void bake_requested();

 private:
  void put(const std::optional<grf::Colour>& value);

  Document& document_;
  Kind kind_;
  ColourFields* fields_;
  QToolButton* clear_;
  QToolButton* bake_ = nullptr;
};

/// Recomputes or flips vertex normals.
class NormalsRow : public QWidget {
  Q_OBJECT

 public:
  explicit NormalsRow(Document& document, QWidget* parent = nullptr);
  void show_facts(const SurfaceFacts& facts);
  /// The control that the row's label focuses.
  QWidget* field() const;

 private:
  enum class Change { Smooth, Flat, Flip };
  void apply(Change change);

  Document& document_;
  NumberBox* angle_;
  QLabel* state_;
};

}  // namespace editor
