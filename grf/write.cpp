#include "grf/write.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "grf/keywords.h"
#include "grf/visit.h"
#include "grf/write_files.h"

namespace grf {
namespace {

// The grammar knows no `transform` without a step and no `def` without a definition.
constexpr std::string_view NoTransform = " translation (0, 0, 0)";

// fmt writes the fewest digits that read back to the same float, without regard to the locale.
void put(std::string& text, const Vec2f& v) {
  fmt::format_to(std::back_inserter(text), "({}, {})", v.x, v.y);
}
void put(std::string& text, const Vec3f& v) {
  fmt::format_to(std::back_inserter(text), "({}, {}, {})", v.x, v.y, v.z);
}

// Text that cannot stand in a file as it is must not make the rest of it unreadable.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\0'; }, ' ');
  return text;
}

// A return at the end of a line is taken for a part of the line end.
std::string comment_text(const std::string& comment) {
  std::string text = on_one_line(comment);
  while (text.ends_with('\r')) text.pop_back();
  return text;
}

std::string quoted(const std::string& string) {
  std::string text = on_one_line(string);
  if (text.find('"') == std::string::npos) return fmt::format("\"{}\"", text);
  for (const std::string_view quote : {"\u201C", "\u201D"}) {
    for (auto at = text.find(quote); at != std::string::npos; at = text.find(quote, at)) {
      text[at] = '"';
      text.erase(at + 1, quote.size() - 1);
    }
  }
  return fmt::format("\u201C{}\u201D", text);
}

/// The word with another case of its letters: each number, seen as binary digits, gives another spelling.
std::string respelled(std::string word, std::uint64_t number) {
  for (char& c : word) {
    const char lower = lower_case(c);
    if (lower < 'a' || lower > 'z') continue;
    if ((number & 1U) != 0) c = c == lower ? static_cast<char>(lower - 'a' + 'A') : lower;
    number >>= 1U;
  }
  return word;
}

class Writer {
 public:
  /// The definitions in force where the text will stand.
  explicit Writer(Scope scope) : scope_(std::move(scope)) {}

  void blocks(const BlockList& list) {
    for (const Block& block : list.blocks) {
      comments_before(block.comments);
      std::visit([this](const auto& content) { put_block(content); }, block.content);
      end_line(block.comments);
    }
    put_comments(list.end_comments);
  }

  /// A file of no bytes at all is taken for a mistake when it is read.
  std::string take_text() { return text_.empty() ? "\n" : std::move(text_); }

 private:
  void put_block(const Shared<Mesh>& mesh);
  void put_block(const AreaLight& light);
  void put_block(const Include& include) { begin_line("include " + quoted(include.file)); }
  void put_block(const Transform& transform);
  void put_block(const DefinitionScope& definitions);

  void put_definition(const Definition& definition, bool first);
  void put_body(const BlockList& body);
  void put_vertices(const Mesh& mesh);
  void put_faces(const Mesh& mesh);
  void put_attributes(const Surface& surface, const MeshComments& comments);
  void put_changes(const Surface& before, const Surface& after);
  void put_attribute(const ColourAttribute& colour);
  void put_attribute(const BrdfAttribute& brdf) { put_model("brdf ", brdf); }
  void put_attribute(const PdfAttribute& pdf) { put_model("pdf ", pdf); }
  void put_attribute(const TextureAttribute& texture);
  void put_attribute(const Colour& emission);
  template <class Attribute>
  void put_model(const char* keyword, const Attribute& attribute);
  template <class Attribute>
  void put_own(const std::optional<Attribute>& attribute, const Comments& comments);
  template <class Attribute>
  void put_change(const char* keyword, const std::optional<Attribute>& before,
                  const std::optional<Attribute>& after);
  template <class ModelOfKind>
  std::string unambiguous(const ModelOfKind& model) const;

  void put_comments(const std::vector<std::string>& comments) {
    for (const std::string& comment : comments) line(fmt::format("//{}", comment_text(comment)));
  }
  void comments_before(const Comments& comments) { put_comments(comments.before); }
  void begin_line(std::string_view words) {
    text_.append(2 * indentation_, ' ');
    text_ += words;
  }
  void end_line() { text_ += '\n'; }
  void end_line(const Comments& comments) {
    const std::string behind = comment_text(comments.behind);
    if (!behind.empty()) text_ += fmt::format("  //{}", behind);
    text_ += '\n';
  }
  void line(std::string_view words) {
    begin_line(words);
    end_line();
  }

