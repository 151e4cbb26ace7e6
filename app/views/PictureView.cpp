// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/PictureView.h"

#include "app/display/Difference.h"
#include "app/look/Theme.h"
#include "app/memory/NewImage.h"
#include "app/mixing/MapPainter.h"
#include "app/pipeline/Pipeline.h"
#include "app/settings/Settings.h"
#include "app/views/ViewCamera.h"
#include "app/views/ViewTitle.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QRandomGenerator>
#include <QTabletEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace txn::app {
namespace {

constexpr int kWipeGrab = 6;
constexpr double kOrbitPerPixel = 0.008;
constexpr double kLightPerPixel = 0.006;
constexpr double kWheelStep = 1.189207115002721; // 2^(1/4)
constexpr double kHighestPitch = 1.55;

} // namespace

PictureView::PictureView(ProjectDocument& document,
                         Pipeline& pipeline,
                         NoiseService& noise,
                         Settings& settings,
                         MapPainter& painter,
                         int place,
                         QWidget* parent)
    : QWidget(parent), m_document(document), m_pipeline(pipeline), m_settings(settings),
      m_feed(new NoiseFeed(noise, this)), m_place(place), m_painter(painter),
      m_title(new ViewTitle(place, this)) {
    setObjectName(QStringLiteral("view%1").arg(place));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setWhatsThis(
        tr("A picture. The wheel zooms where the mouse is, the middle button or Space moves "
           "it, F shows it whole. Hold ` to see the exemplar instead. The right button moves the "
           "light of a material."));
    connectTitle();
    connect(m_feed, &NoiseFeed::frameReady, this, [this] {
        update();
        m_title->setInfo(info());
        emit noiseFrameShown(m_feed->frame());
    });
    connect(m_feed, &NoiseFeed::failed, this, &PictureView::problem);
    connect(&m_document, &ProjectDocument::projectChanged, this, &PictureView::refresh);
    connect(&m_document, &ProjectDocument::viewChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::exemplarChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::gaussianChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::textonChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::noiseTextonChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::meshChanged, this, &PictureView::refresh);
    connect(&m_pipeline, &Pipeline::mixtureChanged, this, &PictureView::refresh);
    connect(&m_painter.tools(), &PaintTools::changed, this, [this] {
        m_brushAt.reset();
        update();
    });
    connect(&m_pipeline, &Pipeline::stateChanged, this, &PictureView::refresh);
    refresh();
}

void PictureView::connectTitle() {
    connect(m_title, &ViewTitle::pictureChosen, this, &PictureView::pictureChosen);
    connect(m_title, &ViewTitle::secondChosen, this, &PictureView::secondChosen);
    connect(m_title, &ViewTitle::doubleClicked, this, &PictureView::titleDoubleClicked);
    connect(m_title, &ViewTitle::gaussianMethodChosen, this, [this](GaussianMethod method) {
        m_document.change(tr("Gaussian method"),
                          [method](Project& project) { project.gaussian.method = method; });
    });
    connect(m_title, &ViewTitle::gaussianSeedWanted, this, [this] {
        const Seed seed{QRandomGenerator::global()->generate()};
        m_document.change(tr("Gaussian seed"),
                          [seed](Project& project) { project.gaussian.seed = seed; });
    });
}

Picture PictureView::picture() const {
    return m_document.view().shown[static_cast<std::size_t>(m_place)];
}

void PictureView::setSecond(std::optional<Picture> second) {
    if (m_second == second)
        return;
    m_second = second;
    refresh();
}

void PictureView::setFlipped(bool flipped) {
    m_flipped = flipped;
    update();
}

void PictureView::setDifference(bool difference) {
    m_difference = difference;
    update();
}

void PictureView::setPanning(bool panning) {
    m_panning = panning;
    if (panning)
        setCursor(Qt::OpenHandCursor);
    else if (m_drag != Drag::Pan)
        unsetCursor();
}

bool PictureView::showsKept() const {
    return m_pipeline.keptTexton() && m_place == 0 && m_document.view().keptBeside;
}

