// The pictures that make_screenshots makes.
#pragma once

#include <QPixmap>
#include <QString>
#include <functional>
#include <vector>

namespace screenshots {

/// A picture of the manual.
struct Picture {
  QString name;
  std::function<QPixmap()> make;
};

std::vector<Picture> manual_pictures();

using Take = std::function<void(const QString& name, const QPixmap& picture)>;

/// Pictures to be looked at, which share a window.
struct ReviewGroup {
  QString name;
  std::function<void(const Take& take)> make;
};

/// All docks, pages, windows and display modes, what they say when they are empty, and what has the focus.
std::vector<ReviewGroup> review_groups();

/// The options of a sample in the OP generator.
QPixmap option_window();
/// The viewer of scenes, with a sample in it.
QPixmap viewer_window();
/// All keys of the editor.
QPixmap shortcut_list();
/// Two renders, one of which is wiped over the other.
QPixmap compared_images();

}  // namespace screenshots
