// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/display/PicturePyramid.h"
#include "app/document/ProjectDocument.h"
#include "app/views/MapOverlay.h"
#include "app/views/NoiseService.h"
#include "app/views/PixelProbe.h"

#include <QWidget>
#include <array>
#include <memory>
#include <vector>

namespace txn::app {

class MapPainter;
class Pipeline;
class Settings;
class ViewTitle;
struct TextonResult;

/// One place of the view area: shows one of the four pictures, or two with a border between them,
/// through the document's one camera. Draws nothing but its own pixels; noise comes from a
/// NoiseFeed.
class PictureView : public QWidget {
    Q_OBJECT

  public:
    PictureView(ProjectDocument& document,
                Pipeline& pipeline,
                NoiseService& noise,
                Settings& settings,
                MapPainter& painter,
                int place,
                QWidget* parent = nullptr);

    Picture picture() const;
    /// A second picture, right of a border that can be dragged.
    void setSecond(std::optional<Picture> second);
    /// While on, the exemplar takes the picture's place.
    void setFlipped(bool flipped);
    /// While on, the difference to the exemplar, times 8, around mid grey.
    void setDifference(bool difference);
    /// While on, the left button moves the picture.
    void setPanning(bool panning);

    /// Of the picture area, in device pixels.
    QSize screen() const;
    void zoomBy(double factor); ///< at the mouse, or else in the middle
    const NoiseFrame& noiseFrame() const { return m_feed->frame(); }
    /// Whether that is what was asked for, in full.
    bool isNoiseCurrent() const { return m_feed->isCurrent(); }
    bool shows(Picture which) const { return picture() == which || m_second == which; }
    /// What is seen, without border and title.
    QImage grabPicture();

    QSize minimumSizeHint() const override { return {160, 120}; }

  signals:
    void probed(const ProbeInfo& info);
    void probeLeft();
    void noiseFrameShown(const NoiseFrame& frame);
    /// The artist chose another picture for this place, or for what is right of the border.
    void pictureChosen(Picture picture);
    void secondChosen(Picture picture);
    void titleDoubleClicked();
    void problem(const QString& message);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Drag { None, Pan, Orbit, Wipe, Light, Paint };

    void connectTitle();
    void refresh();
    void requestNoise();
    QRect area() const;
    QImage drawn(Picture picture);
    QImage drawnNoise() const;
    QImage composed();
    /// Whether the noise shown here, seen from above, is a mixture.
    bool showsMixture() const;
    bool canPaint(QPointF position) const;
    std::optional<std::size_t> shownMixTexton() const;
    QPointF planeAt(QPointF position) const;
    PlaneView planeView() const;
    void paintMap(QPainter& painter);
    QString info() const;
    void paintHint(QPainter& painter);
    Size referenceSize() const;
    Size sizeOf(Picture picture) const;
    bool orbits() const;
    void probe(QPointF position);
    double wipeX() const;
    void moveBorder(double x);
    void orbit(QPointF distance);
    /// Whether this view is the one for the kept texton, beside that of the present one.
    bool showsKept() const;
    std::shared_ptr<const TextonResult> texton() const;
    std::shared_ptr<const Texton> noiseTexton() const;
    /// Whether a light shines on what is shown.
    bool showsMaterial() const;
    /// "A" or "B" where a texton has been kept to compare with.
    QString whichTexton() const;
    void moveLight(QPointF distance);
    std::shared_ptr<const PicturePyramid> pyramidOf(Picture picture) const;
    void zoomAtPoint(QPointF point, double factor);

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    Settings& m_settings;
    NoiseFeed* m_feed;
    int m_place;
    std::optional<Picture> m_second;
    bool m_flipped = false;
    bool m_difference = false;
    bool m_panning = false;
    Drag m_drag = Drag::None;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    QPointF m_last;
    Gesture m_gesture; ///< of the drag
    MapPainter& m_painter;
    MapOverlay m_overlay;
    std::optional<double> m_penPressure; ///< of a pen that is down
    std::optional<QPointF> m_brushAt;    ///< where the mouse is, over a map that can be painted

    /// What was drawn last, since most repaints change nothing about it.
    struct Drawn {
        std::shared_ptr<const PicturePyramid> pyramid;
        PictureWindow window;
        DisplaySettings display;
        QImage image;
    };
    std::array<Drawn, kPictures.size()> m_drawn; ///< by Picture

    ViewTitle* m_title;
};

} // namespace txn::app
