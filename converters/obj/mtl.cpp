#include "converters/obj/mtl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "converters/obj/exact_brdf.h"
#include "converters/obj/wavefront_text.h"
#include "converters/wording.h"
#include "grf/keywords.h"

namespace convert {
namespace {

using grf::same_keyword;

bool is_one_of(std::string_view keyword, std::initializer_list<std::string_view> candidates) {
  return std::any_of(candidates.begin(), candidates.end(),
                     [keyword](std::string_view candidate) { return same_keyword(keyword, candidate); });
}

/// Returns the loss of an unsupported statement that names an image.
std::optional<Loss> loss_of(std::string_view keyword) {
  if (is_one_of(keyword, {"bump", "map_bump", "norm", "map_Kn"})) return Loss::BumpMap;
  if (is_one_of(keyword, {"disp", "decal", "refl"})) return Loss::OtherMap;
  if (same_keyword(keyword.substr(0, 4), "map_")) return Loss::OtherMap;
  return std::nullopt;
}

/// The statements of Exocortex' extension for physically based materials.
constexpr std::array<std::string_view, 7> PhysicalKeywords = {"Pr",  "Pm",    "Ps",    "Pc",
                                                              "Pcr", "aniso", "anisor"};

/// An image of one of these parameters, in the BRDF `gltf`.
struct PhysicalMap {
  std::string_view keyword;
  std::string_view value;      ///< of PhysicalKeywords
  std::string_view parameter;  ///< of the BRDF
  grf::ImageChannel channel = grf::ImageChannel::Red;
};
constexpr std::array<PhysicalMap, 5> PhysicalMaps = {{{"map_Pr", "Pr", "roughness"},
                                                      {"map_Pm", "Pm", "metallic"},
                                                      {"map_Ps", "Ps", "sheenColor", grf::ImageChannel::Rgb},
                                                      {"map_Pc", "Pc", "clearcoat"},
                                                      {"map_Pcr", "Pcr", "coatRoughness"}}};

// The illumination models of the format: 0 and 1 have no highlight; 3 to 9 trace reflections, 4, 6, 7 and 9
// with refraction.
Reflection reflection_of(int illumination) {
  if (illumination == 0 || illumination == 1) return Reflection::None;
  return illumination >= 3 && illumination <= 9 ? Reflection::Mirror : Reflection::Glossy;
}
bool refracts(int illumination) {
  return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
}

/// The table of conversions by `MtlReader` and the mapping.
constexpr std::array<MaterialRule, 19> MtlRules = {{
    {"`Ks` = 0 or absent, or `illum` 0 or 1", "`diffuse kd=Kd`; an absent `Kd` is 0.5",
     "Kd 0.5 0.25 0.1; Ks 0.5; illum 1", "diffuse kd=(0.5, 0.25, 0.1)", ""},
    {"`Ks` > 0, any other `illum` or none",
     "`lewis n=Ns ks=Ks kd=Kd`, the normalised Phong lobe; without `Ns`, its default `n`",
     "Kd 0.5; Ks 0.25; Ns 40; illum 2", "lewis n=40 ks=0.25 kd=0.5", ""},
    {"the same, `Kd` + `Ks` over 1 in a component", "`kd` is reduced there to what `ks` leaves of 1",
     "Kd 0.8; Ks 0.4 0.1 0.1; Ns 10", "lewis n=10 ks=(0.4, 0.1, 0.1) kd=(0.6, 0.8, 0.8)", ""},
    {"the same with `illum` 3 to 9 (a traced reflection) and `Ns` of 900 or more, or none",
     "`specular ks=Ks`", "Kd 0; Ks 0.5; Ns 1000; illum 3", "specular ks=0.5", ""},
    {"and a diffuse part is left", "`lewis n=1000000 ks=Ks kd=Kd`, a lobe a tenth of a degree wide",
     "Kd 0.5; Ks 0.5; illum 3", "lewis n=1000000 ks=0.5 kd=0.5", ""},
    {"`Ke` > 0", "`light rgb` on the faces, which keep their BRDF", "Kd 0.5; Ke 3 2 1",
     "diffuse kd=0.5 light rgb (3, 2, 1)", ""},
    {"`map_Kd`",
     "`texture`, which multiplies the highlight too; `-s` and `-o` are applied to the texture coordinates; "
     "`Kd` is then 1 if absent",
     "map_Kd -s 2 2 wood.png", "diffuse kd=1 texture \"wood.png\"", ""},
    {"`map_Kd` with `-clamp on`, `-cc on`, `-blendu off`, `-mm`, `-t`, `-imfchan` that change something",
     "the image is kept, the option is lost", "map_Kd -clamp on wood.png",
     "diffuse kd=1 texture \"wood.png\"", "option"},
    {"`d` < 1, or else `Tr` > 0", "`opacity d`, or 1 - `Tr`", "Kd 0.5; d 0.25", "diffuse kd=0.5 opacity 0.25",
     ""},
    {"`map_d` with the image of `map_Kd`", "`opacity blend d`: the alpha of the texture",
     "map_Kd wood.png; map_d wood.png", "diffuse kd=1 texture \"wood.png\" opacity blend 1", ""},
    {"`map_d` with another image or none, `d -halo`", "lost", "Kd 0.5; map_d wood.png", "diffuse kd=0.5",
     "transparency"},
    {"`illum` 4, 6, 7 or 9, which refract", "lost", "Kd 0.5; illum 6", "diffuse kd=0.5", "transparency"},
    {"other maps, `bump`, `norm`, `disp`, `refl`", "lost", "Kd 0.5; bump wood.png", "diffuse kd=0.5",
     "bump map"},
    {"`Pr`, `Pm`, `Ps`, `Pc` and their kin",
     "`gltf baseColor=Kd roughness=Pr metallic=Pm sheenColor=Ps clearcoat=Pc coatRoughness=Pcr "
     "anisotropy=aniso "
     "rotation=2 pi anisor ior=Ni`; `Ks` has no effect",
     "Kd 0.5; Ks 0.3; Pr 0.3; Pm 1", "gltf baseColor=0.5 metallic=1 roughness=0.3", ""},
    {"the same without `Pr`", "the roughness of the lobe of `Ns`, or 0.5", "Kd 0.5; Ns 127.5; Pc 1",
     "gltf baseColor=0.5 roughness=0.25 clearcoat=1", ""},
    {"`map_Pr`, `map_Pm`, `map_Ps`, `map_Pc`, `map_Pcr`",
     "images of these parameters, in place of their values; lost with another `-s` or `-o` than `map_Kd` or "
     "the first of them",
     "Kd 0.5; Pr 0.3; map_Pr wood.png", "gltf baseColor=0.5 roughness=texture \"wood.png\" r", ""},
    {"values out of range", "clamped", "Kd 1.5", "diffuse kd=1", "out of range"},
    {"`Ka`, `Ni`, `Tf`, `sharpness`", "kept only in the comment", "Kd 0.5; Ka 0.1; Ni 1.5", "diffuse kd=0.5",
     ""},
    {"`# grf: BRDF`, `# grf rgb: (R, G, B)`",
     "exactly that BRDF and colour, whatever the values say; `# grf: none`: the faces have no BRDF",
     "# grf: ward sx=0.1; # grf rgb: (0.5, 1, 1); Kd 0.5", "ward sx=0.1 rgb (0.5, 1, 1)", ""},
}};

class MtlReader {
 public:
  MtlReader(const SourceText& source, grf::Diagnostics& diagnostics)
      : reader_(source.text, source.file, LineComments::Statements), diagnostics_(diagnostics) {}

