#include "renderer/plan/table_bytes.h"

#include <set>

#include "grf/visit.h"
#include "grf/write.h"
#include "renderer/parallel/loops.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/transport/scene/reflector_set.h"

namespace plan {
namespace {

using transport::CompileSettings;

using IdentityAndScheme = std::pair<std::string, std::string>;
using Bytes = std::map<IdentityAndScheme, std::size_t>;

IdentityAndScheme key_of(const grf::ResolvedSurface& surface, const CompileSettings& settings,
                         reflectance::BrdfMaker& brdfs) {
  const grf::PdfModel* scheme = settings.scheme ? &settings.scheme->model : surface.pdf;
  return {surface.brdf != nullptr ? brdfs.identity(*surface.brdf, surface.brdf_scope) : std::string(),
          scheme != nullptr ? to_text(*scheme) : "auto"};
}

/// Handles one pair at a time: an error in one must not affect the others.
void add_bytes(const grf::ResolvedSurface& surface, const IdentityAndScheme& key,
               const CompileSettings& settings, Bytes& bytes, grf::Diagnostics& diagnostics) {
  transport::ReflectorSetBuilder builder(settings.scheme, settings.missed_part, settings.precision,
                                         diagnostics);
  builder.index_of(surface);
  if (diagnostics.error_count() > 0) return;
  const transport::ReflectorSet set = builder.build();
  for (const transport::TableInfo& table : set.tables) bytes[key] = table.bytes;
}

}  // namespace

Bytes table_bytes(const grf::Scene& scene, const CompileSettings& settings, grf::Diagnostics& diagnostics) {
  Bytes bytes;
  std::set<IdentityAndScheme> known;
  grf::Diagnostics ignored_diagnostics;
  reflectance::BrdfMaker brdfs(ignored_diagnostics);
  const auto reflects = [&](const grf::Mesh& mesh, std::size_t surface) {
    if (!settings.reflecting) return true;
    const auto found = settings.reflecting->find(&mesh);
    return found != settings.reflecting->end() && found->second[surface];
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const std::vector<bool> used = grf::used_surfaces(mesh);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      const grf::ResolvedSurface surface = resolve(mesh.surfaces[i], placement.scope);
      const bool is_emitter = surface.brdf == nullptr && surface.emission;
      if (is_emitter) continue;
      const auto [key, is_new] = known.insert(key_of(surface, settings, brdfs));
      if (!is_new) continue;
      grf::Diagnostics of_what_is_black;
      add_bytes(surface, *key, settings, bytes, reflects(mesh, i) ? diagnostics : of_what_is_black);
    }
  };
  parallel::run_with_threads(settings.threads, [&] { grf::visit(scene, visitor); });
  return bytes;
}

}  // namespace plan
