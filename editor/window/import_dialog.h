#pragma once

#include <QDialog>
#include <QString>
#include <memory>
#include <vector>

#include "editor/document/import_options.h"
#include "editor/document/scene_loader.h"
#include "editor/jobs/background_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace editor {

class NumberBox;
class SceneView;

/// Asks how a model is imported: up axis, unit, normals, welding, decimation, BRDF and objects, with a
/// picture and the resulting size. It shows the effect of each change on the model that was read. The options
/// are remembered for the type of the file.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  ImportDialog(std::shared_ptr<const LoadedScene> loaded, QWidget* parent);

  /// The model with the options applied.
  const std::shared_ptr<const LoadedScene>& result_scene() const { return result_; }

  /// Imports when the latest options are applied.
  void accept() override;

 private:
  void add_placement(QFormLayout& form);
  void add_mesh_operations(QFormLayout& form);
  void add_brdf(QFormLayout& form);
  void add_objects(QFormLayout& form);
  QWidget* picture_column();
  void set_options(const ImportOptions& options);
  ImportOptions options() const;
  void apply();
  void take(const std::shared_ptr<const LoadedScene>& scene);

  const std::shared_ptr<const LoadedScene> loaded_;
  const QString type_;
  std::shared_ptr<const LoadedScene> result_;
  BackgroundJob<std::shared_ptr<const LoadedScene>> applying_;
  bool is_accepted_ = false;  ///< and waits for the result
  SceneView* view_ = nullptr;
  QLabel* size_ = nullptr;
  QComboBox* up_ = nullptr;
  QComboBox* unit_ = nullptr;
  QComboBox* normals_ = nullptr;
  NumberBox* crease_ = nullptr;
  QCheckBox* welds_ = nullptr;
  NumberBox* weld_ = nullptr;
  QCheckBox* decimates_ = nullptr;
  NumberBox* decimate_ = nullptr;
  QLineEdit* brdf_ = nullptr;
  QLabel* problem_ = nullptr;
  QListWidget* objects_ = nullptr;
  QCheckBox* skips_ = nullptr;
  QPushButton* import_ = nullptr;
};

}  // namespace editor
