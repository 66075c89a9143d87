#pragma once

#include <QWidget>
#include <vector>

#include "grf/catalogue.h"

class QComboBox;
class QLabel;

namespace editor {

class ParameterRows;

/// A form for one model of a catalogue that is no BRDF: a sampling scheme or a distribution, with a row for
/// each parameter. Values that `grf::check` rejects stay in the form with its message, and are not reported.
class ChooserForm : public QWidget {
  Q_OBJECT

 public:
  /// `kind` names what is chosen, such as `Sampling scheme`, for people; `check_kind` for messages.
  ChooserForm(const QString& kind, const std::string& check_kind, std::vector<grf::ModelInfo> infos,
              QWidget* parent = nullptr);

  /// Shows a model, without a signal.
  void set_model(const grf::Model& model);
  const grf::Model& model() const { return model_; }

 signals:
  /// Emitted with each valid change; `is_done` once the control is released.
  void edited(const grf::Model& model, bool is_done);

 private:
  void choose(int index);
  void refresh();
  void apply(bool is_done);

  std::string check_kind_;
  std::vector<grf::ModelInfo> infos_;
  grf::Model model_;
  QComboBox* chooser_;
  ParameterRows* parameters_;
  QLabel* problem_;
};

}  // namespace editor
