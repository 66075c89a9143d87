#include "editor/graphics/offscreen_context.h"

#include <QOpenGLContext>

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

}  // namespace editor
