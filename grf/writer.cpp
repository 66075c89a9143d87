#include "grf/writer.h"

#include <array>
#include <variant>

#include <fmt/format.h>

#include "grf/write.h"

namespace grf {
namespace {

// The grammar has no `transform` without a step and no `def` without a definition.
constexpr std::string_view NoTransform = " translation (0, 0, 0)";

}  // namespace

void Writer::blocks(const BlockList& list) {
  for (const Block& block : list.blocks) {
    comments_before(block.comments);
    std::visit([this](const auto& content) { put_block(content); }, block.content);
    end_line(block.comments);
  }
  put_comments(list.end_comments);
}

void Writer::put_comments(const std::vector<std::string>& comments) {
  for (const std::string& comment : comments) line("//" + comment_text(comment));
}

void Writer::end_line(const Comments& comments) {
  const std::string behind = comment_text(comments.behind);
  if (!behind.empty()) text_ += "  //" + behind;
  end_line();
}

void Writer::put_block(const MeshLight& light) {
  line("mesh light begin");
  put_lists(*light.mesh);
  begin_line("end");
}

// The colour is written last, as in the grammar of 2008.
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
  constexpr std::array<const char*, 3> Keywords = {" scale ", " rotation ", " translation "};  // by kind
  for (const TransformStep& step : transform.steps) {
    text_ += Keywords[static_cast<std::size_t>(step.kind)];
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

// Comments before the first `def` belong to the whole block, so those of the first definition are written
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

FileText text_of_file(const BlockList& contents, const Scope& scope) {
  Writer writer(scope);
  writer.blocks(contents);
  return writer.take_text();
}

std::string to_text(const Scene& scene) { return text_of_file(scene.contents, {}).text; }

}  // namespace grf
