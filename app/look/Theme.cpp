// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/look/Theme.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QSvgRenderer>

namespace txn::app {
namespace {

const ThemeColors kDark{QColor(0x2b, 0x2b, 0x2b),
                        QColor(0x32, 0x32, 0x32),
                        QColor(0x25, 0x25, 0x25),
                        QColor(0xe6, 0xe6, 0xe6),
                        QColor(0xa8, 0xa8, 0xa8),
                        QColor(0x4a, 0xa3, 0xdf),
                        QColor(0xe0, 0xa0, 0x30),
                        QColor(0xf0, 0x8c, 0x88),
                        QColor(0x46, 0x46, 0x46),
                        QColor(0x78, 0x78, 0x78)};
const ThemeColors kLight{QColor(0xdc, 0xdc, 0xdc),
                         QColor(0xe8, 0xe8, 0xe8),
                         QColor(0xf6, 0xf6, 0xf6),
                         QColor(0x1e, 0x1e, 0x1e),
                         QColor(0x58, 0x58, 0x58),
                         QColor(0x1a, 0x60, 0x94),
                         QColor(0x7a, 0x4e, 0x00),
                         QColor(0xb0, 0x2a, 0x26),
                         QColor(0xc2, 0xc2, 0xc2),
                         QColor(0x86, 0x86, 0x86)};

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

QPalette paletteOf(const ThemeColors& colors) {
    QPalette palette;
    palette.setColor(QPalette::Window, colors.window);
    palette.setColor(QPalette::WindowText, colors.text);
    palette.setColor(QPalette::Base, colors.field);
    palette.setColor(QPalette::AlternateBase, colors.panel);
    palette.setColor(QPalette::Text, colors.text);
    palette.setColor(QPalette::Button, colors.panel);
    palette.setColor(QPalette::ButtonText, colors.text);
    palette.setColor(QPalette::BrightText, colors.text);
    palette.setColor(QPalette::ToolTipBase, colors.field);
    palette.setColor(QPalette::ToolTipText, colors.text);
    palette.setColor(QPalette::PlaceholderText, colors.secondary);
    palette.setColor(QPalette::Highlight, colors.accent);
    palette.setColor(QPalette::HighlightedText, colors.window);
    palette.setColor(QPalette::Link, colors.accent);
    palette.setColor(QPalette::Light, colors.line);
    palette.setColor(QPalette::Mid, colors.line);
    palette.setColor(QPalette::Dark, colors.line);
    palette.setColor(QPalette::Shadow, colors.field);
    QColor faint = colors.secondary;
    faint.setAlphaF(0.6F);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faint);
    return palette;
}

QString styleSheet(const ThemeColors& colors) {
    QFile file(QStringLiteral(":/look/style.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString text = QString::fromUtf8(file.readAll());
    const std::pair<const char*, QColor> roles[] = {{"@window", colors.window},
                                                    {"@panel", colors.panel},
                                                    {"@field", colors.field},
                                                    {"@text", colors.text},
                                                    {"@secondary", colors.secondary},
                                                    {"@accent", colors.accent},
                                                    {"@stale", colors.stale},
                                                    {"@error", colors.error},
                                                    {"@line", colors.line},
                                                    {"@groove", colors.groove}};
    for (const auto& [role, color] : roles)
        text.replace(QLatin1String(role), color.name());
    text.replace(QLatin1String("@check"),
                 &colors == &kDark ? QLatin1String("check-dark") : QLatin1String("check-light"));
    return text;
}

/// Draws an SVG in the colour of the text, at whatever size is asked for.
class MonochromeIcon final : public QIconEngine {
  public:
    explicit MonochromeIcon(QString file) : m_file(std::move(file)) {}

    void
    paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const QSize pixels = rect.size() * painter->device()->devicePixelRatioF();
        painter->drawPixmap(rect, drawn(pixels, mode, state));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return drawn(size, mode, state);
    }
    /// Qt gives the size in device pixels.
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override {
        return drawn(size, mode, state);
    }
    QIconEngine* clone() const override { return new MonochromeIcon(m_file); }

  private:
    QPixmap drawn(const QSize& size, QIcon::Mode mode, QIcon::State state) const {
        QImage image(size, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        QSvgRenderer(m_file).render(&painter, QRectF(QPointF(), QSizeF(image.size())));
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        const ThemeColors& colors = themeColors();
        painter.fillRect(image.rect(),
                         mode == QIcon::Disabled ? colors.secondary
                         : state == QIcon::On    ? colors.window // on the accent
                                                 : colors.text);
        painter.end();
        return QPixmap::fromImage(image);
    }
    QString m_file;
};

} // namespace

const ThemeColors& darkColors() {
    return kDark;
}

const ThemeColors& lightColors() {
    return kLight;
}

const ThemeColors& themeColors() {
    return isDark(QApplication::palette()) ? kDark : kLight;
}

QColor surroundColor(Surround surround) {
    switch (surround) {
    case Surround::Black:
        return Qt::black;
    case Surround::White:
        return Qt::white;
    case Surround::Grey:
        break;
    }
    return {0x76, 0x76, 0x76};
}

void applyTheme(QApplication& application, ThemeChoice choice) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const bool dark =
        choice == ThemeChoice::Dark ||
        (choice == ThemeChoice::System && isDark(QApplication::style()->standardPalette()));
    const ThemeColors& colors = dark ? kDark : kLight;
    QApplication::setPalette(paletteOf(colors));
    application.setStyleSheet(styleSheet(colors));
}

void paintFocusFrame(QPainter& painter, const QRect& rect) {
    const QColor& color = themeColors().accent;
    painter.fillRect(rect.left(), rect.top(), rect.width(), 1, color);
    painter.fillRect(rect.left(), rect.bottom(), rect.width(), 1, color);
    painter.fillRect(rect.left(), rect.top(), 1, rect.height(), color);
    painter.fillRect(rect.right(), rect.top(), 1, rect.height(), color);
}

QIcon themeIcon(const QString& name) {
    return QIcon(new MonochromeIcon(QStringLiteral(":/icons/") + name + QStringLiteral(".svg")));
}

} // namespace txn::app
