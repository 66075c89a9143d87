#pragma once

#include "editor/view/overlay_painter.h"
#include "editor/view/scene_view.h"
#include "editor/view/view_pictures.h"

namespace editor {

struct SceneView::Graphics {
  explicit Graphics(Gl& functions)
      : gl(functions),
        scene(functions),
        pictures(functions, scene),
        overlay(functions),
        no_vertices(functions, GlKind::VertexArray),
        compose(program_of("screen.vert", {"picture.glsl", "compose.frag"})) {}

  Gl& gl;
  SceneBuffers scene;
  ViewPictures pictures;
  OverlayPainter overlay;
  GlObject no_vertices;
  std::unique_ptr<QOpenGLShaderProgram> compose;
};

}  // namespace editor
