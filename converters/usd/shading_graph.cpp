#include "converters/usd/shading_graph.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <variant>

#include "converters/gltf/gltf_brdf.h"
#include "grf/keywords.h"
#include "grf/write.h"
#include "renderer/reflectance/brdf.h"

namespace convert {
namespace {

using grf::Vec3d;
using reflectance::Rgb;

Vec3d shortest_colour(const grf::Colour& c) {
  return {grf::shortest(c.x), grf::shortest(c.y), grf::shortest(c.z)};
}

ShadingInput number_input(std::string name, double value) { return {std::move(name), "float", {value}, {}}; }
ShadingInput number_input(std::string name, float value) {
  return number_input(std::move(name), grf::shortest(value));
}
ShadingInput colour_input(std::string name, const Vec3d& c) {
  return {std::move(name), "color3", {c.x, c.y, c.z}, {}};
}
ShadingInput colour_input(std::string name, const grf::Colour& c) {
  return colour_input(std::move(name), shortest_colour(c));
}
ShadingInput connected(std::string name, std::string type, std::size_t node) {
  return {std::move(name), std::move(type), {}, {}, node};
}

/// Composes the nodes of one surface.
class GraphBuilder {
 public:
  explicit GraphBuilder(const ShadedSurface& shaded) : shaded_(shaded), surface_(shaded.surface) {}

  ShadingGraph build();

 private:
  std::size_t add(std::string category, std::string type, std::string definition,
                  std::vector<ShadingInput> inputs) {
    graph_.nodes.push_back({std::move(category), std::move(type), std::move(definition), std::move(inputs)});
    return graph_.nodes.size() - 1;
  }

  bool is_tinted() const {
    return surface_.colour != grf::Colour(1) || !shaded_.texture.empty() || shaded_.has_vertex_colours;
  }
  std::size_t image(const char* type, const char* definition);
  std::optional<std::size_t> opacity();
  std::optional<std::size_t> tint();

  std::optional<std::size_t> bsdf_of(const grf::BrdfModel& model, bool& is_exact);
  std::size_t facets_of(const reflectance::Ggx& ggx);
  std::size_t scaled(std::size_t bsdf, const grf::Colour& factor);
  std::optional<std::size_t> sum_of_bsdfs();
  bool put_layers();
  void put_openpbr(const reflectance::OpenPbr& model);
  void put_gltf();
  void put_glass(const GltfBrdf& values);
  void put_nearest();
  void put_openpbr_shader(std::vector<ShadingInput> inputs);
  ShadingInput base_colour(const char* name, const Vec3d& colour);
  void add_opacity(const char* name, std::vector<ShadingInput>& inputs);

