// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoisePainter.h"

#include "core/material/NormalMap.h"
#include "core/noise/NoiseGrid.h"
#include "gl/MaterialTextons.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace txn::app {
namespace {

constexpr double kPieceMs = 20.0;
constexpr int kColors = 3;
/// Fewer take what starting a draw takes.
constexpr std::int64_t kTellingPixels = 4096;
/// A first guess, so that the first frame of a slow renderer does not keep anybody waiting.
constexpr double kUnknownCost = 200.0;

Size scaled(QSize size, double scale) {
    return {std::max(1, static_cast<int>(std::lround(size.width() * scale))),
            std::max(1, static_cast<int>(std::lround(size.height() * scale)))};
}

/// The same view on a picture of another resolution.
View atScale(View view, double scale) {
    if (auto* plane = std::get_if<PlaneView>(&view)) {
        plane->zoom = std::max(plane->zoom * scale, PlaneView::kMinZoom);
    } else if (auto* ground = std::get_if<GroundView>(&view)) {
        ground->zoom = std::max(ground->zoom * scale, PlaneView::kMinZoom);
    }
    return view;
}

double shareOutside(const Image& image) {
    const auto samples = image.samples();
    const auto count = std::count_if(samples.begin(), samples.end(), [](float v) {
        return !(v >= 0.0F && v <= 1.0F);
    });
    return static_cast<double>(count) / static_cast<double>(samples.size());
}

/// Texture fetches for one impact.
double fetchesPerImpact(int order) {
    return order <= 1 ? 1.0 : (order == 3 ? 4.0 : 9.0);
}

} // namespace

NoisePainter::NoisePainter() {
    auto context = HeadlessContext::create();
    if (context) {
        m_context = std::move(*context);
        m_rendererName = m_context->gl().renderer();
    } else {
        m_problem = context.error().message;
    }
}

void NoisePainter::loseContext() {
    if (!m_context)
        return;
    // What lived in it is gone with it; the handles know.
    m_context.reset();
    m_target = {};
    m_refused = {};
    m_problem.clear();
    if (auto context = HeadlessContext::create()) {
        m_context = std::move(*context);
    } else {
        m_rendererName.clear();
        m_problem = context.error().message;
    }
}

double NoisePainter::scaleFor(const NoiseRequest& request, double milliseconds) const {
    const double known = m_cost[request.view.index()];
    const double cost =
        (known > 0.0 ? known : kUnknownCost) * request.size.width() * request.size.height() / 1e6;
    constexpr double kCoarsest = 1.0 / 8.0;
    return cost <= milliseconds ? 1.0 : std::max(kCoarsest, std::sqrt(milliseconds / cost));
}

void NoisePainter::show(const NoiseRequest& request) {
    m_texton = request.texton;
    m_mixture = request.mixture;
    m_maps = request.maps;
    m_map = request.map;
    m_onCard = usesCard(request);
    m_mixingMap.reset(); // depends on how many textons there are
    m_reliefs.reset();
    m_drawnMap.reset();
    const std::span<const Texton> textons =
        m_mixture ? std::span<const Texton>(*m_mixture) : std::span(m_texton.get(), 1);
    const int channels = textons.front().channels();
    const bool isStack = channelCount(m_maps) == channels;
    if (isStack && (m_map || !m_onCard)) // the processor does not shade: it shows the colors
        m_drawnMap = m_map ? *m_map : findMap(m_maps, MapKind::Color).value_or(0);
    auto shown = std::make_shared<std::vector<Texton>>();
    auto reliefs = std::make_shared<std::vector<Texton>>();
    for (const Texton& texton : textons) {
        if (!isStack) {
            shown->push_back(firstChannels(texton, std::min(channels, kColors)));
        } else if (m_drawnMap) {
            shown->push_back(mapTexton(texton, m_maps, *m_drawnMap));
        } else {
            const auto material = materialTextons(texton, m_maps);
            shown->push_back(*material.base);
            reliefs->push_back(*material.relief);
        }
    }
    m_shown = std::move(shown);
    if (!reliefs->empty())
        m_reliefs = std::move(reliefs);
}

void NoisePainter::showMap(const std::shared_ptr<const MixingMap>& map) {
    if (m_mixingMap == map)
        return;
    m_mixingMap = map;
    m_renderer.setField(map ? std::make_shared<const TextonField>(*map,
                                                                  static_cast<int>(m_shown->size()),
                                                                  m_shown->front().footprint())
                            : nullptr);
}

/// Normals are drawn as slopes.
Image NoisePainter::finished(Image drawn) const {
    if (m_drawnMap && isNormal(m_maps[*m_drawnMap].kind))
        return normalsOfSlopes(drawn, m_maps[*m_drawnMap].kind == MapKind::NormalYDown);
    return drawn;
}

bool NoisePainter::isShown(const NoiseRequest& request) const {
    return request.texton == m_texton && request.mixture == m_mixture && request.maps == m_maps &&
           request.map == m_map && usesCard(request) == m_onCard;
}

void NoisePainter::prepare(const NoiseRequest& request) {
    if (!isShown(request))
        show(request);
    showMap(request.mixingMap);
}

void NoisePainter::rehearse(const NoiseRequest& request) {
    if (!usesCard(request))
        return;
    prepare(request);
    static_cast<void>(drawOnCard(request, scaled(request.size, 1.0), 1.0, [] { return false; }));
}

