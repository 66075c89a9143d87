#include "editor/window/lesson_guide.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "editor/appearance/theme.h"
#include "editor/window/main_window.h"

namespace editor {
namespace {

constexpr int CardWidth = 42 * Grid;
constexpr int Gap = Grid;
/// Time between looks at the window, in ms: too short to be waited for.
constexpr int Pause = 150;

bool is_in(const QRect& inner, const QRect& outer) { return outer.contains(inner); }

/// Returns a place for a card beside a control, or in its lower part if nothing beside it has room.
QPoint place_beside(const QSize& card, const QRect& target, const QRect& room) {
  const int x = std::clamp(target.center().x() - card.width() / 2, room.left(),
                           std::max(room.left(), room.right() - card.width()));
  const int y = std::clamp(target.top(), room.top(), std::max(room.top(), room.bottom() - card.height()));
  const std::array places = {QPoint(target.right() + Gap, y), QPoint(target.left() - Gap - card.width(), y),
                             QPoint(x, target.bottom() + Gap), QPoint(x, target.top() - Gap - card.height())};
  for (const QPoint& place : places)
    if (is_in({place, card}, room)) return place;
  return {x, std::max(room.top(), target.bottom() - 2 * Gap - card.height())};
}

}  // namespace

/// A frame around a control, which lets the pointer through.
class LessonGuide::Marker : public QWidget {
 public:
  explicit Marker(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours_of(theme_of(palette())).accent, 3));
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 4, 4);
  }
};

LessonGuide::LessonGuide(MainWindow& window)
    : QFrame(&window),
      window_(window),
      title_(new QLabel(this)),
      text_(new QLabel(this)),
      close_(new QPushButton(tr("&Close lesson"), this)),
      back_(new QPushButton(tr("&Back"), this)),
      next_(new QPushButton(tr("&Next"), this)),
      marker_(new Marker(&window)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setFixedWidth(CardWidth);
  setAccessibleName(tr("Lesson"));
  setToolTip(tr("What to do in this step of the lesson"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  text_->setWordWrap(true);
  back_->setToolTip(tr("Go to the step before"));
  next_->setToolTip(tr("Go to the next step without doing this one"));
  close_->setToolTip(tr("End the lesson; what was done stays"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * Grid, Grid, 2 * Grid, Grid);
  rows->addWidget(title_);
  rows->addWidget(text_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(close_);
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  rows->addLayout(buttons);
  // The keyboard stays with what the lesson is about; Tab reaches the buttons.
  for (QPushButton* button : {back_, next_, close_}) button->setAutoDefault(false);
  connect(back_, &QPushButton::clicked, this, [this] { go_to(step_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { go_to(step_ + 1); });
  connect(close_, &QPushButton::clicked, this, &LessonGuide::end);
  connect(&timer_, &QTimer::timeout, this, &LessonGuide::follow);
  hide();
  marker_->hide();
}

LessonGuide::~LessonGuide() = default;

void LessonGuide::start(const Lesson& lesson) {
  lesson_ = lesson;
  show();
  go_to(0);
  timer_.start(Pause);
}

void LessonGuide::end() {
  timer_.stop();
  is_done_ = nullptr;
  marker_->hide();
  hide();
}

QRect LessonGuide::marked() const { return marker_->isVisibleTo(&window_) ? marker_->geometry() : QRect(); }

void LessonGuide::go_to(int step) {
  const int count = static_cast<int>(lesson_.steps.size());
  step_ = std::clamp(step, 0, count);
  back_->setEnabled(step_ > 0);
  next_->setVisible(step_ < count);
  if (step_ == count) {
    title_->setText(tr("%1: done").arg(lesson_.title));
    text_->setText(tr("Help > Welcome has the other lessons, and F1 lists all shortcuts."));
    target_ = {};
    is_done_ = nullptr;
  } else {
    const LessonStep& now = lesson_.steps[static_cast<std::size_t>(step_)];
    title_->setText(tr("%1: step %2 of %3").arg(lesson_.title).arg(step_ + 1).arg(count));
    text_->setText(now.text);
    target_ = now.target(window_);
    is_done_ = now.begin ? now.begin(window_) : nullptr;
  }
  follow();
}

/// Controls move while docks are arranged, so the frame follows them.
void LessonGuide::follow() {
  if (is_done_ && is_done_()) return go_to(step_ + 1);
  QRect target;
  if (target_.widget != nullptr && target_.widget->isVisible()) {
    const QRect part = target_.part.isEmpty() ? target_.widget->rect() : target_.part;
    target = QRect(target_.widget->mapTo(&window_, part.topLeft()), part.size()) & window_.rect();
  }
  place(target);
}

void LessonGuide::place(const QRect& target) {
  marker_->setVisible(!target.isEmpty());
  if (!target.isEmpty()) marker_->setGeometry(target.adjusted(-2, -2, 2, 2) & window_.rect());
  resize(CardWidth, heightForWidth(CardWidth));
  const QRect room = window_.rect().adjusted(Gap, Gap, -Gap, -Gap);
  const QRect middle(room.center(), QSize(1, 1));
  move(place_beside(size(), target.isEmpty() ? middle : target, room));
  marker_->raise();
  raise();
}

}  // namespace editor
