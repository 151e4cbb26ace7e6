// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeServer.h"

#include "core/base/OutputFiles.h"
#include "core/image/DecodeChannel.h"
#include "core/image/DecodeLimits.h"
#include "core/image/ImageDecoder.h"

#include <algorithm>
#include <csignal>
#include <sys/socket.h>

namespace txn {
namespace {

struct DecoderEnds {
    DecodeChannel messages;
    FileDescriptor pictures;
};

bool writeSamples(int fd, const Image& image) {
    return writeAll(fd, image.samples().data(), image.samples().size_bytes());
}

bool answer(const DecoderEnds& ends, const std::string& name, Result<LoadedImage> loaded) {
    Message description = loaded ? describe(*loaded) : describe(loaded.error());
    if (description.size() > kMaxDescriptionBytes) {
        loaded = Error{ErrorCode::Unreadable,
                       "cannot read " + quoted(std::filesystem::path(name)) +
                           ": its header holds too much text"};
        description = describe(loaded.error());
    }
    const int pipe = ends.pictures.get();
    return ends.messages.send(
               toMessage(DecodeNews{.done = true, .descriptionBytes = description.size()})) &&
           writeAll(pipe, description.data(), description.size()) &&
           (!loaded || writeSamples(pipe, loaded->image)) &&
           (!loaded || !loaded->alpha || writeSamples(pipe, *loaded->alpha));
}

Result<LoadedImage>
decode(const DecodeChannel& channel, const DecodeRequest& request, FileDescriptor descriptor) {
    auto file = FileBytes::of(std::move(descriptor), request.name);
    if (!file)
        return file.error();
    limitDecoding(file->size(), kSamplesBeforeHeader);
    const LoadOptions options{.maxSamples = request.maxSamples};
    const std::uint64_t bytes = file->size();
    return decodeImage(*std::move(file), request.name, options, [&](std::uint64_t samples) {
        samples = std::min(samples, request.maxSamples);
        limitDecoding(bytes, samples);
        // Where nobody listens any more, the next message will tell.
        (void)channel.send(toMessage(DecodeNews{.samples = samples}));
    });
}

} // namespace

bool serveDecoding(FileDescriptor socket, FileDescriptor pipe) {
    int type = 0;
    socklen_t length = sizeof(type);
    if (::getsockopt(socket.get(), SOL_SOCKET, SO_TYPE, &type, &length) != 0 ||
        type != SOCK_SEQPACKET)
        return false;
    std::signal(SIGPIPE, SIG_IGN); // writing for nobody is an error like others
    giveUpRights();
    const DecoderEnds ends{DecodeChannel(std::move(socket)), std::move(pipe)};
    if (!ends.messages.send(toMessage(DecodeNews{}))) // ready
        return true;
    while (true) {
        auto received = ends.messages.receive();
        if (received.got != DecodeChannel::Got::Whole)
            return true;
        const auto request = requestFrom(received.message);
        if (!request || !received.descriptor)
            return true;
        if (!answer(ends,
                    request->name,
                    decode(ends.messages, *request, std::move(received.descriptor))))
            return true;
        freeUnused();
    }
}

} // namespace txn
