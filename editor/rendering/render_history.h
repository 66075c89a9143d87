#pragma once

#include <QListWidget>

#include "editor/rendering/final_render.h"

namespace editor {

/// The list of this session's renders, newest first.
class RenderHistory : public QListWidget {
  Q_OBJECT

 public:
  explicit RenderHistory(QWidget* parent = nullptr);

  void add(const FinalRenderResult& result, const image::Image& image);

  QSize sizeHint() const override;

 signals:
  /// Emitted on click or Return with the path of an image that later renders did not overwrite.
  void image_chosen(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace editor
