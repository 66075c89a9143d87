#include "editor/controls/search_terms.h"

#include <QStringList>
#include <algorithm>

namespace editor {
namespace {

struct SearchTerm {
  const char* term;      ///< as menus, tool tips and options have it
  const char* synonyms;  ///< of Blender, pbrt, Mitsuba and other programs; spaces between
};

constexpr SearchTerm Terms[] = {
    {"add", "create insert new"},
    {"append", "merge link combine insert"},
    {"bake", "lightmap precompute"},
    {"BRDF", "material shader bsdf reflectance"},
    {"camera", "eye viewpoint sensor"},
    {"cancel", "abort"},
    {"connected", "linked contiguous"},
    {"coplanar", "plane flat"},
    {"delete", "remove erase"},
    {"depth", "bounces"},
    {"deselect", "unselect"},
    {"duplicate", "copy clone instance"},
    {"emission", "emitter emissive luminaire glow"},
    {"environment", "hdri envmap skybox ibl"},
    {"error", "noise variance convergence"},
    {"exposure", "brightness gain"},
    {"face", "polygon triangle"},
    {"frame", "focus fit"},
    {"hidden", "xray occluded"},
    {"invert", "inverse"},
    {"light", "lamp emitter luminaire"},
    {"options", "settings preferences"},
    {"orbit", "rotate turn tumble"},
    {"orthographic", "parallel"},
    {"outliner", "hierarchy tree"},
    {"pan", "move track"},
    {"reload", "refresh reread"},
    {"render", "raytrace"},
    {"resume", "continue"},
    {"roughness", "glossy shininess gloss alpha"},
    {"samples", "spp"},
    {"sampling", "importance pdf"},
    {"shortcuts", "keymap hotkeys keys"},
    {"similar", "same like"},
    {"smooth", "relax denoise"},
    {"subdivide", "tessellate refine"},
    {"texture coordinates", "uv uvs unwrap mapping"},
    {"unused", "purge orphan"},
    {"zoom", "dolly nearer"},
};

constexpr qsizetype LeastLetters = 3;  ///< of a synonym, before it counts

bool begins_word_of(const QString& text, const QString& beginning) {
  for (qsizetype at = 0; (at = text.indexOf(beginning, at, Qt::CaseInsensitive)) >= 0; ++at) {
    if (at == 0 || !(text[at - 1].isLetterOrNumber() || text[at - 1] == '_')) return true;
  }
  return false;
}

bool matches_word(const QString& text, const QString& word) {
  if (text.contains(word, Qt::CaseInsensitive)) return true;
  return word.size() >= LeastLetters &&
         std::any_of(std::begin(Terms), std::end(Terms), [&](const SearchTerm& each) {
           return begins_word_of(each.synonyms, word) && begins_word_of(text, each.term);
         });
}

}  // namespace

bool matches_search(const QString& text, const QString& query) {
  const QStringList words = query.split(' ', Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(),
                     [&text](const QString& word) { return matches_word(text, word); });
}

}  // namespace editor
