#include "editor/rendering/cost_run.h"

#include <QtConcurrent>
#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"

namespace editor {
namespace {

void add_list(QStringList& arguments, const QString& flag, const QString& list) {
  if (!list.isEmpty()) arguments << flag << list;
}

QStringList arguments_of(const CostSettings& settings, const QString& base, const QString& continued) {
  QStringList arguments;
  add_list(arguments, "--pdf", settings.schemes.join(','));
  add_list(arguments, "--integrator", settings.integrators.join(','));
  add_list(arguments, "--branches", settings.ways);
  add_list(arguments, "--samples", settings.samples);
  add_list(arguments, "--continue", continued);
  arguments << "--rounds" << QString::number(settings.rounds) << "--output" << base << "--progress"
            << "json";
  if (settings.crop) {
    arguments << "--crop";
    for (const int number : {settings.crop->x, settings.crop->y, settings.crop->width, settings.crop->height})
      arguments << QString::number(number);
  }
  return arguments;
}

}  // namespace

CostRun::CostRun(QString program, QObject* parent) : QObject(parent), process_(std::move(program)) {
  connect(&writing_, &QFutureWatcher<QString>::finished, this, [this] { run(writing_.result()); });
  connect(&process_, &RendererProcess::reported, this, &CostRun::read);
  connect(&process_, &RendererProcess::ended, this, [this](const RendererEnd& ended) { end(ended.problem); });
}

CostRun::~CostRun() {
  writing_.disconnect(this);
  writing_.waitForFinished();
}

void CostRun::start(const FinalRenderRequest& request, const CostSettings& settings,
                    const QString& continued) {
  if (is_running_) return;
  is_running_ = true;
  is_stopped_ = false;
  if (const QString why = process_.why_missing(); !why.isEmpty()) return end(why);
  const QString base = folder_.filePath("scene");
  arguments_ =
      QStringList{"cost", base + ".op"} + arguments_of(settings, folder_.filePath("study"), continued);
  FinalRenderRequest snapshot = request;
  snapshot.options = with_absolute_paths(std::move(snapshot.options), request.path);
  snapshot.options.scene = (base + ".grf").toStdString();
  snapshot.options.shows_window = false;
  writing_.setFuture(QtConcurrent::run([snapshot = std::move(snapshot), base] {
    grf::Diagnostics diagnostics;
    const bool is_written = write_snapshot(snapshot.scene, snapshot.path, base + ".grf", diagnostics) &&
                            write_op_file(snapshot.options, base + ".op", diagnostics);
    return is_written ? QString() : text_of(diagnostics);
  }));
}

void CostRun::run(const QString& problem) {
  if (!problem.isEmpty() || is_stopped_) return end(problem);
  process_.start(arguments_);
}

void CostRun::stop() {
  if (!is_running_) return;
  is_stopped_ = true;
  process_.interrupt();
}

void CostRun::read(const QByteArray& line) {
  if (const auto study = cost_study_of(line)) {
    emit measured(*study);
  } else if (const auto report = render_report_of(line)) {
    emit progressed(report->done);
  }
}

void CostRun::end(const QString& problem) {
  is_running_ = false;
  emit ended(problem);
}

}  // namespace editor
