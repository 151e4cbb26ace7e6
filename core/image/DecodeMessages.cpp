// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeMessages.h"

#include "core/image/ImageFormats.h"

#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace txn {
namespace {

constexpr std::uint32_t kMagic = 0x31445854; // "TXD1"
constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 48U;
constexpr std::uint8_t kRequest = 'Q';
constexpr std::uint8_t kHeaderRead = 'H';
constexpr std::uint8_t kDone = 'D';
constexpr std::uint8_t kPicture = 'P';
constexpr std::uint8_t kError = 'E';

class Writer {
  public:
    explicit Writer(std::uint8_t kind) {
        number(kMagic);
        number(kind);
    }

    template <class T>
    Writer& number(T value) {
        static_assert(std::is_integral_v<T>);
        for (const std::uint8_t byte : std::bit_cast<std::array<std::uint8_t, sizeof(T)>>(value))
            m_bytes.push_back(byte);
        return *this;
    }
    template <class E>
    Writer& choice(E value) {
        return number(static_cast<std::uint8_t>(value));
    }
    Writer& text(std::string_view text) {
        number(static_cast<std::uint32_t>(text.size()));
        m_bytes.insert(m_bytes.end(), text.begin(), text.end());
        return *this;
    }

    Message take() { return std::move(m_bytes); }

  private:
    Message m_bytes;
};

/// After the first thing that is not there or out of range, everything reads as zero and whole()
/// is false.
class MessageReader {
  public:
    explicit MessageReader(std::span<const std::uint8_t> bytes) : m_rest(bytes) {
        m_ok = number<std::uint32_t>() == kMagic && m_ok;
    }

    template <class T>
    T number() {
        static_assert(std::is_integral_v<T>);
        T value{};
        if (!m_ok || m_rest.size() < sizeof(T)) {
            m_ok = false;
            return value;
        }
        std::memcpy(&value, m_rest.data(), sizeof(T));
        m_rest = m_rest.subspan(sizeof(T));
        return value;
    }
    template <class T>
    T within(T least, T most) {
        const T value = number<T>();
        if (value < least || value > most)
            m_ok = false;
        return m_ok ? value : least;
    }
    /// One of an enumeration whose last value is given.
    template <class E>
    E choice(E last) {
        return static_cast<E>(within<std::uint8_t>(0, static_cast<std::uint8_t>(last)));
    }
    std::string text() {
        const auto length = number<std::uint32_t>();
        if (!m_ok || length > m_rest.size()) {
            m_ok = false;
            return {};
        }
        std::string text(reinterpret_cast<const char*>(m_rest.data()), length);
        m_rest = m_rest.subspan(length);
        return text;
    }

    /// Whether all was well and nothing is left.
    bool whole() const { return m_ok && m_rest.empty(); }
    bool ok() const { return m_ok; }

  private:
    std::span<const std::uint8_t> m_rest;
    bool m_ok = true;
};

/// Messages are shown to users and may come from a decoder that was taken over.
bool isOneLine(std::string_view text) {
    constexpr std::size_t kLongest = 8192; // a path and a reason
    if (text.size() > kLongest)
        return false;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            return false;
    }
    return true;
}

Result<PictureDescription> pictureFrom(MessageReader& reader) {
    PictureDescription picture;
    picture.size.width = reader.within<std::int32_t>(1, INT32_MAX);
    picture.size.height = reader.within<std::int32_t>(1, INT32_MAX);
    picture.channels = reader.within<std::int32_t>(1, kMaxChannels);
    picture.hasAlpha = reader.within<std::uint8_t>(0, 1) == 1;
    picture.transfer = reader.choice(Transfer::Linear);
    picture.loaded.format = reader.choice(ImageFormat::WebP);
    picture.loaded.sampleFormat = reader.choice(SampleFormat::Float);
    picture.loaded.iccConverted = reader.within<std::uint8_t>(0, 1) == 1;
    const auto names = reader.within<std::int32_t>(0, kMaxChannels);
    for (int i = 0; i < names && reader.ok(); ++i)
        picture.loaded.channelNames.push_back(reader.text());
    const auto attributes = reader.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < attributes && reader.ok(); ++i) {
        std::string key = reader.text();
        picture.loaded.attributes[std::move(key)] = reader.text();
    }
    return picture;
}

} // namespace

Message toMessage(const DecodeRequest& request) {
    return Writer(kRequest).number(request.maxSamples).text(request.name).take();
}

std::optional<DecodeRequest> requestFrom(std::span<const std::uint8_t> bytes) {
    MessageReader reader(bytes);
    DecodeRequest request;
    const bool right = reader.number<std::uint8_t>() == kRequest;
    request.maxSamples = reader.number<std::uint64_t>();
    request.name = reader.text();
    if (!right || !reader.whole())
        return std::nullopt;
    return request;
}

Message toMessage(const DecodeNews& news) {
    return Writer(news.done ? kDone : kHeaderRead)
        .number(news.done ? news.descriptionBytes : news.samples)
        .take();
}

std::optional<DecodeNews> newsFrom(std::span<const std::uint8_t> bytes) {
    MessageReader reader(bytes);
    const auto kind = reader.number<std::uint8_t>();
    const auto number = reader.number<std::uint64_t>();
    if (!reader.whole())
        return std::nullopt;
    if (kind == kHeaderRead)
        return DecodeNews{.samples = number};
    if (kind == kDone && number <= kMaxDescriptionBytes)
        return DecodeNews{.done = true, .descriptionBytes = number};
    return std::nullopt;
}

Message describe(const LoadedImage& loaded) {
    Writer writer(kPicture);
    writer.number(std::int32_t{loaded.image.width()})
        .number(std::int32_t{loaded.image.height()})
        .number(std::int32_t{loaded.image.channels()})
        .number(std::uint8_t{loaded.alpha ? std::uint8_t{1} : std::uint8_t{0}})
        .choice(loaded.image.transfer())
        .choice(loaded.format)
        .choice(loaded.sampleFormat)
        .number(std::uint8_t{loaded.iccConverted ? std::uint8_t{1} : std::uint8_t{0}})
        .number(static_cast<std::int32_t>(loaded.channelNames.size()));
    for (const std::string& name : loaded.channelNames)
        writer.text(name);
    writer.number(static_cast<std::uint32_t>(loaded.attributes.size()));
    for (const auto& [key, value] : loaded.attributes)
        writer.text(key).text(value);
    return writer.take();
}

Message describe(const Error& error) {
    return Writer(kError).choice(error.code).text(error.message).take();
}

std::optional<Result<PictureDescription>> descriptionFrom(std::span<const std::uint8_t> bytes,
                                                          std::uint64_t maxSamples) {
    MessageReader reader(bytes);
    const auto kind = reader.number<std::uint8_t>();
    if (kind == kError) {
        Error error;
        error.code = reader.choice(ErrorCode::Cancelled);
        error.message = reader.text();
        if (!reader.whole() || !isOneLine(error.message) || error.code == ErrorCode::Cancelled)
            return std::nullopt;
        return error;
    }
    auto picture = pictureFrom(reader);
    if (kind != kPicture || !reader.whole())
        return std::nullopt;
    // In this order the products fit.
    if (picture->size.area() > maxSamples || picture->size.area() > kMostSamples ||
        picture->samples() > maxSamples)
        return std::nullopt;
    return picture;
}

} // namespace txn
