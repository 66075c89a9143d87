#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "editor/document/lamp.h"

class QGridLayout;
class QPushButton;

namespace editor {

class ColourFields;
class NumberBox;

/// Number fields for a lamp: position, direction, size, and its output as radiance, colour temperature or
/// power.
class LampForm : public QWidget {
  Q_OBJECT

 public:
  explicit LampForm(QWidget* parent = nullptr);

  /// Shows a lamp that emits from so many m2 in world space.
  void show_lamp(const Lamp& lamp, double area);
  /// Shows only the output of a light that is no lamp.
  void show_output(const grf::Colour& radiance, double area);

 signals:
  /// Emitted with the changed lamp, of which only the radiance is meant after `show_output`, the title of the
  /// undo step, and the key of those that are merged with it until `finished`.
  void edited(const editor::Lamp& lamp, const QString& title, const QString& key);
  void finished();
  /// Emitted when the lamp shall be turned toward a point that is picked.
  void aim_requested();
  /// Emitted when the lamp shall be placed so that its reflection is at a point that is picked.
  void highlight_requested();

 private:
  struct Field;

  void add_row(int row, const QString& label, const std::vector<Field>& fields);
  void add_placement();
  void add_output();
  void add_buttons();
  void show_radiance();
  void change(const Lamp& lamp, const QString& title, const QString& key);

  Lamp lamp_;
  double area_ = 0;
  QGridLayout* layout_;
  std::vector<std::pair<NumberBox*, double (*)(const Lamp& lamp)>> boxes_;
  ColourFields* radiance_ = nullptr;
  NumberBox* temperature_ = nullptr;
  NumberBox* power_ = nullptr;
  QPushButton* aim_ = nullptr;
  QPushButton* highlight_ = nullptr;
};

}  // namespace editor
