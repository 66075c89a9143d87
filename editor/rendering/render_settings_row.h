#pragma once

#include <QWidget>

#include "renderer/options/render_options.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QSpinBox;

namespace editor {

/// The options that are changed from one render to the next: size, samples, depth, sampling scheme, target
/// error and time. Ranges, words and meanings are those of the options' table.
class RenderSettingsRow : public QWidget {
  Q_OBJECT

 public:
  explicit RenderSettingsRow(QWidget* parent = nullptr);

  void set_options(const options::RenderOptions& render_options);
  /// Those that were set, with what the controls say.
  const options::RenderOptions& options() const { return options_; }

 signals:
  /// A control was changed by hand, and is done with.
  void edited();

 private:
  template <class Control>
  Control* add(const QString& name, std::string_view key, int row, int column, int columns = 1,
               const QString& more = {});
  void connect_controls();
  void take();

  options::RenderOptions options_;
  bool is_showing_ = false;
  QGridLayout* layout_;
  QSpinBox* width_;
  QSpinBox* height_;
  QSpinBox* samples_;
  QSpinBox* depth_;
  QComboBox* scheme_;
  QDoubleSpinBox* target_error_;
  QDoubleSpinBox* seconds_;
};

}  // namespace editor
