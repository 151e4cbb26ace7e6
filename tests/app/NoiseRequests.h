// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/NoiseFrame.h"
#include "core/mesh/BuiltinMeshes.h"
#include "tests/helpers/Gl.h"
#include "tests/helpers/Textons.h"

namespace txn::test {

/// A small picture of a small texton, always the same one.
inline app::NoiseRequest smallRequest(const View& view) {
    static const auto texton = shared(makeTexton({}));
    app::NoiseRequest request;
    request.texton = texton;
    request.mesh = std::make_shared<const TriangleMesh>(planeMesh(2));
    request.view = view;
    request.size = {90, 60};
    return request;
}

} // namespace txn::test