std::shared_ptr<const TextonResult> PictureView::texton() const {
    return showsKept() ? m_pipeline.keptTexton() : m_pipeline.shownTexton();
}

std::shared_ptr<const Texton> PictureView::noiseTexton() const {
    return showsKept() ? m_pipeline.keptNoiseTexton() : m_pipeline.noiseTexton();
}

bool PictureView::showsMixture() const {
    return m_document.project().mix.source && m_pipeline.mixTextons() && m_pipeline.mixingMap() &&
           m_pipeline.mix() && !showsKept() && !m_pipeline.isShowingKept();
}

/// The place in mixTextons() of the one that is shown alone.
std::optional<std::size_t> PictureView::shownMixTexton() const {
    const auto rho = m_document.view().mixRho;
    if (!rho || !showsMixture())
        return std::nullopt;
    const auto last = static_cast<double>(m_pipeline.mixTextons()->size() - 1);
    return static_cast<std::size_t>(std::lround(std::clamp(*rho, 0.0, 1.0) * last));
}

bool PictureView::canPaint(QPointF position) const {
    return picture() == Picture::Noise && !orbits() && !m_panning && !m_flipped &&
           (!m_second || position.x() < wipeX()) && showsMixture() && !shownMixTexton() &&
           m_painter.isReady();
}

PlaneView PictureView::planeView() const {
    const View view = noiseView(m_document.view(), m_document.project().noise, 1.0);
    return std::holds_alternative<PlaneView>(view) ? std::get<PlaneView>(view) : PlaneView{};
}

QPointF PictureView::planeAt(QPointF position) const {
    return onPlane(planeView(),
                   screen(),
                   (position - QPointF(area().topLeft())) * devicePixelRatioF());
}

void PictureView::paintMap(QPainter& painter) {
    if (picture() != Picture::Noise || orbits() || m_flipped || !showsMixture() || shownMixTexton())
        return;
    painter.save();
    painter.setClipRect(m_second ? QRectF(area().left(), area().top(), wipeX(), area().height())
                                 : QRectF(area()));
    painter.translate(area().topLeft());
    painter.scale(1.0 / devicePixelRatioF(), 1.0 / devicePixelRatioF());
    if (m_document.view().mapShown)
        m_overlay.draw(painter, m_pipeline.mixingMap(), planeView(), screen());
    const PaintTools::State& tools = m_painter.tools().state();
    if (m_brushAt && m_painter.isReady() && tools.tool != PaintTool::Line &&
        tools.tool != PaintTool::Circle)
        MapOverlay::drawBrush(painter,
                              *m_brushAt,
                              tools.radiusPx,
                              tools.hardness,
                              planeView(),
                              screen());
    painter.restore();
}

bool PictureView::showsMaterial() const {
    const auto texton = this->texton();
    return picture() == Picture::Noise && texton && !texton->maps.empty() &&
           !findMap(texton->maps, m_document.project().noise.map.toStdString());
}

/// Null where there is no such picture (yet), and for the noise.
std::shared_ptr<const PicturePyramid> PictureView::pyramidOf(Picture picture) const {
    const auto exemplar = m_pipeline.exemplar();
    // Of a stack, the map that is shown, or the first one.
    const auto pictureOf = [&](const auto& result, const MaterialMaps& maps) {
        const std::size_t map =
            findMap(maps, m_document.project().noise.map.toStdString()).value_or(0);
        return std::shared_ptr<const PicturePyramid>(
            result,
            &result->pictures[std::min(map, result->pictures.size() - 1)]);
    };
    switch (picture) {
    case Picture::Exemplar:
        if (exemplar)
            return pictureOf(exemplar, exemplar->exemplar.maps);
        break;
    case Picture::Gaussian:
        if (const auto gaussian = m_pipeline.gaussian(); gaussian && exemplar)
            return pictureOf(gaussian, exemplar->exemplar.maps);
        break;
    case Picture::Texton:
        if (const auto one = shownMixTexton(); one && m_pipeline.mix()->finished) {
            const auto mix = m_pipeline.mix();
            return pictureOf(std::shared_ptr<const MixFrame>(mix, &mix->frames[*one]), mix->maps);
        }
        if (const auto shown = texton())
            return pictureOf(shown, shown->maps);
        break;
    case Picture::Noise:
        break;
    }
    return nullptr;
}

