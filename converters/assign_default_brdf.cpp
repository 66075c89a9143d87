#include "converters/assign_default_brdf.h"

#include <algorithm>

namespace convert {
namespace {

bool is_bare(const grf::Surface& surface) { return !surface.brdf && !surface.emission; }

class Giver {
 public:
  explicit Giver(const grf::BrdfModel& brdf) : brdf_(brdf) {}

  void give(grf::BlockList& list) {
    for (grf::Block& block : list.blocks) {
      std::visit([this](auto& content) { give(content); }, block.content);
    }
  }

 private:
  // A mesh is edited, and so copied if it is shared, only if a face needs the BRDF.
  void give(grf::Shared<grf::Mesh>& mesh) {
    if (std::none_of(mesh->surfaces.begin(), mesh->surfaces.end(), is_bare)) return;
    for (grf::Surface& surface : mesh.edit().surfaces) {
      if (is_bare(surface)) surface.brdf = brdf_;
    }
  }
  void give(grf::AreaLight&) {}
  void give(grf::Include& include) {
    grf::BlockList contents = *include.contents;
    give(contents);
    if (!(contents == *include.contents)) include.contents = std::move(contents);
  }
  void give(grf::Transform& transform) { give(transform.body); }
  void give(grf::DefinitionScope& scope) {
    for (grf::Definition& definition : scope.definitions) {
      if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) give(*mesh);
    }
    give(scope.body);
  }
  void give(grf::MeshLight&) {}
  void give(grf::Params&) {}
  void give(grf::Use&) {}

  const grf::BrdfModel& brdf_;
};

}  // namespace

void assign_default_brdf(grf::Scene& scene, const grf::BrdfModel& brdf) { Giver(brdf).give(scene.contents); }

}  // namespace convert
