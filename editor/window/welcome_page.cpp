#include "editor/window/welcome_page.h"

#include <QCheckBox>
#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

/// More would not be looked at.
constexpr int MostRecent = 5;
constexpr int SampleColumns = 4;
constexpr QSize PictureSize(18 * Grid, 14 * Grid);

QLabel* heading(const QString& text, double scale, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * scale);
  font.setBold(true);
  label->setFont(font);
  return label;
}

/// A file name and its folder, as a button that looks like a link.
QCommandLinkButton* link(const QString& text, const QString& description, const QString& tip,
                         QWidget* parent) {
  auto* button = new QCommandLinkButton(text, description, parent);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setIcon(icon("open"));
  button->setIconSize({2 * Grid, 2 * Grid});
  return button;
}

/// The middle of a picture, in the proportions of the others.
QPixmap cropped_picture(const QString& file, qreal ratio) {
  const QSize size = PictureSize * ratio;
  QPixmap picture(file);
  if (picture.isNull()) return picture;
  picture = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  picture = picture.copy((picture.width() - size.width()) / 2, (picture.height() - size.height()) / 2,
                         size.width(), size.height());
  picture.setDevicePixelRatio(ratio);
  return picture;
}

}  // namespace

WelcomePage::WelcomePage(const std::vector<SampleScene>& samples, const std::vector<Lesson>& lessons,
                         QWidget* parent)
    : QScrollArea(parent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  auto* contents = new QWidget;
  auto* rows = new QVBoxLayout(contents);
  rows->setContentsMargins(4 * Grid, 4 * Grid, 4 * Grid, 3 * Grid);
  rows->setSpacing(3 * Grid);
  rows->addWidget(heading(tr("Welcome to wannabe"), 1.7, contents));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(4 * Grid);
  columns->addWidget(make_start(), 1, Qt::AlignTop);
  columns->addWidget(make_lessons(lessons), 1, Qt::AlignTop);
  rows->addLayout(columns);
  rows->addWidget(make_samples(samples));
  rows->addStretch(1);
  at_start_ = new QCheckBox(tr("&Show this page at the start"), contents);
  at_start_->setToolTip(
      tr("Show this page when the editor starts without a file; Help > Welcome shows it, too"));
  connect(at_start_, &QCheckBox::toggled, this, &WelcomePage::shown_at_start_changed);
  rows->addWidget(at_start_);
  setWidget(contents);
}

QWidget* WelcomePage::make_start() {
  auto* group = new QWidget(this);
  auto* rows = tight_layout<QVBoxLayout>(group, Grid);
  rows->addWidget(heading(tr("Start"), 1.2, group));
  auto* buttons = new QHBoxLayout;
  auto* create = new QPushButton(icon("new"), tr("&New scene"), group);
  create->setToolTip(tr("Start an empty scene"));
  connect(create, &QPushButton::clicked, this, &WelcomePage::new_requested);
  auto* open = new QPushButton(icon("open"), tr("&Open..."), group);
  open->setToolTip(tr("Open scenes, or import models of other formats"));
  connect(open, &QPushButton::clicked, this, &WelcomePage::open_requested);
  for (QPushButton* button : {create, open}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  rows->addLayout(buttons);
  auto* recent = new QWidget(group);
  recent_ = tight_layout<QVBoxLayout>(recent, 0);
  rows->addWidget(recent);
  return group;
}

QWidget* WelcomePage::make_lessons(const std::vector<Lesson>& lessons) {
  auto* group = new QWidget(this);
  auto* rows = tight_layout<QVBoxLayout>(group, Grid / 2);
  rows->addWidget(heading(tr("Lessons"), 1.2, group));
  for (int i = 0; const Lesson& lesson : lessons) {
    QCommandLinkButton* button = link(
        lesson.title, lesson.about, tr("%n step(s) in the window", nullptr, int(lesson.steps.size())), group);
    button->setIcon(icon("pick"));
    connect(button, &QCommandLinkButton::clicked, this, [this, i] { emit lesson_chosen(i); });
    rows->addWidget(button);
    ++i;
  }
  return group;
}

QWidget* WelcomePage::make_samples(const std::vector<SampleScene>& samples) {
  auto* group = new QWidget(this);
  auto* grid = tight_layout<QGridLayout>(group, Grid);
  grid->addWidget(heading(tr("Samples"), 1.2, group), 0, 0, 1, SampleColumns);
  if (samples.empty()) {
    auto* hint = new QLabel(tr("No samples are installed: they are in the package granada-samples."), group);
    hint->setWordWrap(true);
    grid->addWidget(hint, 1, 0, 1, SampleColumns);
  }
  for (int i = 0; const SampleScene& sample : samples) {
    auto* button = new QToolButton(group);
    button->setText(sample.title);
    button->setAccessibleName(sample.title);
    button->setToolTip(tr("Open the sample %1").arg(QDir::toNativeSeparators(sample.file)));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setIcon(cropped_picture(sample.picture, devicePixelRatioF()));
    button->setIconSize(PictureSize);
    connect(button, &QToolButton::clicked, this, [this, file = sample.file] { emit file_chosen(file); });
    grid->addWidget(button, 1 + i / SampleColumns, i % SampleColumns);
    ++i;
  }
  grid->setColumnStretch(SampleColumns, 1);
  return group;
}

void WelcomePage::show_recent(const QStringList& files) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (const QString& file : files.mid(0, MostRecent)) {
    const QFileInfo info(file);
    const QString folder = path_text(info.absolutePath());
    QCommandLinkButton* button =
        link(info.fileName(), folder, tr("Open %1").arg(file), recent_->parentWidget());
    button->setEnabled(info.exists());
    if (!info.exists()) button->setToolTip(tr("%1 is not there any more").arg(file));
    connect(button, &QCommandLinkButton::clicked, this, [this, file] { emit file_chosen(file); });
    recent_->addWidget(button);
  }
  if (files.isEmpty())
    recent_->addWidget(hint_label(tr("Files that were opened are listed here."), recent_->parentWidget()));
}

void WelcomePage::set_shown_at_start(bool is_shown) { at_start_->setChecked(is_shown); }

}  // namespace editor
