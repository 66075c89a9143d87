#pragma once

#include <QColor>
#include <QImage>
#include <QSize>
#include <cstdint>
#include <memory>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/view/frame_renderer.h"
#include "editor/view/geometry_store.h"
#include "editor/view/overlay_painter.h"
#include "editor/view/texture_store.h"

namespace editor {

struct ViewColours {
  QColor background_top;
  QColor background_bottom;
  QColor accent;  ///< selected faces
};

/// The complete state of a view. Shared members are unchanged while their pointer is.
struct ViewState {
  std::int64_t number = 0;  ///< increases from state to state
  std::shared_ptr<const SceneObjects> objects;
  std::shared_ptr<const FaceSelection> selection;
  std::shared_ptr<const FaceSelection> hidden;  ///< faces that are not drawn
  std::vector<MeshShape> shapes;
  std::vector<ReadTexture> textures;
  FrameRequest request;
  QSize size;  ///< device pixels
  /// Drawn in place of the faces and the background where it is opaque, stretched to the view; null: none.
  std::shared_ptr<const QImage> rendered;
  double backplate_aspect =
      1;  ///< width over height of the image that a backplate fills, as high as the view
  OverlayPainter::Screen screen;
  ViewColours colours;
  std::vector<OverlayLayer> overlay;
};

}  // namespace editor
