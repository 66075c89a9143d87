#pragma once

#include <QWidget>

class QLineEdit;

namespace editor {

/// Edits the file name of a measured BRDF.
class DataFileRow : public QWidget {
  Q_OBJECT

 public:
  explicit DataFileRow(QWidget* parent = nullptr);

  /// Sets the file name, without a signal.
  void set_file(const QString& file, bool is_mixed);

 signals:
  void edited(const QString& file);

 private:
  void choose();
  void take(const QString& file);

  QString file_;
  QLineEdit* line_ = nullptr;
};

}  // namespace editor