QRect PictureView::area() const {
    return rect().adjusted(0, ViewTitle::kHeight, 0, 0);
}

QSize PictureView::screen() const {
    const double ratio = devicePixelRatioF();
    return {static_cast<int>(std::lround(area().width() * ratio)),
            static_cast<int>(std::lround(area().height() * ratio))};
}

Size PictureView::sizeOf(Picture picture) const {
    const auto pyramid = pyramidOf(picture);
    return pyramid ? pyramid->image().size() : Size{};
}

QString PictureView::whichTexton() const {
    if (!m_pipeline.keptTexton())
        return {};
    return (m_pipeline.isShowingKept() || showsKept() ? tr("A (kept)") : tr("B (present)")) +
           QStringLiteral("  \u00b7  ");
}

QString PictureView::info() const {
    if (m_second)
        return {};
    if (picture() == Picture::Noise) {
        const NoiseFrame& frame = m_feed->frame();
        if (frame.image.isNull() || !noiseTexton())
            return {};
        return whichTexton() +
               tr("%1 fps").arg(
                   QLocale().toString(1000.0 / std::max(frame.milliseconds, 0.1), 'f', 0));
    }
    const Size size = sizeOf(picture());
    if (size.width <= 0)
        return {};
    return (picture() == Picture::Texton ? whichTexton() : QString()) +
           tr("%1 x %2 px").arg(size.width).arg(size.height);
}

Size PictureView::referenceSize() const {
    const Size exemplar = sizeOf(Picture::Exemplar);
    return exemplar.width > 0 ? exemplar : Size{512, 512};
}

bool PictureView::orbits() const {
    return picture() == Picture::Noise && m_document.project().noise.scene != NoiseScene::Plane;
}

void PictureView::refresh() {
    // What is drawn of a result must not keep all of it alive once it has been replaced.
    for (const Picture each : kPictures) {
        Drawn& drawn = m_drawn[static_cast<std::size_t>(each)];
        if (drawn.pyramid && drawn.pyramid != pyramidOf(each))
            drawn = {};
    }
    m_title->showPictures(picture(), m_second);
    m_title->showGaussian(m_document.project().gaussian.method);
    m_title->setStale(m_pipeline.isStale(picture()) || (m_second && m_pipeline.isStale(*m_second)));
    m_title->setInfo(info());
    setAccessibleName(nameOf(picture()));
    requestNoise();
    update();
}

void PictureView::requestNoise() {
    NoiseRequest request;
    if (shows(Picture::Noise) && isVisible()) {
        const Project& project = m_document.project();
        const ViewState& view = m_document.view();
        request.texton = noiseTexton();
        if (const auto of =
                showsKept() ? m_pipeline.keptTexton() : m_pipeline.noiseTextonSource()) {
            request.maps = of->maps;
            request.map = findMap(of->maps, project.noise.map.toStdString());
        }
        if (showsMixture()) {
            request.maps = m_pipeline.mix()->maps;
            request.map = findMap(request.maps, project.noise.map.toStdString());
            const auto textons = m_pipeline.mixTextons();
            if (const auto one = shownMixTexton()) {
                request.texton = {textons, &(*textons)[*one]};
            } else {
                request.texton = {textons, &textons->front()};
                request.mixture = textons;
                request.mixingMap = m_pipeline.mixingMap();
            }
        }
        request.style.light = project.noise.light;
        const bool onMesh =
            project.noise.scene == NoiseScene::Mesh || project.noise.scene == NoiseScene::Surface;
        if (onMesh)
            request.mesh = m_pipeline.mesh();
        const double radius =
            request.mesh ? static_cast<double>(boundingSphere(*request.mesh).radius) : 1.0;
        request.style.noise.process = project.noise.process;
        if (request.mixture)
            request.style.noise.process = mixedProcess(project.noise.process);
        request.style.noise.meanImpacts = project.noise.meanImpacts;
        request.style.noise.seed = project.noise.seed;
        request.style.filter = project.noise.filter;
        request.view = noiseView(view, project.noise, radius);
        if (request.map && request.maps[*request.map].kind != MapKind::Color)
            showAsData(request.view);
        request.size = screen();
        request.display = {view.exposure, view.channel};
    }
    m_feed->request(request);
}

