#include "grf/scene.h"

#include <algorithm>
#include <array>

namespace grf {

bool operator==(const BlockList& a, const BlockList& b) {
  return a.blocks == b.blocks && a.end_comments == b.end_comments;
}

std::string_view kind_of(const Definition::Body& body) {
  constexpr std::array<std::string_view, std::variant_size_v<Definition::Body>> Kinds = {
      "colour", "BRDF", "PDF", "texture", "mesh"};
  return Kinds[body.index()];
}

bool has_irradiance(const BlockList& contents) {
  const auto defines_some = [](const Definition& definition) {
    const auto* mesh = std::get_if<Shared<Mesh>>(&definition.body);
    return mesh != nullptr && !(*mesh)->irradiance->empty();
  };
  return std::any_of(contents.blocks.begin(), contents.blocks.end(), [&](const Block& block) {
    if (const auto* mesh = std::get_if<Shared<Mesh>>(&block.content)) return !(*mesh)->irradiance->empty();
    if (const auto* light = std::get_if<MeshLight>(&block.content)) return !light->mesh->irradiance->empty();
    if (const auto* transform = std::get_if<Transform>(&block.content))
      return has_irradiance(transform->body);
    const auto* scope = std::get_if<DefinitionScope>(&block.content);
    return scope != nullptr &&
           (std::any_of(scope->definitions.begin(), scope->definitions.end(), defines_some) ||
            has_irradiance(scope->body));
  });
}

std::size_t nesting_of(const BlockList& contents) {
  std::size_t deepest = 0;
  for (const Block& block : contents.blocks) {
    if (const auto* transform = std::get_if<Transform>(&block.content)) {
      deepest = std::max(deepest, 1 + nesting_of(transform->body));
    } else if (const auto* scope = std::get_if<DefinitionScope>(&block.content)) {
      deepest = std::max(deepest, 1 + nesting_of(scope->body));
    } else if (const auto* include = std::get_if<Include>(&block.content)) {
      deepest = std::max(deepest, nesting_of(*include->contents));
    }
  }
  return deepest;
}

Matrix44d matrix_of(const std::vector<TransformStep>& steps) {
  Matrix44d matrix;
  for (const TransformStep& step : steps) {
    const Vec3d value(step.value);
    Matrix44d action;
    switch (step.kind) {
      case TransformStep::Kind::Scale:
        action.setScale(value);
        break;
      case TransformStep::Kind::Rotation: {
        Matrix44d x;
        Matrix44d y;
        Matrix44d z;
        x.setAxisAngle(Vec3d(1, 0, 0), value.x);
        y.setAxisAngle(Vec3d(0, 1, 0), value.y);
        z.setAxisAngle(Vec3d(0, 0, 1), value.z);
        action = x * y * z;
        break;
      }
      case TransformStep::Kind::Translation:
        action.setTranslation(value);
        break;
    }
    matrix *= action;
  }
  return matrix;
}

}  // namespace grf
