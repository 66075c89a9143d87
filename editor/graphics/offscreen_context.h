#pragma once

#include <QOffscreenSurface>
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

}  // namespace editor
