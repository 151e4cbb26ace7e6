// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spectral/Fft.h"

#include <algorithm>
#include <cassert>
#include <fftw3.h>
#include <mutex>
#include <new>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace txn {
namespace {

constexpr int kLanes = FftPlan::kLanes;

/// FFTW's planner is not thread-safe; this is the one mutable static of the library.
std::mutex& plannerMutex() {
    static std::mutex mutex;
    return mutex;
}

fftwf_complex* raw(Complex* p) {
    return reinterpret_cast<fftwf_complex*>(p);
}

Complex* complexAt(HalfSpectrum& spectrum, int block, int row) {
    return spectrum.block(block).data() + static_cast<std::size_t>(row) * kLanes;
}

/// Owns one FFTW plan.
struct Plan {
    fftwf_plan plan = nullptr;

    explicit Plan(fftwf_plan p) : plan(p) {
        if (plan == nullptr)
            throw std::bad_alloc();
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    ~Plan() {
        const std::lock_guard lock(plannerMutex());
        fftwf_destroy_plan(plan);
    }
};

} // namespace

int fastLength(int n) {
    for (;; ++n) {
        int rest = n;
        for (const int p : {2, 3, 5, 7}) {
            while (rest % p == 0)
                rest /= p;
        }
        if (rest == 1)
            return n;
    }
}

struct FftPlan::State : Plan {
    using Plan::Plan;
};

FftPlan::FftPlan(std::unique_ptr<State> state) : m_state(std::move(state)) {}
FftPlan::FftPlan(FftPlan&&) noexcept = default;
FftPlan& FftPlan::operator=(FftPlan&&) noexcept = default;
FftPlan::~FftPlan() = default;

FftPlan FftPlan::realForward(int length) {
    AlignedBuffer<float> in(static_cast<std::size_t>(length));
    AlignedBuffer<Complex> out(static_cast<std::size_t>(length / 2 + 1));
    const std::lock_guard lock(plannerMutex());
    return FftPlan(std::make_unique<State>(
        fftwf_plan_dft_r2c_1d(length, in.data(), raw(out.data()), FFTW_ESTIMATE)));
}

FftPlan FftPlan::realInverse(int length) {
    AlignedBuffer<Complex> in(static_cast<std::size_t>(length / 2 + 1));
    AlignedBuffer<float> out(static_cast<std::size_t>(length));
    const std::lock_guard lock(plannerMutex());
    return FftPlan(
        std::make_unique<State>(fftwf_plan_dft_c2r_1d(length,
                                                      raw(in.data()),
                                                      out.data(),
                                                      FFTW_ESTIMATE | FFTW_DESTROY_INPUT)));
}

namespace {

fftwf_plan planColumns(int length, int sign) {
    AlignedBuffer<Complex> lanes(static_cast<std::size_t>(length) * kLanes);
    const std::lock_guard lock(plannerMutex());
    return fftwf_plan_many_dft(1,
                               &length,
                               kLanes,
                               raw(lanes.data()),
                               nullptr,
                               kLanes,
                               1,
                               raw(lanes.data()),
                               nullptr,
                               kLanes,
                               1,
                               sign,
                               FFTW_ESTIMATE);
}

} // namespace

FftPlan FftPlan::columnsForward(int length) {
    return FftPlan(std::make_unique<State>(planColumns(length, FFTW_FORWARD)));
}

FftPlan FftPlan::columnsInverse(int length) {
    return FftPlan(std::make_unique<State>(planColumns(length, FFTW_BACKWARD)));
}

void FftPlan::run(const float* in, Complex* out) const {
    // FFTW takes a mutable pointer, but an out-of-place r2c transform leaves its input alone.
    fftwf_execute_dft_r2c(m_state->plan, const_cast<float*>(in), raw(out));
}

void FftPlan::run(Complex* in, float* out) const {
    fftwf_execute_dft_c2r(m_state->plan, raw(in), out);
}

void FftPlan::run(Complex* inOut) const {
    fftwf_execute_dft(m_state->plan, raw(inOut), raw(inOut));
}

HalfSpectrum::HalfSpectrum(Size imageSize)
    : m_size(imageSize), m_data(static_cast<std::size_t>(blocksFor(imageSize.width)) *
                                static_cast<std::size_t>(imageSize.height) * kLanes) {
    for (int row = 0; row < imageSize.height; ++row) {
        for (int column = columns(); column < blocks() * kLanes; ++column)
            at(row, column) = Complex{};
    }
}

RealFft2d::RealFft2d(Size size)
    : m_size(size), m_rowForward(FftPlan::realForward(size.width)),
      m_rowInverse(FftPlan::realInverse(size.width)),
      m_columnForward(FftPlan::columnsForward(size.height)),
      m_columnInverse(FftPlan::columnsInverse(size.height)) {}

HalfSpectrum RealFft2d::forward(std::span<const float> plane, float offset) const {
    assert(plane.size() == m_size.area());
    HalfSpectrum spectrum(m_size);
    const auto width = static_cast<std::size_t>(m_size.width);
    tbb::parallel_for(tbb::blocked_range<int>(0, m_size.height, 8), [&](const auto& rows) {
        AlignedBuffer<float> line(width);
        AlignedBuffer<Complex> out(static_cast<std::size_t>(spectrum.blocks()) * kLanes);
        out.fill({});
        for (int y = rows.begin(); y != rows.end(); ++y) {
            const auto source = plane.subspan(static_cast<std::size_t>(y) * width, width);
            std::transform(source.begin(), source.end(), line.data(), [offset](float v) {
                return v + offset;
            });
            m_rowForward.run(line.data(), out.data());
            for (int b = 0; b < spectrum.blocks(); ++b)
                std::copy_n(out.data() + b * kLanes, kLanes, complexAt(spectrum, b, y));
        }
    });
    tbb::parallel_for(0, spectrum.blocks(), [&](int b) {
        m_columnForward.run(spectrum.block(b).data());
    });
    return spectrum;
}

void RealFft2d::inverse(HalfSpectrum&& spectrum, std::span<float> plane) const {
    assert(plane.size() == m_size.area() && spectrum.imageSize() == m_size);
    HalfSpectrum scratch = std::move(spectrum);
    tbb::parallel_for(0, scratch.blocks(), [&](int b) {
        m_columnInverse.run(scratch.block(b).data());
    });
    const auto width = static_cast<std::size_t>(m_size.width);
    const float scale = 1.0F / static_cast<float>(m_size.area());
    tbb::parallel_for(tbb::blocked_range<int>(0, m_size.height, 8), [&](const auto& rows) {
        AlignedBuffer<Complex> in(static_cast<std::size_t>(scratch.blocks()) * kLanes);
        AlignedBuffer<float> line(width);
        for (int y = rows.begin(); y != rows.end(); ++y) {
            for (int b = 0; b < scratch.blocks(); ++b)
                std::copy_n(complexAt(scratch, b, y), kLanes, in.data() + b * kLanes);
            m_rowInverse.run(in.data(), line.data());
            std::transform(line.data(),
                           line.data() + width,
                           plane.begin() + static_cast<std::ptrdiff_t>(y) * m_size.width,
                           [scale](float v) { return v * scale; });
        }
    });
}

struct CosineTransform2d::State {
    Plan forward;
    Plan inverse;

    State(fftwf_plan f, fftwf_plan i) : forward(f), inverse(i) {}
};

CosineTransform2d::CosineTransform2d(Size size) : m_size(size), m_values(size.area()) {
    const auto plan = [&](fftw_r2r_kind kind) {
        const std::lock_guard lock(plannerMutex());
        return fftwf_plan_r2r_2d(size.height,
                                 size.width,
                                 m_values.data(),
                                 m_values.data(),
                                 kind,
                                 kind,
                                 FFTW_ESTIMATE);
    };
    m_state = std::make_unique<State>(plan(FFTW_REDFT10), plan(FFTW_REDFT01));
}

CosineTransform2d::CosineTransform2d(CosineTransform2d&&) noexcept = default;
CosineTransform2d& CosineTransform2d::operator=(CosineTransform2d&&) noexcept = default;
CosineTransform2d::~CosineTransform2d() = default;

void CosineTransform2d::forward() {
    fftwf_execute(m_state->forward.plan);
}

void CosineTransform2d::inverse() {
    fftwf_execute(m_state->inverse.plan);
    const float scale = 1.0F / (4.0F * static_cast<float>(m_size.area()));
    for (float& v : m_values.span())
        v *= scale;
}

} // namespace txn
