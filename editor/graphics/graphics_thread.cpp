#include "editor/graphics/graphics_thread.h"

#include <QOpenGLContext>
#include <utility>

namespace editor {

OffscreenContext::OffscreenContext() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  surface_.setFormat(format);
  surface_.create();
}

OffscreenContext::~OffscreenContext() = default;

QOpenGLContext* OffscreenContext::make_current() {
  if (is_refused_) return nullptr;
  if (context_ == nullptr) {
    context_ = std::make_unique<QOpenGLContext>();
    context_->setFormat(surface_.format());
    is_refused_ = !context_->create() || context_->format().version() < qMakePair(3, 3);
  }
  if (is_refused_ || !context_->makeCurrent(&surface_)) return nullptr;
  return context_.get();
}

void OffscreenContext::end() { context_.reset(); }

GraphicsThread::GraphicsThread(const QString& name, std::function<void()> at_end) : receiver_(new QObject) {
  receiver_->moveToThread(&thread_);
  // Emitted by the thread itself, which owns the objects of the context.
  QObject::connect(
      &thread_, &QThread::finished, receiver_,
      [this, at_end = std::move(at_end)] {
        at_end();
        context_.end();
      },
      Qt::DirectConnection);
  thread_.setObjectName(name);
  thread_.start();
}

GraphicsThread::~GraphicsThread() {
  thread_.quit();
  thread_.wait();
  delete receiver_;
}

void GraphicsThread::run(Task task) {
  QMetaObject::invokeMethod(
      receiver_, [this, task = std::move(task)] { task(context_.make_current()); }, Qt::QueuedConnection);
}

}  // namespace editor
