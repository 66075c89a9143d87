#pragma once

#include <QDialog>
#include <QString>
#include <vector>

#include "editor/document/scene_export.h"
#include "editor/jobs/background_job.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace editor {

/// Asks for the file and the format of an export, and lists what the format loses of the scene before
/// anything is written. A name with another extension selects its format, and the reverse.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// Proposes a file. The format is the one of the last export.
  ExportDialog(ExportRequest scene, const QString& file, QWidget* parent);

  /// The export as it is chosen.
  const ExportRequest& request() const { return request_; }

  void accept() override;

 private:
  QWidget* file_row();
  void browse();
  std::vector<const convert::Format*>::const_iterator format_of(const QString& file) const;
  void choose_format();
  void take_name();
  void update_losses();
  void show_losses(const grf::Diagnostics& diagnostics);

  ExportRequest request_;
  const std::vector<const convert::Format*> formats_ = export_formats();
  BackgroundJob<grf::Diagnostics> trial_;
  QComboBox* format_ = nullptr;
  QCheckBox* is_2008_ = nullptr;
  QLineEdit* file_ = nullptr;
  QLabel* summary_ = nullptr;
  QListWidget* losses_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace editor
