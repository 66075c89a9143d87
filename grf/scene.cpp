#include "grf/scene.h"

#include <array>

namespace grf {

bool operator==(const BlockList& a, const BlockList& b) {
  return a.blocks == b.blocks && a.end_comments == b.end_comments;
}

std::string_view kind_of(const Definition::Body& body) {
  constexpr std::array<std::string_view, std::variant_size_v<Definition::Body>> Kinds = {"colour", "BRDF",
                                                                                         "PDF", "texture"};
  return Kinds[body.index()];
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
