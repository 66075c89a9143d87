#include "tests/editor/document/plain_project.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/write.h"

namespace editor {
namespace {

Plain3 plain(const grf::Vec3f& value) { return {value.x, value.y, value.z}; }

std::string text_of(const grf::Colour& colour) {
  return fmt::format("{} {} {}", colour.x, colour.y, colour.z);
}

std::string text_of(const grf::Reference& reference) { return "@" + reference.name; }

std::string text_of(const grf::BrdfModel& brdf) {
  if (brdf.terms.empty()) return grf::to_text(brdf);
  std::string text = brdf.keyword;
  for (const grf::CombineTerm& term : brdf.terms) text += fmt::format(" {} @{}", term.weight, term.brdf.name);
  return text;
}

std::string beside(const std::string& naming_file, const std::string& name) {
  return std::filesystem::weakly_canonical(std::filesystem::path(naming_file).parent_path() / name).string();
}

/// A transform of scales and translations.
struct Placing {
  float scale = 1;
  Plain3 offset = {};

  Placing inside(const std::vector<grf::TransformStep>& steps) const {
    Placing step;
    for (const grf::TransformStep& each : steps) {
      const bool scales = each.kind == grf::TransformStep::Kind::Scale;
      for (std::size_t i = 0; i < 3; ++i) {
        step.offset[i] = scales ? step.offset[i] * each.value.x : step.offset[i] + each.value[int(i)];
      }
      if (scales) step.scale *= each.value.x;
    }
    Placing both = *this;
    both.scale *= step.scale;
    for (std::size_t i = 0; i < 3; ++i) both.offset[i] += scale * step.offset[i];
    return both;
  }
};

class Reader {
 public:
  PlainReading read(const grf::Scene& scene, const std::string& path) {
    naming_file_ = path;
    read(scene.contents, {}, 0, reading_.project.main);
    return std::move(reading_);
  }

 private:
  void read(const grf::BlockList& list, const Placing& placing, std::size_t before, PlainFile& file) {
    path_.push_back(static_cast<std::uint32_t>(before));
    for (const grf::Block& block : list.blocks) {
      std::visit([&](const auto& content) { read(content, placing, file); }, block.content);
      ++path_.back();
    }
    path_.pop_back();
  }

  PlainObject& add(PlainObject::Kind kind, const std::string& name, const Placing& placing, PlainFile& file) {
    reading_.places.push_back({file_, {}, file.objects.size(), path_, file_scale_});
    return file.objects.emplace_back(PlainObject{kind, name, placing.scale, placing.offset, {}, {}});
  }

  void read(const grf::Shared<grf::Mesh>& mesh, const Placing& placing, PlainFile& file) {
    add(PlainObject::Kind::Mesh, mesh->name, placing, file).mesh = mesh_of(*mesh);
  }
  void read(const grf::MeshLight& light, const Placing& placing, PlainFile& file) {
    add(PlainObject::Kind::MeshLight, {}, placing, file).mesh = mesh_of(*light.mesh);
  }
  void read(const grf::AreaLight& light, const Placing& placing, PlainFile& file) {
    add(PlainObject::Kind::Light, {}, placing, file).points = {
        plain(light.corner), plain(light.edge1), plain(light.edge2),
        plain(light.radiance.value_or(grf::Colour(1)))};
  }
  void read(const grf::Params& params, const Placing& placing, PlainFile& file) {
    PlainObject& object = add(PlainObject::Kind::Observers, {}, placing, file);
    for (const grf::Vec3f& view : params.views) object.points.push_back(plain(view));
  }
  void read(const grf::Use& use, const Placing& placing, PlainFile& file) {
    add(PlainObject::Kind::Use, use.mesh.name, placing, file);
  }
  void read(const grf::Transform& transform, const Placing& placing, PlainFile& file) {
    read(transform.body, placing.inside(transform.steps), 0, file);
  }
  void read(const grf::Include& include, const Placing& placing, PlainFile& file) {
    const std::string name = beside(naming_file_, include.file);
    add(PlainObject::Kind::Include, name, placing, file);
    const std::string outer_naming = std::exchange(naming_file_, name);
    const std::string outer_file = std::exchange(file_, name);
    const float outer_scale = std::exchange(file_scale_, file_scale_ * placing.scale);
    PlainFile contents;
    read(*include.contents, {}, 0, contents);
    const auto [known, is_new] = reading_.project.files.emplace(name, contents);
    if (!is_new && known->second != contents) reading_.has_one_text_per_file = false;
    naming_file_ = outer_naming;
    file_ = outer_file;
    file_scale_ = outer_scale;
  }
  void read(const grf::DefinitionScope& scope, const Placing& placing, PlainFile& file) {
    path_.push_back(0);
    for (const grf::Definition& definition : scope.definitions) {
      const bool is_known = file.definitions.contains(definition.name);
      reading_.has_one_meaning_per_name = reading_.has_one_meaning_per_name && !is_known;
      PlainDefinition& plain = file.definitions[definition.name];
      if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body)) {
        plain.is_mesh = true;
        plain.mesh = mesh_of(**mesh);
      } else if (const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body)) {
        plain.text = text_of(*brdf);
      } else if (const auto* colour = std::get_if<grf::Colour>(&definition.body)) {
        plain.text = text_of(*colour);
      }
      reading_.places.push_back({file_, definition.name, 0, path_, file_scale_});
      ++path_.back();
    }
    path_.pop_back();
    read(scope.body, placing, scope.definitions.size(), file);
  }

  PlainMesh mesh_of(const grf::Mesh& mesh) const {
    PlainMesh plain;
    plain.own = surface_of(mesh.surfaces.front());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      PlainFace& added = plain.faces.emplace_back();
      for (const std::uint32_t corner : mesh.face(face)) added.corners.push_back(corner_of(mesh, corner));
      added.surface = surface_of(mesh.surface(face));
    }
    return plain;
  }

  static PlainCorner corner_of(const grf::Mesh& mesh, std::uint32_t vertex) {
    PlainCorner corner;
    corner.position = plain(mesh.geometry->positions[vertex]);
    if (mesh.geometry->colours.has(vertex)) corner.colour = plain(mesh.geometry->colours[vertex]);
    if (mesh.irradiance->has(vertex)) {
      corner.irradiance = plain(std::get<grf::Colour>((*mesh.irradiance)[vertex]));
    }
    return corner;
  }

  PlainSurface surface_of(const grf::Surface& surface) const {
    const auto text = [](const auto& attribute) {
      return std::visit([](const auto& value) { return text_of(value); }, attribute);
    };
    PlainSurface plain_surface;
    if (surface.colour) plain_surface.colour = text(*surface.colour);
    if (surface.brdf) plain_surface.brdf = text(*surface.brdf);
    if (surface.texture) {
      plain_surface.texture = beside(naming_file_, std::get<grf::Texture>(*surface.texture).file);
    }
    if (surface.emission) plain_surface.emission = plain(*surface.emission);
    return plain_surface;
  }

  PlainReading reading_;
  grf::ScenePath path_;
  std::string naming_file_;
  std::string file_;
  float file_scale_ = 1;
};

