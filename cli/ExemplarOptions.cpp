// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ExemplarOptions.h"

#include "cli/Parse.h"
#include "cli/Report.h"
#include "core/base/OutputFiles.h"
#include "core/image/ColorTransfer.h"
#include "core/image/ImageGeometry.h"
#include "core/spectral/Lighting.h"

namespace txn::cli {

void addExemplarOptions(CLI::App& app, ExemplarOptions& options) {
    app.add_option("EXEMPLAR", options.path, "Picture of the material")->required();
    addParsed(app, "--crop", options.crop, parseRect, "X,Y,W,H", "Use only this part, in pixels");
    app.add_option("--rotate",
                   options.rotate,
                   "Turn by DEG degrees, counter-clockwise, to straighten grain")
        ->type_name("DEG");
    app.add_option("--flatten", options.flatten, "Even out lighting smoother than RADIUS pixels")
        ->type_name("RADIUS")
        ->check(between(0.5, 1e5));
    app.add_flag("--linear", options.linear, "Convert to linear light first");
}

Result<Exemplar> loadExemplar(const ExemplarOptions& options) {
    const BusySign busy("Preparing the exemplar");
    auto loaded = loadImage(options.path);
    if (!loaded)
        return loaded.error();
    const auto named = [&](const Error& error) {
        return Error{error.code, quoted(options.path) + ": " + error.message};
    };
    Image image = std::move(loaded->image);
    if (options.crop) {
        auto part = crop(image, *options.crop);
        if (!part)
            return named(part.error());
        image = std::move(*part);
    }
    // Before samples that are not numbers can spread by filtering.
    auto exemplar = makeExemplar(std::move(image), options.path.filename().string());
    if (!exemplar)
        return exemplar.error();
    image = std::move(exemplar->image);
    if (options.rotate != 0.0) {
        auto turned = rotated(image, options.rotate);
        if (!turned)
            return named(turned.error());
        image = std::move(*turned);
    }
    if (options.flatten) {
        auto flat = flattenLighting(image, *options.flatten);
        if (!flat)
            return named(flat.error());
        image = std::move(*flat);
    }
    if (options.linear)
        image = toLinear(std::move(image));
    return makeExemplar(std::move(image), options.path.filename().string());
}

} // namespace txn::cli
