#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>

#include "editor/image/screen_colours.h"
#include "renderer/image/image.h"

namespace editor {

/// The fixed scale on which the relative error of pixels is shown in false colours: so they darken as it
/// falls.
ScreenSettings error_screen_settings();

/// Converts an image to sRGB, downscaled to fit into `pixels` with its aspect ratio. Where the relative error
/// of its pixels is given and finite, that is shown instead.
QImage fitted(const image::Image& image, const QSize& pixels, const image::Image* error = nullptr);

/// Displays an image scaled to fit. A click or Return requests to open it.
class FittedImage : public QWidget {
  Q_OBJECT

 public:
  explicit FittedImage(QWidget* parent = nullptr);

  /// Sets the image and the relative error of its pixels, if that is known; null shows none.
  void set_image(std::shared_ptr<const image::Image> image,
                 std::shared_ptr<const image::Image> error = nullptr);
  /// Shows the error in place of the image, where it is known.
  void set_error_shown(bool is_shown);
  const std::shared_ptr<const image::Image>& image() const { return image_; }
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
  std::shared_ptr<const image::Image> image_;
  std::shared_ptr<const image::Image> error_;
  bool is_error_shown_ = false;
  QImage drawn_;  ///< cache for the last painted size; null before the first painting
  QString hint_;
};

}  // namespace editor
