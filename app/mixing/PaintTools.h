// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mixing/MapBrush.h"

#include <QObject>

namespace txn::app {

/// What the mouse does to the mixing map, in the noise seen from above.
enum class PaintTool { Look, Paint, Smooth, Erase, Line, Circle };

/// How the artist's hand is set: the tool and its brush. Not part of the project. Interface thread.
class PaintTools : public QObject {
    Q_OBJECT

  public:
    struct State {
        PaintTool tool = PaintTool::Look;
        double radiusPx = 64.0; ///< exemplar pixels
        double hardness = 0.5;
        double strength = 1.0;
        double target = 1.0; ///< rho
        Symmetry symmetry;

        bool operator==(const State&) const = default;
    };
    static constexpr double kMinRadiusPx = 2.0;
    static constexpr double kMaxRadiusPx = 1024.0;

    using QObject::QObject;

    const State& state() const { return m_state; }
    void set(const State& state) {
        if (state == m_state)
            return;
        m_state = state;
        emit changed();
    }

  signals:
    void changed();

  private:
    State m_state;
};

} // namespace txn::app
