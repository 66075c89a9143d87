#include "editor/controls/tab_order.h"

#include <QWidget>

namespace editor {
namespace {

/// The controls that are a part or in it, in tab order; one with a focus proxy follows that.
std::vector<QWidget*> controls_in(QWidget* part) {
  std::vector<QWidget*> controls;
  QWidget* each = part;
  do {
    const bool is_inside = each == part || part->isAncestorOf(each);
    if (is_inside && each->focusPolicy() != Qt::NoFocus && each->focusProxy() == nullptr)
      controls.push_back(each);
    each = each->nextInFocusChain();
  } while (each != part);
  return controls;
}

}  // namespace

void lead_tab_through(const std::vector<QWidget*>& parts) {
  QWidget* last = nullptr;
  for (QWidget* part : parts) {
    for (QWidget* control : controls_in(part)) {
      if (last != nullptr) QWidget::setTabOrder(last, control);
      last = control;
    }
  }
}

}  // namespace editor
