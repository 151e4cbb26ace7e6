// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/PictureView.h"

#include <array>

class QGridLayout;

namespace txn::app {

/// The middle of the window: one, two or four views that are kept when the layout changes.
class ViewArea : public QWidget {
    Q_OBJECT

  public:
    ViewArea(ProjectDocument& document,
             Pipeline& pipeline,
             NoiseService& noise,
             Settings& settings,
             MapPainter& painter,
             QWidget* parent = nullptr);

    void setLayoutKind(ViewLayout layout);
    void fit();
    void zoomBy(double factor);
    /// In device pixels per pixel of the exemplar.
    void setZoom(double zoom);
    /// The Gaussian version in the view under the mouse.
    void showGaussian();
    std::optional<Picture> pictureUnderMouse() const;
    /// What a view of the noise shows; null where there is none, or not yet in full.
    QImage screenshotOfNoise();
    const std::array<PictureView*, 4>& views() const { return m_views; }

  signals:
    void probed(const ProbeInfo& info);
    void probeLeft();
    void noiseFrameShown(const NoiseFrame& frame);
    void problem(const QString& message);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void arrange();
    /// Keys that act as long as they are held, on the view under the mouse, wherever the focus is.
    /// Whether it was one.
    bool holdKey(const QKeyEvent& event);
    void releaseKeys(bool flip, bool difference, bool panning);
    PictureView* viewUnderMouse() const;
    PictureView* focusedView() const;
    PictureView& mainView() const { return *m_views.front(); }
    void choose(std::size_t place, Picture picture);
    void maximize(std::size_t place);

    ProjectDocument& m_document;
    Pipeline& m_pipeline;
    QGridLayout* m_grid;
    std::array<PictureView*, 4> m_views{};
    std::optional<ViewLayout> m_arranged;
    ViewLayout m_beforeMaximizing = ViewLayout::Quad;
    bool m_byKeyboard = false;                  ///< the focus was moved by keys, not by the mouse
    std::shared_ptr<const Source> m_keepViewOf; ///< of an opened project, until it is prepared
    bool m_fitted = false;                      ///< and not moved since
    Size m_fittedSize;
};

} // namespace txn::app
