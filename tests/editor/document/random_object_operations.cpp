#include <utility>
#include <variant>

#include <fmt/format.h>

#include "editor/document/definitions.h"
#include "editor/document/light_edits.h"
#include "editor/document/object_edits.h"
#include "editor/document/scene_places.h"
#include "tests/editor/document/random_session.h"
#include "tests/editor/moved_object.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

using Kind = PlainObject::Kind;

void rename(RandomSession& session) {
  PlainProject after = session.modelled.state();
  const auto at = session.place([&](const PlainPlace& each) {
    return each.is_definition() || object_at(after, each).kind == Kind::Mesh;
  });
  if (!at) return;
  const std::string name = fresh_plain_name(after, fmt::format("name{}", session.below(6)));
  if (at->is_definition()) {
    session.expect_refused(rename_object(session.modelled.scene(), at->path, "no name", session.diagnostics),
                           "the name 'no name'");
    rename_plain_definition(after, *at, name);
  } else {
    object_at(after, *at).name = name;
  }
  session.replace("Rename", rename_object(session.modelled.scene(), at->path, name, session.diagnostics),
                  after);
}

void shift(PlainObject& object, const grf::Vec3d& by, const PlainPlace& place) {
  for (std::size_t i = 0; i < 3; ++i) object.offset[i] += plain(by)[i] / place.file_scale;
}

void move(RandomSession& session) {
  const auto at = session.movable_object();
  if (!at) return;
  const grf::Vec3d by = session.offset();
  PlainProject after = session.modelled.state();
  // An object of an included file moves with its include.
  const grf::ScenePath block = moved_block(session.modelled.scene(), at->path);
  const auto moved = session.place([&](const PlainPlace& each) { return each.path == block; });
  shift(object_at(after, *moved), by, *moved);
  session.replace("Move", moved_object(session.modelled.scene(), at->path, by, session.diagnostics), after,
                  session.key("move"));
}

void duplicate(RandomSession& session) {
  const auto at = session.movable_object();
  if (!at || session.is_full()) return;
  const grf::Vec3d by = session.offset();
  PlainProject after = session.modelled.state();
  PlainObject& original = object_at(after, *at);
  if (original.kind == Kind::Mesh) {
    const std::string name = fresh_plain_name(after, original.name.empty() ? "mesh" : original.name);
    file_at(after, *at).definitions[name] = {true, {}, std::exchange(original.mesh, {})};
    original.kind = Kind::Use;
    original.name = name;
  }
  PlainObject copy = original;
  shift(copy, by, *at);
  auto& objects = file_at(after, *at).objects;
  objects.insert(objects.begin() + static_cast<std::ptrdiff_t>(at->object) + 1, copy);
  session.replace("Duplicate", duplicate_object(session.modelled.scene(), at->path, by, session.diagnostics),
                  after);
}

void remove(RandomSession& session) {
  const auto at = session.place([](const PlainPlace&) { return true; });
  if (!at) return;
  PlainProject after = session.modelled.state();
  const auto scene = remove_objects(session.modelled.scene(), {at->path}, {}, session.diagnostics);
  if (!at->is_definition()) {
    erase_object(after, *at);
  } else if (is_used(after, at->name)) {
    return session.expect_refused(scene, "deleting what is used");
  } else {
    file_at(after, *at).definitions.erase(at->name);
  }
  session.replace("Delete", scene, after);
}

