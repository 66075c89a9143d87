#pragma once

#include <optional>
#include <vector>

#include "renderer/options/render_options.h"
#include "renderer/transport/camera.h"

namespace editor {

class Document;

/// The camera that the options of a document have without a name, framed to the scene as far as they do not
/// place it.
transport::View own_camera(const Document& document);

/// The render camera of a document: the named one that its options select, else their own.
transport::View render_camera(const Document& document);

/// Places the camera that the options have without a name; its lens stays.
void place_own_camera(options::RenderOptions& render_options, const transport::View& view);

/// Places the render camera, whichever it is; its lens stays.
void place_render_camera(options::RenderOptions& render_options, const transport::View& view);

/// Returns a camera with a name and this view; the reverse of job::view_of.
options::NamedCamera named_camera(std::string name, const transport::View& view);

/// The vertical field of view, in degrees, of a lens with this focal length on a sensor that is 24 mm high (a
/// full-frame camera), and the reverse; millimetres.
double field_of_view_of(double focal_length);
double focal_length_of(double field_of_view);

}  // namespace editor
