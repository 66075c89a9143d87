#include "editor/panels/scene_check.h"

#include <QtConcurrentRun>
#include <utility>

#include "grf/check.h"

namespace editor {

SceneCheck::SceneCheck(Document& document, grf::Catalogue catalogue, QObject* parent)
    : QObject(parent), document_(document), catalogue_(std::move(catalogue)) {
  constexpr int PauseMilliseconds = 150;  // edits of a gesture follow each other faster
  pause_.setSingleShot(true);
  pause_.setInterval(PauseMilliseconds);
  connect(&pause_, &QTimer::timeout, this, &SceneCheck::start);
  connect(&running_, &QFutureWatcher<grf::Diagnostics>::finished, this, &SceneCheck::take_result);
  connect(&document_, &Document::changed, this, [this] {
    is_outdated_ = true;
    pause_.start();
  });
  pause_.start();
}

SceneCheck::~SceneCheck() { running_.waitForFinished(); }

void SceneCheck::start() {
  // The running check is of an older scene: the next one starts when it ends.
  if (is_running_) return;
  is_running_ = true;
  is_outdated_ = false;
  running_.setFuture(QtConcurrent::run([scene = document_.scene(), this] {
    grf::Diagnostics diagnostics;
    grf::check(scene, catalogue_, diagnostics);
    return diagnostics;
  }));
}

void SceneCheck::take_result() {
  is_running_ = false;
  diagnostics_ = running_.result();
  if (is_outdated_ && !pause_.isActive()) start();
  emit checked();
}

}  // namespace editor
