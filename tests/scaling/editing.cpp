#include "tests/scaling/editing.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/face_query.h"

namespace scaling {

using editor::Document;
using editor::FaceSelection;

void edit(const grf::Scene& scene, const std::string& path) {
  Document document;
  document.take(scene, QString::fromStdString(path), {});
  FaceSelection selection(document.objects());
  if (selection.mesh_count() > 0) selection.set_mesh(0);
  connected(selection, document.objects());
  grown(selection, document.objects());
  select_similar(selection, document.objects(), editor::Similarity::of_surface());
  selection.select_all();
  document.select(selection);
  selected_area(document.objects(), selection);
  editor::SurfaceEdit change;
  grf::BrdfModel brdf;
  brdf.keyword = "phong";
  change.brdf = editor::AttributeEdit<grf::BrdfAttribute>::set(brdf);
  document.edit_surfaces("Assign phong", change);
  // A mesh light emits and does not reflect: it has no BRDF.
  const std::vector<std::uint32_t> meshes = selection.meshes();
  const bool reflects = std::any_of(meshes.begin(), meshes.end(), [&](std::uint32_t mesh) {
    return !document.objects().meshes[mesh].is_light;
  });
  EXPECT_EQ(document.is_modified(), reflects);
  document.undo_stack().undo();
  EXPECT_EQ(document.scene(), scene);
}

}  // namespace scaling
