#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>

#include "renderer/transport/image/image.h"

namespace editor {

/// An image as a screen shows it, no larger than so many pixels and in its own proportions; encoded in sRGB.
QImage fitted(const transport::Image& image, const QSize& pixels);

/// A small display of an image, as large as fits. A click, or Return, opens it elsewhere.
class FittedImage : public QWidget {
  Q_OBJECT

 public:
  explicit FittedImage(QWidget* parent = nullptr);

  /// Null: none.
  void set_image(std::shared_ptr<const transport::Image> image);
  const std::shared_ptr<const transport::Image>& image() const { return image_; }
  /// What is said while there is none.
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
  QImage drawn_;  ///< for the size at which it was last painted; null: not painted yet
  QString hint_;
};

}  // namespace editor
