#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>

#include "renderer/transport/image/image.h"

namespace editor {

/// Converts an image to sRGB, downscaled to fit into `pixels` with its aspect ratio.
QImage fitted(const transport::Image& image, const QSize& pixels);

/// Displays an image scaled to fit. A click or Return requests to open it.
class FittedImage : public QWidget {
  Q_OBJECT

 public:
  explicit FittedImage(QWidget* parent = nullptr);

  /// Sets the image; null shows none.
  void set_image(std::shared_ptr<const transport::Image> image);
  const std::shared_ptr<const transport::Image>& image() const { return image_; }
  /// Sets the text shown while there is no image.
  void set_hint(const QString& hint);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void activated();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::shared_ptr<const transport::Image> image_;
  QImage drawn_;  ///< cache for the last painted size; null before the first painting
  QString hint_;
};

}  // namespace editor
