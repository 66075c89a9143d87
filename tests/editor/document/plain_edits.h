// Queries and edits of a plain project, for reference models of the editor.
#pragma once

#include <set>
#include <string>

#include "tests/editor/document/plain_project.h"

namespace editor {

PlainFile& file_at(PlainProject& project, const PlainPlace& place);
PlainObject& object_at(PlainProject& project, const PlainPlace& place);
/// The mesh of an object or of a definition.
PlainMesh& plain_mesh_at(PlainProject& project, const PlainPlace& place);

template <class Action>
void for_each_file(PlainProject& project, const Action& action) {
  action(project.main);
  for (auto& [name, each] : project.files) action(each);
}

/// Whether a surface, a `use` or a sum of BRDFs refers to the definition.
bool is_used(PlainProject project, const std::string& name);
/// An unused name like `wanted`, which is no keyword of a model.
std::string fresh_plain_name(const PlainProject& project, const std::string& wanted);
/// Whether a name is undefined or ambiguous.
bool have_unclear_names(PlainProject project);
bool emits(PlainProject project);
bool has_irradiance(const PlainFile& file);

void erase_object(PlainProject& project, const PlainPlace& place);
/// Removes the mesh definition and all uses of it.
void erase_defined_mesh(PlainProject& project, const PlainPlace& place);
void erase_unused_definitions(PlainProject& project);
void rename_plain_definition(PlainProject& project, const PlainPlace& place, const std::string& name);
/// Removes files that nothing includes any more.
void erase_lost_files(PlainProject& project);

}  // namespace editor
