#include "editor/rendering/final_render.h"

#include <QDir>
#include <QFileInfo>
#include <QtConcurrent>
#include <algorithm>
#include <utility>

#include <unistd.h>

#include "editor/controls/text.h"
#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"
#include "grf/text_file.h"
#include "renderer/job/camera_path.h"

namespace editor {
namespace {

/// Keeps an image as it is, if possible as a hard link, at no cost: the renderer replaces files instead of
/// writing into them.
bool keep_copy(const QString& image, const QString& copy) {
  return ::link(QFile::encodeName(image).constData(), QFile::encodeName(copy).constData()) == 0 ||
         QFile::copy(image, copy);
}

}  // namespace

FinalRender::FinalRender(QString program, QObject* parent) : QObject(parent), process_(std::move(program)) {
  connect(&writing_, &QFutureWatcher<Files>::finished, this, [this] { run(writing_.result()); });
  connect(&reading_, &QFutureWatcher<Outcome>::finished, this, &FinalRender::finish);
  connect(&process_, &RendererProcess::reported, this, &FinalRender::read);
  connect(&process_, &RendererProcess::logged, this, &FinalRender::logged);
  connect(&process_, &RendererProcess::ended, this, &FinalRender::end);
}

FinalRender::~FinalRender() {
  writing_.disconnect(this);
  writing_.waitForFinished();
  reading_.disconnect(this);
  reading_.waitForFinished();
}

QString FinalRender::output_of(const FinalRenderRequest& request) const {
  const QFileInfo scene(request.path);
  if (!request.options.output.empty()) {
    return QString::fromStdString(with_absolute_paths(request.options, request.path).output);
  }
  if (request.path.isEmpty()) return folder_.filePath(tr("Untitled") + ".exr");
  return QDir(scene.absolutePath()).filePath(scene.completeBaseName() + ".exr");
}

QStringList FinalRender::images_of(const FinalRenderRequest& request) const {
  const QString output = output_of(request);
  QStringList images;
  for (const int frame : job::frames_of(request.options)) {
    images << QString::fromStdString(job::file_of_frame(output.toStdString(), frame));
  }
  return images.isEmpty() ? QStringList(output) : images;
}

bool FinalRender::is_from_other_session(const QString& output) const {
  return QFileInfo::exists(output) && !rendered_.contains(output);
}

bool FinalRender::lock_output() {
  const QFileInfo image(output_);
  lock_ = std::make_unique<QLockFile>(image.dir().filePath("." + image.fileName() + ".lock"));
  lock_->setStaleLockTime(0);  // while its process lives
  if (lock_->tryLock()) return true;
  // If no lock can be made, the image cannot be written either: the renderer reports that better.
  return lock_->error() != QLockFile::LockFailedError;
}

void FinalRender::start(FinalRenderRequest request) {
  if (is_running_) return emit failed(tr("a render is already running: stop it first"));
  if (const QString why = process_.why_missing(); !why.isEmpty()) return emit failed(why);
  const QString output = output_of(request);
  images_ = images_of(request);
  done_images_ = 0;
  output_ = images_.front();
  request.options = with_absolute_paths(std::move(request.options), request.path);
  const std::string& environment = request.options.environment;
  if (!environment.empty() && grf::canonical_path(environment) == grf::canonical_path(output_.toStdString()))
    return emit failed(
        tr("the output %1 is the scene's environment map: choose another output").arg(output_));
  for (const QString& image : images_) {
    if (request.may_overwrite || !is_from_other_session(image)) continue;
    return emit failed(
        tr("%1 exists and was not rendered in this session: choose another output").arg(image));
  }
  if (!lock_output())
    return emit failed(
        tr("another render is writing %1: wait for it, or choose another output").arg(output_));
  is_running_ = true;
  is_stopped_ = false;
  summary_.reset();
  farm_ = request.farm;
  const QString base = folder_.filePath(QString("render%1").arg(++number_));
  request.options.output = output.toStdString();
  request.options.scene = (base + ".grf").toStdString();
  request.options.shows_window = false;
  if (!display_.isEmpty()) request.options.display_server = display_.toStdString();
  emit started(output_);
  // Frames of an animation are compared with nothing.
  const QString replaced = images_.size() == 1 ? output_ : QString();
  const QString former = base + "_former." + QFileInfo(output_).suffix();
  writing_.setFuture(QtConcurrent::run([request = std::move(request), base, replaced, former] {
    const QString problem = write_snapshot_files(request.scene, request.path, request.options, base);
    const bool is_kept = QFile::exists(replaced) && keep_copy(replaced, former);
    return problem.isEmpty() ? Files{base + ".op", {}, is_kept ? former : QString()} : Files{{}, problem, {}};
  }));
}

void FinalRender::run(const Files& files) {
  if (files.options.isEmpty()) return give_up(files.problem);
  if (is_stopped_) return give_up(tr("stopped before the first image"));
  former_ = files.former;
  options_file_ = files.options;
  if (farm_) return run_on_farm();
  process_.start({"render", files.options, "--progress", "json", "--json"});
}

/// Each frame of an animation is a job of its own on the farm. A job that was stopped resumes from its
/// ledger.
void FinalRender::run_on_farm() {
  QStringList arguments = {"farm", "render", options_file_, "--output", output_, "--server", farm_->server};
  const auto add = [&](const char* flag, const QString& value) {
    if (!value.isEmpty()) arguments << flag << value;
  };
  add("--token-file", farm_->token_file);
  add("--tls-ca", farm_->authority_file);
  add("--tls-cert", farm_->certificate_file);
  add("--tls-key", farm_->key_file);
  if (images_.size() > 1) arguments << "--frame" << QString::number(done_images_ + 1);
  process_.start(arguments << "--progress"
                           << "json"
                           << "--json");
}

void FinalRender::stop() {
  if (!is_running_) return;
  is_stopped_ = true;
  process_.interrupt();
}

void FinalRender::show(const QString& name, const std::shared_ptr<const image::Image>& image) {
  if (is_running_ && name == output_) emit image_changed(image);
}

void FinalRender::read(const QByteArray& line) {
  if (auto report = render_report_of(line)) {
    if (images_.size() > 1) {
      report->done = (done_images_ + report->done) / static_cast<double>(images_.size());
      report->seconds_left.reset();  // it is that of the frame
    }
    emit progressed(*report);
  } else if (const auto summary = render_summary_of(line)) {
    summary_ = summary;
    rendered_.insert(output_);
    if (++done_images_ < images_.size()) output_ = images_[done_images_];
  }
}

void FinalRender::end(const RendererEnd& end) {
  if (!end.problem.isEmpty()) return give_up(end.problem);
  if (!summary_) {
    return give_up(end.is_interrupted ? tr("stopped before the first image")
                                      : tr("the renderer wrote no image"));
  }
  if (farm_ && !end.is_interrupted && done_images_ < images_.size()) return run_on_farm();
  output_ = images_[done_images_ - 1];
  FinalRenderResult result;
  result.image = output_;
  result.summary = *summary_;
  result.is_stopped = end.is_interrupted;
  result.former = former_;
  const QString copy = folder_.filePath(QString("render%1.%2").arg(number_).arg(QFileInfo(output_).suffix()));
  reading_.setFuture(QtConcurrent::run(&FinalRender::read_result, result, copy));
}

FinalRender::Outcome FinalRender::read_result(FinalRenderResult result, const QString& copy) {
  result.copy = keep_copy(result.image, copy) ? copy : result.image;
  grf::Diagnostics ignored_diagnostics;  // the renderer has just written it
  Outcome left = {std::move(result), nullptr};
  auto image = image::read_image(left.result.image.toStdString(), ignored_diagnostics);
  if (image) left.image = std::make_shared<const image::Image>(std::move(*image));
  return left;
}

void FinalRender::finish() {
  const Outcome left = reading_.result();
  is_running_ = false;
  lock_.reset();
  if (left.image) emit image_changed(left.image);
  emit finished(left.result);
}

void FinalRender::give_up(const QString& why) {
  is_running_ = false;
  lock_.reset();
  emit failed(why);
}

}  // namespace editor
