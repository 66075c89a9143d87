#include "grf/catalogue.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/text_file.h"
#include "grf/visit.h"

namespace grf {
namespace {

std::string with_suggestion(const std::string& message, std::string_view word,
                            const std::vector<std::string>& candidates) {
  const std::string suggestion = did_you_mean(word, candidates);
  return suggestion.empty() ? message : message + ": " + suggestion;
}

std::vector<std::string> keywords_of(const std::vector<ModelInfo>& models) {
  std::vector<std::string> keywords;
  for (const ModelInfo& model : models) keywords.emplace_back(model.keyword);
  return keywords;
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

bool in_range(float value, const ParameterInfo& parameter) {
  return value >= parameter.minimum && value <= parameter.maximum;
}

/// The range of a parameter in words.
std::string range_of(const ParameterInfo& parameter) {
  const bool has_maximum = parameter.maximum < std::numeric_limits<float>::max();
  return has_maximum ? fmt::format("from {} to {}", parameter.minimum, parameter.maximum)
                     : fmt::format("of {} or more", parameter.minimum);
}

/// What the value should have been, or nothing if it is right.
std::optional<std::string> wrong_value(const Value& value, const ParameterInfo& parameter) {
  const auto* number = std::get_if<float>(&value);
  if (parameter.kind == ParameterKind::Boolean) {
    const bool zero_or_one = number != nullptr && (*number == 0 || *number == 1);
    if (std::holds_alternative<bool>(value) || zero_or_one) return std::nullopt;
    return "expected true, false, 1 or 0";
  }
  const std::string range = range_of(parameter);
  if (number != nullptr) {
    if (in_range(*number, parameter)) return std::nullopt;
    return fmt::format("{} is out of range, expected a number {}", *number, range);
  }
  const auto* colour = std::get_if<Colour>(&value);
  if (parameter.kind != ParameterKind::Reflectance) return fmt::format("expected a number {}", range);
  if (colour == nullptr) return fmt::format("expected a number, or three in parentheses, {}", range);
  for (const float component : {colour->x, colour->y, colour->z}) {
    if (!in_range(component, parameter)) {
      return fmt::format("{} is out of range, expected numbers {}", component, range);
    }
  }
  return std::nullopt;
}

void check_arguments(const Model& model, const ModelInfo& info, Diagnostics& diagnostics) {
  std::set<std::string_view> given;
  for (const Argument& argument : model.arguments) {
    const ParameterInfo* parameter = info.find(argument.name);
    if (parameter == nullptr) {
      std::vector<std::string> names;
      for (const ParameterInfo& known : info.parameters) names.emplace_back(known.name);
      const std::string known = names.empty() ? "it has none" : "it has " + joined(names);
      diagnostics.error(argument.location, with_suggestion(fmt::format("'{}' has no parameter '{}', {}",
                                                                       info.keyword, argument.name, known),
                                                           argument.name, names));
    } else if (!given.insert(parameter->name).second) {
      diagnostics.error(argument.location, fmt::format("the parameter '{}' is given twice", parameter->name));
    } else if (const auto wrong = wrong_value(argument.value, *parameter)) {
      diagnostics.error(argument.location,
                        fmt::format("'{}' of '{}': {}", parameter->name, info.keyword, *wrong));
    }
  }
}

/// What no single parameter's range says; not asked of values of which one is already wrong.
void check_together(const Model& model, const ModelInfo& info, std::size_t errors_before,
                    Diagnostics& diagnostics) {
  if (info.wrong_together == nullptr || diagnostics.error_count() != errors_before) return;
  const std::string wrong = info.wrong_together(model);
  if (!wrong.empty()) diagnostics.error(model.location, fmt::format("'{}': {}", info.keyword, wrong));
}

/// The models of one kind, and what messages call them.
template <class ModelOfKind>
struct Kind {
  const std::vector<ModelInfo>& models;
  std::string_view name;
};

class Check {
 public:
  Check(const Catalogue& catalogue, Diagnostics& diagnostics)
      : brdfs_{catalogue.brdfs, "BRDF"}, pdfs_{catalogue.pdfs, "PDF"}, diagnostics_(diagnostics) {}

  void run(const Scene& scene) {
    SceneVisitor visitor;
    visitor.mesh = [this](const Mesh& mesh, const Placement& placement, const Block& block) {
      check_mesh(mesh, *placement.scope, block);
    };
    visitor.definition = [this](const Definition& definition, const Placement& placement) {
      check_definition(definition, *placement.scope);
    };
    visitor.light = [this](const AreaLight& light, const Placement&, const Block& block) {
      if (light.radiance) check_colour(*light.radiance, block.location, "radiance");
    };
    visit(scene, visitor);
  }

 private:
  // The names of definitions are suggested too: who wrote an unknown keyword may have meant one of those.
  template <class ModelOfKind>
  void check_model(const ModelOfKind& model, const Kind<ModelOfKind>& kind, const Scope& scope) {
    if (find_model(kind.models, model.keyword) != nullptr) {
      check(model, kind.models, kind.name, diagnostics_);
      return;
    }
    std::vector<std::string> candidates = keywords_of(kind.models);
    const std::vector<std::string> defined = scope.names_of<ModelOfKind>();
    candidates.insert(candidates.end(), defined.begin(), defined.end());
    const std::string message = fmt::format("unknown {} '{}'", kind.name, model.keyword);
    diagnostics_.error(model.location, with_suggestion(message, model.keyword, candidates));
  }

  // The default of absent BRDFs is one that nobody wrote down, so a file that relies on it hears of it, once.
  void warn_of_default(const Mesh& mesh, const Block& block) {
    const std::string file = block.location.file ? block.location.file->path : std::string();
    if (files_with_default_.contains(file)) return;
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      if (mesh.surface(i).brdf || mesh.surface(i).emission) continue;
      files_with_default_.insert(file);
      diagnostics_.warning(block.location, "faces without a BRDF: they are diffuse with kd=0.5");
      return;
    }
  }

  void check_mesh(const Mesh& mesh, const Scope& scope, const Block& block) {
    for (const Surface& surface : mesh.surfaces) {
      check_attribute(surface.brdf, brdfs_, scope);
      check_attribute(surface.pdf, pdfs_, scope);
      check_attribute(surface.colour, block, scope);
      check_texture(surface.texture, scope);
      if (surface.emission) check_colour(*surface.emission, block.location, "radiance");
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      if (mesh.colours.has(i)) check_colour(mesh.colours[i], block.location, "vertex colour");
    }
    warn_of_default(mesh, block);
    warn_of_missing_uvs(mesh, block);
  }

  void warn_of_missing_uvs(const Mesh& mesh, const Block& block) {
    std::size_t faces = 0;
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      const auto corners = mesh.face(i);
      const auto lacks_uv = [&](std::uint32_t corner) { return !mesh.uvs.has(corner); };
      if (mesh.surface(i).texture && std::any_of(corners.begin(), corners.end(), lacks_uv)) ++faces;
    }
    if (faces == 0) return;
    diagnostics_.warning(
        block.location,
        fmt::format("{} with a texture {} corners without uv: it is (0, 0) there",
                    faces == 1 ? "a face" : fmt::format("{} faces", faces), faces == 1 ? "has" : "have"));
  }

