#include "editor/rendering/noise_places.h"

#include "editor/document/op_document.h"
#include "editor/document/surface_edits.h"
#include "grf/visit.h"
#include "renderer/transport/scene/reflector_set.h"

namespace editor {
namespace {

FaceSelection emitting_faces(const SceneObjects& objects, std::size_t instance) {
  FaceSelection selection(objects);
  if (instance >= objects.instances->size()) return selection;
  const std::uint32_t index = (*objects.instances)[instance].mesh;
  const MeshObject& object = objects.meshes[index];
  std::vector<bool> are_emitting;
  for (const FlatSurface& surface : object.flat_surfaces) {
    are_emitting.push_back(object.is_light || surface.emission.value_or(grf::Colour(0)) != grf::Colour(0));
  }
  select_surfaces(*object.mesh, index, are_emitting, selection);
  return selection;
}

}  // namespace

FaceSelection faces_with(const Document& document, const std::string& brdf, const std::string& scheme) {
  const SceneObjects& objects = document.objects();
  FaceSelection selection(objects);
  std::size_t instance = 0;
  grf::SceneVisitor visitor;
  visitor.mesh_light = [&](const grf::MeshLight&, const grf::Placement&, const grf::Block&) { ++instance; };
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    std::vector<bool> are_such;
    for (const grf::Surface& surface : mesh.surfaces) {
      const grf::ResolvedSurface resolved = grf::resolve(surface, placement.scope);
      are_such.push_back(transport::brdf_text(resolved.brdf) == brdf &&
                         (scheme.empty() || transport::scheme_text(resolved.pdf) == scheme));
    }
    select_surfaces(mesh, (*objects.instances)[instance++].mesh, are_such, selection);
  };
  grf::visit(document.scene(), visitor, document.path().toStdString());
  return selection;
}

bool select_part(Document& document, const NoiseShareRow& part) {
  using Kind = NoiseShareRow::Kind;
  const auto number = static_cast<std::size_t>(part.number);
  if (part.kind == Kind::AreaLight) {
    if (number >= document.objects().lights.size()) return false;
    document.select_objects({document.objects().lights[number].path});
    return true;
  }
  if (part.kind != Kind::Mesh && part.kind != Kind::Brdf) return false;
  const bool has_own_scheme = document.options().valid_options().scheme.empty();
  FaceSelection faces = part.kind == Kind::Mesh
                            ? emitting_faces(document.objects(), number)
                            : faces_with(document, part.brdf.toStdString(),
                                         has_own_scheme ? part.scheme.toStdString() : std::string());
  if (faces.empty()) return false;
  document.select(std::move(faces));
  return true;
}

void apply_change(Document& document, const NoiseTrial& change, const QString& title) {
  if (!change.option.isEmpty()) {
    options::RenderOptions now = document.options().valid_options();
    std::vector<std::string> words;
    for (const QString& word : change.value.split(' ')) words.push_back(word.toStdString());
    options::set_option(now, *options::find_option(change.option.toStdString()), words);
    return document.options().set_options(title, now);
  }
  document.select(faces_with(document, change.brdf.toStdString(), change.before.toStdString()));
  grf::PdfModel scheme;
  scheme.keyword = change.value.toStdString();
  SurfaceEdit edit;
  edit.pdf = AttributeEdit<grf::PdfAttribute>::set(scheme);
  document.edit_surfaces(title, edit);
}

}  // namespace editor
