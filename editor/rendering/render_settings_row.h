#pragma once

#include <QWidget>
#include <vector>

#include "renderer/options/render_options.h"

class QComboBox;
class QGridLayout;

namespace editor {

class NumberBox;

/// Controls for the most used render options: size, samples, depth, sampling scheme, target error and time
/// limit. Ranges, words and meanings come from the options' table.
class RenderSettingsRow : public QWidget {
  Q_OBJECT

 public:
  explicit RenderSettingsRow(QWidget* parent = nullptr);

  void set_options(const options::RenderOptions& render_options);
  /// The options that were set, with the values of the controls.
  const options::RenderOptions& options() const { return options_; }
  /// Commits typed text, as the Return key does.
  void commit();

 signals:
  /// Emitted when the user has finished editing a control.
  void edited();

 private:
  template <class Control>
  Control* add(const QString& name, std::string_view key, int row, int column, int columns = 1,
               const QString& more = {});
  NumberBox* add_number(const QString& name, std::string_view key, int row, int column,
                        const QString& more = {});
  std::vector<NumberBox*> numbers() const;
  void set_ranges();
  void connect_controls();
  void show_options();
  void take();

  options::RenderOptions options_;
  bool is_showing_ = false;
  QGridLayout* layout_;
  NumberBox* width_;
  NumberBox* height_;
  NumberBox* samples_;
  NumberBox* depth_;
  QComboBox* scheme_;
  NumberBox* target_error_;
  NumberBox* seconds_;
};

}  // namespace editor
