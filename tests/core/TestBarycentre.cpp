// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gaussian/Barycentre.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Threads.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

namespace {

Exemplar lightened(const Exemplar& exemplar, float factor, float offset) {
    Image image = exemplar.image;
    for (float& v : image.samples())
        v = offset + factor * v;
    return exemplarOf(std::move(image));
}

/// What decides on the texture: t_i conj(t_j) of all channels at all frequencies.
std::vector<double> crossSpectra(const GaussianModel& model) {
    std::vector<double> values;
    for (int i = 0; i < model.channels(); ++i) {
        for (int j = 0; j < model.channels(); ++j) {
            for (int y = 0; y < model.domain().height; ++y) {
                for (int x = 0; x < model.spot(i).columns(); ++x) {
                    const auto product = std::complex<double>(model.spot(i).at(y, x)) *
                                         std::conj(std::complex<double>(model.spot(j).at(y, x)));
                    values.push_back(product.real());
                    values.push_back(product.imag());
                }
            }
        }
    }
    return values;
}

/// The distance by its definition, frequency by frequency over the whole plane of them.
double naiveDistance(const GaussianModel& u, const GaussianModel& v) {
    double square = 0.0;
    const Size size = u.domain();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            // What is not stored is the conjugate of what lies opposite.
            const bool stored = x < u.spot(0).columns();
            const int column = stored ? x : size.width - x;
            const int row = stored ? y : (size.height - y) % size.height;
            std::complex<double> product = 0.0;
            for (int c = 0; c < u.channels(); ++c) {
                const std::complex<double> a(u.spot(c).at(row, column));
                const std::complex<double> b(v.spot(c).at(row, column));
                square += std::norm(a) + std::norm(b);
                product += std::conj(a) * b;
            }
            square -= 2.0 * std::abs(product);
        }
    }
    square /= static_cast<double>(size.area());
    for (std::size_t c = 0; c < u.mean().size(); ++c)
        square += std::pow(u.mean()[c] - v.mean()[c], 2);
    return std::sqrt(square);
}

} // namespace

class TestBarycentre : public QObject {
    Q_OBJECT

