#pragma once

#include <QString>
#include <QThread>
#include <functional>

#include "editor/graphics/offscreen_context.h"

namespace editor {

/// A thread that draws images with OpenGL, which widgets then show: rendering is slow, above all in software,
/// and must not block the window.
class GraphicsThread {
 public:
  /// Receives the current context, or null without OpenGL 3.3.
  using Task = std::function<void(QOpenGLContext*)>;

  /// `at_end` is the last task of the thread, which destroys the objects of its context.
  GraphicsThread(const QString& name, std::function<void()> at_end);
  /// Waits for the running task; queued ones are dropped.
  ~GraphicsThread();
  GraphicsThread(const GraphicsThread&) = delete;
  GraphicsThread& operator=(const GraphicsThread&) = delete;

  /// Queues a task.
  void run(Task task);

 private:
  OffscreenContext context_;
  QThread thread_;
  QObject* receiver_;
};

}  // namespace editor
