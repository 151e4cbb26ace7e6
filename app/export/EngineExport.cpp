// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/EngineExport.h"

#include "core/base/PlainText.h"
#include "core/noise/Normalization.h"
#include "gl/NoiseUniforms.h"
#include "gl/ShaderLibrary.h"

#include <QFile>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace txn::app {
namespace {

struct Parameters {
    ImpulseProcess impulses;
    ChannelScale scale;

    Parameters(const Texton& texton, const NoiseParams& noise)
        : impulses(noise, texton.footprint(), texton.kernelCount()),
          scale(channelScale(normalization(texton, impulses))) {}
};

/// A float that reads back as the same bits, with a point, as GLSL wants it.
std::string literal(float value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    std::string result(text.data(), end);
    if (result.find_first_of(".e") == std::string::npos)
        result.append(".0");
    return result;
}

std::string literal(const glm::vec4& v) {
    std::string text = "vec4(";
    for (int i = 0; i < 4; ++i)
        text.append(i > 0 ? ", " : "").append(literal(v[i]));
    return text.append(")");
}

void replaceAll(std::string& text, const std::string& what, const std::string& with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

/// Turns the declaration of a uniform into one of a constant.
Result<void> fix(std::string& shader,
                 const std::string& type,
                 const std::string& name,
                 const std::string& value) {
    const std::string declaration =
        std::string("uniform ").append(type).append(" ").append(name).append(";");
    if (shader.find(declaration) == std::string::npos)
        return Error{ErrorCode::Unsupported, "the shader does not declare " + name};
    replaceAll(shader,
               declaration,
               std::string("const ")
                   .append(type)
                   .append(" ")
                   .append(name)
                   .append(" = ")
                   .append(value)
                   .append(";"));
    return {};
}

constexpr const char* kHeader =
    R"(// Texton noise, after Galerne, Leclaire and Moisan (2017). CC0-1.0: use it as you like.
//
//     vec4 textonNoise(vec2 point)
//
// is the endless material at a point in pixels of the exemplar. Bind to txnKernels a
// sampler2DArray with the texels of the .f32 file (RGBA32F, nearest, no mipmaps; the .json file
// tells its size). Everything else is a constant below. It gives points of the noise: where a pixel
// of the picture covers more than one of the exemplar, average over several.
)";

constexpr const char* kEntry = R"(
vec4 textonNoise(vec2 point) {
    return textonNoise(point, vec2(1.0, 0.0), vec2(0.0, 1.0));
}
)";

} // namespace

Result<std::string> engineShader(const Texton& texton, const NoiseParams& noise) {
    if (texton.channels() > 4)
        return Error{ErrorCode::Unsupported, "a shader shows at most 4 channels"};
    ShaderDefines defines{{"TXN_FILTER", "0"},
                          {"TXN_ORDER", std::to_string(texton.interpolationOrder)}};
    addNoiseDefines(defines, noise);
    auto shader = shaderText("texton_noise.glsl", defines);
    if (!shader)
        return shader;
    const Parameters parameters(texton, noise);
    const ImpulseProcess& impulses = parameters.impulses;
    const auto vec2 = [](double x, double y) {
        return std::string("vec2(")
            .append(literal(static_cast<float>(x)))
            .append(", ")
            .append(literal(static_cast<float>(y)))
            .append(")");
    };
    const Size footprint = texton.footprint();
    struct Constant {
        const char* type;
        const char* name;
        std::string value;
    };
    const std::array constants{
        Constant{"uint", "txnSeed", std::to_string(noise.seed.value) + "u"},
        Constant{"int", "txnKernelCount", std::to_string(texton.kernelCount())},
        Constant{"vec2", "txnCell", vec2(impulses.cellWidth(), impulses.cellHeight())},
        Constant{"ivec2",
                 "txnPeriod",
                 std::string("ivec2(")
                     .append(std::to_string(impulses.periodX()))
                     .append(", ")
                     .append(std::to_string(impulses.periodY()))
                     .append(")")},
        Constant{"vec4", "txnGain", literal(parameters.scale.gain)},
        Constant{"vec4", "txnOffset", literal(parameters.scale.offset)},
        Constant{"vec2", "txnFootprint", vec2(footprint.width, footprint.height)}};
    for (const Constant& constant : constants) {
        if (const auto ok = fix(*shader, constant.type, constant.name, constant.value); !ok)
            return ok.error();
    }
    // After the version, which has to come first.
    const auto line = shader->find('\n');
    return shader->substr(0, line + 1) + kHeader + shader->substr(line + 1) + kEntry;
}

std::string kernelTexels(const Texton& texton) {
    const Size size = texton.footprint();
    const int frame = texton.frame();
    std::vector<float> texels(size.area() * texton.kernels.size() * 4);
    for (std::size_t q = 0; q < texton.kernels.size(); ++q) {
        const Image& kernel = texton.kernels[q];
        for (int y = 0; y < kernel.height(); ++y) {
            for (int x = 0; x < kernel.width(); ++x) {
                const std::size_t texel = (q * static_cast<std::size_t>(size.height) +
                                           static_cast<std::size_t>(y + frame)) *
                                              static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x + frame);
                // One channel is grey.
                const int shown = kernel.channels() == 1 ? 3 : kernel.channels();
                for (int c = 0; c < shown; ++c)
                    texels[4 * texel + static_cast<std::size_t>(c)] =
                        kernel.at(x, y, kernel.channels() == 1 ? 0 : c);
            }
        }
    }
    return {reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof(float)};
}

std::string engineParameters(const Texton& texton, const NoiseParams& noise) {
    const Parameters parameters(texton, noise);
    const auto list = [](const glm::vec4& v) { return std::vector<float>{v.x, v.y, v.z, v.w}; };
    nlohmann::ordered_json json;
    json["width"] = texton.footprint().width;
    json["height"] = texton.footprint().height;
    json["kernels"] = texton.kernelCount();
    json["channels"] = texton.channels();
    json["interpolation_order"] = texton.interpolationOrder;
    json["transfer"] = texton.transfer == Transfer::Linear ? "linear" : "srgb";
    json["process"] = toString(noise.process);
    json["mni"] = noise.meanImpacts;
    json["seed"] = noise.seed.value;
    json["cell"] = {parameters.impulses.cellWidth(), parameters.impulses.cellHeight()};
    json["gain"] = list(parameters.scale.gain);
    json["offset"] = list(parameters.scale.offset);
    return json.dump(2).append("\n");
}

Result<std::string> engineExample(const Texton& texton, const std::string& name) {
    QFile file(QStringLiteral(":/export/example.cpp.in"));
    if (!file.open(QIODevice::ReadOnly))
        return Error{ErrorCode::NotFound, "the program's own example is missing; please reinstall"};
    std::string text = file.readAll().toStdString();
    const std::string plain = inOneLine(name);
    // Into a command that people copy: for the shell, as one word.
    std::string word = "./" + plain + "_example.cpp"; // never an option
    replaceAll(word, "'", "'\\''");
    replaceAll(text, "@FILE@", "'" + word + "'");
    // Into string literals of C++.
    std::string escaped = plain;
    replaceAll(escaped, "\\", "\\\\");
    replaceAll(escaped, "\"", "\\\"");
    replaceAll(text, "@NAME@", escaped);
    replaceAll(text, "@WIDTH@", std::to_string(texton.footprint().width));
    replaceAll(text, "@HEIGHT@", std::to_string(texton.footprint().height));
    replaceAll(text, "@KERNELS@", std::to_string(texton.kernelCount()));
    return text;
}

} // namespace txn::app
