// Renders spheres of GGX metals and dielectrics with bpt and with Blender's Cycles, and compares their mean
// radiance: see tests/benchmarks/README.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/benchmarks/render/command_line.h"
#include "tests/benchmarks/render/materials.h"
#include "tests/benchmarks/render/pictures.h"
#include "tests/benchmarks/render/renderers.h"

namespace {

using benchmark::difference;
using benchmark::Masking;
using benchmark::Material;
using benchmark::SphereComparison;
using benchmark::SphereMeans;
using benchmark::Surroundings;

struct Arguments {
  benchmark::MaterialSettings settings;
  std::vector<std::string> names;  ///< of materials; empty: all
  double scale = 1;                ///< of all tolerances
};

std::vector<Material> chosen(const std::vector<std::string>& names) {
  std::vector<Material> found;
  for (const Material& material : benchmark::materials()) {
    if (names.empty() || std::find(names.begin(), names.end(), material.name) != names.end())
      found.push_back(material);
  }
  return found;
}

/// Returns the difference of the band that differs most.
double largest_of_bands(const SphereMeans& bpt, const SphereMeans& cycles) {
  return std::max({difference(bpt.centre, cycles.centre), difference(bpt.middle, cycles.middle),
                   difference(bpt.rim, cycles.rim)},
                  [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// Prints the differences in the studio, writes the picture, and returns whether what is alike agrees.
bool compare_in_studio(const Arguments& arguments) {
  fmt::print("| material | in Cycles |");
  for (const double roughness : benchmark::Roughnesses) fmt::print(" {} |", roughness);
  fmt::print("\n|---|---|--:|--:|--:|--:|--:|\n");
  bool agree = true;
  std::vector<std::vector<image::Image>> picture;
  for (const Material& material : chosen(arguments.names)) {
    fmt::print("| {} | {} |", material.name, material.in_cycles);
    auto& row = picture.emplace_back();
    for (SphereComparison& sphere : compare_material(material, Surroundings::Studio, arguments.settings)) {
      const double all = difference(sphere.bpt.all, sphere.cycles.all);
      const bool is_alike = sphere.roughness <= material.alike_up_to;
      agree = agree && (!is_alike || std::abs(all) <= arguments.scale * material.tolerance);
      fmt::print(" {:.2f} ({:.2f}) |", all, largest_of_bands(sphere.bpt, sphere.cycles));
      row.push_back(std::move(sphere.bpt_image));
      row.push_back(std::move(sphere.cycles_image));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  benchmark::write_grid(picture, arguments.settings.folder / "materials.png");
  fmt::print("\n");
  return agree;
}

/// Prints the means in white surroundings of what is known there, and returns whether bpt has them, and
/// Cycles those of its own masking. Where facets scatter light to each other, Kulla and Conty's lobe is an
/// approximation, and Cycles gives up after some bounces.
bool compare_in_white(const Arguments& arguments) {
  fmt::print(
      "| material | roughness | bpt | Cycles | expected | with separable masking "
      "|\n|---|--:|--:|--:|--:|--:|\n");
  bool agree = true;
  for (const Material& material : chosen(arguments.names)) {
    if (!material.ior) continue;
    for (const SphereComparison& sphere :
         compare_material(material, Surroundings::White, arguments.settings)) {
      const double expected = mean_in_white(material, sphere.roughness, Masking::HeightCorrelated);
      const double separable =
          material.is_single ? mean_in_white(material, sphere.roughness, Masking::Separable) : expected;
      fmt::print("| {} | {} | {:.4f} | {:.4f} | {:.4f} |", material.name, sphere.roughness, sphere.bpt.inner,
                 sphere.cycles.inner, expected);
      fmt::print("{} |\n", material.is_single ? fmt::format(" {:.4f}", separable) : "");
      const double of_bpt = material.is_single || *material.ior == 0 ? 0.5 : 3;
      agree = agree && std::abs(difference(sphere.bpt.inner, expected)) <= arguments.scale * of_bpt;
      if (!material.is_single && sphere.roughness > material.alike_up_to) continue;
      const double of_cycles = material.is_single ? 0.5 : 1;
      agree = agree && std::abs(difference(sphere.cycles.inner, separable)) <= arguments.scale * of_cycles;
    }
  }
  return agree;
}

int run(const Arguments& arguments) {
  fmt::print("{}\n\n", benchmark::required_blender_version());
  const bool agree_in_studio = compare_in_studio(arguments);
  const bool agree_in_white = compare_in_white(arguments);
  return agree_in_studio && agree_in_white ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares spheres of GGX in bpt and Cycles; fails if their mean radiance differs");
  Arguments arguments;
  auto& settings = arguments.settings;
  settings.folder = "build/benchmarks/render/materials";
  app.add_option("--folder", settings.folder, "folder for scenes and images")->capture_default_str();
  app.add_option("--size", settings.size, "width and height, pixels")->check(CLI::Range(16, 8192));
  app.add_option("--samples", settings.samples, "samples per pixel")->check(CLI::Range(1, 1'000'000));
  app.add_option("--threads", settings.threads)->check(CLI::Range(1, 1024));
  app.add_option("--materials", arguments.names, "names of materials, all if omitted")->delimiter(',');
  app.add_option("--scale-tolerances", arguments.scale, "factor of all tolerances")
      ->check(CLI::Range(0.0, 1e3));
  return benchmark::run_command_line(app, argc, argv, [&] { return run(arguments); });
}