void new_light(RandomSession& session) {
  grf::AreaLight light;
  light.corner = grf::Vec3f(session.number(), session.number(), 9);
  light.edge1 = grf::Vec3f(1, 0, 0);
  light.edge2 = grf::Vec3f(0, 1, 0);
  PlainProject after = session.modelled.state();
  PlainObject& added = after.main.objects.emplace_back();
  added.kind = Kind::Light;
  added.points = {{light.corner.x, light.corner.y, 9}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
  session.replace("Add light", add_light(session.modelled.scene(), light), after);
}

void edit_light(RandomSession& session) {
  const auto at = session.object_of({Kind::Light});
  if (!at) return;
  PlainProject after = session.modelled.state();
  grf::AreaLight light = std::get<grf::AreaLight>(block_at(session.modelled.scene(), at->path)->content);
  light.radiance = session.colour();
  object_at(after, *at).points.back() = plain(grf::Vec3d(*light.radiance));
  session.replace("Light", change_light(session.modelled.scene(), at->path, light, session.diagnostics),
                  after, session.key("light"));
}

void new_observer(RandomSession& session) {
  const grf::Vec3d position = session.offset();
  PlainProject after = session.modelled.state();
  auto& objects = after.main.objects;
  auto block = std::find_if(objects.begin(), objects.end(),
                            [](const PlainObject& each) { return each.kind == Kind::Observers; });
  if (block == objects.end()) {
    block = objects.insert(block, PlainObject());
    block->kind = Kind::Observers;
  }
  block->points.push_back(plain(position));
  session.replace("Add observer", add_observer(session.modelled.scene(), position), after);
}

void edit_observers(RandomSession& session) {
  const auto at = session.object_of({Kind::Observers});
  if (!at) return;
  PlainProject after = session.modelled.state();
  auto& points = object_at(after, *at).points;
  const std::size_t number = session.below(points.size());
  const auto& observers = session.modelled.document().objects().observers;
  const auto one = std::find_if(observers.begin(), observers.end(), [&](const ObserverObject& each) {
    return each.path == at->path && each.number == number;
  });
  if (one == observers.end()) return session.modelled.fail("an observer is not among the objects");
  if (session.one_in(2)) {
    points[number] = {7, 7, 7};
    return session.replace("Move observer",
                           move_observer(session.modelled.scene(), *one, grf::Vec3d(7), session.diagnostics),
                           after, session.key("observer"));
  }
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(number));
  if (points.empty()) erase_object(after, *at);
  session.replace("Delete observer",
                  remove_objects(session.modelled.scene(), {}, {*one}, session.diagnostics), after);
}

// Definitions and options.

void new_definition(RandomSession& session) {
  PlainProject after = session.modelled.state();
  const bool is_colour = session.one_in(2);
  const grf::Colour value = session.colour();
  const std::string wanted = is_colour ? "hue" : "gloss";
  after.main.definitions[fresh_plain_name(after, wanted)] = {
      false, is_colour ? colour_text(value) : "phong n=5", {}};
  const auto defined =
      define(session.modelled.scene(), wanted,
             is_colour ? grf::Definition::Body(value) : grf::Definition::Body(brdf_model("phong n=5")),
             session.diagnostics);
  session.replace("Define", defined ? std::optional(defined->scene) : std::nullopt, after);
}

void edit_definition(RandomSession& session) {
  PlainProject after = session.modelled.state();
  const auto at = session.place([&](const PlainPlace& each) {
    return each.is_definition() && !file_at(after, each).definitions.at(each.name).is_mesh;
  });
  if (!at) return;
  const bool is_colour =
      std::holds_alternative<grf::Colour>(definition_at(session.modelled.scene(), at->path)->body);
  const grf::Colour value = session.colour();
  std::string& text = file_at(after, *at).definitions.at(at->name).text;
  text = is_colour ? colour_text(value) : fmt::format("ward sx=0.{}", 1 + session.below(8));
  const grf::Definition::Body body =
      is_colour ? grf::Definition::Body(value) : grf::Definition::Body(brdf_model(text));
  session.replace("Edit", change_definition(session.modelled.scene(), at->path, body, session.diagnostics),
                  after, session.key("definition"));
}

void remove_unused(RandomSession& session) {
  PlainProject after = session.modelled.state();
  erase_unused_definitions(after);
  session.replace("Remove unused", remove_unused_definitions(session.modelled.scene()), after);
}

void edit_options(RandomSession& session) {
  session.modelled.set_depth(1 + static_cast<int>(session.below(3)), session.key("depth"));
}

}  // namespace

std::vector<RandomOperation> object_operations() {
  return {{"rename", rename},
          {"move", move},
          {"duplicate", duplicate},
          {"delete", remove},
          {"add light", new_light},
          {"edit light", edit_light},
          {"add observer", new_observer},
          {"edit observers", edit_observers},
          {"define", new_definition},
          {"edit definition", edit_definition},
          {"remove unused", remove_unused},
          {"options", edit_options}};
}

}  // namespace editor
