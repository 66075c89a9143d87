#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "editor/brdf/model_values.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace editor {

class ColourButton;
class MapButton;
class NumberBox;
class ScaledSlider;

/// The controls of one parameter, generated from its description: a slider and a number field, three fields
/// for RGB, a check box or a choice of words, and buttons for an image that varies it and for a reset.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  /// `takes_maps` tells whether images may vary parameters of the model.
  explicit ParameterRow(const grf::ParameterInfo& parameter, bool takes_maps, QWidget* parent = nullptr);

  const grf::ParameterInfo& parameter() const { return parameter_; }

  /// Shows the values of the edited models; `mixed` where they differ.
  void show_values(const std::vector<grf::Value>& values, bool is_default);
  void show_maps(const std::vector<std::optional<grf::ParameterMap>>& maps);
  /// Shows an error of the value; an empty message clears it.
  void set_message(const QString& message);
  /// Sets the width of the name column, the same for all rows.
  void set_name_width(int width);
  int name_width() const;

 signals:
  void changing(const grf::Value& value);
  void edited(const grf::Value& value);
  void map_edited(const std::optional<grf::ParameterMap>& map);
  void reset();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void add_number();
  void add_colour();
  void add_choice();
  void add_map();
  void add_reset();
  void show_number(const std::vector<grf::Value>& values);
  void show_colour(const std::vector<grf::Value>& values);
  void show_channels(bool are_shown);
  void split_channels(bool into_three);
  void report_channel(std::size_t channel, double number, bool is_done);
  NumberBox* new_box(const QString& name);

  grf::ParameterInfo parameter_;
  bool is_updating_ = false;
  grf::Colour rgb_ = grf::Colour(0);
  QLabel* name_ = nullptr;
  QToolButton* reset_ = nullptr;
  ScaledSlider* slider_ = nullptr;
  NumberBox* box_ = nullptr;
  std::array<NumberBox*, 3> channels_ = {};
  QToolButton* split_ = nullptr;
  ColourButton* colour_ = nullptr;
  QCheckBox* check_ = nullptr;
  QComboBox* words_ = nullptr;
  MapButton* map_ = nullptr;
};

}  // namespace editor