QImage PictureView::drawnNoise() const {
    const NoiseFrame& frame = m_feed->frame();
    QImage result = newImage(screen(), QImage::Format_ARGB32_Premultiplied);
    result.fill(Qt::transparent);
    if (frame.image.isNull() || !noiseTexton())
        return result;
    QPainter painter(&result);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QRectF place(QPointF(0, 0), QSizeF(screen()));
    const auto* then = std::get_if<PlaneView>(&frame.request.view);
    const View present = noiseView(m_document.view(), m_document.project().noise, 1.0);
    if (const auto* now = std::get_if<PlaneView>(&present); now != nullptr && then != nullptr) {
        // Until the new frame is there, the old one moves along.
        const double ratio = now->zoom / then->zoom;
        const QSizeF size = QSizeF(frame.request.size) * ratio;
        const QPointF middle(place.width() / 2.0 + (then->centerX - now->centerX) * now->zoom,
                             place.height() / 2.0 + (then->centerY - now->centerY) * now->zoom);
        place = QRectF(middle - QPointF(size.width() / 2.0, size.height() / 2.0), size);
    }
    painter.drawImage(place, frame.image);
    return result;
}

QImage PictureView::drawn(Picture picture) {
    if (picture == Picture::Noise)
        return drawnNoise();
    const ViewState& view = m_document.view();
    const auto pyramid = pyramidOf(picture);
    if (!pyramid) {
        QImage nothing = newImage(screen(), QImage::Format_ARGB32_Premultiplied);
        nothing.fill(Qt::transparent);
        return nothing;
    }
    PictureWindow window = pictureWindow(view, screen(), pyramid->image().size());
    window.tiled = view.tiled && picture != Picture::Texton;
    const DisplaySettings display{view.exposure, view.channel};
    Drawn& last = m_drawn[static_cast<std::size_t>(picture)];
    if (last.pyramid != pyramid || last.window != window || last.display != display)
        last = {pyramid, window, display, pyramid->draw(window, display)};
    return last.image;
}

double PictureView::wipeX() const {
    return m_document.view().wipe * area().width();
}

QImage PictureView::composed() {
    const Picture first = m_flipped ? Picture::Exemplar : picture();
    QImage image = drawn(first);
    if (m_difference && first != Picture::Exemplar)
        return difference(image, drawn(Picture::Exemplar));
    if (!m_second || m_flipped)
        return image;
    const int border = static_cast<int>(std::lround(wipeX() * devicePixelRatioF()));
    const QImage second = drawn(*m_second);
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(border, 0, second, border, 0, second.width() - border, second.height());
    return image;
}

QImage PictureView::grabPicture() {
    return composed();
}

void PictureView::paintHint(QPainter& painter) {
    QString hint;
    const auto& source = m_document.project().source;
    // Over the sample of the first start only: whoever chose one knows.
    const bool firstStart = source && !source->sample().isEmpty() &&
                            m_document.undoStack().count() <= 1 && m_document.filePath().isEmpty();
    if (firstStart && picture() == Picture::Exemplar && !m_flipped && !m_second)
        hint = tr("Drop a photo here");
    else if (!m_document.project().source && !m_document.project().importedTexton)
        hint = picture() == Picture::Exemplar ? tr("Drop a photo here") : QString();
    else if (m_document.project().importedTexton && picture() == Picture::Exemplar)
        hint = tr("A texton from a file has no exemplar");
    else if (m_document.project().importedTexton && picture() == Picture::Gaussian)
        hint = tr("A texton from a file has no Gaussian version");
    if (hint.isEmpty())
        return;
    const QRect text = painter.fontMetrics().boundingRect(hint).adjusted(-12, -8, 12, 8);
    QRect box(QPoint(0, 0), text.size());
    box.moveCenter(area().center());
    if (source) // out of the way of the sample
        box.moveBottom(area().bottom() - 12);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, hint);
}

