#include <algorithm>
#include <cmath>
#include <variant>

#include "grf/write.h"
#include "grf/writer.h"

namespace grf {

// Writes a mesh from the current line on; the last line is left open.
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
  const Geometry& geometry = *mesh.geometry;
  const VertexIrradiance& irradiance = *mesh.irradiance;
  const auto put_value = [this](const char* keyword, const auto& values, std::size_t i) {
    if (!values.has(i)) return;
    text_ += keyword;
    put(values[i]);
    text_ += ' ';
  };
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    begin_line("");
    put_value("normal ", geometry.normals, i);
    put_value("rgb ", geometry.colours, i);
    put_value("uv ", geometry.uvs, i);
    if (irradiance.has(i)) {
      put_irradiance(irradiance[i]);
      text_ += ' ';
    }
    put(geometry.positions[i]);
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
    if ((*mesh.surface_of_face)[i] != current) {
      put_changes(mesh.surfaces[current], mesh.surface(i));
      current = (*mesh.surface_of_face)[i];
    }
    begin_line("");
    append(text_, mesh.face(i));
    end_line();
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
  put_own(surface.opacity, comments.opacity);
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
  put_change("opacity", before.opacity, after.opacity);
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

void Writer::put_attribute(const Opacity& opacity) {
  if (!std::isfinite(opacity.value)) add_problem(NotFinite);
  text_ += to_text(opacity);
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

void Writer::put_attribute(const BrdfAttribute& brdf) { put_model("brdf ", brdf); }

void Writer::put_attribute(const PdfAttribute& pdf) { put_model("pdf ", pdf); }

// A keyword without parameters would read as a reference to a definition of the same spelling. Definitions
// are case-sensitive and keywords are not, so another case of letters denotes the keyword.
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

// Returns the text of a BRDF: the name of its file if it has one.
std::string Writer::text_or_file(const BrdfModel& brdf) {
  if (!brdf.instance_file.empty()) return quoted(brdf.instance_file);
  add_problem(problem_of(brdf));
  return to_text(brdf);
}

std::string Writer::text_or_file(const PdfModel& pdf) {
  add_problem(problem_of(pdf));
  return to_text(pdf);
}

std::string to_text(const Surface& surface) {
  Writer writer({});
  writer.attributes(surface);
  return writer.take_text().text;
}

}  // namespace grf
