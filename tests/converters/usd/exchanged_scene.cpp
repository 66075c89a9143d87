#include "tests/converters/usd/exchanged_scene.h"

#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "converters/format.h"
#include "tests/converters/reading.h"

namespace convert {

ExchangedScene::ExchangedScene(const std::string& grf, const std::string& op) { write(grf, op); }

ExchangedScene::ExchangedScene(const std::string& grf, const std::string& op,
                               const test::TemporaryFolder& files) {
  for (const std::string& name : files.names()) folder_.add(name, test::bytes_of(files.path(name)));
  write(grf, op);
}

void ExchangedScene::write(const std::string& grf, const std::string& op) {
  const grf::Scene scene = scene_of_grf(grf);
  folder_.add("scene.grf", grf);
  WriteOptions options;
  if (!op.empty()) options.op_file = folder_.add("view.op", op);
  const auto written = [&](const char* format, const std::string& path, std::string& warnings) {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(find_format(format)->write_view(scene, path, options, diagnostics)) << diagnostics.to_text();
    warnings = diagnostics.to_text();
    return test::bytes_of(path);
  };
  usd_text_ = written("usd", folder_.path("out.usda"), usd_warnings_);
  mtlx_text_ = written("materialx", folder_.path("out.mtlx"), mtlx_warnings_);
  usd_ = test::parse_usda(usd_text_, folder_.path());
  mtlx_ = test::parse_mtlx(mtlx_text_);
}

std::string exchange_cube(const std::string& attributes, const std::vector<std::string>& of_faces) {
  constexpr std::array Faces = {"(0,2,3,1)", "(4,5,7,6)", "(0,1,5,4)", "(2,6,7,3)", "(0,4,6,2)", "(1,3,7,5)"};
  std::string text = "begin mesh \"cube\" " + attributes + " begin vertexs\n";
  for (int i = 0; i < 8; ++i)
    text += fmt::format("({}, {}, {})\n", i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
  text += "end vertexs begin faces\n";
  for (std::size_t i = 0; i < Faces.size(); ++i)
    text += (i < of_faces.size() ? of_faces[i] + " " : "") + Faces[i] + "\n";
  return text + "end faces end mesh\n";
}

}  // namespace convert