  private slots:
    void endsAreTheExemplars_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("channels");
        for (const auto& [w, h, c] : {std::tuple{32, 24, 3},
                                      {31, 23, 3},
                                      {32, 23, 1},
                                      {17, 30, 2},
                                      {24, 24, 7},
                                      {33, 1, 3},
                                      {1, 20, 1}})
            QTest::addRow("%d x %d, %d channels", w, h, c) << w << h << c;
    }
    void endsAreTheExemplars() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, channels);
        const Size size{width, height};
        const GaussianModel a = texturedModel(size, channels, 1);
        const GaussianModel b(exemplarOf(randomImage(size, channels, 2)));
        const auto path =
            BarycentrePath::create(texturedModel(size, channels, 1),
                                   GaussianModel(exemplarOf(randomImage(size, channels, 2))));
        TXN_OK(path);
        TXN_AT_MOST(relativeError(crossSpectra(path->at(0.0)), crossSpectra(a)), 1e-5);
        TXN_AT_MOST(relativeError(crossSpectra(path->at(1.0)), crossSpectra(b)), 1e-6);
        TXN_AT_MOST(largestDifference(path->at(0.0).mean(), a.mean()), 1e-12);
        TXN_AT_MOST(largestDifference(path->at(1.0).mean(), b.mean()), 1e-12);
        TXN_AT_MOST(std::abs(path->distance() - naiveDistance(a, b)), 1e-6 * path->distance());

        // The shortest way: distances add up, and grow in proportion to rho.
        for (const auto& [from, to] : {std::pair{0.0, 0.3}, {0.3, 0.85}, {0.5, 1.0}, {0.0, 1.0}}) {
            const double part = transportDistance(path->at(from), path->at(to));
            TXN_AT_MOST(std::abs(part - (to - from) * path->distance()), 1e-5 * path->distance());
        }
        TXN_AT_MOST(std::abs(path->distanceTo(path->at(0.4)) - 0.4 * path->distance()),
                    1e-5 * path->distance());
        const double half = 0.5 * (a.mean()[0] + b.mean()[0]);
        TXN_AT_MOST(std::abs(path->at(0.5).mean()[0] - half), 1e-12);
    }

    void swappingTurnsThePathAround() {
        const Size size{30, 26};
        const auto there = BarycentrePath::create(exemplarOf(texturedImage(size, 3, 1)),
                                                  exemplarOf(randomImage(size, 3, 2)));
        const auto back = BarycentrePath::create(exemplarOf(randomImage(size, 3, 2)),
                                                 exemplarOf(texturedImage(size, 3, 1)));
        TXN_AT_MOST(std::abs(there->distance() - back->distance()), 1e-9);
        for (const double rho : {0.0, 0.2, 0.5, 0.9}) {
            TXN_AT_MOST(
                relativeError(crossSpectra(there->at(rho)), crossSpectra(back->at(1.0 - rho))),
                1e-5);
        }
    }

    void knownDistances() {
        const Exemplar a = exemplarOf(texturedImage({40, 32}, 1, 5));
        const double deviation = std::sqrt(GaussianModel(a).covariance()(0, 0));
        // More contrast: that much further; another mean: the difference.
        const auto stronger = BarycentrePath::create(a, lightened(a, 3.0F, 0.0F));
        const double mean = GaussianModel(a).mean()[0];
        TXN_AT_MOST(std::abs(stronger->distance() - 2.0 * std::hypot(deviation, mean)), 1e-5);
        const auto brighter = BarycentrePath::create(a, lightened(a, 1.0F, 0.25F));
        TXN_AT_MOST(std::abs(brighter->distance() - 0.25), 1e-5);
        // The same texture, shifted around or upside down: no way to go.
        Image turned = a.image;
        std::ranges::reverse(turned.samples());
        const auto same = BarycentrePath::create(a, exemplarOf(std::move(turned)), false, false);
        TXN_AT_MOST(same->distance(), 1e-6);
        // Of one channel all amplitudes are interpolated, not powers.
        TXN_AT_MOST(std::abs(std::sqrt(stronger->at(0.5).covariance()(0, 0)) - 2.0 * deviation),
                    1e-6);
    }

    void materialsWithoutACommonFrequencyMix() {
        const Size size{32, 32};
        Image stripes(size, 1);
        Image rows(size, 1);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                stripes.at(x, y, 0) = x % 2 == 0 ? 0.0F : 1.0F;
                rows.at(x, y, 0) = y % 2 == 0 ? 0.0F : 1.0F;
            }
        }
        const auto path = BarycentrePath::create(exemplarOf(std::move(stripes)),
                                                 exemplarOf(std::move(rows)),
                                                 false,
                                                 false);
        TXN_OK(path);
        TXN_AT_MOST(std::abs(path->distance() - std::sqrt(0.5)), 1e-5);
        const auto middle = path->at(0.5);
        QVERIFY(allFinite(crossSpectra(middle)));
        TXN_AT_MOST(std::abs(middle.covariance()(0, 0) - 0.125), 1e-5);
    }

    void sizesMayDiffer() {
        const Exemplar a = exemplarOf(texturedImage({48, 20}, 3, 1));
        const Exemplar b = exemplarOf(texturedImage({30, 40}, 3, 2));
        const auto path = BarycentrePath::create(a, b);
        TXN_OK(path);
        QCOMPARE(path->domain().width, 48);
        QCOMPARE(path->domain().height, 40);
        const GaussianModel own(a);
        const GaussianModel there = path->at(0.0);
        TXN_AT_MOST(largestDifference(there.mean(), own.mean()), 1e-6);
        for (int c = 0; c < 3; ++c)
            TXN_AT_MOST(std::abs(there.covariance()(c, c) / own.covariance()(c, c) - 1.0), 0.15);
    }

    void threadsDoNotMatter() {
        const auto spectra = [](int threads) {
            return onThreads(threads, [] {
                const auto path = BarycentrePath::create(exemplarOf(texturedImage({60, 44}, 3, 1)),
                                                         exemplarOf(texturedImage({60, 44}, 3, 2)));
                auto values = crossSpectra(path->at(0.37));
                values.push_back(path->distance());
                return values;
            });
        };
        QVERIFY(spectra(1) == spectra(4));
    }

    void badInputIsRefused() {
        const Exemplar color = exemplarOf(texturedImage({20, 20}, 3, 1));
        const Exemplar grey = exemplarOf(texturedImage({20, 20}, 1, 1));
        const Exemplar flat = exemplarOf(Image({20, 20}, 3, 0.5F));
        TXN_FAILS_WITH(BarycentrePath::create(color, grey), ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(BarycentrePath::create(color, flat), ErrorCode::Degenerate);
        QVERIFY(BarycentrePath::create(color, flat).error().message.find("B") != std::string::npos);
        TXN_FAILS_WITH(BarycentrePath::create(flat, color), ErrorCode::Degenerate);
        QVERIFY(BarycentrePath::create(flat, color).error().message.find("A") != std::string::npos);
        Exemplar linear = color;
        linear.image.setTransfer(Transfer::Linear);
        TXN_FAILS_WITH(BarycentrePath::create(color, linear), ErrorCode::SizeMismatch);
        const auto stack = [](const char* first, MapKind kind) {
            return *makeExemplar(texturedImage({20, 20}, 3, 1),
                                 "stack",
                                 {{first, MapKind::Height, 1}, {"n", kind, 2}});
        };
        TXN_FAILS_WITH(BarycentrePath::create(color, stack("h", MapKind::Normal)),
                       ErrorCode::SizeMismatch);
        TXN_FAILS_WITH(
            BarycentrePath::create(stack("rough", MapKind::Normal), stack("h", MapKind::Normal)),
            ErrorCode::SizeMismatch);
        QVERIFY(
            BarycentrePath::create(stack("h", MapKind::NormalYDown), stack("h", MapKind::Normal)));
        TXN_FAILS_WITH(
            BarycentrePath::create(texturedModel({20, 20}, 3, 1), texturedModel({20, 21}, 3, 1)),
            ErrorCode::SizeMismatch);
    }
};

QTEST_APPLESS_MAIN(TestBarycentre)
#include "TestBarycentre.moc"