  template <class ModelOfKind>
  void check_attribute(const std::optional<std::variant<ModelOfKind, Reference>>& attribute,
                       const Kind<ModelOfKind>& kind, const Scope& scope) {
    if (!attribute) return;
    if (const auto* reference = std::get_if<Reference>(&*attribute)) {
      check_reference<ModelOfKind>(*reference, kind.name, scope);
    } else {
      check_model(std::get<ModelOfKind>(*attribute), kind, scope);
    }
  }

  void check_attribute(const std::optional<ColourAttribute>& attribute, const Block& block,
                       const Scope& scope) {
    if (!attribute) return;
    if (const auto* reference = std::get_if<Reference>(&*attribute)) {
      check_reference<Colour>(*reference, "colour", scope);
    } else {
      check_colour(std::get<Colour>(*attribute), block.location, "colour");
    }
  }

  void check_texture(const std::optional<TextureAttribute>& attribute, const Scope& scope) {
    if (!attribute) return;
    if (const auto* reference = std::get_if<Reference>(&*attribute)) {
      check_reference<Texture>(*reference, "texture", scope);
    } else {
      check_image(std::get<Texture>(*attribute));
    }
  }

  // A scene is of use without its images, so one that is missing is no error. Each is reported once.
  void check_image(const Texture& texture) {
    const SourceLocation& location = texture.location;
    const std::string path = location.file ? path_beside(location.file->path, texture.file) : texture.file;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) || !missing_images_.insert(path).second) return;
    diagnostics_.warning(location, fmt::format("there is no image '{}'", path));
  }

  template <class Body>
  void check_reference(const Reference& reference, std::string_view kind, const Scope& scope) {
    if (scope.find<Body>(reference.name) != nullptr) return;
    const std::string message = fmt::format("no {} called '{}' is defined here", kind, reference.name);
    diagnostics_.error(reference.location, with_suggestion(message, reference.name, scope.names_of<Body>()));
  }

  void check_definition(const Definition& definition, const Scope& scope) {
    if (const auto* brdf = std::get_if<BrdfModel>(&definition.body)) {
      check_model(*brdf, brdfs_, scope);
    } else if (const auto* pdf = std::get_if<PdfModel>(&definition.body)) {
      check_model(*pdf, pdfs_, scope);
    } else if (const auto* colour = std::get_if<Colour>(&definition.body)) {
      check_colour(*colour, definition.location, "colour");
    } else if (const auto* texture = std::get_if<Texture>(&definition.body)) {
      check_image(*texture);
    }
  }

  void check_colour(const Colour& colour, const SourceLocation& location, std::string_view what) {
    if (colour.x < 0 || colour.y < 0 || colour.z < 0) {
      diagnostics_.error(location, fmt::format("a {} of ({}, {}, {}), expected components of 0 or more", what,
                                               colour.x, colour.y, colour.z));
    } else if (what != "radiance" && std::max({colour.x, colour.y, colour.z}) > 1) {
      diagnostics_.warning(location,
                           "a colour over 1: such a surface can reflect more light than it receives");
    }
  }

  const Kind<BrdfModel> brdfs_;
  const Kind<PdfModel> pdfs_;
  Diagnostics& diagnostics_;
  std::set<std::string> files_with_default_;
  std::set<std::string> missing_images_;
};

}  // namespace

