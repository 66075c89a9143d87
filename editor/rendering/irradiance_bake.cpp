#include "editor/rendering/irradiance_bake.h"

#include <QRegularExpression>
#include <QtConcurrent>
#include <utility>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"
#include "grf/read.h"

namespace editor {
namespace {

/// Resets options that do not concern the irradiance, or would write files.
options::RenderOptions bake_options(options::RenderOptions render_options, const QString& scene_path,
                                    const QString& snapshot) {
  render_options = with_absolute_paths(std::move(render_options), scene_path);
  render_options.scene = snapshot.toStdString();
  render_options.output.clear();
  render_options.checkpoint.clear();
  render_options.display_server.clear();
  render_options.shows_window = false;
  return render_options;
}

}  // namespace

IrradianceBake::IrradianceBake(QString program, QObject* parent)
    : QObject(parent), process_(std::move(program)) {
  connect(&writing_, &QFutureWatcher<QString>::finished, this, [this] { run(writing_.result()); });
  connect(&reading_, &QFutureWatcher<std::shared_ptr<Baked>>::finished, this, &IrradianceBake::finish);
  connect(&process_, &RendererProcess::reported, this, &IrradianceBake::read);
  connect(&process_, &RendererProcess::ended, this, &IrradianceBake::end);
}

IrradianceBake::~IrradianceBake() {
  writing_.disconnect(this);
  writing_.waitForFinished();
  process_.kill();
  reading_.disconnect(this);
  reading_.waitForFinished();
}

QString IrradianceBake::file(const char* extension) const { return folder_.filePath("scene.") + extension; }

void IrradianceBake::start(const grf::Scene& scene, const QString& path,
                           options::RenderOptions render_options) {
  if (is_running_) return emit failed(tr("irradiance is already being baked: stop that first"));
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit failed(why);
  is_running_ = true;
  is_stopped_ = false;
  const QString named = naming_path(path);
  snapshot_ = scene;
  summary_.reset();
  result_ = {};
  render_options = bake_options(std::move(render_options), named, file("grf"));
  writing_.setFuture(
      QtConcurrent::run([scene, render_options, from = named, base = folder_.filePath("scene")] {
        return write_snapshot_files(scene, from, render_options, base);
      }));
}

void IrradianceBake::run(const QString& problem) {
  if (!problem.isEmpty()) return give_up(problem);
  if (is_stopped_) return give_up(tr("stopped before any irradiance was computed"));
  process_.start({"bake", file("op"), "-o", file("igrf"), "--progress", "json", "--json"});
}

void IrradianceBake::stop() {
  if (!is_running_) return;
  is_stopped_ = true;
  process_.interrupt();
}

void IrradianceBake::read(const QByteArray& line) {
  if (const auto report = render_report_of(line)) {
    emit progressed(report->done, report->seconds_left);
  } else if (const auto summary = bake_summary_of(line)) {
    summary_ = summary;
  }
}

void IrradianceBake::end(const RendererEnd& end) {
  if (!end.problem.isEmpty()) return give_up(without_snapshot(end.problem));
  if (!summary_) return give_up(tr("stopped before any irradiance was computed"));
  result_ = {*summary_, without_snapshot(process_.lines().join('\n')), end.is_interrupted};
  reading_.setFuture(QtConcurrent::run([file = file("igrf").toStdString(), snapshot = snapshot_] {
    grf::Diagnostics diagnostics;
    auto baked = std::make_shared<Baked>();
    if (const auto scene = grf::read(file, diagnostics)) {
      baked->irradiance.emplace(snapshot, *scene);
    } else {
      baked->problem = text_of(diagnostics);
    }
    return baked;
  }));
}

void IrradianceBake::finish() {
  const Baked baked = std::move(*reading_.result());  // the future would keep it
  if (!baked.irradiance) return give_up(without_snapshot(baked.problem));
  is_running_ = false;
  snapshot_ = {};
  emit finished(*baked.irradiance, result_);
}

void IrradianceBake::give_up(const QString& why) {
  is_running_ = false;
  snapshot_ = {};
  emit failed(why);
}

/// Removes locations in the snapshot, which mean nothing to the user; quoted lines are kept.
QString IrradianceBake::without_snapshot(QString text) const {
  const QString name = QRegularExpression::escape(file("")) + "i?grf";
  return text.remove(QRegularExpression(name + "(:\\d+:\\d+)?: "));
}

}  // namespace editor
