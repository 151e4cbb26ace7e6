// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sheet/ContactSheet.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QtTest>

using namespace txn;
using namespace txn::test;

class TestContactSheet : public QObject {
    Q_OBJECT

  private slots:
    void pictureOfATexton() {
        const Texton texton = makeTexton({1, 1, {9, 7}, 3, 1});
        const Image picture = textonPicture(texton, {40, 40});
        QCOMPARE(picture.size(), (Size{36, 28})); // four times, and no fifth
        QCOMPARE(picture.channels(), 3);
        QVERIFY(allFinite(picture.samples()));
        const double gain = std::sqrt(11.0 * 9.0);
        for (int y = 0; y < 28; ++y) {
            for (int x = 0; x < 36; ++x) {
                for (int c = 0; c < 3; ++c) {
                    const double expected =
                        texton.mean[static_cast<std::size_t>(c)] +
                        gain * static_cast<double>(texton.kernels[0].at(x / 4, y / 4, c));
                    TXN_AT_MOST(std::abs(static_cast<double>(picture.at(x, y, c)) - expected),
                                1e-5);
                }
            }
        }
        // Never smaller than the kernel, even where the limit is.
        QCOMPARE(textonPicture(texton, {4, 3}).size(), (Size{9, 7}));
    }

    void kernelsStandSideBySide() {
        Texton texton = makeTexton({1, 3, {5, 4}, 1, 2});
        texton.transfer = Transfer::Linear;
        const Image picture = textonPicture(texton, {34, 100});
        QCOMPARE(picture.size(), (Size{34, 8})); // (3 * 5 + 2 gaps) * 2
        QVERIFY(picture.transfer() == Transfer::Linear);
        const double gain = std::sqrt(7.0 * 6.0);
        for (int q = 0; q < 3; ++q) {
            const auto& kernel = texton.kernels[static_cast<std::size_t>(q)];
            TXN_AT_MOST(std::abs(static_cast<double>(picture.at(2 * (6 * q + 3), 5, 0)) -
                                 texton.mean[0] - gain * static_cast<double>(kernel.at(3, 2, 0))),
                        1e-5);
        }
        TXN_AT_MOST(std::abs(static_cast<double>(picture.at(10, 3, 0)) - texton.mean[0]), 1e-6);
    }

    void rowsHoldTheirPanels() {
        const std::vector<std::vector<Panel>> rows{
            {{"first", texturedImage({60, 50}, 3, 3)}, {"second", texturedImage({40, 70}, 1, 4)}},
            {{"wide", texturedImage({500, 30}, 3, 5)}}};
        const auto sheet = rowSheet("A title", rows);
        if (!sheet && sheet.error().code == ErrorCode::Unsupported)
            QSKIP("no font on this system");
        TXN_OK(sheet);
        QCOMPARE(sheet->width(), 500 + 2 * 24);
        // The second panel of the first row stands right of the first one, at the same height.
        const auto holds = [&](const Image& image, int left, int top) {
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (sheet->at(left + x, top + y, 0) != image.at(x, y, 0))
                        return false;
                }
            }
            return true;
        };
        const int top = 24 + 24 + 16 + 32;
        QVERIFY(holds(rows[0][0].image, 24, top));
        QVERIFY(holds(rows[0][1].image, 24 + 60 + 16, top));
        QVERIFY(holds(rows[1][0].image, 24, top + 70 + 16 + 32));
    }

    void sheetsHoldTheirPanels() {
        const std::vector<Panel> panels{{"exemplar", texturedImage({60, 50}, 3, 3)},
                                        {"grey", texturedImage({40, 70}, 1, 4)},
                                        {"stack", texturedImage({64, 64}, 5, 5)}};
        const auto sheet =
            contactSheet("A title with \xc3\xa9 and a very long text behind it", panels);
        if (!sheet && sheet.error().code == ErrorCode::Unsupported)
            QSKIP("no font on this system");
        TXN_OK(sheet);
        QCOMPARE(sheet->channels(), 3);
        QVERIFY(sheet->transfer() == Transfer::Encoded);
        QVERIFY(allFinite(sheet->samples()));
        QVERIFY(sheet->width() >= 2 * 64 && sheet->height() >= 2 * 70);
        // Every panel is there, pixel by pixel, its first corner found somewhere.
        for (const Panel& panel : panels) {
            bool found = false;
            for (int top = 0; top + panel.image.height() <= sheet->height() && !found; ++top) {
                for (int left = 0; left + panel.image.width() <= sheet->width() && !found; ++left)
                    found = holds(*sheet, left, top, panel.image);
            }
            QVERIFY2(found, panel.label.c_str());
        }
        // Labels and title leave marks on the ground.
        const auto blank = contactSheet("", std::vector<Panel>{{"", panels[0].image}});
        const auto marked = contactSheet("Title", std::vector<Panel>{{"label", panels[0].image}});
        TXN_OK(blank);
        TXN_OK(marked);
        QCOMPARE(blank->size(), marked->size());
        QVERIFY(!(*blank == *marked));
    }

    void linearPanelsAreEncoded() {
        Image linear({20, 20}, 3, 0.2140411F, Transfer::Linear);
        const auto sheet = contactSheet("t", std::vector<Panel>{{"p", linear}});
        if (!sheet && sheet.error().code == ErrorCode::Unsupported)
            QSKIP("no font on this system");
        TXN_OK(sheet);
        // That is one half, encoded.
        int count = 0;
        for (const float v : sheet->plane(0))
            count += std::abs(v - 0.5F) < 1e-4F ? 1 : 0;
        QVERIFY(count >= 400);
    }

    void sheetsMayBeEmpty() {
        const auto sheet = contactSheet("nothing", {});
        if (!sheet && sheet.error().code == ErrorCode::Unsupported)
            QSKIP("no font on this system");
        TXN_OK(sheet);
        QVERIFY(allFinite(sheet->samples()));
    }

  private:
    static bool holds(const Image& sheet, int left, int top, const Image& panel) {
        for (int y = 0; y < panel.height(); ++y) {
            for (int x = 0; x < panel.width(); ++x) {
                for (int c = 0; c < 3; ++c) {
                    const int source = panel.channels() >= 3 ? c : 0;
                    if (sheet.at(left + x, top + y, c) != panel.at(x, y, source))
                        return false;
                }
            }
        }
        return true;
    }
};

QTEST_APPLESS_MAIN(TestContactSheet)
#include "TestContactSheet.moc"
