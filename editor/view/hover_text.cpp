#include "editor/view/hover_text.h"

#include <QStringList>

#include "editor/view/scene_view.h"

namespace editor {

QString hover_text(const SceneObjects& objects, FaceId face) {
  const MeshObject& mesh = objects.meshes[face.mesh];
  const FlatSurface& flat_surface = mesh.flat_surfaces[(*mesh.mesh->surface_of_face)[face.face]];
  QStringList surface(flat_surface.brdf ? QString::fromStdString(flat_surface.brdf->keyword)
                                        : SceneView::tr("default diffuse"));
  if (!flat_surface.texture.empty()) surface += SceneView::tr("textured");
  if (flat_surface.emission) surface += SceneView::tr("emissive");
  return SceneView::tr("%1 · face %2 · %3")
      .arg(mesh.name.empty() ? SceneView::tr("unnamed mesh") : QString::fromStdString(mesh.name),
           QString::number(face.face), mesh.is_light ? SceneView::tr("light") : surface.join(", "));
}

}  // namespace editor
