#include "tests/editor/document/plain_edits.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace editor {
namespace {

template <class Action>
void for_each_mesh(PlainProject& project, const Action& action) {
  for_each_file(project, [&](PlainFile& file) {
    for (auto& [name, definition] : file.definitions) action(definition.mesh);
    for (PlainObject& object : file.objects) action(object.mesh);
  });
}

/// Visits each text that may refer to definitions.
template <class Action>
void for_each_reference(PlainProject& project, const Action& action) {
  const auto of_surface = [&](PlainSurface& surface) {
    if (surface.colour) action(*surface.colour);
    if (surface.brdf) action(*surface.brdf);
  };
  for_each_mesh(project, [&](PlainMesh& mesh) {
    of_surface(mesh.own);
    for (PlainFace& face : mesh.faces) of_surface(face.surface);
  });
  for_each_file(project, [&](PlainFile& file) {
    for (auto& [name, definition] : file.definitions) action(definition.text);
    for (PlainObject& object : file.objects) {
      if (object.kind != PlainObject::Kind::Use) continue;
      std::string name = "@" + object.name;
      action(name);
      object.name = name.substr(1);
    }
  });
}

std::multiset<std::string> defined_names(PlainProject project) {
  std::multiset<std::string> defined;
  for_each_file(project, [&](const PlainFile& file) {
    for (const auto& [name, definition] : file.definitions) defined.insert(name);
  });
  return defined;
}

/// The words of a text.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace

PlainFile& file_at(PlainProject& project, const PlainPlace& place) {
  return place.file.empty() ? project.main : project.files.at(place.file);
}

PlainObject& object_at(PlainProject& project, const PlainPlace& place) {
  return file_at(project, place).objects.at(place.object);
}

PlainMesh& plain_mesh_at(PlainProject& project, const PlainPlace& place) {
  if (place.is_definition()) return file_at(project, place).definitions.at(place.name).mesh;
  return object_at(project, place).mesh;
}

bool is_used(PlainProject project, const std::string& name) {
  bool is_used = false;
  for_each_reference(project, [&](const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    is_used = is_used || std::count(words.begin(), words.end(), "@" + name) > 0;
  });
  return is_used;
}

std::string fresh_plain_name(const PlainProject& project, const std::string& wanted) {
  std::multiset<std::string> taken = defined_names(project);
  taken.insert({"ward", "phong", "diffuse", "combine"});
  std::string name = wanted;
  for (int i = 2; taken.contains(name); ++i) name = fmt::format("{}_{}", wanted, i);
  return name;
}

bool have_unclear_names(PlainProject project) {
  const std::multiset<std::string> defined = defined_names(project);
  bool are_unclear = std::any_of(defined.begin(), defined.end(),
                                 [&](const std::string& name) { return defined.count(name) > 1; });
  for_each_reference(project, [&](const std::string& text) {
    for (const std::string& word : words_of(text)) {
      are_unclear = are_unclear || (word.starts_with('@') && !defined.contains(word.substr(1)));
    }
  });
  return are_unclear;
}

bool emits(PlainProject project) {
  bool emits = false;
  for_each_mesh(project, [&](const PlainMesh& mesh) {
    for (const PlainFace& face : mesh.faces) emits = emits || face.surface.emission;
  });
  for_each_file(project, [&](const PlainFile& file) {
    for (const PlainObject& object : file.objects) {
      emits = emits || object.kind == PlainObject::Kind::Light || object.kind == PlainObject::Kind::MeshLight;
    }
  });
  return emits;
}

bool has_irradiance(const PlainFile& file) {
  const auto has = [](const PlainMesh& mesh) {
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const PlainFace& face) {
      return std::any_of(face.corners.begin(), face.corners.end(),
                         [](const PlainCorner& corner) { return corner.irradiance.has_value(); });
    });
  };
  return std::any_of(file.definitions.begin(), file.definitions.end(),
                     [&](const auto& each) { return has(each.second.mesh); }) ||
         std::any_of(file.objects.begin(), file.objects.end(),
                     [&](const PlainObject& each) { return has(each.mesh); });
}

void erase_object(PlainProject& project, const PlainPlace& place) {
  auto& objects = file_at(project, place).objects;
  objects.erase(objects.begin() + static_cast<std::ptrdiff_t>(place.object));
}

void erase_defined_mesh(PlainProject& project, const PlainPlace& place) {
  file_at(project, place).definitions.erase(place.name);
  for_each_file(project, [&](PlainFile& file) {
    std::erase_if(file.objects, [&](const PlainObject& object) {
      return object.kind == PlainObject::Kind::Use && object.name == place.name;
    });
  });
}

void erase_unused_definitions(PlainProject& project) {
  for (bool goes = true; std::exchange(goes, false);) {
    for_each_file(project, [&](PlainFile& file) {
      for (auto definition = file.definitions.begin(); definition != file.definitions.end();) {
        const bool stays = is_used(project, definition->first);
        goes = goes || !stays;
        definition = stays ? std::next(definition) : file.definitions.erase(definition);
      }
    });
  }
}

void rename_plain_definition(PlainProject& project, const PlainPlace& place, const std::string& name) {
  auto& definitions = file_at(project, place).definitions;
  auto node = definitions.extract(place.name);
  node.key() = name;
  definitions.insert(std::move(node));
  for_each_reference(project, [&](std::string& text) {
    std::vector<std::string> words = words_of(text);
    std::replace(words.begin(), words.end(), "@" + place.name, "@" + name);
    text = fmt::format("{}", fmt::join(words, " "));
  });
}

void erase_lost_files(PlainProject& project) {
  std::set<std::string> included;
  for (const PlainObject& object : project.main.objects) {
    if (object.kind == PlainObject::Kind::Include) included.insert(object.name);
  }
  std::erase_if(project.files, [&](const auto& each) { return !included.contains(each.first); });
}

}  // namespace editor
