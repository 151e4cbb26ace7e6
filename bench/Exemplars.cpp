// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Exemplars.h"

#include "core/image/ImageIo.h"
#include "core/samples/Samples.h"

#include <cstdio>

namespace txn::bench {

std::optional<Exemplar> photograph(const char* fileName) {
    auto loaded = loadImage(std::filesystem::path(TXN_SHARED_EXEMPLARS) / fileName);
    if (!loaded)
        return std::nullopt;
    return *makeExemplar(std::move(loaded->image), fileName);
}

Exemplar photographOrSample(const char* fileName, Size size) {
    if (auto exemplar = photograph(fileName))
        return std::move(*exemplar);
    std::fprintf(stderr, "%s is not here: a generated material takes its place\n", fileName);
    return *makeExemplar(*makeSample("rust", size, Seed{1}), "rust");
}

} // namespace txn::bench
