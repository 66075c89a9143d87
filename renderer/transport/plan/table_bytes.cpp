#include "renderer/transport/plan/table_bytes.h"

#include <set>

#include "grf/visit.h"
#include "renderer/parallel/loops.h"
#include "renderer/transport/scene/reflector_set.h"

namespace transport {
namespace {

using Bytes = std::map<std::pair<std::string, std::string>, std::size_t>;

/// One at a time: an error in one is none in the others.
void add_bytes(const grf::ResolvedSurface& surface, const CompileSettings& settings, Bytes& bytes,
               grf::Diagnostics& diagnostics) {
  ReflectorSetBuilder builder(settings.scheme, settings.missed_part, settings.precision, diagnostics);
  builder.index_of(surface);
  if (diagnostics.error_count() > 0) return;
  const ReflectorSet set = builder.build();
  for (const TableInfo& table : set.tables) bytes[{table.brdf, table.scheme}] = table.bytes;
}

}  // namespace

Bytes table_bytes(const grf::Scene& scene, const CompileSettings& settings, grf::Diagnostics& diagnostics) {
  Bytes bytes;
  std::set<std::pair<const grf::BrdfModel*, const grf::PdfModel*>> known;
  const auto reflects = [&](const grf::Mesh& mesh, std::size_t surface) {
    if (!settings.reflecting) return true;
    const auto found = settings.reflecting->find(&mesh);
    return found != settings.reflecting->end() && found->second[surface];
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const std::vector<bool> used = used_surfaces(mesh);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      const grf::ResolvedSurface surface = resolve(mesh.surfaces[i], placement.scope);
      const bool is_emitter = surface.brdf == nullptr && surface.emission;
      if (is_emitter || !known.emplace(surface.brdf, surface.pdf).second) continue;
      grf::Diagnostics unheard;
      add_bytes(surface, settings, bytes, reflects(mesh, i) ? diagnostics : unheard);
    }
  };
  parallel::run_with_threads(settings.threads, [&] { grf::visit(scene, visitor); });
  return bytes;
}

}  // namespace transport