void PictureView::paintEvent(QPaintEvent*) {
    if (m_feed->isWanted() && m_feed->wantedSize() != screen()) // moved to a screen of other pixels
        QMetaObject::invokeMethod(this, &PictureView::requestNoise, Qt::QueuedConnection);
    QPainter painter(this);
    painter.fillRect(QRect(0, 0, width(), ViewTitle::kHeight), themeColors().panel);
    painter.fillRect(area(), surroundColor(m_settings.surround()));
    QImage image = composed();
    image.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(area().topLeft(), image);
    paintMap(painter);
    if (m_second && !m_flipped) {
        const int x = static_cast<int>(std::lround(wipeX()));
        painter.fillRect(QRect(x, area().top(), 1, area().height()), Qt::white);
    }
    paintHint(painter);
    if (hasFocus())
        paintFocusFrame(painter, rect());
}

void PictureView::showEvent(QShowEvent*) {
    refresh(); // what was missed while nobody looked
}

void PictureView::resizeEvent(QResizeEvent*) {
    m_title->setGeometry(0, 0, width(), ViewTitle::kHeight);
    requestNoise();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
    if (m_drag != Drag::None)
        return; // another button, in the middle of a drag
    m_last = event->position();
    m_dragButton = event->button();
    const bool left = event->button() == Qt::LeftButton;
    if (m_second && left && std::abs(event->position().x() - wipeX()) <= kWipeGrab)
        m_drag = Drag::Wipe;
    else if (event->button() == Qt::MiddleButton || (left && m_panning))
        m_drag = Drag::Pan;
    else if (left && orbits())
        m_drag = Drag::Orbit;
    else if (left && canPaint(event->position()))
        m_drag = Drag::Paint;
    else if (event->button() == Qt::RightButton && showsMaterial())
        m_drag = Drag::Light;
    m_gesture = Gesture::next();
    if (m_drag == Drag::Pan)
        setCursor(Qt::ClosedHandCursor);
    if (m_drag == Drag::Paint)
        m_painter.press(planeAt(event->position()),
                        m_penPressure.value_or(1.0),
                        event->modifiers().testFlag(Qt::ShiftModifier));
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF distance = event->position() - m_last;
    m_last = event->position();
    switch (m_drag) {
    case Drag::Pan:
        m_document.changeView([&](ViewState& view) { pan(view, distance * devicePixelRatioF()); });
        break;
    case Drag::Orbit:
        orbit(distance);
        break;
    case Drag::Wipe:
        moveBorder(event->position().x());
        break;
    case Drag::Light:
        moveLight(distance);
        break;
    case Drag::Paint:
        m_painter.move(planeAt(event->position()), m_penPressure.value_or(1.0));
        break;
    case Drag::None:
        setCursor(m_second && std::abs(event->position().x() - wipeX()) <= kWipeGrab
                      ? Qt::SplitHCursor
                  : m_panning                   ? Qt::OpenHandCursor
                  : canPaint(event->position()) ? Qt::CrossCursor
                                                : Qt::ArrowCursor);
        break;
    }
    if (m_brushAt || canPaint(event->position())) {
        m_brushAt =
            canPaint(event->position()) ? std::optional(planeAt(event->position())) : std::nullopt;
        update();
    }
    probe(event->position());
}

void PictureView::orbit(QPointF distance) {
    const double lowest =
        m_document.project().noise.scene == NoiseScene::Perspective ? 0.02 : -kHighestPitch;
    m_document.changeView([&](ViewState& view) {
        view.yaw = std::remainder(view.yaw - distance.x() * kOrbitPerPixel, 2.0 * M_PI);
        view.pitch = std::clamp(view.pitch + distance.y() * kOrbitPerPixel, lowest, kHighestPitch);
    });
}