  const ShadedSurface& shaded_;
  const grf::ResolvedSurface& surface_;
  ShadingGraph graph_;
};

std::size_t GraphBuilder::image(const char* type, const char* definition) {
  return add("image", type, definition,
             {{"file", "filename", {}, shaded_.texture},
              {"uaddressmode", "string", {}, "periodic"},
              {"vaddressmode", "string", {}, "periodic"}});
}

/// Returns a node with the colour that multiplies the BRDF, unless that is a constant.
std::optional<std::size_t> GraphBuilder::tint() {
  std::optional<std::size_t> node;
  if (!shaded_.texture.empty()) node = image("color3", "ND_image_color3");
  if (!shaded_.has_vertex_colours) return node;
  const std::size_t vertices = add("geompropvalue", "color3", "ND_geompropvalue_color3",
                                   {{"geomprop", "string", {}, std::string(VertexColours)}});
  if (!node) return vertices;
  return add("multiply", "color3", "ND_multiply_color3",
             {connected("in1", "color3", *node), connected("in2", "color3", vertices)});
}

/// Returns a node with the opacity where the texture's alpha decides it.
std::optional<std::size_t> GraphBuilder::opacity() {
  if (!surface_.opacity.reads_alpha() || shaded_.texture.empty()) return std::nullopt;
  const std::size_t colour = image("color4", "ND_image_color4");
  const std::size_t alpha = add("extract", "float", "ND_extract_color4",
                                {connected("in", "color4", colour), {"index", "integer", {3}, {}}});
  if (surface_.opacity.kind == grf::Opacity::Kind::Blend) {
    return add("multiply", "float", "ND_multiply_float",
               {connected("in1", "float", alpha), number_input("in2", surface_.opacity.value)});
  }
  return add("ifgreatereq", "float", "ND_ifgreatereq_float",
             {connected("value1", "float", alpha), number_input("value2", surface_.opacity.value),
              number_input("in1", 1.0), number_input("in2", 0.0)});
}

void GraphBuilder::add_opacity(const char* name, std::vector<ShadingInput>& inputs) {
  if (const auto node = opacity()) {
    inputs.push_back(connected(name, "float", *node));
  } else if (!surface_.opacity.reads_alpha() && surface_.opacity.value < 1) {
    inputs.push_back(number_input(name, surface_.opacity.value));
  }
}

std::size_t GraphBuilder::scaled(std::size_t bsdf, const grf::Colour& factor) {
  if (factor == grf::Colour(1)) return bsdf;
  return add("multiply", "BSDF", "ND_multiply_bsdfC",
             {connected("in1", "BSDF", bsdf), colour_input("in2", factor)});
}

std::size_t GraphBuilder::facets_of(const reflectance::Ggx& ggx) {
  std::vector<ShadingInput> inputs;
  const bool has_f0 = ggx.f0 != Rgb(0);
  if (has_f0) {
    inputs = {colour_input("color0", ggx.f0), colour_input("color82", ggx.f82),
              colour_input("color90", Vec3d(1))};
  } else {
    inputs = {colour_input("ior", ggx.nreal), colour_input("extinction", ggx.nimag)};
  }
  inputs.push_back({"roughness", "vector2", {grf::shortest(ggx.alpha), grf::shortest(ggx.ay)}, {}});
  inputs.push_back({"distribution", "string", {}, "ggx"});
  const std::string category = has_f0 ? "generalized_schlick_bsdf" : "conductor_bsdf";
  return scaled(add(category, "BSDF", "ND_" + category, std::move(inputs)), ggx.ks);
}

/// Returns the node of a model that MaterialX has, without its colour.
std::optional<std::size_t> GraphBuilder::bsdf_of(const grf::BrdfModel& model, bool& is_exact) {
  if (!model.terms.empty() || !model.data_file.empty()) return std::nullopt;
  const auto brdf = reflectance::make_brdf(model);
  if (!brdf) return std::nullopt;
  const auto diffuse_node = [&](const Rgb& colour, float roughness, bool keeps_energy) {
    std::vector<ShadingInput> inputs = {colour_input("color", colour), number_input("roughness", roughness)};
    if (keeps_energy) inputs.push_back({"energy_compensation", "boolean", {1}, {}});
    return add("oren_nayar_diffuse_bsdf", "BSDF", "ND_oren_nayar_diffuse_bsdf", std::move(inputs));
  };
  if (const auto* diffuse = std::get_if<reflectance::Diffuse>(&*brdf))
    return diffuse_node(diffuse->kd, 0, false);
  if (const auto* eon = std::get_if<reflectance::Eon>(&*brdf)) return diffuse_node(eon->kd, eon->rough, true);
  if (const auto* oren = std::get_if<reflectance::Oren>(&*brdf)) {
    is_exact = is_exact && oren->s == 0;
    return diffuse_node(oren->r, oren->s, false);
  }
  if (const auto* sheen = std::get_if<reflectance::Sheen>(&*brdf)) {
    return add("sheen_bsdf", "BSDF", "ND_sheen_bsdf",
               {colour_input("color", sheen->ks),
                number_input("roughness", sheen->rough),
                {"mode", "string", {}, "zeltner"}});
  }
  if (const auto* mirror = std::get_if<reflectance::Specular>(&*brdf)) {
    return add("generalized_schlick_bsdf", "BSDF", "ND_generalized_schlick_bsdf",
               {colour_input("color0", mirror->ks),
                colour_input("color82", Vec3d(1)),
                colour_input("color90", mirror->ks),
                {"roughness", "vector2", {0, 0}, {}}});
  }
  const auto* ggx = std::get_if<reflectance::Ggx>(&*brdf);
  if (ggx == nullptr || ggx->anisotropy != 0 || ggx->rotation != 0) return std::nullopt;
  // The nodes of MaterialX scale the lobe for what leaves after several reflections.
  constexpr int ScaledScattering = 1;
  is_exact = is_exact && ggx->scattering == ScaledScattering;
  return facets_of(*ggx);
}

/// Returns the node of a BRDF, or of the sum of its terms; nothing if MaterialX lacks the model of one.
std::optional<std::size_t> GraphBuilder::sum_of_bsdfs() {
  const grf::BrdfModel fallback = reflectance::default_model();
  const grf::BrdfModel& model = surface_.brdf != nullptr ? *surface_.brdf : fallback;
  if (grf::is_layered(model)) return std::nullopt;
  std::optional<std::size_t> sum;
  for (const grf::WeightedBrdf& term : grf::summands_of(model, surface_.brdf_scope)) {
    auto bsdf = bsdf_of(*term.model, graph_.is_exact);
    if (!bsdf) return std::nullopt;
    if (term.weight != 1) {
      bsdf = add("multiply", "BSDF", "ND_multiply_bsdfF",
                 {connected("in1", "BSDF", *bsdf), number_input("in2", term.weight)});
    }
    sum = !sum ? *bsdf
               : add("add", "BSDF", "ND_add_bsdf",
                     {connected("in1", "BSDF", *sum), connected("in2", "BSDF", *bsdf)});
  }
  return sum;
}

/// Puts a `surface` of BSDFs; false if MaterialX lacks the model.
bool GraphBuilder::put_layers() {
  std::vector<ShadingInput> inputs;
  const bool is_black = surface_.brdf == nullptr && surface_.emission;
  if (!is_black) {
    auto bsdf = sum_of_bsdfs();
    if (!bsdf) {
      graph_ = {};
      return false;
    }
    bsdf = scaled(*bsdf, surface_.colour);
    if (const auto factor = tint()) {
      bsdf = add("multiply", "BSDF", "ND_multiply_bsdfC",
                 {connected("in1", "BSDF", *bsdf), connected("in2", "color3", *factor)});
    }
    inputs.push_back(connected("bsdf", "BSDF", *bsdf));
  }
  if (surface_.emission) {
    inputs.push_back(
        connected("edf", "EDF",
                  add("uniform_edf", "EDF", "ND_uniform_edf", {colour_input("color", *surface_.emission)})));
  }
  add_opacity("opacity", inputs);
  add("surface", "surfaceshader", "ND_surface", std::move(inputs));
  return true;
}

/// Returns the input of a shader with one base colour, which takes the surface's colours.
ShadingInput GraphBuilder::base_colour(const char* name, const Vec3d& colour) {
  const Vec3d base = colour * Vec3d(shortest_colour(surface_.colour));
  const auto factor = tint();
  if (!factor) return colour_input(name, base);
  if (base == Vec3d(1)) return connected(name, "color3", *factor);
  return connected(name, "color3",
                   add("multiply", "color3", "ND_multiply_color3",
                       {connected("in1", "color3", *factor), colour_input("in2", base)}));
}

void GraphBuilder::put_openpbr_shader(std::vector<ShadingInput> inputs) {
  if (surface_.emission) {
    const Vec3d radiance = shortest_colour(*surface_.emission);
    const double largest = std::max({radiance.x, radiance.y, radiance.z});
    inputs.push_back(number_input("emission_luminance", largest));
    inputs.push_back(colour_input("emission_color", radiance / largest));
  }
  add_opacity("geometry_opacity", inputs);
  add("open_pbr_surface", "surfaceshader", "ND_open_pbr_surface_surfaceshader", std::move(inputs));
}

void GraphBuilder::put_openpbr(const reflectance::OpenPbr& model) {
  graph_.is_exact = !is_tinted() && model.rotation == 0;
  std::vector<ShadingInput> inputs = {base_colour("base_color", shortest_colour(model.base_colour))};
  const auto number = [&](const char* name, float value) { inputs.push_back(number_input(name, value)); };
  const auto colour = [&](const char* name, const Rgb& c) { inputs.push_back(colour_input(name, c)); };
  number("base_weight", model.base_weight);
  number("base_metalness", model.metalness);
  number("base_diffuse_roughness", model.diffuse_roughness);
  number("specular_weight", model.specular_weight);
  colour("specular_color", model.specular_colour);
  number("specular_roughness", model.roughness);
  number("specular_roughness_anisotropy", model.anisotropy);
  number("specular_ior", model.ior);
  number("coat_weight", model.coat_weight);
  colour("coat_color", model.coat_colour);
  number("coat_roughness", model.coat_roughness);
  number("coat_roughness_anisotropy", model.coat_anisotropy);
  number("coat_ior", model.coat_ior);
  number("coat_darkening", model.coat_darkening);
  number("fuzz_weight", model.fuzz_weight);
  colour("fuzz_color", model.fuzz_colour);
  number("fuzz_roughness", model.fuzz_roughness);
  number("thin_film_weight", model.film_weight);
  number("thin_film_thickness", model.film_thickness);
  number("thin_film_ior", model.film_ior);
  put_openpbr_shader(std::move(inputs));
}

// The fibres of glTF's material have the lobe of Charlie, and GRF's that of Zeltner.
void GraphBuilder::put_gltf() {
  const GltfBrdf values = nearest_gltf(*surface_.brdf, surface_.brdf_scope);
  graph_.is_exact = !is_tinted() && values.sheen_colour == Vec3d(0);
  std::vector<ShadingInput> inputs = {base_colour("base_color", values.base),
                                      number_input("metallic", values.metallic),
                                      number_input("roughness", values.roughness),
                                      number_input("specular", values.specular),
                                      colour_input("specular_color", values.specular_colour),
                                      number_input("ior", values.ior),
                                      number_input("anisotropy_strength", values.anisotropy),
                                      number_input("anisotropy_rotation", values.rotation),
                                      number_input("clearcoat", values.clearcoat),
                                      number_input("clearcoat_roughness", values.coat_roughness),
                                      colour_input("sheen_color", values.sheen_colour),
                                      number_input("sheen_roughness", values.sheen_roughness),
                                      number_input("iridescence", values.iridescence),
                                      number_input("iridescence_ior", values.iridescence_ior),
                                      number_input("iridescence_thickness", values.film_thickness)};
  if (surface_.emission) inputs.push_back(colour_input("emissive", *surface_.emission));
  const std::size_t others = inputs.size();
  add_opacity("alpha", inputs);
  constexpr double Blended = 2;
  if (inputs.size() > others) inputs.push_back({"alpha_mode", "integer", {Blended}, {}});
  add("gltf_pbr", "surfaceshader", "ND_gltf_pbr_surfaceshader", std::move(inputs));
}

/// Puts the OpenPBR surface of glass. Its colour is what is left of light after `transmission_depth`; with 0
/// it is that of all that is transmitted.
void GraphBuilder::put_glass(const GltfBrdf& values) {
  const bool is_pane = !(values.thickness > 0);
  const bool has_depth = !is_pane && std::isfinite(values.attenuation_distance);
  std::vector<ShadingInput> inputs = {
      number_input("base_weight", 0.0), number_input("specular_roughness", values.roughness),
      number_input("specular_ior", values.ior), number_input("transmission_weight", 1.0),
      colour_input("transmission_color", is_pane ? values.base : values.attenuation_colour)};
  if (has_depth) inputs.push_back(number_input("transmission_depth", values.attenuation_distance));
  if (is_pane) inputs.push_back({"geometry_thin_walled", "boolean", {1}, {}});
  put_openpbr_shader(std::move(inputs));
}

/// Puts the OpenPBR surface with the diffuse and the glossy lobe of the BRDF, or that of glass.
void GraphBuilder::put_nearest() {
  graph_.is_exact = false;
  const GltfBrdf values = nearest_gltf(*surface_.brdf, surface_.brdf_scope);
  if (values.is_glass()) return put_glass(values);
  put_openpbr_shader({base_colour("base_color", values.base), number_input("base_metalness", values.metallic),
                      number_input("specular_weight", values.specular),
                      number_input("specular_roughness", values.roughness)});
}

ShadingGraph GraphBuilder::build() {
  const grf::BrdfModel* model = surface_.brdf;
  if (model != nullptr && model->terms.empty() && grf::same_keyword(model->keyword, "openpbr")) {
    if (const auto brdf = reflectance::make_brdf(*model)) put_openpbr(std::get<reflectance::OpenPbr>(*brdf));
  } else if (model != nullptr && model->terms.empty() && grf::same_keyword(model->keyword, "gltf")) {
    put_gltf();
  } else if (!put_layers()) {
    put_nearest();
  }
  return std::move(graph_);
}

}  // namespace

ShadingGraph shading_graph_of(const ShadedSurface& shaded) { return GraphBuilder(shaded).build(); }

bool is_linear_image(const std::string& file) {
  const std::string extension = grf::lower_case(std::filesystem::path(file).extension().string());
  return extension == ".exr" || extension == ".hdr" || extension == ".pfm" || extension == ".raw";
}

}  // namespace convert
