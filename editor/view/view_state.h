#pragma once

#include <QColor>
#include <QSize>
#include <cstdint>
#include <memory>
#include <vector>

#include "editor/document/face_selection.h"
#include "editor/view/geometry_store.h"
#include "editor/view/overlay_painter.h"
#include "editor/view/picture_painter.h"
#include "editor/view/texture_store.h"

namespace editor {

struct ViewColours {
  QColor background_top;
  QColor background_bottom;
  QColor accent;  ///< of selected faces
};

/// All that is to be seen in a view. What is shared is the same as before while its pointer is.
struct ViewState {
  std::int64_t number = 0;  ///< a later state has a greater one
  std::shared_ptr<const SceneObjects> objects;
  std::shared_ptr<const FaceSelection> selection;
  std::vector<MeshShape> shapes;
  std::vector<ReadTexture> textures;
  PictureRequest request;
  QSize size;  ///< pixels of the screen
  OverlayPainter::Screen screen;
  ViewColours colours;
  std::vector<OverlayLayer> overlay;
};

}  // namespace editor
