// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/ViewArea.h"

#include "app/pipeline/Pipeline.h"
#include "app/views/ViewCamera.h"

#include <QApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <algorithm>

namespace txn::app {
namespace {

/// Side by side and wipe compare the same two pictures.
constexpr std::size_t kSecondPlace = 1;

bool compares(ViewLayout layout) {
    return layout == ViewLayout::SideBySide || layout == ViewLayout::Wipe;
}

std::size_t placesOf(ViewLayout layout) {
    switch (layout) {
    case ViewLayout::Quad:
        return 4;
    case ViewLayout::SideBySide:
        return 2;
    case ViewLayout::Single:
    case ViewLayout::Wipe:
        break;
    }
    return 1;
}

} // namespace

ViewArea::ViewArea(ProjectDocument& document,
                   Pipeline& pipeline,
                   NoiseService& noise,
                   Settings& settings,
                   MapPainter& painter,
                   QWidget* parent)
    : QWidget(parent), m_document(document), m_pipeline(pipeline), m_grid(new QGridLayout(this)) {
    setObjectName(QStringLiteral("viewArea"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(2);
    for (std::size_t place = 0; place < m_views.size(); ++place) {
        auto* view = new PictureView(document,
                                     pipeline,
                                     noise,
                                     settings,
                                     painter,
                                     static_cast<int>(place),
                                     this);
        m_views[place] = view;
        connect(view, &PictureView::probed, this, &ViewArea::probed);
        connect(view, &PictureView::probeLeft, this, &ViewArea::probeLeft);
        connect(view, &PictureView::noiseFrameShown, this, &ViewArea::noiseFrameShown);
        connect(view, &PictureView::problem, this, &ViewArea::problem);
        connect(view, &PictureView::pictureChosen, this, [this, place](Picture picture) {
            choose(place, picture);
        });
        connect(view, &PictureView::secondChosen, this, [this](Picture picture) {
            choose(kSecondPlace, picture);
        });
        connect(view, &PictureView::titleDoubleClicked, this, [this, place] { maximize(place); });
    }
    connect(&m_document, &ProjectDocument::viewChanged, this, &ViewArea::arrange);
    connect(&m_document, &ProjectDocument::replaced, this, [this] {
        m_keepViewOf = m_document.project().source;
        m_fitted = false;
        m_fittedSize = {};
    });
    connect(&m_pipeline, &Pipeline::exemplarChanged, this, [this] {
        // Another picture starts whole in view; an edited one stays where it is, and that of a
        // project where it was.
        const auto exemplar = m_pipeline.exemplar();
        if (!exemplar)
            return;
        const Size size = exemplar->exemplar.image.size();
        const bool keep = exemplar->source == m_keepViewOf;
        m_keepViewOf.reset();
        if (keep)
            m_fittedSize = size;
        else if (m_fitted || size != m_fittedSize)
            fit();
    });
    // Held keys act on the view under the mouse, wherever the focus is.
    qApp->installEventFilter(this);
    arrange();
}

void ViewArea::arrange() {
    const ViewState& view = m_document.view();
    if (m_fitted && (view.centerX != 0.0 || view.centerY != 0.0))
        m_fitted = false;
    const bool wipe = view.layout == ViewLayout::Wipe;
    m_views[0]->setSecond(wipe ? std::optional(view.shown[kSecondPlace]) : std::nullopt);
    if (m_arranged == view.layout)
        return;
    m_arranged = view.layout;
    const std::size_t places = placesOf(view.layout);
    for (std::size_t i = 0; i < m_views.size(); ++i) {
        m_grid->removeWidget(m_views[i]);
        m_views[i]->setVisible(i < places);
    }
    for (std::size_t i = 0; i < places; ++i)
        m_grid->addWidget(m_views[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
    for (int i = 0; i < 2; ++i) {
        const bool second = i == 0 || places == 4;
        m_grid->setRowStretch(i, second ? 1 : 0);
        m_grid->setColumnStretch(i, i == 0 || places >= 2 ? 1 : 0);
    }
    if (m_fitted) {
        m_grid->activate();
        fit();
    }
}

void ViewArea::setLayoutKind(ViewLayout layout) {
    m_document.changeView([layout](ViewState& view) {
        // At first, what goes in is compared with what comes out.
        if (compares(layout) && !compares(view.layout) && view.shown == kPictures)
            std::swap(view.shown[kSecondPlace], view.shown[3]);
        if (layout == ViewLayout::Quad)
            view.shown = kPictures;
        view.layout = layout;
    });
}

void ViewArea::choose(std::size_t place, Picture picture) {
    m_document.changeView([&](ViewState& view) {
        // The picture that was there goes where the new one comes from: none is lost.
        const auto other = std::find(view.shown.begin(), view.shown.end(), picture);
        if (other != view.shown.end())
            *other = view.shown[place];
        view.shown[place] = picture;
    });
}

void ViewArea::maximize(std::size_t place) {
    const ViewLayout now = m_document.view().layout;
    if (now == ViewLayout::Single) {
        setLayoutKind(m_beforeMaximizing);
        return;
    }
    m_beforeMaximizing = now;
    m_document.changeView([&](ViewState& view) {
        std::swap(view.shown[0], view.shown[place]);
        view.layout = ViewLayout::Single;
    });
}

void ViewArea::fit() {
    const auto exemplar = m_pipeline.exemplar();
    const Size size = exemplar ? exemplar->exemplar.image.size() : Size{512, 512};
    m_fittedSize = size;
    m_fitted = true;
    m_document.changeView([&](ViewState& view) { app::fit(view, mainView().screen(), size); });
    m_fitted = true;
}

void ViewArea::zoomBy(double factor) {
    m_fitted = false;
    PictureView* view = viewUnderMouse();
    (view != nullptr ? *view : mainView()).zoomBy(factor);
}

void ViewArea::setZoom(double zoom) {
    m_fitted = false;
    m_document.changeView([zoom](ViewState& view) { view.zoom = zoom; });
}

PictureView* ViewArea::focusedView() const {
    const auto found = std::find(m_views.begin(), m_views.end(), QApplication::focusWidget());
    return found != m_views.end() ? *found : nullptr;
}

PictureView* ViewArea::viewUnderMouse() const {
    for (PictureView* view : m_views) {
        if (view->isVisible() && view->underMouse())
            return view;
    }
    return nullptr;
}

std::optional<Picture> ViewArea::pictureUnderMouse() const {
    const PictureView* view = viewUnderMouse();
    return view != nullptr ? std::optional(view->picture()) : std::nullopt;
}

void ViewArea::showGaussian() {
    const PictureView* view = viewUnderMouse();
    const auto found = std::find(m_views.begin(), m_views.end(), view);
    choose(found == m_views.end() ? 0 : static_cast<std::size_t>(found - m_views.begin()),
           Picture::Gaussian);
}

QImage ViewArea::screenshotOfNoise() {
    for (PictureView* view : m_views) {
        if (view->isVisible() && view->shows(Picture::Noise) && view->isNoiseCurrent())
            return view->noiseFrame().image;
    }
    return {};
}

bool ViewArea::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        if (holdKey(*static_cast<QKeyEvent*>(event)))
            return true;
        break;
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
        m_byKeyboard = false;
        break;
    case QEvent::WindowDeactivate: // the release goes to somebody else
    case QEvent::ApplicationDeactivate:
        releaseKeys(true, true, true);
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

bool ViewArea::holdKey(const QKeyEvent& event) {
    const int key = event.key();
    if (key == Qt::Key_Tab || key == Qt::Key_Backtab || key == Qt::Key_F6 || key == Qt::Key_Up ||
        key == Qt::Key_Down || key == Qt::Key_Left || key == Qt::Key_Right)
        m_byKeyboard = true;
    // With Shift, the same key may have become another one by the time it is let go.
    const bool flip = key == Qt::Key_QuoteLeft || key == Qt::Key_AsciiTilde;
    if (!flip && key != Qt::Key_X && key != Qt::Key_Space)
        return false;
    if (event.type() == QEvent::KeyRelease) {
        if (!event.isAutoRepeat())
            releaseKeys(flip, key == Qt::Key_X, key == Qt::Key_Space);
        return false;
    }
    PictureView* view = m_byKeyboard ? focusedView() : viewUnderMouse();
    // Who types into a field means the letter, who got to a button by the keyboard wants to press
    // it, and other windows have nothing to do with views.
    const QWidget* focus = QApplication::focusWidget();
    const bool types = focus != nullptr && focus->testAttribute(Qt::WA_InputMethodEnabled);
    if (view == nullptr || types || event.modifiers() != Qt::NoModifier ||
        QApplication::activeWindow() != window() || QApplication::activePopupWidget() != nullptr)
        return false;
    if (event.isAutoRepeat())
        return true;
    if (flip)
        view->setFlipped(true);
    else if (key == Qt::Key_X)
        view->setDifference(true);
    else
        view->setPanning(true);
    return true;
}

void ViewArea::releaseKeys(bool flip, bool difference, bool panning) {
    for (PictureView* view : m_views) {
        if (flip)
            view->setFlipped(false);
        if (difference)
            view->setDifference(false);
        if (panning)
            view->setPanning(false);
    }
}

void ViewArea::resizeEvent(QResizeEvent*) {
    if (m_fitted) {
        m_grid->activate();
        fit();
    }
}

} // namespace txn::app
