#pragma once

#include <QOffscreenSurface>
#include <QString>
#include <QThread>
#include <functional>
#include <memory>

class QOpenGLContext;

namespace editor {

/// An OpenGL 3.3 core context without a window. It is created and destroyed in the GUI thread, and used in
/// one thread.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();

  /// Creates the context on the first call. Null without OpenGL 3.3.
  QOpenGLContext* make_current();
  /// Releases the context in the thread that uses it, after its objects are destroyed.
  void end();

 private:
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  bool is_refused_ = false;
};

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
