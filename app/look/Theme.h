// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/Settings.h"

#include <QColor>
#include <QIcon>

class QApplication;
class QPainter;
class QRect;

namespace txn::app {

/// The colours by their roles, for whoever paints by hand. groove: what has to be seen against a
/// panel without being read, such as the track of a slider.
struct ThemeColors {
    QColor window, panel, field, text, secondary, accent, stale, error, line, groove;
};
[[nodiscard]] const ThemeColors& darkColors();
[[nodiscard]] const ThemeColors& lightColors();
/// Those in force, told from the application's palette.
[[nodiscard]] const ThemeColors& themeColors();
[[nodiscard]] QColor surroundColor(Surround surround);

/// Palette, style and style sheet. May be called again at any time; System follows the desktop.
void applyTheme(QApplication& application, ThemeChoice choice);

/// Of resources/icons, such as "open": monochrome, in the colour of the text, crisp at any scale.
[[nodiscard]] QIcon themeIcon(const QString& name);

/// The line around what has the focus and paints itself: one pixel inside rect, whole at any scale.
void paintFocusFrame(QPainter& painter, const QRect& rect);

} // namespace txn::app
