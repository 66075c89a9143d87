#include "grf/write.h"

#include <algorithm>
#include <cmath>
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

bool is_finite(float number) { return std::isfinite(number); }
bool is_finite(const Vec2f& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite(const std::vector<Argument>& arguments) {
  return std::all_of(arguments.begin(), arguments.end(), [](const Argument& argument) {
    const auto* number = std::get_if<float>(&argument.value);
    const auto* colour = std::get_if<Colour>(&argument.value);
    return (number == nullptr || is_finite(*number)) && (colour == nullptr || is_finite(*colour));
  });
}

bool is_finite(const BrdfModel& brdf) {
  return is_finite(brdf.arguments) &&
         std::all_of(brdf.terms.begin(), brdf.terms.end(),
                     [](const CombineTerm& term) { return is_finite(term.weight); });
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

std::string text_of(const std::vector<Argument>& arguments) {
  std::string text;
  for (const Argument& argument : arguments) {
    text += ' ' + argument.name + '=';
    if (const auto* number = std::get_if<float>(&argument.value)) text += fmt::format("{}", *number);
    if (const auto* flag = std::get_if<bool>(&argument.value)) text += *flag ? "true" : "false";
    if (const auto* colour = std::get_if<Colour>(&argument.value)) put(text, *colour);
  }
  return text;
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
  explicit Writer(const Scope& scope) : scope_(scope) {}

  void blocks(const BlockList& list) {
    for (const Block& block : list.blocks) {
      comments_before(block.comments);
      std::visit([this](const auto& content) { put_block(content); }, block.content);
      end_line(block.comments);
    }
    put_comments(list.end_comments);
  }

  /// A file of no bytes at all is taken for a mistake when it is read.
  FileText take_text() { return {text_.empty() ? "\n" : std::move(text_), is_finite_}; }

 private:
  void put_block(const Shared<Mesh>& mesh) {
    begin_line("");
    put_mesh(*mesh);
  }
  void put_block(const MeshLight& light);
  void put_block(const AreaLight& light);
  void put_block(const Include& include) { begin_line("include " + quoted(include.file)); }
  void put_block(const Transform& transform);
  void put_block(const DefinitionScope& definitions);
  void put_block(const Params& params);
  void put_block(const Use& use) { begin_line("use " + use.mesh.name); }

  void put_definition(const Definition& definition, bool first);
  void put_definition_body(const Definition::Body& body);
  void put_body(const BlockList& body);
  void put_mesh(const Mesh& mesh);
  void put_lists(const Mesh& mesh);
  void put_vertices(const Mesh& mesh);
  void put_irradiance(const Irradiance& irradiance);
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
  std::string unambiguous(const ModelOfKind& model);

  // Numbers that are not finite cannot be read again.
  template <class Vector>
  void put(const Vector& v) {
    is_finite_ = is_finite_ && is_finite(v);
    grf::put(text_, v);
  }
  std::string text_or_file(const BrdfModel& brdf);
  std::string text_or_file(const PdfModel& pdf);

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
  ScopeStack scope_;
  bool is_finite_ = true;
};

void Writer::put_block(const MeshLight& light) {
  line("mesh light begin");
  put_lists(*light.mesh);
  begin_line("end");
}

// The colour stands last, where the grammar of 2008 has it.
void Writer::put_block(const AreaLight& light) {
  line("light begin");
  ++indentation_;
  for (const Vec3f& v : {light.corner, light.edge1, light.edge2}) {
    begin_line("");
    put(v);
    end_line();
  }
  if (light.radiance) {
    begin_line("rgb ");
    put(*light.radiance);
    end_line();
  }
  --indentation_;
  begin_line("end");
}

void Writer::put_block(const Params& params) {
  line("params begin");
  ++indentation_;
  for (const Vec3f& view : params.views) {
    begin_line("dependent view ");
    put(view);
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
    put(step.value);
  }
  if (transform.steps.empty()) text_ += NoTransform;
  text_ += " begin\n";
  put_body(transform.body);
}

void Writer::put_block(const DefinitionScope& definitions) {
  bool first = true;
  for (const Definition& definition : definitions.definitions) {
    put_definition(definition, first);
    scope_.enter(definition);
    first = false;
  }
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
  put_definition_body(definition.body);
  end_line(definition.comments);
}

void Writer::put_definition_body(const Definition::Body& body) {
  if (const auto* colour = std::get_if<Colour>(&body)) {
    text_ += "rgb ";
    put(*colour);
  } else if (const auto* brdf = std::get_if<BrdfModel>(&body)) {
    text_ += "brdf " + text_or_file(*brdf);
  } else if (const auto* pdf = std::get_if<PdfModel>(&body)) {
    text_ += "pdf " + text_or_file(*pdf);
  } else if (const auto* texture = std::get_if<Texture>(&body)) {
    text_ += "texture " + quoted(texture->file);
  } else if (const auto* mesh = std::get_if<Shared<Mesh>>(&body)) {
    put_mesh(**mesh);
  }
}

void Writer::put_body(const BlockList& body) {
  ++indentation_;
  blocks(body);
  --indentation_;
  begin_line("end");
}

// On the line that was begun, and up to the end of a last line that is open.
void Writer::put_mesh(const Mesh& mesh) {
  text_ += mesh.name.empty() ? "begin mesh" : "begin mesh " + quoted(mesh.name);
  end_line();
  put_lists(mesh);
  begin_line("end mesh");
}

void Writer::put_lists(const Mesh& mesh) {
  ++indentation_;
  put_attributes(mesh.surfaces.front(), mesh.comments);
  comments_before(mesh.comments.vertices);
  put_vertices(mesh);
  comments_before(mesh.comments.faces);
  put_faces(mesh);
  put_comments(mesh.comments.end);
  --indentation_;
}

void Writer::put_vertices(const Mesh& mesh) {
  line("begin vertexs");
  ++indentation_;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    begin_line("");
    if (mesh.normals.has(i)) {
      text_ += "normal ";
      put(mesh.normals[i]);
      text_ += ' ';
    }
    if (mesh.colours.has(i)) {
      text_ += "rgb ";
      put(mesh.colours[i]);
      text_ += ' ';
    }
    if (mesh.uvs.has(i)) {
      text_ += "uv ";
      put(mesh.uvs[i]);
      text_ += ' ';
    }
    if (mesh.irradiance.has(i)) {
      put_irradiance(mesh.irradiance[i]);
      text_ += ' ';
    }
    put(mesh.positions[i]);
    end_line();
  }
  --indentation_;
  begin_line("end vertexs");
  end_line(mesh.comments.vertices);
}

void Writer::put_irradiance(const Irradiance& irradiance) {
  if (const auto* value = std::get_if<Colour>(&irradiance)) {
    text_ += "irad ";
    return put(*value);
  }
  text_ += "begin list";
  for (const DirectionalIrradiance& arrival : std::get<1>(irradiance)) {
    text_ += " ray ";
    put(arrival.direction);
    text_ += " irad ";
    put(arrival.irradiance);
  }
  text_ += " end list";
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
    put(std::get<Colour>(colour));
  }
}

