// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/NoiseFrame.h"
#include "gl/HeadlessContext.h"
#include "gl/NoiseRenderer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace txn::app {

/// Draws requests, by OpenGL or, without it, on the processor. All on one thread.
class NoisePainter {
  public:
    NoisePainter();

    const std::string& renderer() const { return m_rendererName; }
    const std::string& problem() const { return m_problem; }
    void loseContext();

    /// How much smaller than asked for a picture should be to be drawn in the given time, 1 or
    /// less; told from what the last ones of its kind took.
    double scaleFor(const NoiseRequest& request, double milliseconds) const;

    /// A frame of scale times the request's size, not yet marked as complete. stop is asked between
    /// pieces of some 20 ms; nothing if it says so. Where the driver cannot, such as when it
    /// refuses a shader, the processor stands in for this kind of view from then on, and problem()
    /// says why. Errors: those of NoiseRenderer and NoiseGrid.
    [[nodiscard]] Result<std::optional<NoiseFrame>>
    draw(const NoiseRequest& request, double scale, const std::function<bool()>& stop);
    /// Draws by OpenGL what is asked for later, so that its shaders are compiled by then.
    void rehearse(const NoiseRequest& request);

  private:
    static constexpr std::size_t kViews = std::variant_size_v<View>;
    bool usesCard(const NoiseRequest& request) const {
        return m_context && !m_refused[request.view.index()];
    }
    bool isShown(const NoiseRequest& request) const;
    void prepare(const NoiseRequest& request);
    void show(const NoiseRequest& request);
    void showMap(const std::shared_ptr<const MixingMap>& map);
    Image finished(Image drawn) const;
    Result<std::optional<Image>> drawAnyway(const NoiseRequest& request,
                                            Size size,
                                            double scale,
                                            const std::function<bool()>& stop);
    Result<std::optional<Image>> drawOnCard(const NoiseRequest& request,
                                            Size size,
                                            double scale,
                                            const std::function<bool()>& stop);
    Result<std::optional<Image>> drawOnProcessor(const NoiseRequest& request,
                                                 Size size,
                                                 double scale,
                                                 const std::function<bool()>& stop);

    std::optional<HeadlessContext> m_context;
    NoiseRenderer m_renderer;
    OffscreenTarget m_target;
    std::string m_rendererName;
    std::string m_problem;
    using Textons = std::shared_ptr<const std::vector<Texton>>;

    // As requested.
    std::shared_ptr<const Texton> m_texton;
    Textons m_mixture;
    std::shared_ptr<const MixingMap> m_mixingMap;
    MaterialMaps m_maps;
    std::optional<std::size_t> m_map;
    std::optional<std::size_t> m_drawnMap; ///< alone
    bool m_onCard = false;
    Textons m_shown;   ///< one, or those of a mixture: first channels, a map's, or a material's
    Textons m_reliefs; ///< of a shaded material
    std::shared_ptr<const TriangleMesh> m_mesh;
    std::array<double, kViews> m_cost{};  ///< nanoseconds per pixel by kind of view; 0: unknown
    std::array<bool, kViews> m_refused{}; ///< kinds of views that the driver cannot draw
};

} // namespace txn::app
