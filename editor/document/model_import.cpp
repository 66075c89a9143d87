#include "editor/document/model_import.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <QStandardPaths>
#include <QtConcurrent>
#include <algorithm>
#include <utility>

#include "converters/format.h"
#include "editor/document/op_files.h"
#include "editor/programs/bundled_program.h"
#include "grf/read.h"
#include "renderer/options/op_file.h"

namespace editor {
namespace {

/// Parses the messages of `grfconvert`, of which only the severity is needed.
grf::Diagnostics diagnostics_of(const QString& printed) {
  const QString warning = "warning: ";
  grf::Diagnostics diagnostics;
  for (const QString& line : printed.split('\n', Qt::SkipEmptyParts)) {
    if (!line.contains(warning)) continue;
    diagnostics.warning({}, QString(line).remove(warning).toStdString());
  }
  return diagnostics;
}

/// Reads the converted files, after which only the images are needed. Null after an error.
std::shared_ptr<const ImportedModel> read_model(std::shared_ptr<const ImportFolder> folder,
                                                const QString& path, QStringList losses,
                                                const QString& printed) {
  auto model = std::make_shared<ImportedModel>();
  grf::Diagnostics diagnostics;
  auto scene = grf::read(path.toStdString(), diagnostics);
  const QString op_file = op_file_beside(path);
  const auto view = options::read_op_file(op_file.toStdString(), diagnostics);
  if (!scene || !view) return nullptr;
  for (const QString& file : {path, op_file}) QFile::remove(file);
  if (!QDir(folder->path()).isEmpty()) model->folder = std::move(folder);
  model->scene = std::move(*scene);
  model->path = path;
  model->losses = std::move(losses);
  model->diagnostics = diagnostics_of(printed);
  model->cameras = view->cameras;
  return model;
}

QStringList losses_in(const QByteArray& report) {
  QStringList losses;
  for (const QJsonValue loss : QJsonDocument::fromJson(report).object()["losses"].toArray()) {
    losses.append(loss.toString());
  }
  return losses;
}

}  // namespace

ModelImport::ModelImport(QString parent_folder, QObject* parent)
    : QObject(parent), parent_(std::move(parent_folder)) {
  connect(&reading_, &QFutureWatcher<std::shared_ptr<const ImportedModel>>::finished, this, [this] {
    if (reading_.future().resultCount() == 0) return;  // it was cancelled
    folder_.reset();                                   // now owned by the model
    if (const auto model = reading_.future().takeResult()) return emit done(model);
    fail(tr("%1: the converted file could not be read").arg(file_));
  });
}

ModelImport::~ModelImport() {
  cancel();
  for (ChildProcess* process : findChildren<ChildProcess*>()) process->finish();
}

QString ModelImport::default_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/imports";
}

QStringList ModelImport::name_patterns() {
  QStringList patterns;
  for (const convert::Format& format : convert::formats()) {
    if (format.read == nullptr) continue;
    for (const std::string_view extension : format.extensions) {
      patterns.append("*." + QString::fromUtf8(extension.data(), static_cast<int>(extension.size())));
    }
  }
  return patterns;
}

double ModelImport::memory_limit() { return QSettings().value("import/memory_limit", 4).toDouble(); }

void ModelImport::set_memory_limit(double gigabytes) {
  QSettings().setValue("import/memory_limit", gigabytes);
}

int ModelImport::time_limit(qint64 bytes) {
  constexpr qint64 Least = 60;                // there may be large files beside it
  constexpr qint64 SlowestReading = 100'000;  // bytes per second: text, on a busy machine
  return static_cast<int>(std::min<qint64>(Least + bytes / SlowestReading, 24 * 3600));
}

void ModelImport::start(const QString& file, const QStringList& options) {
  cancel();
  file_ = file;
  const QString program = bundled_program("grfconvert");
  if (program.isEmpty()) return fail(tr("cannot find the program grfconvert"));
  folder_ = ImportFolder::make(parent_);
  if (!folder_) return fail(tr("cannot create a folder in %1").arg(parent_));
  output_ = folder_->path() + "/" + QFileInfo(file).completeBaseName() + ".grf";
  const QString memory = QString::number(qRound64(1024 * memory_limit())) + "MB";
  const QString time = QString::number(time_limit(QFileInfo(file).size()));
  run(program, options + QStringList{"--max-memory", memory, "--max-time", time, "--json", "-o",
                                     op_file_beside(output_), "--", file});
}

void ModelImport::run(const QString& program, const QStringList& arguments) {
  report_.clear();
  messages_.clear();
  process_ = new ChildProcess({}, this);
  connect(process_, &ChildProcess::wrote, this, [this](const QByteArray& line) { report_ += line; });
  connect(process_, &ChildProcess::logged, this, [this](const QByteArray& line) { messages_ += line; });
  connect(process_, &ChildProcess::ended, this, &ModelImport::read_output);
  process_->start(program, arguments);
}

void ModelImport::cancel() {
  reading_.setFuture({});
  const auto folder = std::exchange(folder_, nullptr);
  if (process_ == nullptr) return;
  // It kills its own child, and removes partial output.
  ChildProcess* process = std::exchange(process_, nullptr);
  process->disconnect(this);
  connect(process, &ChildProcess::ended, process, [process, folder] {
    process->deleteLater();  // and releases the folder
  });
  process->cancel();
}

void ModelImport::read_output(const ChildEnd& end) {
  std::exchange(process_, nullptr)->deleteLater();
  const QString messages = QString::fromUtf8(messages_);
  if (end.cause == ChildEnd::Cause::NotStarted) return fail(tr("cannot start grfconvert: %1").arg(end.why));
  if (end.cause != ChildEnd::Cause::Returned) return fail(tr("%1: grfconvert crashed").arg(file_));
  if (end.code != 0) return fail(messages.isEmpty() ? tr("cannot read %1").arg(file_) : messages.trimmed());
  reading_.setFuture(QtConcurrent::run(read_model, folder_, output_, losses_in(report_), messages));
}

void ModelImport::fail(const QString& message) {
  folder_.reset();
  emit failed(message);
}

}  // namespace editor
