// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <cstdio>

/// Used by the build: draws the icon in one size. Arguments: SVG PNG SIZE.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    QSvgRenderer drawing(arguments.value(1));
    const int size = arguments.value(3).toInt();
    if (!drawing.isValid() || size < 1) {
        std::fputs("usage: render-icon SVG PNG SIZE\n", stderr);
        return 2;
    }
    // Drawn larger and shrunk: small sizes stay smooth.
    constexpr int kFiner = 4;
    QImage icon(size * kFiner, size * kFiner, QImage::Format_ARGB32_Premultiplied);
    icon.fill(Qt::transparent);
    QPainter painter(&icon);
    painter.setRenderHint(QPainter::Antialiasing);
    drawing.render(&painter);
    painter.end();
    const QImage small = icon.scaled(size, size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (!small.save(arguments.value(2), "PNG")) {
        std::fprintf(stderr, "%s cannot be written\n", qPrintable(arguments.value(2)));
        return 1;
    }
    return 0;
}