std::string text_of(const PlainSurface& surface) {
  std::string text = fmt::format("{} | {} | {}", surface.colour.value_or("-"), surface.brdf.value_or("-"),
                                 surface.texture.value_or("-"));
  if (surface.emission) text += fmt::format(" emits {}", *surface.emission);
  return text;
}

std::string text_of(const PlainMesh& mesh) {
  if (mesh.faces.empty()) return {};
  std::string text = "\n      own: " + text_of(mesh.own);
  for (const PlainFace& face : mesh.faces) {
    text += "\n     ";
    for (const PlainCorner& corner : face.corners) {
      text += fmt::format(" {}", corner.position);
      if (corner.colour) text += fmt::format(" rgb {}", *corner.colour);
      if (corner.irradiance) text += fmt::format(" irad {}", *corner.irradiance);
    }
    text += ": " + text_of(face.surface);
  }
  return text;
}

std::string text_of(const PlainFile& file) {
  std::string text;
  for (const auto& [name, definition] : file.definitions) {
    text += fmt::format("    def {} = {}{}\n", name, definition.text, text_of(definition.mesh));
  }
  for (const PlainObject& object : file.objects) {
    text += fmt::format("    kind {} '{}' scale {} offset {} points {}{}\n", static_cast<int>(object.kind),
                        object.name, object.scale, object.offset, object.points, text_of(object.mesh));
  }
  return text;
}

std::string text_of(const PlainProject& project) {
  std::string text = fmt::format("  depth {} background {}\n", project.depth, project.background);
  text += text_of(project.main);
  for (const auto& [name, file] : project.files) text += fmt::format("  {}\n", name) + text_of(file);
  return text;
}

}  // namespace

PlainReading plain_reading(const grf::Scene& scene, const std::string& path) {
  return Reader().read(scene, path);
}

std::string differences(const PlainProject& expected, const PlainProject& found) {
  if (expected == found) return {};
  const auto lines_of = [](const PlainProject& project) {
    std::istringstream text(text_of(project));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  };
  const std::vector<std::string> wanted = lines_of(expected);
  const std::vector<std::string> there = lines_of(found);
  std::string text = "the project is another one\n";
  const auto tell = [&text](const char* what, const auto& lines, const auto& others) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool is_other =
          std::count(others.begin(), others.end(), lines[i]) == 0 || lines.size() == others.size();
      if (is_other && (i >= others.size() || others[i] != lines[i]))
        text += fmt::format("{}{}\n", what, lines[i]);
    }
  };
  tell("expected ", wanted, there);
  tell("found    ", there, wanted);
  return text;
}

}  // namespace editor
