#include "converters/surface_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "converters/returned_surface.h"
#include "grf/read.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr std::size_t MostSurfaces = 100;

double mean(const Rgb& rgb) { return (double(rgb.x) + double(rgb.y) + double(rgb.z)) / 3; }

double mean_difference(const Rgb& a, const Rgb& b) {
  return (std::abs(double(a.x - b.x)) + std::abs(double(a.y - b.y)) + std::abs(double(a.z - b.z))) / 3;
}

/// A surface of a scene, and what becomes of it.
struct Entry {
  ReflectingSurface original;
  std::size_t faces = 0;
  std::optional<ReflectingSurface> returned;
};

/// The integral of |f' - f| cos over directions, and that of f cos.
struct LobeDifference {
  double difference = 0;
  double total = 0;
};

/// Samples directions of both BRDFs in turn, with the mean of both pdfs.
LobeDifference lobe_difference(const Entry& entry, const Reflector& a, const Reflector& b, const Vec3f& u) {
  constexpr int Count = 4096;
  const grf::Colour& colour = entry.original.colour;
  const grf::Colour& returned_colour = entry.returned->colour;
  LobeDifference result;
  for (int i = 0; i < Count; ++i) {
    const reflectance::Uniforms xi = reflectance::halton_point(static_cast<std::uint32_t>(i / 2));
    const auto sample = (i % 2 == 0 ? a : b).sample(u, xi);
    if (!sample || !(sample->pdf > 0) || !(sample->direction.z > 0)) continue;  // none, or a delta one
    const Vec3f& v = sample->direction;
    const double density = (double(a.pdf(u, v)) + double(b.pdf(u, v))) / 2;
    if (!(density > 0)) continue;
    const Rgb value = a.evaluate(u, v) * colour;
    const double weight = double(v.z) / density / Count;
    result.difference += weight * mean_difference(b.evaluate(u, v) * returned_colour, value);
    result.total += weight * mean(value);
  }
  const Rgb mirror = reflectance::specular_weight(a.brdf(), u) * colour;
  result.difference += mean_difference(reflectance::specular_weight(b.brdf(), u) * returned_colour, mirror);
  result.total += mean(mirror);
  return result;
}

SurfaceComparison compared(const Entry& entry) {
  SurfaceComparison comparison;
  comparison.original = entry.original.text();
  comparison.returned = entry.returned->text();
  comparison.faces = entry.faces;
  const Reflector a(entry.original.made, reflectance::OwnScheme());
  const Reflector b(entry.returned->made, reflectance::OwnScheme());
  LobeDifference sum;
  for (std::size_t i = 0; i < ComparedDegrees.size(); ++i) {
    const double theta = ComparedDegrees[i] * std::numbers::pi / 180;
    const Vec3f u(static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta)));
    comparison.albedos[i] = mean(reflectance::albedo(a, u) * entry.original.colour);
    comparison.returned_albedos[i] = mean(reflectance::albedo(b, u) * entry.returned->colour);
    const LobeDifference one = lobe_difference(entry, a, b, u);
    sum.difference += one.difference;
    sum.total += one.total;
  }
  if (sum.total > 0) comparison.lobe_error = sum.difference / sum.total;
  return comparison;
}

/// Collects the surfaces of a scene, and replaces them.
class SurfaceComparer {
 public:
  SurfaceComparer(const Format& format, std::string folder, grf::Diagnostics& diagnostics)
      : format_(format), folder_(std::move(folder)), diagnostics_(diagnostics) {}

  std::optional<ComparedScene> compare(const grf::Scene& scene);

 private:
  void add(const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block& block);
  grf::Scene mapped(const grf::Scene& scene) const;
  void replace(const grf::BlockList& original, grf::BlockList& copy) const;
  void replace(const void* place, grf::Shared<grf::Mesh>& mesh) const;
  void replace(grf::Mesh& mesh, const std::vector<std::size_t>& entries) const;

  const Format& format_;
  std::string folder_;
  grf::Diagnostics& diagnostics_;
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> entry_of_text_;
  /// By the definition or block of a mesh and the mesh's surfaces: a mesh that is included twice is shared,
  /// and names in it can mean something else.
  std::map<const void*, std::vector<std::size_t>> entries_of_place_;
};

