#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <memory>

#include "renderer/image/image.h"

class QMenu;

namespace editor {

class ImageBrowser;
class ImageServer;
class Pages;
class RenderPanel;

/// Shows images of renders, of other programs and of files in the image view, which is created on first use.
class ImageController : public QObject {
  Q_OBJECT

 public:
  /// The menu is shown once there is an image view, with its actions. All outlive the controller.
  ImageController(RenderPanel& render, Pages& pages, QMenu& menu, QObject* parent);

  /// Goes to the image view.
  ImageBrowser& browser();

 private:
  void connect_renders();
  void compare_with_last();
  void take_sent(const QString& name, const std::shared_ptr<const image::Image>& image);

  RenderPanel& render_;
  Pages& pages_;
  QMenu& menu_;
  ImageServer* server_;
  ImageBrowser* browser_ = nullptr;
  QDeadlineTimer late_;  ///< for what is sent of a finished render
};

}  // namespace editor
