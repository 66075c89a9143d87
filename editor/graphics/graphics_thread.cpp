#include "editor/graphics/graphics_thread.h"

#include <utility>

namespace editor {

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
