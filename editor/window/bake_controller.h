#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "editor/document/import_folder.h"
#include "editor/rendering/irradiance_bake.h"

namespace editor {

class Document;
class Job;
class JobList;

/// Bakes irradiance as a job, and applies it to the current scene.
class BakeController : public QObject {
  Q_OBJECT

 public:
  /// Document and jobs outlive the controller.
  BakeController(Document& document, JobList& jobs, QObject* parent);

  /// Starts a bake of the current scene, unless one is running.
  void bake();
  bool is_running() const { return bake_.is_running(); }

 signals:
  void status_message(const QString& message);
  void failed(const QString& why);

 private:
  void begin(Job& job);
  void take(const BakedIrradiance& irradiance, const IrradianceBakeResult& result);

  Document& document_;
  JobList& jobs_;
  QPointer<Job> job_;
  ImportFolders imports_;  ///< folders with images of the baked scene
  IrradianceBake bake_;
};

}  // namespace editor
