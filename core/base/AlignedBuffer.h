// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace txn {

/// Array of trivial values aligned to a cache line, uninitialised until written. Move-only.
/// FFTW picks its fastest code for such buffers, and the same one on every run.
template <class T>
class AlignedBuffer {
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    static constexpr std::size_t kAlignment = 64;

    AlignedBuffer() = default;
    explicit AlignedBuffer(std::size_t count)
        : m_data(static_cast<T*>(::operator new (std::max<std::size_t>(count, 1) * sizeof(T),
                                                 std::align_val_t{kAlignment}))),
          m_size(count) {}

    T* data() { return m_data.get(); }
    const T* data() const { return m_data.get(); }
    std::size_t size() const { return m_size; }
    T& operator[](std::size_t i) { return m_data.get()[i]; }
    const T& operator[](std::size_t i) const { return m_data.get()[i]; }
    std::span<T> span() { return {data(), m_size}; }
    std::span<const T> span() const { return {data(), m_size}; }
    void fill(const T& value) { std::fill_n(data(), m_size, value); }

  private:
    struct Free {
        void operator()(T* p) const { ::operator delete (p, std::align_val_t{kAlignment}); }
    };
    std::unique_ptr<T, Free> m_data;
    std::size_t m_size = 0;
};

} // namespace txn
