// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

namespace txn {

class GlContext;

/// Owns one OpenGL object; move-only. Empty until something is made in it, so that it can be a
/// member of what exists before any context. The context must be current when an object is made,
/// used or deleted. Once the GlContext that it was made with is gone, so is the object, and nothing
/// is deleted: its number may belong to another object by then.
class GlHandle {
  public:
    enum class Kind { Buffer, VertexArray, Texture, Framebuffer, Renderbuffer, Program };

    GlHandle() = default;
    static GlHandle make(const GlContext& context, Kind kind);

    ~GlHandle() { reset(); }
    GlHandle(GlHandle&& other) noexcept { swap(other); }
    GlHandle& operator=(GlHandle&& other) noexcept {
        GlHandle moved(std::move(other));
        swap(moved);
        return *this;
    }
    GlHandle(const GlHandle&) = delete;
    GlHandle& operator=(const GlHandle&) = delete;

    /// Deletes the object, if there is one.
    void reset() noexcept;
    /// OpenGL's number for it; 0 when empty.
    unsigned id() const { return m_id; }
    explicit operator bool() const { return m_id != 0; }

  private:
    void swap(GlHandle& other) noexcept {
        std::swap(m_kind, other.m_kind);
        std::swap(m_id, other.m_id);
        std::swap(m_life, other.m_life);
    }

    Kind m_kind = Kind::Buffer;
    unsigned m_id = 0;
    std::weak_ptr<const void> m_life;
};

} // namespace txn