bool ParameterInfo::is_called(std::string_view word) const {
  return same_keyword(name, word) ||
         std::any_of(aliases.begin(), aliases.end(),
                     [word](std::string_view alias) { return same_keyword(alias, word); });
}

const ParameterInfo* ModelInfo::find(std::string_view word) const {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(),
                   [word](const ParameterInfo& parameter) { return parameter.is_called(word); });
  return found == parameters.end() ? nullptr : &*found;
}

const ModelInfo* find_model(const std::vector<ModelInfo>& models, std::string_view keyword) {
  const auto found = std::find_if(models.begin(), models.end(), [keyword](const ModelInfo& model) {
    return same_keyword(model.keyword, keyword);
  });
  return found == models.end() ? nullptr : &*found;
}

const Argument* find_argument(const Model& model, const ParameterInfo& parameter) {
  const auto found =
      std::find_if(model.arguments.begin(), model.arguments.end(),
                   [&](const Argument& argument) { return parameter.is_called(argument.name); });
  return found == model.arguments.end() ? nullptr : &*found;
}

bool check(const Model& model, const std::vector<ModelInfo>& models, std::string_view kind,
           Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const ModelInfo* info = find_model(models, model.keyword);
  if (info != nullptr) {
    check_arguments(model, *info, diagnostics);
    check_together(model, *info, errors_before, diagnostics);
  } else {
    diagnostics.error(model.location, with_suggestion(fmt::format("unknown {} '{}'", kind, model.keyword),
                                                      model.keyword, keywords_of(models)));
  }
  return diagnostics.error_count() == errors_before;
}

bool check(const Scene& scene, const Catalogue& catalogue, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  Check(catalogue, diagnostics).run(scene);
  return diagnostics.error_count() == errors_before;
}

}  // namespace grf
