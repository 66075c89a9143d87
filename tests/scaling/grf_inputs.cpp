#include <fmt/format.h>

#include "tests/scaling/inputs.h"

namespace scaling {
namespace {

Text same(std::string piece) {
  return [piece = std::move(piece)](std::size_t) { return piece; };
}

std::string square(const std::string& attributes = "") {
  return "begin mesh " + attributes +
         " begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs begin faces (0,1,2,3) end faces end "
         "mesh\n";
}

const std::string SquareWithFaces =
    "begin mesh begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs begin faces\n";
const std::string EndOfFaces = " end faces end mesh\n";

/// A strip of squares, each vertex with values.
std::string strip(std::size_t count, const std::string& values, bool is_light = false) {
  std::string text = is_light ? "mesh light begin" : "begin mesh";
  text += " begin vertexs\n";
  for (std::size_t i = 0; i <= count; ++i) {
    for (const int y : {0, 1}) text += fmt::format("{}({},{},{})\n", values, i, y, i % 2);
  }
  text += "end vertexs begin faces\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += fmt::format("({},{},{},{})\n", 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  }
  return text + (is_light ? " end faces end\n" : EndOfFaces);
}

/// A zigzag band, or with one side of the band straight, a comb.
std::string one_face(std::size_t corners, bool is_comb) {
  const std::size_t half = corners / 2 + 2;
  std::string text = "begin mesh begin vertexs\n";
  for (std::size_t i = 0; i < half; ++i) text += fmt::format("({},{},0)\n", i, is_comb ? 0 : 100 * (i % 2));
  for (std::size_t i = half; i-- > 0;) text += fmt::format("({},{},0)\n", i, 100 * (i % 2) + 1);
  text += "end vertexs begin faces (";
  for (std::size_t i = 0; i < 2 * half; ++i) text += fmt::format("{}{}", i > 0 ? "," : "", i);
  return text + ")" + EndOfFaces;
}

std::string nested(std::size_t depth, const std::string& begin) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += begin + " begin\n";
  text += square();
  for (std::size_t i = 0; i < depth; ++i) text += "end\n";
  return text;
}

std::string chain_of_definitions(std::size_t count) {
  std::string text = "def c0 = brdf diffuse kd=0.5\n";
  for (std::size_t i = 1; i < count; ++i) text += fmt::format("def c{} = brdf combine 1 c{}\n", i, i - 1);
  return text + "begin " + square(fmt::format("brdf c{}", count - 1)) + "end\n";
}

/// Coats over the end of a chain of sums, which each of them could go through.
std::string coats_over_a_chain(std::size_t count) {
  std::string text = "def c0 = brdf diffuse kd=0.5\n";
  for (std::size_t i = 1; i < count; ++i) text += fmt::format("def c{} = brdf combine 1 c{}\n", i, i - 1);
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("def k{} = brdf coat base=c{}\n", i, count - 1);
  return text + "begin " + square("brdf k0") + "end\n";
}

std::string combine_of(std::size_t terms) {
  std::string text = "def a = brdf diffuse kd=0.5\ndef sum = brdf combine ";
  for (std::size_t i = 0; i < terms; ++i)
    text += fmt::format("{}{} a", i > 0 ? ", " : "", 1.0 / double(terms));
  return text + "\nbegin " + square("brdf sum") + "end\n";
}

std::vector<Input> mesh_inputs() {
  return {
      {"faces", "grf", [](std::size_t n) { return strip(n, ""); }},
      {"vertices with normals, colours and uv", "grf",
       [](std::size_t n) { return strip(n, "normal (0,0,1) rgb (1,0,0) uv (0,1) "); }},
      {"vertices that no face uses", "grf",
       pieces("begin mesh begin vertexs (0,0,0) (1,0,0) (1,1,0)\n", same("(2,3,4)\n"),
              "end vertexs begin faces (0,1,2)" + EndOfFaces)},
      {"corners of one face, a zigzag", "grf", [](std::size_t n) { return one_face(n, false); }},
      {"corners of one face, a comb", "grf", [](std::size_t n) { return one_face(n, true); }},
      {"faces on one another", "grf", pieces(SquareWithFaces, same("(0,1,2)\n"), EndOfFaces)},
      {"runs of attributes", "grf",
       pieces(
           SquareWithFaces,
           [](std::size_t i) { return fmt::format("rgb ({},0,0) (0,1,2)\n", double(i % 2)); }, EndOfFaces)},
      {"surfaces", "grf",
       pieces(
           SquareWithFaces, [](std::size_t i) { return fmt::format("brdf diffuse kd=0.{:06} (0,1,2)\n", i); },
           EndOfFaces)},
      {"textures", "grf",
       pieces(
           SquareWithFaces, [](std::size_t i) { return fmt::format("texture \"{}.png\" (0,1,2)\n", i); },
           EndOfFaces),
       1000},
      {"values of irradiance", "igrf",
       pieces("begin mesh begin vertexs begin list\n", same("ray (0,0,1) irad (1,1,1)\n"),
              "end list (0,0,0) (1,0,0) (1,1,0) end vertexs begin faces (0,1,2)" + EndOfFaces)},
      {"vertices with irradiance", "igrf", [](std::size_t n) { return strip(n, "irad (1,2,3) "); }},
      {"faces that emit", "grf", pieces(SquareWithFaces, same("light rgb (1,1,1) (0,1,2)\n"), EndOfFaces)},
      {"faces of a mesh light", "grf", [](std::size_t n) { return strip(n, "", true) + square(); }},
  };
}

std::vector<Input> block_inputs() {
  return {
      {"meshes", "grf", pieces("", same(square("brdf phong n=10")))},
      {"mesh lights", "grf",
       pieces("",
              same("mesh light begin begin vertexs (0,0,0) (1,0,0) (1,1,0) end vertexs begin faces (0,1,2) "
                   "end faces end\n"))},
      {"lights", "grf",
       pieces(
           "",
           [](std::size_t i) { return fmt::format("light begin ({},0,0) (1,0,0) (0,1,0) end\n", 2 * i); })},
      {"lights that face nothing", "grf",
       pieces("",
              [](std::size_t i) {
                return fmt::format("transform translation (0,0,-{}) begin ", i) + square() +
                       fmt::format("end light begin ({},0,0) (1,0,0) (0,1,0) end\n", i);
              })},
      {"faces of a light that faces nothing", "grf",
       [](std::size_t n) {
         return strip(n, "", true) + "transform translation (0,0,-0.1) begin " + strip(n, "") + "end\n";
       }},
      {"observers", "grf", pieces("params begin\n", same("dependent view (0,0,1)\n"), "end\n")},
      {"transforms", "grf", pieces("", same("transform translation (1,2,3) begin " + square() + "end\n"))},
      {"steps of a transform", "grf",
       pieces("transform\n", same("rotation (0,0.1,0)\n"), "begin " + square() + "end\n")},
      {"nested transforms", "grf", [](std::size_t n) { return nested(n, "transform translation (0,0,1)"); },
       15},
      {"nested definitions", "grf", [](std::size_t n) { return nested(n, "def a = brdf diffuse kd=0.5"); },
       15},
      {"scopes", "grf", pieces("", same("def a = brdf diffuse kd=0.5 begin " + square("brdf a") + "end\n"))},
      {"scopes with meshes of one name", "grf",
       pieces("", same("def m = " + square("light rgb (1,1,1)") + "begin use m use m end\n"))},
      {"definitions", "grf",
       pieces(
           "", [](std::size_t i) { return fmt::format("def a{} = brdf phong n={}\n", i, 1 + i % 100); },
           "begin " + square("brdf a0") + "end\n")},
      {"definitions of everything", "grf",
       pieces(
           "",
           [](std::size_t i) {
             return fmt::format("def r{0} = rgb (1,0,0) def p{0} = pdf cosine def t{0} = texture \"x.png\"\n",
                                i);
           },
           "begin " + square() + "end\n")},
      {"uses of definitions", "grf",
       pieces("def a = brdf phong n=10 begin\n", same(square("brdf a")), "end\n")},
      {"chain of definitions", "grf", chain_of_definitions, 500},
      {"terms of a combine", "grf", combine_of, 500},
      {"coats over a chain", "grf", coats_over_a_chain, 500},
      {"meshes that are defined", "grf",
       pieces(
           "", [](std::size_t i) { return fmt::format("def m{} = ", i) + square(); }, "begin use m0 end\n")},
      {"uses of a mesh", "grf", pieces("def m = " + square() + "begin\n", same("use m\n"), "end\n")},
      {"uses of a mesh of many vertices", "grf",
       [](std::size_t n) {
         std::string text = "def m = begin mesh begin vertexs\n";
         for (std::size_t i = 0; i < n + 3; ++i) text += fmt::format("({},{},0)\n", i, i % 2);
         text += "end vertexs begin faces (0,1,2)" + EndOfFaces + "begin\n";
         for (std::size_t i = 0; i < n; ++i) text += "use m\n";
         return text + "end\n";
       }},
      {"names of meshes", "grf",
       pieces("", [](std::size_t i) { return square(fmt::format("\"mesh {}\"", i)); })},
  };
}

std::vector<Input> include_inputs() {
  const std::string includes = "include \"part.grf\"\n";
  const auto part = [](std::size_t) { return std::vector<CompanionFile>{{"part.grf", square()}}; };
  const auto parts = [](std::size_t count) {
    std::vector<CompanionFile> files;
    for (std::size_t i = 0; i < count; ++i) files.push_back({fmt::format("part{}.grf", i), square()});
    return files;
  };
  const auto chain = [](std::size_t count) {
    std::vector<CompanionFile> files = {{"part0.grf", square()}};
    for (std::size_t i = 1; i < count; ++i) {
      files.push_back(
          {fmt::format("part{}.grf", i), fmt::format("include \"part{}.grf\"\n", i - 1) + square()});
    }
    return files;
  };
  return {
      {"includes of one file", "grf", copies("", includes), 500, false, part},
      {"included files", "grf",
       pieces("", [](std::size_t i) { return fmt::format("include \"part{}.grf\"\n", i); }), 250, false,
       parts},
      {"files that include one another", "grf",
       [](std::size_t n) { return fmt::format("include \"part{}.grf\"\n", n - 1); }, 3, false, chain},
      {"includes with other names", "grf",
       pieces("",
              [](std::size_t i) {
                return fmt::format("def a = brdf phong n={} begin include \"part.grf\" end\n", i % 100);
              }),
       500, false,
       [](std::size_t) {
         return std::vector<CompanionFile>{{"part.grf", square("brdf combine 1 a")}};
       }},
  };
}

/// Errors are reported up to a limit, but the whole file is read.
std::vector<Input> text_inputs() {
  return {
      {"comments", "grf", pieces("", same("// about\n"), square())},
      {"blocks with comments", "grf", pieces("", same("// about\n" + square()))},
      {"a long comment", "grf", pieces("// ", same("about "), "\n" + square())},
      {"blank lines", "grf", pieces("", same("\n"), square())},
      {"mistakes", "grf", pieces("", same("begin mesh nonsense\n")), 500, true},
      {"mistakes on one line", "grf", pieces("", same("nonsense ")), 500, true},
      {"unknown models on one line", "grf",
       pieces("begin mesh begin vertexs (0,0,0) (1,0,0) (1,1,0) end vertexs begin faces ",
              same("brdf fong m=10 (0,1,2) "), EndOfFaces)},
      {"unknown parameters", "grf",
       pieces(
           "begin mesh brdf phong ", [](std::size_t i) { return fmt::format("p{}=1 ", i); },
           square().substr(11))},
      {"names that mean nothing", "grf",
       pieces("", [](std::size_t i) { return square(fmt::format("brdf unknown{}", i)); }), 500},
  };
}

}  // namespace

std::vector<Input> grf_inputs() {
  std::vector<Input> inputs = mesh_inputs();
  for (const auto& more : {block_inputs(), include_inputs(), text_inputs()})
    inputs.insert(inputs.end(), more.begin(), more.end());
  return inputs;
}

}  // namespace scaling
