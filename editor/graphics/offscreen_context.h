#pragma once

#include <QOffscreenSurface>
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

}  // namespace editor
