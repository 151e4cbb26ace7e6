// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"

#include <QElapsedTimer>

namespace txn::app {

/// Keys pressed and wheels turned without a pause are one gesture.
class GestureRun {
  public:
    /// That of the run that goes on, or a new one.
    Gesture next() {
        constexpr qint64 kPauseMs = 400;
        if (!m_last.isValid() || m_last.elapsed() > kPauseMs)
            m_gesture = Gesture::next();
        m_last.start();
        return m_gesture;
    }

  private:
    QElapsedTimer m_last;
    Gesture m_gesture;
};

} // namespace txn::app
