#include "editor/document/risk_repair.h"

#include <numbers>

#include "editor/document/geometry_edits.h"
#include "editor/document/object_edits.h"
#include "editor/document/texture_coordinates.h"

namespace editor {

using convert::RiskKind;

FaceSelection faces_of(const convert::Risk& risk, const SceneObjects& objects) {
  FaceSelection faces(objects);
  const std::optional<std::uint32_t> mesh = objects.mesh_at(risk.path);
  if (!mesh) return faces;
  const std::size_t count = objects.meshes[*mesh].mesh->face_count();
  if (risk.faces.empty()) faces.set_mesh(*mesh);
  for (const std::uint32_t face : risk.faces) {
    if (face < count) faces.set({*mesh, face});
  }
  return faces;
}

bool has_repair(RiskKind kind) {
  return kind != RiskKind::LampInSolid && kind != RiskKind::EnergyGain && kind != RiskKind::FarFromMiddle;
}

std::optional<grf::Scene> repaired(const grf::Scene& scene, const SceneObjects& objects,
                                   const convert::Risk& risk) {
  constexpr double Crease = std::numbers::pi / 6;
  const FaceSelection selection = faces_of(risk, objects);
  const SelectedFaces faces = {scene, objects, selection};
  switch (risk.kind) {
    case RiskKind::FacesWithoutArea:
    case RiskKind::DuplicateFaces:
      return without_faces(faces);
    case RiskKind::InwardFaces:
      return flipped(faces);
    case RiskKind::NormalsAgainstFaces:
      return with_smooth_normals(faces, Crease);
    case RiskKind::UvWithoutArea:
      return with_projected_uvs(faces, UvProjection::Box);
    case RiskKind::DuplicateMesh: {
      grf::Diagnostics diagnostics;
      return remove_objects(scene, {risk.path}, {}, diagnostics);
    }
    case RiskKind::LampInSolid:
    case RiskKind::EnergyGain:
    case RiskKind::FarFromMiddle:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace editor
