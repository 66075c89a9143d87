// The tables of FORMATS.md are those of the code. To rewrite them after a change:
//   GRANADA_UPDATE_DOCUMENTS=1 build/release/bin/converters_test --gtest_filter='FormatsDocument*'
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "converters/brdf_lobes.h"
#include "converters/format.h"
#include "converters/risks/risk.h"
#include "tests/support/generated_document.h"

namespace convert {
namespace {

void expect_table(std::string_view name, const std::string& table) {
  test::expect_generated("converters/FORMATS.md", fmt::format("converters_test {}", name), table);
}

std::string code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

std::string material_table(std::string_view from, std::string_view to, std::span<const MaterialRule> rules) {
  std::string table = fmt::format("| {} | {} | for example |\n|---|---|---|\n", from, to);
  for (const MaterialRule& rule : rules) {
    table += fmt::format("| {} | {} | {} gives {} |\n", rule.source, rule.result, code(rule.example),
                         code(rule.gives));
  }
  return table;
}

TEST(FormatsDocument, ListsTheFormats) {
  const auto yes_or_no = [](bool is) { return is ? "yes" : "no"; };
  std::string table =
      "| name | title | extensions | read | written | keeps | loses |\n|---|---|---|---|---|---|---|\n";
  for (const Format& format : formats()) {
    table += fmt::format("| `{}` | {} | .{} | {} | {} | {} | {} |\n", format.name, format.title,
                         fmt::join(format.extensions, ", ."), yes_or_no(format.read != nullptr),
                         yes_or_no(format.write != nullptr), format.keeps, format.loses);
  }
  expect_table("formats", table);
}

TEST(FormatsDocument, SaysWhatBecomesOfMaterials) {
  expect_table("MTL to GRF", material_table("MTL", "GRF", find_format("obj")->read_materials));
  expect_table("GRF to MTL", material_table("GRF", "MTL", find_format("obj")->written_materials));
  expect_table("glTF to GRF", material_table("glTF", "GRF", find_format("gltf")->read_materials));
  expect_table("GRF to glTF", material_table("GRF", "glTF", find_format("gltf")->written_materials));
  expect_table("GRF to USD", material_table("GRF", "USD", find_format("usd")->written_materials));
  expect_table("GRF to MaterialX",
               material_table("GRF", "MaterialX", find_format("materialx")->written_materials));
  expect_table("GRF to pbrt", material_table("GRF", "pbrt", find_format("pbrt")->written_materials));
  expect_table("GRF to Mitsuba", material_table("GRF", "Mitsuba", find_format("mitsuba")->written_materials));
  expect_table("VRML to GRF", material_table("VRML", "GRF", find_format("vrml")->read_materials));
  expect_table("Assimp to GRF",
               material_table("Assimp's material", "GRF", find_format("other")->read_materials));
}

TEST(FormatsDocument, ListsTheRisks) {
  std::string table = "| risk | in JSON | is found where | what to do |\n|---|---|---|---|\n";
  for (const RiskInfo& info : risk_infos()) {
    table += fmt::format("| {} | `{}` | {} | {} |\n", info.title, info.name, info.test, info.advice);
  }
  expect_table("risks", table);
}

TEST(FormatsDocument, SaysWhatThePartsOfBrdfsAre) {
  std::string table = "| BRDF | diffuse lobe m | glossy lobe g | exponent h of g |\n|---|---|---|---|\n";
  for (const BrdfRule& rule : brdf_rules()) {
    table +=
        fmt::format("| {} | {} | {} | {} |\n", code(rule.keyword), rule.diffuse, rule.glossy, rule.exponent);
  }
  expect_table("BRDFs", table);
}

}  // namespace
}  // namespace convert
