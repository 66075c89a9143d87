#pragma once

#include <QDialog>
#include <QTimer>
#include <vector>

#include "editor/document/face_query.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace editor {

class Document;
class NumberBox;

/// A dialog, not modal, that selects faces by conditions, and counts those that fulfil them as they are
/// edited. The result replaces, extends, reduces or intersects the selection.
class FaceQueryDialog : public QDialog {
  Q_OBJECT

 public:
  /// The document outlives it.
  FaceQueryDialog(Document& document, QWidget* parent);

  FaceQuery query() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct SimilarityBox {
    QCheckBox* box;
    bool Similarity::*attribute;
  };

  void add_geometry(QFormLayout& form);
  void add_similarities(QFormLayout& form);
  void add_buttons(QFormLayout& form);
  NumberBox* limit(const QString& name, const QString& help);
  NumberBox* add_tolerance(QFormLayout& form, QCheckBox*& box, const QString& name, const QString& tip,
                           double value, double largest, const QString& unit);
  void follow(NumberBox* box);
  void update_soon();
  FaceSelection found() const;
  void show_count();

  Document& document_;
  QComboBox* axis_;
  NumberBox* angle_;
  NumberBox* least_area_;
  NumberBox* largest_area_;
  NumberBox* lowest_;
  NumberBox* highest_;
  QLineEdit* material_;
  std::vector<SimilarityBox> similarities_;
  QCheckBox* has_normal_;
  NumberBox* normal_tolerance_;
  QCheckBox* has_area_;
  NumberBox* area_tolerance_;
  QLabel* count_;
  QTimer timer_;
};

}  // namespace editor
