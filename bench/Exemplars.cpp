// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Exemplars.h"

#include "core/image/ImageIo.h"
#include "core/samples/Samples.h"

#include <cstdio>

namespace txn::bench {

Exemplar photographOrSample(const char* fileName, Size size) {
    const std::filesystem::path path = std::filesystem::path(TXN_SHARED_EXEMPLARS) / fileName;
    if (auto loaded = loadImage(path))
        return *makeExemplar(std::move(loaded->image), fileName);
    std::fprintf(stderr, "%s is not here: a generated material takes its place\n", fileName);
    return *makeExemplar(*makeSample("rust", size, Seed{1}), "rust");
}

} // namespace txn::bench
