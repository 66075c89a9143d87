#pragma once

#include <QWidget>

class QLineEdit;

namespace editor {

/// The name of a file of measured data, typed or chosen.
class DataFileRow : public QWidget {
  Q_OBJECT

 public:
  explicit DataFileRow(QWidget* parent = nullptr);

  /// Without a signal.
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
