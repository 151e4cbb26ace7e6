// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"

#include <QWidget>
#include <vector>

class QLineEdit;

namespace txn::app {

class SliderTrack;

/// A labelled number: a track to drag (Shift: fine), wheel, arrow keys, double-click for the
/// default, and a field that takes a number or a sum such as "64*2+1". Label left, value right with
/// its unit. Keyboard focus and accessible name included.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    enum class Scale { Linear, Logarithmic };
    struct Range {
        double low = 0.0;
        double high = 1.0;
        double standard = 0.0; ///< where double-click goes
        int decimals = 2;      ///< 0: whole numbers
        Scale scale = Scale::Linear;
        std::vector<double> stops; ///< marked on the track; the drag is drawn to them
        QString unit;              ///< shown after the value, such as "px"
        /// What may be typed beyond the track's ends; equal ends: the same as the track.
        double typedLow = 0.0;
        double typedHigh = 0.0;
    };

    ValueSlider(const QString& label, Range range, QWidget* parent = nullptr);

    double value() const { return m_value; }
    /// Shows a value without telling anybody.
    void setValue(double value);
    const Range& range() const { return m_range; }

  signals:
    /// By the user. Changes of one drag, or of one run of the wheel, have one gesture.
    void valueEdited(double value, Gesture gesture);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    friend class SliderTrack;
    void takeTyped();
    void edit(double value, Gesture gesture);
    void showValue();

    Range m_range;
    double m_value = 0.0;
    SliderTrack* m_track = nullptr;
    QLineEdit* m_field = nullptr;
};

} // namespace txn::app