  std::string text_;
  std::size_t indentation_ = 0;
  Scope scope_;
};

void Writer::put_block(const AreaLight& light) {
  line("light begin");
  ++indentation_;
  if (light.radiance) {
    begin_line("rgb ");
    put(text_, *light.radiance);
    end_line();
  }
  for (const Vec3f& v : {light.corner, light.edge1, light.edge2}) {
    begin_line("");
    put(text_, v);
    end_line();
  }
  --indentation_;
  begin_line("end");
}

void Writer::put_block(const Transform& transform) {
  begin_line("transform");
  for (const TransformStep& step : transform.steps) {
    switch (step.kind) {
      case TransformStep::Kind::Scale:
        text_ += " scale ";
        break;
      case TransformStep::Kind::Rotation:
        text_ += " rotation ";
        break;
      case TransformStep::Kind::Translation:
        text_ += " translation ";
        break;
    }
    put(text_, step.value);
  }
  if (transform.steps.empty()) text_ += NoTransform;
  text_ += " begin\n";
  put_body(transform.body);
}

void Writer::put_block(const DefinitionScope& definitions) {
  bool first = true;
  for (const Definition& definition : definitions.definitions) {
    put_definition(definition, first);
    first = false;
  }
  for (const Definition& definition : definitions.definitions) scope_.enter(definition);
  line(definitions.definitions.empty() ? fmt::format("transform{} begin", NoTransform) : "begin");
  put_body(definitions.body);
  scope_.leave(definitions.definitions.size());
}

// What is before the first `def` belongs to the block as a whole, so comments of the first definition stand
// between `def` and its name.
void Writer::put_definition(const Definition& definition, bool first) {
  if (first && !definition.comments.before.empty()) {
    line("def");
    ++indentation_;
    comments_before(definition.comments);
    begin_line(definition.name);
    --indentation_;
  } else {
    comments_before(definition.comments);
    begin_line("def " + definition.name);
  }
  text_ += " = ";
  if (const auto* colour = std::get_if<Colour>(&definition.body)) {
    text_ += "rgb ";
    put(text_, *colour);
  } else if (const auto* brdf = std::get_if<BrdfModel>(&definition.body)) {
    text_ += "brdf " + to_text(*brdf);
  } else if (const auto* pdf = std::get_if<PdfModel>(&definition.body)) {
    text_ += "pdf " + to_text(*pdf);
  } else if (const auto* texture = std::get_if<Texture>(&definition.body)) {
    text_ += "texture " + quoted(texture->file);
  }
  end_line(definition.comments);
}

void Writer::put_body(const BlockList& body) {
  ++indentation_;
  blocks(body);
  --indentation_;
  begin_line("end");
}

void Writer::put_block(const Shared<Mesh>& shared_mesh) {
  const Mesh& mesh = *shared_mesh;
  line(mesh.name.empty() ? "begin mesh" : "begin mesh " + quoted(mesh.name));
  ++indentation_;
  put_attributes(mesh.surfaces.front(), mesh.comments);
  comments_before(mesh.comments.vertices);
  put_vertices(mesh);
  comments_before(mesh.comments.faces);
  put_faces(mesh);
  put_comments(mesh.comments.end);
  --indentation_;
  begin_line("end mesh");
}

void Writer::put_vertices(const Mesh& mesh) {
  line("begin vertexs");
  ++indentation_;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    begin_line("");
    if (mesh.normals.has(i)) {
      text_ += "normal ";
      put(text_, mesh.normals[i]);
      text_ += ' ';
    }
    if (mesh.colours.has(i)) {
      text_ += "rgb ";
      put(text_, mesh.colours[i]);
      text_ += ' ';
    }
    if (mesh.uvs.has(i)) {
      text_ += "uv ";
      put(text_, mesh.uvs[i]);
      text_ += ' ';
    }
    put(text_, mesh.positions[i]);
    end_line();
  }
  --indentation_;
  begin_line("end vertexs");
  end_line(mesh.comments.vertices);
}

