#pragma once

class QMainWindow;

namespace editor {

/// Opens a list of all keys of a window, by its menus and by the controls that have keys of their own, and of
/// the gestures in the 3D view. It can be searched, and stays open beside the window.
void show_shortcuts(QMainWindow& window);

}  // namespace editor
