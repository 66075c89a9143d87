#include <variant>

#include "renderer/fit/observations.h"
#include "renderer/parallel/loops.h"

namespace fit {

void evaluate(const reflectance::Brdf& brdf, std::span<const Observation> observations,
              std::vector<Vec3d>& values) {
  values.resize(observations.size());
  std::visit(
      [&](const auto& model) {
        parallel::for_each_range(observations.size(), [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            values[i] = model.evaluate(observations[i].u, observations[i].v);
        });
      },
      brdf);
}

}  // namespace fit