void Writer::put_faces(const Mesh& mesh) {
  line("begin faces");
  ++indentation_;
  std::uint32_t current = 0;
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    if (mesh.surface_of_face[i] != current) {
      put_changes(mesh.surfaces[current], mesh.surface(i));
      current = mesh.surface_of_face[i];
    }
    begin_line("");
    fmt::format_to(std::back_inserter(text_), "({})\n", fmt::join(mesh.face(i), ", "));
  }
  --indentation_;
  begin_line("end faces");
  end_line(mesh.comments.faces);
}

template <class Attribute>
void Writer::put_own(const std::optional<Attribute>& attribute, const Comments& comments) {
  comments_before(comments);
  if (!attribute) return;
  begin_line("");
  put_attribute(*attribute);
  end_line(comments);
}

void Writer::put_attributes(const Surface& surface, const MeshComments& comments) {
  put_own(surface.colour, comments.colour);
  put_own(surface.brdf, comments.brdf);
  put_own(surface.pdf, comments.pdf);
  put_own(surface.texture, comments.texture);
  put_own(surface.emission, comments.emission);
}

template <class Attribute>
void Writer::put_change(const char* keyword, const std::optional<Attribute>& before,
                        const std::optional<Attribute>& after) {
  if (before == after) return;
  begin_line("");
  if (after) {
    put_attribute(*after);
  } else {
    text_ += std::string(keyword) + " none";
  }
  end_line();
}

void Writer::put_changes(const Surface& before, const Surface& after) {
  put_change("rgb", before.colour, after.colour);
  put_change("brdf", before.brdf, after.brdf);
  put_change("pdf", before.pdf, after.pdf);
  put_change("texture", before.texture, after.texture);
  put_change("light", before.emission, after.emission);
}

void Writer::put_attribute(const ColourAttribute& colour) {
  text_ += "rgb ";
  if (const auto* reference = std::get_if<Reference>(&colour)) {
    text_ += reference->name;
  } else {
    put(text_, std::get<Colour>(colour));
  }
}

void Writer::put_attribute(const TextureAttribute& texture) {
  const auto* reference = std::get_if<Reference>(&texture);
  text_ += "texture " + (reference != nullptr ? reference->name : quoted(std::get<Texture>(texture).file));
}

void Writer::put_attribute(const Colour& emission) {
  text_ += "light rgb ";
  put(text_, emission);
}

template <class Attribute>
void Writer::put_model(const char* keyword, const Attribute& attribute) {
  text_ += keyword;
  if (const auto* reference = std::get_if<Reference>(&attribute)) {
    text_ += reference->name;
  } else {
    text_ += unambiguous(std::get<0>(attribute));
  }
}

// A keyword without parameters reads as a reference where a definition has the same spelling. Definitions
// are case-sensitive and keywords are not, so another spelling says the keyword.
template <class ModelOfKind>
std::string Writer::unambiguous(const ModelOfKind& model) const {
  std::string text = to_text(model);
  if (!model.arguments.empty()) return text;
  const std::uint64_t spellings = std::uint64_t{1} << std::min<std::size_t>(model.keyword.size(), 63);
  for (std::uint64_t i = 1; i < spellings && scope_.find<ModelOfKind>(text) != nullptr; ++i) {
    text = respelled(model.keyword, i);
  }
  return text;
}

}  // namespace

std::string text_of_file(const BlockList& contents, const Scope& scope) {
  Writer writer(scope);
  writer.blocks(contents);
  return writer.take_text();
}

std::string to_text(const Scene& scene) { return text_of_file(scene.contents, {}); }

std::string to_text(const Model& model) {
  std::string text = model.keyword;
  for (const Argument& argument : model.arguments) {
    text += ' ' + argument.name + '=';
    if (const auto* number = std::get_if<float>(&argument.value)) text += fmt::format("{}", *number);
    if (const auto* flag = std::get_if<bool>(&argument.value)) text += *flag ? "true" : "false";
    if (const auto* colour = std::get_if<Colour>(&argument.value)) put(text, *colour);
  }
  return text;
}

}  // namespace grf
