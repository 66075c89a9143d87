#include "converters/obj/mtl_writer.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/visit.h"
#include "grf/write.h"

namespace convert {
namespace {

std::vector<float> components(const std::optional<grf::Colour>& colour) {
  return colour ? std::vector{colour->x, colour->y, colour->z} : std::vector<float>();
}

std::string numbers(const grf::Vec3d& v) {
  return fmt::format("{} {} {}", static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

/// Returns whether a name can be written: without leading or trailing spaces, and without line ends.
bool fits_a_line(std::string_view name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (name.empty()) return true;  // OBJ files can have an empty name
  return name.front() != ' ' && name.back() != ' ' && std::none_of(name.begin(), name.end(), is_control);
}

std::string name_of_definition(const grf::Definition& definition) {
  const std::string name = grf::from_identifier(definition.name);
  return fits_a_line(name) ? name : definition.name;
}

/// Converts a BRDF's text to a name without spaces: `ward_sx_0.2_ks_0.4`.
std::string name_of_text(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool is_kept = grf::is_word_character(c) || c == '.' || c == '-';
    if (is_kept) name += c;
    if (!is_kept && !name.empty() && name.back() != '_') name += '_';
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

/// Returns whether MTL represents a model exactly.
bool is_exact_in_mtl(const grf::BrdfModel& brdf) {
  constexpr std::array<std::string_view, 4> Exact = {"diffuse", "specular", "phong", "lewis"};
  return std::any_of(Exact.begin(), Exact.end(),
                     [&brdf](std::string_view keyword) { return grf::same_keyword(brdf.keyword, keyword); });
}

/// The table of conversions by `MtlWriter::text_of`.
constexpr std::array<MaterialRule, 8> MtlWriterRules = {{
    {"only a diffuse lobe", "`Kd`, `illum 1`", "brdf oren r=0.25", "Kd 0.25 0.25 0.25; Ks 0 0 0; illum 1",
     ""},
    {"a glossy lobe of exponent h", "`Ks`, `Ns` = h/4, `illum 2`", "brdf ashikhmin ex=80 Rs=0.25 Rd=0.5",
     "Kd 0.375 0.375 0.375; Ks 0.25 0.25 0.25; Ns 20; illum 2", ""},
    {"perfect specular reflection", "`Ks`, `Ns 1000`, `illum 3`", "brdf coupled R0=0.5 Rm=0.5",
     "Kd 0.25 0.25 0.25; Ks 0.5 0.5 0.5; Ns 1000; illum 3", ""},
    {"`rgb` of a face", "a factor of `Kd` and `Ks`", "rgb (0.5, 1, 1) brdf diffuse kd=0.5",
     "Kd 0.25 0.5 0.5; Ks 0 0 0; illum 1", ""},
    {"`light rgb` of a face, lights", "`Ke`; without a BRDF they are black", "light rgb (3, 2, 1)",
     "Kd 0 0 0; Ks 0 0 0; illum 1; Ke 3 2 1", ""},
    {"`texture`", "`map_Kd`", "brdf diffuse kd=0.5 texture \"wood.png\"",
     "Kd 0.5 0.5 0.5; Ks 0 0 0; illum 1; map_Kd wood.png", ""},
    {"`opacity` with a number", "`d`", "brdf diffuse kd=0.5 opacity 0.25",
     "Kd 0.5 0.5 0.5; Ks 0 0 0; illum 1; d 0.25", ""},
    {"`opacity` with `mask` or `blend`", "`map_d`, and `d` for the factor; a cutoff is lost",
     "brdf diffuse kd=0.5 texture \"wood.png\" opacity blend 0.5",
     "Kd 0.5 0.5 0.5; Ks 0 0 0; illum 1; map_Kd wood.png; d 0.5; map_d wood.png", ""},
}};

int illumination_of(Reflection reflection) {
  return reflection == Reflection::None ? 1 : reflection == Reflection::Glossy ? 2 : 3;
}

}  // namespace

MtlWriter::MtlWriter(const grf::Scene& scene, const WorldMeshes& meshes) {
  find_definitions(scene);
  std::vector<Key> keys;  // distinct, in the order of faces
  std::set<Key> known;
  for (const WorldMesh& mesh : meshes.meshes()) {
    for (const WorldSurface& surface : mesh.surfaces()) {
      const Key key = key_of(surface, mesh.is_light());
      if (surface.faces == 0 || key.is_plain()) continue;
      if (key.brdf != nullptr && !is_exact_in_mtl(*key.brdf)) approximated_faces_ += surface.faces;
      if (known.insert(key).second) keys.push_back(key);
    }
  }
  if (returns_to_plain(meshes)) keys.emplace_back();
  add_materials(keys);
}

/// Returns whether faces without a material come after others, so that they need a named default material.
bool MtlWriter::returns_to_plain(const WorldMeshes& meshes) {
  bool has_material = false;
  for (const WorldMesh& mesh : meshes.meshes()) {
    std::vector<bool> plain;
    for (const WorldSurface& surface : mesh.surfaces()) {
      plain.push_back(key_of(surface, mesh.is_light()).is_plain());
    }
    for (const std::uint32_t surface : *mesh.mesh().surface_of_face) {
      if (has_material && plain[surface]) return true;
      has_material = has_material || !plain[surface];
    }
  }
  return false;
}

MtlWriter::Key MtlWriter::key_of(const WorldSurface& surface, bool is_light) {
  Key key;
  key.brdf = surface.brdf;
  key.terms = surface.terms;
  key.is_black = surface.brdf == nullptr && (is_light || surface.emission);
  if (surface.texture != nullptr) key.image = surface.texture->file;
  key.colour = components(surface.colour);
  key.emission = components(surface.emission);
  key.reads_alpha = surface.opacity.reads_alpha();
  if (surface.opacity.kind != grf::Opacity::Kind::Mask) key.opacity = surface.opacity.value;
  return key;
}

void MtlWriter::find_definitions(const grf::Scene& scene) {
  grf::SceneVisitor visitor;
  visitor.definition = [this](const grf::Definition& definition, const grf::Placement& placement) {
    const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body);
    if (brdf == nullptr) return;
    const NamedBrdf& named =
        definitions_.emplace_back(NamedBrdf{&definition, named_brdfs(*brdf, placement.scope)});
    lobes_of_definitions_.emplace(brdf, lobes_of(*brdf, named.terms));  // its terms precede it
  };
  grf::visit(scene, visitor);
}

// Definitions come first, in order, since the terms of a sum must precede it; then unnamed BRDFs.
void MtlWriter::add_materials(const std::vector<Key>& keys) {
  std::unordered_map<const grf::BrdfModel*, std::vector<const Key*>> keys_of_brdf;
  for (const Key& key : keys) keys_of_brdf[key.brdf].push_back(&key);
  std::unordered_set<const grf::BrdfModel*> added;
  for (const auto& [definition, terms] : definitions_) {
    const auto* brdf = std::get_if<grf::BrdfModel>(&definition->body);
    const std::string name = name_of_definition(*definition);
    const auto own = keys_of_brdf.find(brdf);
    if (own != keys_of_brdf.end() && added.insert(brdf).second) {
      for (const Key* key : own->second) add(*key, name);
    } else {
      Key unused;
      unused.brdf = brdf;
      unused.terms = terms;
      add(unused, name);
    }
  }
  for (const Key& key : keys) {
    if (added.contains(key.brdf)) continue;
    const char* without_brdf = key.is_black ? "light" : "default";
    add(key, key.brdf == nullptr ? without_brdf : name_of_text(grf::to_text(*key.brdf)));
  }
}

void MtlWriter::add(const Key& key, const std::string& name) {
  first_of_brdf_.emplace(key.brdf, materials_.size());
  by_key_.emplace(key, materials_.size());
  materials_.push_back({key, names_.take(name)});
}

const std::string* MtlWriter::name_of(const WorldSurface& surface, bool is_light) const {
  const Key key = key_of(surface, is_light);
  if (key.is_plain()) return nullptr;
  const auto known = by_key_.find(key);
  return known == by_key_.end() ? nullptr : &materials_[known->second].name;
}

const std::string* MtlWriter::name_of_none() const {
  const auto known = by_key_.find(Key());
  return known == by_key_.end() ? nullptr : &materials_[known->second].name;
}

std::string MtlWriter::text() const {
  std::string text = "# A comment \"grf:\" is the exact BRDF, and goes before the values below it.\n";
  for (const Material& material : materials_) text += text_of(material);
  return text;
}

/// Returns the BRDF with identifiers of materials as its terms; nothing if one of them is undefined.
std::optional<grf::BrdfModel> MtlWriter::with_named_terms(const Key& key) const {
  grf::BrdfModel named = *key.brdf;
  for (std::size_t i = 0; i < named.terms.size(); ++i) {
    const auto first = first_of_brdf_.find(key.terms[i]);
    if (first == first_of_brdf_.end() || first->first == nullptr) return std::nullopt;
    named.terms[i].brdf.name = grf::to_identifier(materials_[first->second].name);
  }
  return named;
}

BrdfLobes MtlWriter::lobes_of(const grf::BrdfModel& brdf,
                              const std::vector<const grf::BrdfModel*>& terms) const {
  if (brdf.terms.empty()) return brdf_lobes(brdf);
  std::vector<WeightedLobes> sum;
  std::vector<BrdfLobes> layers;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto known = lobes_of_definitions_.find(terms[i]);
    const bool is_defined = known != lobes_of_definitions_.end();
    layers.push_back(is_defined ? known->second : BrdfLobes());
    if (is_defined) sum.push_back({static_cast<double>(brdf.terms[i].weight), known->second});
  }
  return is_layered(brdf) ? layered_lobes(brdf, layers) : sum_of_lobes(sum);
}

PhongMaterial MtlWriter::phong_of(const Key& key) const {
  PhongMaterial phong;
  if (key.brdf != nullptr) {
    phong = phong_material(lobes_of(*key.brdf, key.terms));
  } else {
    phong.diffuse = grf::Vec3d(key.is_black ? 0 : 0.5);
    phong.reflection = Reflection::None;
  }
  if (!key.colour.empty()) {
    const grf::Vec3d colour(key.colour[0], key.colour[1], key.colour[2]);
    phong.diffuse *= colour;
    phong.specular *= colour;
  }
  return phong;
}

std::string MtlWriter::text_of(const Material& material) const {
  const Key& key = material.key;
  const auto brdf = key.brdf == nullptr ? std::nullopt : with_named_terms(key);
  // A backslash at the end of a line would join the next one to it.
  std::string text = fmt::format("\nnewmtl {}{}\n", material.name, material.name.ends_with('\\') ? " " : "");
  if (brdf) text += fmt::format("# grf: {}\n", grf::to_text(*brdf));
  if (key.brdf == nullptr) text += "# grf: none\n";
  if (!key.colour.empty() && (brdf || key.brdf == nullptr)) {
    text += fmt::format("# grf rgb: ({})\n", fmt::join(key.colour, ", "));
  }
  const PhongMaterial phong = phong_of(key);
  text += fmt::format("Kd {}\nKs {}\n", numbers(phong.diffuse), numbers(phong.specular));
  if (phong.exponent) text += fmt::format("Ns {}\n", static_cast<float>(*phong.exponent));
  text += fmt::format("illum {}\n", illumination_of(phong.reflection));
  if (!key.emission.empty()) text += fmt::format("Ke {}\n", fmt::join(key.emission, " "));
  if (key.image) text += fmt::format("map_Kd {}{}\n", key.image->starts_with('-') ? "./" : "", *key.image);
  if (key.opacity < 1) text += fmt::format("d {}\n", key.opacity);
  if (key.reads_alpha)
    text += fmt::format("map_d {}{}\n", key.image->starts_with('-') ? "./" : "", *key.image);
  return text;
}

std::span<const MaterialRule> mtl_writer_rules() { return MtlWriterRules; }

}  // namespace convert
