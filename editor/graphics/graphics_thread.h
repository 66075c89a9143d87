#pragma once

#include <QOffscreenSurface>
#include <QString>
#include <QThread>
#include <functional>
#include <memory>

class QOpenGLContext;

namespace editor {

/// An OpenGL 3.3 core context without a window. It is made and destroyed in the GUI's thread, and used in
/// one.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();

  /// Makes the context when it is asked for first. Null without OpenGL 3.3.
  QOpenGLContext* make_current();
  /// In the thread that uses it, once what lives in the context is destroyed.
  void end();

 private:
  QOffscreenSurface surface_;
  std::unique_ptr<QOpenGLContext> context_;
  bool is_refused_ = false;
};

/// A thread that draws by OpenGL into pictures, which widgets then show: drawing takes long, above all by
/// software, and the window has to answer meanwhile.
class GraphicsThread {
 public:
  /// Gets the context, which is current, or null without OpenGL 3.3.
  using Task = std::function<void(QOpenGLContext*)>;

  /// `at_end` is the last that the thread does, with its context: what lives there is destroyed then.
  GraphicsThread(const QString& name, std::function<void()> at_end);
  /// Waits for the task that runs; those that did not start are forgotten.
  ~GraphicsThread();
  GraphicsThread(const GraphicsThread&) = delete;
  GraphicsThread& operator=(const GraphicsThread&) = delete;

  /// Does one task after the other.
  void run(Task task);

 private:
  OffscreenContext context_;
  QThread thread_;
  QObject* receiver_;
};

}  // namespace editor
