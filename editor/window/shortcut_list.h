#pragma once

class QMainWindow;

namespace editor {

/// Opens a searchable list of all shortcuts of a window, by menus and by controls with their own keys, and of
/// the gestures in the 3D view. It stays open beside the window.
void show_shortcuts(QMainWindow& window);

}  // namespace editor
