// Reads a scene of any format, prints what the BRDF of each of its definitions reflects at 45 degrees, and
// writes the scene in the format of another name. Usage: example INPUT OUTPUT
#include <cmath>
#include <iostream>
#include <optional>

#include "converters/input.h"
#include "converters/output.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/brdf_instance.h"

namespace {

void print_brdf(const std::string& name, const grf::BrdfModel& model, grf::Diagnostics& diagnostics) {
  const auto brdf = reflectance::make_brdf(model, diagnostics);
  if (!brdf) return;
  const reflectance::Reflector reflector(*brdf, reflectance::OwnScheme());
  const float half = std::sqrt(0.5F);
  const reflectance::Vec3f u(half, 0, half);   // towards the eye
  const reflectance::Vec3f v(-half, 0, half);  // towards the light, mirrored
  std::cout << name << " (" << grf::to_text(model) << "): f = " << reflector.evaluate(u, v).x
            << " / sr, albedo " << reflectance::albedo(reflector, u).x << '\n';
}

bool convert_scene(const std::string& input, const std::string& output, grf::Diagnostics& diagnostics) {
  auto read = convert::read_input({input, nullptr, {}}, diagnostics);
  if (!read) return false;
  grf::SceneVisitor visitor;
  visitor.definition = [&](const grf::Definition& definition, const grf::Placement&) {
    const auto* model = std::get_if<grf::BrdfModel>(&definition.body);
    if (model != nullptr) print_brdf(definition.name, *model, diagnostics);
  };
  grf::visit(read->import.scene, visitor, input);
  const convert::Format* format = convert::format_of_name(output);
  if (format == nullptr || format->write == nullptr) {
    std::cerr << output << ": no format of this name is written\n";
    return false;
  }
  return convert::write_output(read->import.scene, read->import.files, input, {output, format, {}},
                               diagnostics)
      .has_value();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: example INPUT OUTPUT\n";
    return 2;
  }
  grf::Diagnostics diagnostics;
  const bool is_done = convert_scene(arguments[1], arguments[2], diagnostics);
  std::cerr << diagnostics.to_text();
  return is_done ? 0 : 1;
}