void PictureView::moveLight(QPointF distance) {
    m_document.change(
        tr("Light"),
        [&](Project& project) {
            // As a ball under the mouse: right of the middle comes from the right.
            Light& light = project.noise.light;
            const glm::dvec3 from = light.direction();
            const double x = from.x + distance.x() * kLightPerPixel;
            const double y = from.y - distance.y() * kLightPerPixel;
            light.azimuth = std::atan2(y, x);
            light.elevation = std::acos(std::min(1.0, std::hypot(x, y)));
        },
        m_gesture);
}

void PictureView::moveBorder(double x) {
    m_document.changeView([&](ViewState& view) {
        view.wipe = std::clamp(x / std::max(1, area().width()), 0.0, 1.0);
    });
}

void PictureView::tabletEvent(QTabletEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton))
        m_penPressure = event->pressure();
    else // lifted or hovering
        m_penPressure.reset();
    event->ignore(); // comes again as a mouse
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != m_dragButton)
        return;
    if (m_drag == Drag::Paint)
        m_painter.release();
    m_drag = Drag::None;
    unsetCursor();
}

void PictureView::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0.0)
        return;
    zoomAtPoint(event->position() - QPointF(area().topLeft()), std::pow(kWheelStep, steps));
    event->accept();
}

void PictureView::zoomAtPoint(QPointF point, double factor) {
    const bool onMesh = orbits() && m_document.project().noise.scene != NoiseScene::Perspective;
    m_document.changeView([&](ViewState& view) {
        if (onMesh)
            view.distance = std::clamp(view.distance / factor, 0.2, 20.0);
        else
            zoomAt(view, screen(), point * devicePixelRatioF(), factor);
    });
}

void PictureView::zoomBy(double factor) {
    QPointF point = QPointF(mapFromGlobal(QCursor::pos())) - QPointF(area().topLeft());
    if (!underMouse())
        point = QPointF(area().width() / 2.0, area().height() / 2.0);
    zoomAtPoint(point, factor);
}

void PictureView::leaveEvent(QEvent*) {
    m_brushAt.reset();
    update();
    emit probeLeft();
}

void PictureView::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 40.0;
    const bool border = m_second && event->modifiers().testFlag(Qt::ShiftModifier);
    const auto move = [&](double x, double y) {
        if (border)
            moveBorder(wipeX() - x);
        else if (orbits())
            orbit(QPointF(-x, -y));
        else
            m_document.changeView([&](ViewState& view) { pan(view, QPointF(x, y)); });
    };
    switch (event->key()) {
    case Qt::Key_Left:
        move(kStep, 0.0);
        return;
    case Qt::Key_Right:
        move(-kStep, 0.0);
        return;
    case Qt::Key_Up:
        move(0.0, kStep);
        return;
    case Qt::Key_Down:
        move(0.0, -kStep);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void PictureView::probe(QPointF position) {
    const QPointF point = (position - QPointF(area().topLeft())) * devicePixelRatioF();
    Picture picture = this->picture();
    if (m_second && position.x() >= wipeX())
        picture = *m_second;
    const Image* image = nullptr;
    QPointF place;
    int sampleX = 0;
    int sampleY = 0;
    if (picture == Picture::Noise) {
        const NoiseFrame& frame = m_feed->frame();
        if (!frame.samples || frame.request.size != screen())
            return;
        image = frame.samples.get();
        place = pictureAt(m_document.view(), screen(), referenceSize(), point);
        sampleX = static_cast<int>(point.x() * image->width() / screen().width());
        sampleY = static_cast<int>(point.y() * image->height() / screen().height());
    } else {
        const auto pyramid = pyramidOf(picture);
        if (!pyramid)
            return;
        image = &pyramid->image();
        place = pictureAt(m_document.view(), screen(), image->size(), point);
        sampleX = static_cast<int>(std::floor(place.x()));
        sampleY = static_cast<int>(std::floor(place.y()));
        if (m_document.view().tiled && picture != Picture::Texton) {
            sampleX = ((sampleX % image->width()) + image->width()) % image->width();
            sampleY = ((sampleY % image->height()) + image->height()) % image->height();
        }
    }
    emit probed(probePixel(
        *image,
        {sampleX, sampleY},
        {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y()))}));
}

} // namespace txn::app
