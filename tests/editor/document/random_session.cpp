#include "tests/editor/document/random_session.h"

#include <utility>

#include <fmt/format.h>

namespace editor {
namespace {

std::string mesh_text(const std::string& head) {
  return "begin mesh " + head +
         " begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) (0,0,1) end vertexs "
         "begin faces (0,1,2,3) (0,1,4) rgb (0,1,0) (1,2,4) end faces end mesh\n";
}

std::string model_text() {
  return mesh_text("\"extra\" texture \"brick.png\"") + "light begin (0,0,5) (1,0,5) (0,1,5) end\n";
}

}  // namespace

std::string main_text() {
  return "// The project's file.\ndef red = rgb (1,0,0)\n gold = brdf ward sx=0.2\n matt = brdf diffuse "
         "kd=0.25\n"
         " mix = brdf combine 0.5 gold, 0.5 matt\n tile = " +
         mesh_text("rgb red") + "begin\n use tile\n transform scale (2,2,2) begin use tile\n" +
         mesh_text("\"box\" brdf gold") +
         "end\n include \"part.grf\"\n"
         " transform scale (2,2,2) translation (8,0,0) begin include \"part.grf\" end\n" +
         mesh_text("\"floor\" brdf mix texture \"wood.png\"") +
         "light begin (0,0,4) (1,0,4) (0,1,4) end\n"
         "mesh light begin rgb (5,5,5) begin vertexs (0,0,3) (1,0,3) (0,1,3) end begin faces (0,1,2) end "
         "end\n"
         "params begin dependent view (1,2,3) end\n end\n";
}

std::vector<std::string> part_texts() {
  return {mesh_text("\"panel\" texture \"part.png\"") + "transform translation (1,2,3) begin " +
              mesh_text("\"knob\" rgb (0,0,1)") + "end\n",
          mesh_text("\"other_panel\""), "def bolt = " + mesh_text("") + "begin use bolt use bolt end\n"};
}

Plain3 plain(const grf::Vec3d& value) { return {float(value.x), float(value.y), float(value.z)}; }

std::string colour_text(const grf::Colour& colour) {
  return fmt::format("{} {} {}", colour.x, colour.y, colour.z);
}

RandomSession::RandomSession() {
  folder.add("b/notes.txt", "a folder to save in");
  modelled.write(part_file, part_texts().front());
  modelled.write(main_file, main_text());
  folder.add("c/model.grf", model_text());
  modelled.open(main_file);
  modelled.check();
}

void RandomSession::replace(const QString& text, std::optional<grf::Scene> scene, PlainProject after,
                            const QString& key) {
  if (scene) return modelled.replace(text, std::move(*scene), std::move(after), key);
  modelled.fail(text.toStdString() + " was refused: " + std::exchange(diagnostics, {}).to_text());
}

void RandomSession::expect_refused(const std::optional<grf::Scene>& scene, const std::string& what) {
  if (scene) modelled.fail(what + " was not refused");
  diagnostics = {};
}

}  // namespace editor