Result<std::optional<NoiseFrame>>
NoisePainter::draw(const NoiseRequest& request, double scale, const std::function<bool()>& stop) {
    using Clock = std::chrono::steady_clock;
    // Uploading a texton or a mesh costs the same at any size, and must not count as cost per
    // pixel.
    const bool warm = isShown(request) &&
                      (!std::holds_alternative<MeshView>(request.view) || request.mesh == m_mesh);
    const Size size = scaled(request.size, scale);
    prepare(request);
    const auto start = Clock::now();
    auto image = drawAnyway(request, size, scale, stop);
    if (!image)
        return image.error();
    if (!*image)
        return std::optional<NoiseFrame>();
    const double nanoseconds =
        std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    if (warm && size.area() >= kTellingPixels) {
        double& cost = m_cost[request.view.index()];
        const double now = nanoseconds / static_cast<double>(size.area());
        cost = cost > 0.0 ? 0.7 * cost + 0.3 * now : now;
    }

    NoiseFrame frame;
    frame.image = toQImage(**image, request.display);
    frame.clippedShare = shareOutside(**image);
    frame.samples = std::make_shared<const Image>(std::move(**image));
    frame.request = request;
    frame.onProcessor = !m_onCard;
    frame.milliseconds = nanoseconds / 1e6;
    frame.fetchesPerPixel =
        request.style.noise.meanImpacts * fetchesPerImpact(m_shown->front().interpolationOrder);
    return std::optional<NoiseFrame>(std::move(frame));
}

/// As drawOnCard, or by what stands in for it.
Result<std::optional<Image>> NoisePainter::drawAnyway(const NoiseRequest& request,
                                                      Size size,
                                                      double scale,
                                                      const std::function<bool()>& stop) {
    if (m_onCard) {
        auto image = drawOnCard(request, size, scale, stop);
        if (m_context->isLost()) { // the driver was reset: once more, in another context
            loseContext();
            prepare(request);
            if (m_onCard)
                image = drawOnCard(request, size, scale, stop);
        }
        if (m_onCard && !image && image.error().code == ErrorCode::Unsupported) {
            m_refused[request.view.index()] = true;
            m_problem = image.error().message;
            prepare(request);
        }
        if (m_onCard)
            return image;
    }
    return drawOnProcessor(request, size, scale, stop);
}

Result<std::optional<Image>> NoisePainter::drawOnCard(const NoiseRequest& request,
                                                      Size size,
                                                      double scale,
                                                      const std::function<bool()>& stop) {
    const GlContext& gl = m_context->gl();
    if (!m_target || m_target.size() != size) {
        m_target = {};
        auto target = OffscreenTarget::create(gl, size);
        if (!target)
            return target.error();
        m_target = std::move(*target);
    }
    m_renderer.setTextons(m_shown);
    m_renderer.setReliefs(m_reliefs);
    const View view = atScale(request.view, scale);
    if (std::holds_alternative<MeshView>(view) && request.mesh != m_mesh) {
        m_renderer.setMesh(request.mesh);
        m_mesh = request.mesh;
    }
    const double known = m_cost[view.index()] > 0.0 ? m_cost[view.index()] : kUnknownCost;
    const int rows =
        std::clamp(static_cast<int>(kPieceMs * 1e6 / (known * size.width)), 16, size.height);
    for (int y = 0; y < size.height; y += rows) {
        if (y > 0 && stop())
            return std::optional<Image>();
        const int count = std::min(rows, size.height - y);
        const Rect piece{0, y, {size.width, count}};
        if (auto ok = m_renderer.draw(gl, view, request.style, m_target, piece); !ok)
            return ok.error();
        m_context->finish();
    }
    // A material's fourth channel is no transparency.
    const Texton& first = m_shown->front();
    const int channels = m_reliefs ? kColors : first.channels();
    return std::optional<Image>(finished(m_target.read(channels, first.transfer)));
}

Result<std::optional<Image>> NoisePainter::drawOnProcessor(const NoiseRequest& request,
                                                           Size size,
                                                           double scale,
                                                           const std::function<bool()>& stop) {
    // Other views need OpenGL: the plane stands in for them.
    PlaneView plane;
    if (const auto* asked = std::get_if<PlaneView>(&request.view))
        plane = *asked;
    const double zoom = std::clamp(plane.zoom * scale, NoiseGrid::kMinScale, NoiseGrid::kMaxScale);
    Mixture mixture;
    mixture.textons = *m_shown;
    if (m_mixingMap)
        mixture.map = *m_mixingMap;
    auto grid = NoiseGrid::create(std::move(mixture), request.style.noise, zoom);
    if (!grid)
        return grid.error();
    const auto left = std::llround(plane.centerX * zoom - size.width / 2.0);
    const auto top = std::llround(plane.centerY * zoom - size.height / 2.0);
    const int channels = m_shown->front().channels();
    const int bandRows = std::max(1, grid->tileSize().height); // tiles are computed whole anyway
    Image whole(size, channels, 0.0F, m_shown->front().transfer);
    for (int y = 0; y < size.height; y += bandRows) {
        if (y > 0 && stop())
            return std::optional<Image>();
        const int rows = std::min(bandRows, size.height - y);
        const auto band = grid->render({left, top + y, {size.width, rows}});
        if (!band)
            return band.error();
        for (int c = 0; c < channels; ++c) {
            for (int row = 0; row < rows; ++row)
                std::ranges::copy(band->row(c, row), whole.row(c, y + row).begin());
        }
    }
    return std::optional<Image>(finished(std::move(whole)));
}

} // namespace txn::app
