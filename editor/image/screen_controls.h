#pragma once

#include <QWidget>

#include "editor/image/screen_colours.h"

class QComboBox;
class QSlider;

namespace editor {

class NumberBox;

/// Controls for exposure, tone curve and displayed channels. The range of false colours depends on the image.
class ScreenControls : public QWidget {
  Q_OBJECT

 public:
  explicit ScreenControls(QWidget* parent = nullptr);

  const ScreenSettings& settings() const { return settings_; }
  /// Sets all that the controls show, without a signal.
  void set_settings(const ScreenSettings& settings);
  void set_exposure(float stops);
  void set_channel(ImageChannel channel);
  void set_false_colour(bool is_on);

 signals:
  /// Emitted also while the slider is dragged.
  void edited(const editor::ScreenSettings& settings);

 private:
  void add_exposure();
  void add_curve();
  void add_view();
  void show_exposure();
  template <class Edit>
  void change(const Edit& edit);

  ScreenSettings settings_;
  QSlider* slider_;
  NumberBox* stops_;
  QComboBox* curve_;
  QComboBox* view_;
};

}  // namespace editor
