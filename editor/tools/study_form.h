#pragma once

#include <QWidget>
#include <vector>

#include "renderer/studies/study.h"

class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace editor {

class BrdfForm;
class ChooserForm;
class ParameterRows;

/// The form of a study tool: its settings, and the distribution, BRDFs, sampling schemes and files that it
/// takes.
class StudyForm : public QWidget {
  Q_OBJECT

 public:
  /// The tool's description outlives the form.
  explicit StudyForm(const studies::StudyTool& tool, QWidget* parent = nullptr);

  /// Shows a state, without a signal.
  void set_state(const studies::ToolState& state);
  const studies::ToolState& state() const { return state_; }

 signals:
  /// Emitted with each valid change; `is_done` once the control is released.
  void edited(const studies::ToolState& state, bool is_done);
  /// Emitted when the user asks for files to add.
  void files_requested();

 private:
  QVBoxLayout* add_section(const QString& title);
  void add_settings();
  void add_models();
  void add_files();
  void refresh();
  void refresh_files();
  void remove_file();

  const studies::StudyTool& tool_;
  studies::ToolState state_;
  QVBoxLayout* column_;
  ParameterRows* settings_ = nullptr;
  ChooserForm* distribution_ = nullptr;
  std::vector<BrdfForm*> brdfs_;
  std::vector<ChooserForm*> pdfs_;
  QListWidget* files_ = nullptr;
  QToolButton* remove_ = nullptr;
};

}  // namespace editor