  std::vector<MtlMaterial> run() {
    Statement statement;
    while (reader_.next(statement)) {
      if (same_keyword(statement.keyword, "newmtl")) {
        finish();
        begin(statement);
      } else if (current_ && statement.keyword == "#") {
        read_comment(statement);
      } else if (current_) {
        read(statement);
      }
    }
    finish();
    if (unread_values_ > 0) {
      diagnostics_.warning(first_unread_, counted(unread_values_, "value was", "values were") +
                                              " not read: one number, or three, were expected");
    }
    return std::move(materials_);
  }

 private:
  void begin(const Statement& statement);
  void read(const Statement& statement);
  void read_comment(const Statement& statement);
  void read_exact_brdf_of(const Statement& comment, std::string_view text);
  void read_exact_colour(const Statement& comment, std::string_view text);
  bool read_physically_based(const Statement& statement);
  GltfBrdf physically_based();
  void add_maps(GltfBrdf& values);
  bool read_map(const Statement& statement);
  bool read_transparency(const Statement& statement);
  void read_image(const Statement& statement);
  void finish();
  std::optional<grf::Vec3d> colour(const Statement& statement);
  std::optional<double> number(const Statement& statement);
  void note_unread(const Statement& statement);
  void add_loss(Loss loss);

  template <class Target, class Source>
  static void assign(Target& target, const std::optional<Source>& value) {
    if (value) target = *value;
  }