void Writer::put_attribute(const TextureAttribute& texture) {
  const auto* reference = std::get_if<Reference>(&texture);
  text_ += "texture " + (reference != nullptr ? reference->name : quoted(std::get<Texture>(texture).file));
}

void Writer::put_attribute(const Colour& emission) {
  text_ += "light rgb ";
  put(emission);
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
std::string Writer::unambiguous(const ModelOfKind& model) {
  std::string text = text_or_file(model);
  if (!is_bare_word(model)) return text;
  const Scope scope = scope_.scope();
  const std::uint64_t spellings = std::uint64_t{1} << std::min<std::size_t>(model.keyword.size(), 63);
  for (std::uint64_t i = 1; i < spellings && scope.find<ModelOfKind>(text) != nullptr; ++i) {
    text = respelled(model.keyword, i);
  }
  return text;
}

// A BRDF as it is written: by the name of its file where it has one.
std::string Writer::text_or_file(const BrdfModel& brdf) {
  if (!brdf.instance_file.empty()) return quoted(brdf.instance_file);
  is_finite_ = is_finite_ && is_finite(brdf);
  return to_text(brdf);
}

std::string Writer::text_or_file(const PdfModel& pdf) {
  is_finite_ = is_finite_ && is_finite(pdf.arguments);
  return to_text(pdf);
}

}  // namespace

FileText text_of_file(const BlockList& contents, const Scope& scope) {
  Writer writer(scope);
  writer.blocks(contents);
  return writer.take_text();
}

std::string to_text(const Scene& scene) { return text_of_file(scene.contents, {}).text; }

std::string to_text(const BrdfModel& brdf) {
  std::string text = brdf.keyword;
  if (!brdf.data_file.empty()) text += ' ' + quoted(brdf.data_file);
  for (const CombineTerm& term : brdf.terms) {
    text += fmt::format("{}{} {}", &term == brdf.terms.data() ? " " : ", ", term.weight, term.brdf.name);
  }
  return text + text_of(brdf.arguments);
}

std::string to_text(const PdfModel& pdf) { return pdf.keyword + text_of(pdf.arguments); }

}  // namespace grf
