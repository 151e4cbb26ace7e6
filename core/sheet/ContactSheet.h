// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/image/Image.h"
#include "core/texton/Texton.h"

#include <span>
#include <string>
#include <vector>

namespace txn {

/// One picture of a contact sheet and the line above it.
struct Panel {
    std::string label;
    Image image;
};

/// Panels two abreast on a dark grey ground under a title, each label above its picture: RGB,
/// Encoded. Panels show one or three channels (the first three of more), linear ones encoded.
/// Errors: Unsupported if the system has no font for the labels.
[[nodiscard]] Result<Image> contactSheet(const std::string& title, std::span<const Panel> panels);

/// The same with panels in rows of their own, from the left: as figures show a mixture.
[[nodiscard]] Result<Image> rowSheet(const std::string& title,
                                     std::span<const std::vector<Panel>> rows);

/// The kernels of a texton as a picture, the way the papers show them: mean plus coefficients at
/// the contrast of a spot noise of one impact per pixel, kernels side by side, magnified by whole
/// factors to fit limit. Values may lie outside [0, 1].
[[nodiscard]] Image textonPicture(const Texton& texton, Size limit);

} // namespace txn