  StatementReader reader_;
  grf::Diagnostics& diagnostics_;
  std::vector<MtlMaterial> materials_;
  std::set<std::string, std::less<>> identifiers_;  // identifiers of the materials so far
  std::optional<MtlMaterial> current_;
  bool has_diffuse_ = false;                     // the current material has `Kd`
  std::optional<double> dissolve_;               // `d` of the current material: 1 is opaque
  std::optional<double> transparency_;           // `Tr`, 1 - `d`; `d` overrides it
  std::optional<std::string> alpha_map_;         // `map_d`
  std::map<std::string_view, double> physical_;  // the parameters of `PhysicalKeywords` that the material has
  std::map<const PhysicalMap*, MtlImage> physical_maps_;  // images of them
  std::optional<double> index_;                           // `Ni`, the index of refraction
  std::size_t unread_values_ = 0;
  grf::SourceLocation first_unread_;
};

void MtlReader::begin(const Statement& statement) {
  PhongMaterial& phong = current_.emplace().phong;
  phong.name = statement.text();
  phong.source = "MTL";
  phong.location = reader_.location(statement.keyword);
  has_diffuse_ = false;
  dissolve_.reset();
  transparency_.reset();
  alpha_map_.reset();
  physical_.clear();
  physical_maps_.clear();
  index_.reset();
}

void MtlReader::finish() {
  if (!current_) return;
  current_->phong.opacity = dissolve_.value_or(1 - transparency_.value_or(0));
  if (alpha_map_) {
    const auto& map = current_->phong.diffuse_map;
    current_->phong.reads_alpha = map && map->file == *alpha_map_;
    if (!current_->phong.reads_alpha) add_loss(Loss::Transparency);
  }
  // An image without a colour is not scaled.
  if (current_->phong.diffuse_map && !has_diffuse_) current_->phong.diffuse = grf::Vec3d(1);
  if (!physical_.empty() || !physical_maps_.empty()) current_->phong.physically_based = physically_based();
  // Values derived from the exact BRDF add no information.
  if (current_->exact) current_->phong.source_values.clear();
  identifiers_.insert(grf::to_identifier(current_->phong.name));
  materials_.push_back(std::move(*current_));
  current_.reset();
}

void MtlReader::read(const Statement& statement) {
  PhongMaterial& phong = current_->phong;
  const std::string_view keyword = statement.keyword;
  const std::string text = statement.text();
  phong.source_values.push_back(text.empty() ? std::string(keyword) : fmt::format("{} {}", keyword, text));
  if (same_keyword(keyword, "Kd")) {
    assign(phong.diffuse, colour(statement));
    has_diffuse_ = true;
  } else if (same_keyword(keyword, "Ks")) {
    assign(phong.specular, colour(statement));
  } else if (same_keyword(keyword, "Ke")) {
    assign(phong.emission, colour(statement));
  } else if (same_keyword(keyword, "Ns")) {
    // `Ns` is taken as a Phong exponent: the format's specification means Blinn's half vector, but exporters
    // write Phong's exponent or an invented scale of it, and so the number in the file is kept.
    assign(phong.exponent, number(statement));
  } else if (same_keyword(keyword, "illum")) {
    const int illumination = static_cast<int>(std::clamp(number(statement).value_or(2), 0.0, 99.0));
    phong.reflection = reflection_of(illumination);
    if (refracts(illumination)) add_loss(Loss::Transparency);
  } else if (same_keyword(keyword, "map_Kd")) {
    read_image(statement);
  } else if (read_transparency(statement) || read_physically_based(statement) || read_map(statement)) {
    return;
  } else if (const auto loss = loss_of(keyword)) {
    add_loss(*loss);
  }
}

bool MtlReader::read_physically_based(const Statement& statement) {
  if (same_keyword(statement.keyword, "Ni")) {
    assign(index_, number(statement));
    return true;
  }
  const auto known =
      std::find_if(PhysicalKeywords.begin(), PhysicalKeywords.end(),
                   [&](std::string_view keyword) { return same_keyword(statement.keyword, keyword); });
  if (known == PhysicalKeywords.end()) return false;
  if (const auto value = number(statement)) physical_[*known] = *value;
  return true;
}

// Programs write these beside `Ks` and `Ns`, which are for those that do not know them.
GltfBrdf MtlReader::physically_based() {
  // Programs that write an image beside a value, such as Blender, mean the image alone.
  for (const auto& [map, image] : physical_maps_) physical_[map->value] = 1;
  const auto value = [this](std::string_view keyword, double otherwise) {
    const auto found = physical_.find(keyword);
    return found == physical_.end() ? otherwise : found->second;
  };
  GltfBrdf values;
  if (current_->phong.exponent)
    values.roughness = std::sqrt(slope_of(to_half_vector_exponent(*current_->phong.exponent)));
  values.roughness = value("Pr", values.roughness);
  values.metallic = value("Pm", 0);
  values.sheen_colour = grf::Vec3d(value("Ps", 0));
  values.clearcoat = value("Pc", 0);
  values.coat_roughness = value("Pcr", 0);
  values.anisotropy = value("aniso", 0);
  values.rotation = 2 * std::numbers::pi * std::remainder(value("anisor", 0), 1.0);
  if (index_.value_or(0) >= 1) values.ior = *index_;
  add_maps(values);
  return values;
}

// All images of a face have the same texture coordinates in GRF.
void MtlReader::add_maps(GltfBrdf& values) {
  for (const auto& [map, image] : physical_maps_) {
    const bool is_first = !current_->phong.diffuse_map && values.maps.empty();
    if (is_first) current_->uv = image.uv;
    if (image.uv != current_->uv) {
      add_loss(Loss::OtherMap);
    } else {
      values.maps[map->parameter] = {image.name, map->channel};
    }
  }
}

/// Reads the image of a parameter of `PhysicalMaps`.
bool MtlReader::read_map(const Statement& statement) {
  const auto map = std::ranges::find_if(PhysicalMaps, [&](const PhysicalMap& candidate) {
    return same_keyword(statement.keyword, candidate.keyword);
  });
  if (map == PhysicalMaps.end()) return false;
  if (const auto image = parse_image(statement)) {
    physical_maps_[&*map] = *image;
    if (image->has_other_options) add_loss(Loss::TextureOption);
  } else {
    note_unread(statement);
  }
  return true;
}

bool MtlReader::read_transparency(const Statement& statement) {
  if (same_keyword(statement.keyword, "map_d")) {
    const auto image = parse_image(statement);
    alpha_map_ = image ? image->name : std::string();
    return true;
  }
  if (same_keyword(statement.keyword, "d")) {
    // A halo is opaque at its rim alone.
    if (statement.rest.starts_with("-halo")) {
      add_loss(Loss::Transparency);
      return true;
    }
    assign(dissolve_, number(statement));
    return true;
  }
  if (!same_keyword(statement.keyword, "Tr")) return false;
  assign(transparency_, number(statement));
  return true;
}

void MtlReader::read_image(const Statement& statement) {
  const auto image = parse_image(statement);
  if (!image) return note_unread(statement);
  current_->phong.diffuse_map = grf::Texture{image->name, reader_.location(statement.keyword)};
  current_->uv = image->uv;
  if (image->has_other_options) add_loss(Loss::TextureOption);
}

void MtlReader::read_comment(const Statement& statement) {
  constexpr std::string_view Brdf = "grf:";
  constexpr std::string_view Colour = "grf rgb:";
  const auto behind = [&](std::string_view prefix) {
    std::string_view text = statement.rest.substr(prefix.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text;
  };
  if (statement.rest.starts_with(Brdf)) return read_exact_brdf_of(statement, behind(Brdf));
  if (statement.rest.starts_with(Colour)) read_exact_colour(statement, behind(Colour));
}

void MtlReader::read_exact_brdf_of(const Statement& comment, std::string_view text) {
  ExactSurface exact;
  if (text != "none") {
    exact.brdf =
        read_exact_brdf(text, [this](const std::string& name) { return identifiers_.contains(name); });
    if (!exact.brdf) {
      diagnostics_.warning(reader_.location(comment.keyword),
                           fmt::format("'{}' is not a BRDF: the values of MTL beside it are used", text));
      return;
    }
  }
  if (current_->exact) exact.colour = current_->exact->colour;
  current_->exact = exact;
}

// Parses `(R, G, B)`, as in GRF.
void MtlReader::read_exact_colour(const Statement& comment, std::string_view text) {
  std::string numbers(text);
  std::replace_if(
      numbers.begin(), numbers.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream words(numbers);
  std::vector<float> components;
  for (std::string word; words >> word;) {
    if (const auto number = parse_float(word); number && *number >= 0) components.push_back(*number);
  }
  if (components.size() != 3 || !current_->exact) {
    diagnostics_.warning(reader_.location(comment.keyword),
                         "this is not a colour after a BRDF: it is ignored");
    return;
  }
  current_->exact->colour = grf::Colour(components[0], components[1], components[2]);
}

// Parses a colour; one number is repeated. The other two forms, `spectral FILE` and `xyz`, are not used in
// practice.
std::optional<grf::Vec3d> MtlReader::colour(const Statement& statement) {
  std::vector<double> components;
  for (const std::string_view word : statement.arguments) {
    if (const auto component = parse_number(word)) components.push_back(*component);
  }
  const bool all_read = components.size() == statement.arguments.size();
  if (all_read && components.size() == 1) return grf::Vec3d(components[0]);
  if (all_read && components.size() == 3) return grf::Vec3d(components[0], components[1], components[2]);
  note_unread(statement);
  return std::nullopt;
}

// Parses the last word, since `d` may have the option `-halo` before its value.
std::optional<double> MtlReader::number(const Statement& statement) {
  if (!statement.arguments.empty()) {
    if (const auto value = parse_number(statement.arguments.back())) return value;
  }
  note_unread(statement);
  return std::nullopt;
}

void MtlReader::note_unread(const Statement& statement) {
  if (unread_values_++ == 0) first_unread_ = reader_.location(statement.keyword);
}

void MtlReader::add_loss(Loss loss) {
  std::vector<Loss>& losses = current_->phong.losses;
  if (std::find(losses.begin(), losses.end(), loss) == losses.end()) losses.push_back(loss);
}

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::string& path, const grf::SourceLocation& asked_for_at,
                                  grf::Diagnostics& diagnostics) {
  auto problems = grf::Diagnostics::to_be_repeated();
  const auto source = read_source_text(path, "a material library", problems, asked_for_at);
  for (const grf::Diagnostic& problem : problems.entries()) {
    diagnostics.warning(problem.location, problem.message);
  }
  return source ? MtlReader(*source, diagnostics).run() : std::vector<MtlMaterial>();
}

std::span<const MaterialRule> mtl_rules() { return MtlRules; }

}  // namespace convert
