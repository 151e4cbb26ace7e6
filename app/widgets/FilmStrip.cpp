// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/widgets/FilmStrip.h"

#include "app/look/Theme.h"

#include <QKeyEvent>
#include <QPainter>

namespace txn::app {
namespace {

constexpr int kSide = 48;
constexpr int kGap = 4;
constexpr int kCaptionHeight = 18;
constexpr int kHeight = 2 * kSide + kGap + kCaptionHeight + 2 * kGap;

} // namespace

FilmStrip::FilmStrip(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize FilmStrip::sizeHint() const {
    return {kGap + static_cast<int>(m_frames.size()) * (kSide + kGap), kHeight};
}

QRect FilmStrip::frameRect(int frame) const {
    return {kGap + frame * (kSide + kGap), kGap, kSide, kHeight - 2 * kGap};
}

void FilmStrip::setFrames(std::vector<Frame> frames) {
    m_frames = std::move(frames);
    updateGeometry();
    update();
}

void FilmStrip::setChosen(std::optional<int> frame) {
    if (m_chosen == frame)
        return;
    m_chosen = frame;
    update();
}

void FilmStrip::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = themeColors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
        const Frame& frame = m_frames[i];
        const QRect place = frameRect(static_cast<int>(i));
        const QRect top(place.topLeft(), QSize(kSide, kSide));
        const QRect bottom = top.translated(0, kSide + kGap);
        // Of several kernels side by side, the first one.
        const int square = std::min(frame.picture.width(), frame.picture.height());
        painter.drawImage(top, frame.picture, QRect(0, 0, square, square));
        // A piece at 100 %, whatever size it came in.
        const int part = std::min({kSide, frame.below.width(), frame.below.height()});
        painter.drawImage(bottom, frame.below, QRect(0, 0, part, part));
        const bool chosen = m_chosen == static_cast<int>(i);
        painter.setPen(chosen ? colors.text : colors.secondary);
        painter.drawText(QRect(place.left(), bottom.bottom() + 1, kSide, kCaptionHeight),
                         Qt::AlignCenter,
                         frame.caption);
        if (chosen) {
            painter.setPen(QPen(colors.accent, 2.0));
            painter.drawRect(QRect(place.topLeft(), bottom.bottomRight()).adjusted(-1, -1, 1, 1));
        }
    }
    if (hasFocus())
        paintFocusFrame(painter, rect());
}

void FilmStrip::choose(std::optional<int> frame) {
    setChosen(frame);
    if (frame)
        emit reached(frameRect(*frame));
    emit chosen(frame);
}

void FilmStrip::mousePressEvent(QMouseEvent* event) {
    for (int i = 0; i < static_cast<int>(m_frames.size()); ++i) {
        if (frameRect(i).contains(event->pos())) {
            choose(m_chosen == i ? std::nullopt : std::optional(i));
            return;
        }
    }
}

void FilmStrip::keyPressEvent(QKeyEvent* event) {
    const int last = static_cast<int>(m_frames.size()) - 1;
    const int step = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
    if (event->key() == Qt::Key_Escape && m_chosen)
        choose(std::nullopt);
    else if (step != 0 && last >= 0)
        choose(std::clamp(m_chosen ? *m_chosen + step : (step > 0 ? 0 : last), 0, last));
    else
        QWidget::keyPressEvent(event);
}

} // namespace txn::app