// Instances have the surfaces of their definition.
void SurfaceComparer::add(const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block& block) {
  std::vector<std::size_t> faces(mesh.surfaces.size());
  for (const std::uint32_t surface : *mesh.surface_of_face) ++faces[surface];
  const void* place = &block;
  if (placement.instance_of != nullptr) place = placement.instance_of;
  std::vector<std::size_t>& entries = entries_of_place_[place];
  const bool is_known = !entries.empty();
  for (std::size_t i = 0; i < mesh.surfaces.size() && !diagnostics_.has_errors(); ++i) {
    if (!is_known) {
      const grf::ResolvedSurface surface = grf::resolve(mesh.surfaces[i], placement.scope);
      auto reflecting = reflecting_surface(surface, diagnostics_);
      if (!reflecting) return;
      const auto [known, is_new] = entry_of_text_.emplace(reflecting->text(), entries_.size());
      if (is_new) {
        const std::string name = fmt::format("returned_{}", entries_.size() + 1);
        Entry entry{*reflecting, 0, {}};
        entry.returned = returned_surface(*reflecting, surface, format_, name, folder_, diagnostics_);
        entries_.push_back(std::move(entry));
      }
      entries.push_back(known->second);
    }
    entries_[entries[i]].faces += faces[i];
  }
}

void SurfaceComparer::replace(grf::Mesh& mesh, const std::vector<std::size_t>& entries) const {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ReflectingSurface& returned = *entries_[entries[i]].returned;
    grf::Surface& surface = mesh.surfaces[i];
    if (!surface.brdf && surface.emission) continue;
    surface.brdf = returned.model;
    surface.colour = returned.colour;
  }
}

void SurfaceComparer::replace(const void* place, grf::Shared<grf::Mesh>& mesh) const {
  const auto found = entries_of_place_.find(place);
  if (found != entries_of_place_.end()) replace(mesh.edit(), found->second);
}

void SurfaceComparer::replace(const grf::BlockList& original, grf::BlockList& copy) const {
  for (std::size_t i = 0; i < original.blocks.size(); ++i) {
    const grf::Block& block = original.blocks[i];
    grf::Block& copied = copy.blocks[i];
    if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&copied.content)) replace(&block, *mesh);
    if (auto* transform = std::get_if<grf::Transform>(&copied.content))
      replace(std::get<grf::Transform>(block.content).body, transform->body);
    if (auto* scope = std::get_if<grf::DefinitionScope>(&copied.content)) {
      const auto& definitions = std::get<grf::DefinitionScope>(block.content);
      for (std::size_t k = 0; k < scope->definitions.size(); ++k) {
        if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&scope->definitions[k].body))
          replace(&definitions.definitions[k], *mesh);
      }
      replace(definitions.body, scope->body);
    }
  }
}

// The names of the returned BRDFs are defined around the scene.
grf::Scene SurfaceComparer::mapped(const grf::Scene& scene) const {
  std::string definitions;
  for (const Entry& entry : entries_) definitions += entry.returned->definitions;
  grf::Scene result = scene;
  replace(scene.contents, result.contents);
  if (definitions.empty()) return result;
  grf::Diagnostics ignored;  // the definitions were read before
  auto around = grf::read_text("def\n" + definitions + "begin\nend\n", "surfaces", ignored);
  for (grf::Block& block : around->contents.blocks) {
    if (auto* scope = std::get_if<grf::DefinitionScope>(&block.content)) scope->body = result.contents;
  }
  return *std::move(around);
}

std::optional<ComparedScene> SurfaceComparer::compare(const grf::Scene& scene) {
  grf::SceneVisitor visitor;
  visitor.mesh = [this](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block& block) {
    if (!diagnostics_.has_errors()) add(mesh, placement, block);
  };
  grf::visit(scene, visitor);
  if (diagnostics_.has_errors()) return std::nullopt;
  ComparedScene result;
  if (format_.read == nullptr) result.mapped = mapped(scene);
  std::vector<const Entry*> order;
  for (const Entry& entry : entries_) {
    if (entry.faces > 0) order.push_back(&entry);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Entry* a, const Entry* b) { return a->faces > b->faces; });
  const std::size_t count = std::min(order.size(), MostSurfaces);
  result.surfaces_left_out = order.size() - count;
  for (std::size_t i = 0; i < count; ++i) result.surfaces.push_back(compared(*order[i]));
  return result;
}

}  // namespace

double SurfaceComparison::albedo_change() const {
  double largest = 0;
  for (std::size_t i = 0; i < albedos.size(); ++i)
    largest = std::max(largest, std::abs(returned_albedos[i] - albedos[i]));
  return largest;
}

std::optional<ComparedScene> compare_surfaces(const grf::Scene& scene, const Format& format,
                                              const std::string& folder, grf::Diagnostics& diagnostics) {
  return SurfaceComparer(format, folder, diagnostics).compare(scene);
}

}  // namespace convert
