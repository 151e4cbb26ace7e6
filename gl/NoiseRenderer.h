// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/TriangleMesh.h"
#include "core/mixing/TextonField.h"
#include "core/texton/Texton.h"
#include "gl/NoiseStyle.h"
#include "gl/OffscreenTarget.h"
#include "gl/SharedTextons.h"
#include "gl/View.h"

#include <memory>
#include <optional>

namespace txn {

/// Draws noise of textons and mixtures: that of SpotNoise and NoiseGrid, in any view. What it draws
/// is set without a context; what that needs on the graphics card is made when it is drawn, and
/// made again once that context is gone. To move to another context while the old one lives,
/// release() in the old one first. Move-only; draw() and release() belong to the context's thread.
class NoiseRenderer {
  public:
    NoiseRenderer();
    NoiseRenderer(NoiseRenderer&&) noexcept;
    NoiseRenderer& operator=(NoiseRenderer&&) noexcept;
    /// The context that was drawn with last must be current or gone.
    ~NoiseRenderer();

    /// texton: 1 to 4 channels, shown as grey (1), as red and green (2), as colours (3), as colours
    /// and alpha (4).
    void setTexton(std::shared_ptr<const Texton> texton);
    /// Set: the texton's first four channels are the base of a material, which is shaded under the
    /// style's light (see MaterialTextons). Null: nothing is shaded but meshes.
    void setRelief(std::shared_ptr<const Texton> relief);
    /// The same for a mixture: textons as checkMixedTextons takes them, as many in the relief. They
    /// are uploaded when they are first drawn; which of them each place takes can be changed
    /// without uploading them again.
    void setTextons(std::shared_ptr<const std::vector<Texton>> textons);
    void setReliefs(std::shared_ptr<const std::vector<Texton>> reliefs);
    /// Only looked at where there are several textons.
    void setField(std::shared_ptr<const TextonField> field);
    /// For mesh views. Computes its tangent field, which may take a moment.
    void setMesh(std::shared_ptr<const TriangleMesh> mesh);

    /// Draws the view over all of target. The caller's framebuffer and viewport are put back; other
    /// state is left as OpenGL starts with it.
    /// Errors: InvalidArgument for values out of range, without a texton or a mesh that suits the
    /// view, or while another living context holds what was drawn with; Unsupported for what the
    /// driver cannot do, such as compiling a shader; TooLarge.
    /// part: only these pixels of the target change, y down; views that take long can be drawn
    /// piece by piece.
    [[nodiscard]] Result<void> draw(const GlContext& context,
                                    const View& view,
                                    const NoiseStyle& style,
                                    const OffscreenTarget& target,
                                    const std::optional<Rect>& part = {});

    /// Gives back everything on the graphics card; the next draw() makes it again.
    void release();

  private:
    struct Card;
    struct MeshData;

    struct CardTextons;

    static Result<void> upload(const GlContext& context,
                               CardTextons& card,
                               const SharedTextons& textons,
                               bool filtered);
    [[nodiscard]] Result<void> checkField(const NoiseParams& params) const;
    Result<void> prepare(const GlContext& context, const View& view, const NoiseStyle& style);

    SharedTextons m_textons;
    SharedTextons m_reliefs;
    std::shared_ptr<const TextonField> m_field;
    std::shared_ptr<const MeshData> m_mesh;
    std::unique_ptr<Card> m_card;
};

/// Errors: InvalidArgument for values that draw() does not take, the first one named.
[[nodiscard]] Result<void> checkView(const View& view);
[[nodiscard]] Result<void> checkStyle(const NoiseStyle& style);

} // namespace txn
