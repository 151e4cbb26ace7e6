// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sheet/ContactSheet.h"

#include "core/image/ColorTransfer.h"
#include "core/image/TextLabel.h"

#include <algorithm>
#include <cmath>

namespace txn {
namespace {

constexpr float kGround = 0.169F; // #2b2b2b
constexpr float kText = 0.902F;   // #e6e6e6
constexpr int kMargin = 24;
constexpr int kGap = 16;
constexpr int kLabelHeight = 18;
constexpr int kTitleHeight = 24;
constexpr int kLine = 32; ///< a label with its space
constexpr int kColumns = 2;
constexpr int kHeader = kMargin + kTitleHeight + kGap;

void paste(const Image& picture, int left, int top, Image& sheet) {
    const Image encoded = toEncoded(picture);
    for (int c = 0; c < 3; ++c) {
        const int source = encoded.channels() >= 3 ? c : 0;
        for (int y = 0; y < encoded.height(); ++y) {
            const auto from = encoded.row(source, y);
            std::copy(from.begin(), from.end(), sheet.row(c, top + y).begin() + left);
        }
    }
}

/// Ground and title, with room for content of that size from (kMargin, kHeader) on.
Result<Image> emptySheet(const std::string& title, Size content) {
    Image sheet({2 * kMargin + content.width, kHeader + content.height + kMargin}, 3, kGround);
    if (const auto ok =
            drawText(sheet, kMargin, kMargin + kTitleHeight, kTitleHeight, title, kText);
        !ok)
        return ok.error();
    return sheet;
}

Result<void> addPanel(const Panel& panel, int left, int top, Image& sheet) {
    if (auto ok = drawText(sheet, left, top + kLine - 10, kLabelHeight, panel.label, kText); !ok)
        return ok;
    paste(panel.image, left, top + kLine, sheet);
    return {};
}

} // namespace

Result<Image> contactSheet(const std::string& title, std::span<const Panel> panels) {
    Size cell{kTitleHeight * 12, 1};
    for (const Panel& panel : panels) {
        cell.width = std::max(cell.width, panel.image.width());
        cell.height = std::max(cell.height, panel.image.height());
    }
    const int rows = (static_cast<int>(panels.size()) + kColumns - 1) / kColumns;
    auto sheet = emptySheet(title,
                            {kColumns * cell.width + (kColumns - 1) * kGap,
                             rows * (kLine + cell.height) + (rows - 1) * kGap});
    for (std::size_t i = 0; sheet && i < panels.size(); ++i) {
        const int column = static_cast<int>(i) % kColumns;
        const int row = static_cast<int>(i) / kColumns;
        const auto ok = addPanel(panels[i],
                                 kMargin + column * (cell.width + kGap),
                                 kHeader + row * (kLine + cell.height + kGap),
                                 *sheet);
        if (!ok)
            return ok.error();
    }
    return sheet;
}

Result<Image> rowSheet(const std::string& title, std::span<const std::vector<Panel>> rows) {
    Size content{kTitleHeight * 12, -kGap};
    std::vector<int> heights;
    for (const auto& row : rows) {
        int width = -kGap;
        int height = 0;
        for (const Panel& panel : row) {
            width += kGap + panel.image.width();
            height = std::max(height, kLine + panel.image.height());
        }
        content.width = std::max(content.width, width);
        content.height += kGap + height;
        heights.push_back(height);
    }
    auto sheet = emptySheet(title, content);
    int top = kHeader;
    for (std::size_t r = 0; sheet && r < rows.size(); ++r) {
        int left = kMargin;
        for (const Panel& panel : rows[r]) {
            if (const auto ok = addPanel(panel, left, top, *sheet); !ok)
                return ok.error();
            left += panel.image.width() + kGap;
        }
        top += heights[r] + kGap;
    }
    return sheet;
}

Image textonPicture(const Texton& texton, Size limit) {
    const Size support = texton.support.size();
    const Size footprint = texton.footprint();
    const int count = texton.kernelCount();
    const int gap = count > 1 ? 1 : 0;
    const Size natural{count * (support.width + gap) - gap, support.height};
    const int zoom =
        std::max(1, std::min(limit.width / natural.width, limit.height / natural.height));
    const double gain = std::sqrt(static_cast<double>(footprint.area()));
    Image picture({natural.width * zoom, natural.height * zoom},
                  texton.channels(),
                  0.0F,
                  texton.transfer);
    for (int c = 0; c < texton.channels(); ++c) {
        const double mean = texton.mean[static_cast<std::size_t>(c)];
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const int column = x / zoom;
                const int q = column / (support.width + gap);
                const int kx = column % (support.width + gap);
                const double value =
                    kx < support.width && q < count
                        ? gain * texton.kernels[static_cast<std::size_t>(q)].at(kx, y / zoom, c)
                        : 0.0;
                picture.at(x, y, c) = static_cast<float>(mean + value);
            }
        }
    }
    return picture;
}

} // namespace txn
