// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/DecodeClient.h"
#include "core/image/DecodeLimits.h"
#include "core/image/ImageDecoder.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Verify.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace txn;
using namespace txn::test;
namespace fs = std::filesystem;

namespace {

/// Processes of this program's decoder, and of nobody else's.
std::vector<pid_t> decodersOf(pid_t parent) {
    std::vector<pid_t> decoders;
    for (const auto& thread : fs::directory_iterator("/proc/" + std::to_string(parent) + "/task")) {
        std::ifstream children(thread.path() / "children");
        for (pid_t child = 0; children >> child;) {
            std::string name;
            std::ifstream("/proc/" + std::to_string(child) + "/comm") >> name;
            if (name == "texton-decode")
                decoders.push_back(child);
        }
    }
    return decoders;
}

std::vector<pid_t> decoders() {
    return decodersOf(::getpid());
}

void signalDecoders(int signal) {
    QVERIFY(!decoders().empty());
    for (const pid_t decoder : decoders())
        ::kill(decoder, signal);
}

LoadedImage somePicture() {
    LoadedImage loaded;
    loaded.image = randomImage({5, 3}, 3, 1);
    loaded.alpha = randomImage({5, 3}, 1, 2);
    loaded.format = ImageFormat::OpenExr;
    loaded.sampleFormat = SampleFormat::Half;
    loaded.channelNames = {"R", "G", ""};
    loaded.attributes = {{"texton:a", "1"}, {"texton:b", std::string("\0\n", 2)}};
    loaded.iccConverted = true;
    return loaded;
}

/// Bytes of description and samples, as an honest decoder writes them.
Message pictureBytes(const LoadedImage& loaded) {
    Message bytes = describe(loaded);
    const auto add = [&](const Image& image) {
        const auto samples = std::as_bytes(image.samples());
        for (const std::byte byte : samples)
            bytes.push_back(static_cast<std::uint8_t>(byte));
    };
    add(loaded.image);
    if (loaded.alpha)
        add(*loaded.alpha);
    return bytes;
}

Message done(const Message& description) {
    return toMessage(DecodeNews{.done = true, .descriptionBytes = description.size()});
}

/// The ends of a decoder that is played by the test.
struct FakeDecoder {
    DecoderConnection client{DecodeChannel(FileDescriptor()), FileDescriptor()};
    DecodeChannel messages{FileDescriptor()};
    FileDescriptor pictures;

    FakeDecoder() {
        std::array<int, 2> sockets{};
        std::array<int, 2> pipe{};
        if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0 ||
            ::pipe2(pipe.data(), O_CLOEXEC) != 0)
            qFatal("no socket or pipe");
        ::fcntl(pipe[0], F_SETFL, O_NONBLOCK);
        client = {DecodeChannel(FileDescriptor(sockets[0])), FileDescriptor(pipe[0])};
        messages = DecodeChannel(FileDescriptor(sockets[1]));
        pictures = FileDescriptor(pipe[1]);
    }
    void write(const Message& bytes) const {
        QVERIFY(writeAll(pictures.get(), bytes.data(), bytes.size()));
    }
};

/// What the client makes of a decoder that does this with a request.
DecodeAnswer answerOf(const std::function<void(FakeDecoder&)>& decoder,
                      const LoadOptions& options = {}) {
    FakeDecoder fake;
    const std::array<std::uint8_t, 3> content{1, 2, 3};
    const auto file = FileBytes::holding(content, "some.png");
    std::thread thread([&] {
        const auto request = fake.messages.receive();
        if (request.got == DecodeChannel::Got::Whole)
            decoder(fake);
    });
    DecodeAnswer answer = askDecoder(fake.client, *file, "some.png", options);
    thread.join();
    return answer;
}

/// The exit code of a copy of this process that does only this.
int inChild(const std::function<int()>& work) {
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(work());
    int status = -1;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

/// Pictures are decoded in a process of their own: its death, its lies and its silence.
class TestDecoder : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    fs::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

  private slots:
    void initTestCase() {
        QVERIFY(saveImage(randomImage({40, 30}, 3, 7), path("good.png")));
        QVERIFY(loadImage(path("good.png")));
    }

    // The real one

    void oneDecoderServesManyPictures() {
        QVERIFY(loadImage(path("good.png")));
        const auto before = decoders();
        QCOMPARE(before.size(), std::size_t{1});
        for (int i = 0; i < 20; ++i)
            QVERIFY(loadImage(path("good.png")));
        QVERIFY(decoders() == before);
    }

    void helperAndProgramDecodeAlike() {
        auto file = FileBytes::open(path("good.png"));
        QVERIFY(file);
        const auto here = decodeImage(*std::move(file), path("good.png"), {});
        const auto there = loadImage(path("good.png"));
        QVERIFY(here && there);
        QVERIFY(here->image == there->image);
        QVERIFY(here->channelNames == there->channelNames);
    }

    void contentIsDecodedLikeFiles() {
        QFile file(m_folder.filePath("good.png"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        const std::span content(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                static_cast<std::size_t>(bytes.size()));
        const auto loaded = loadImage(content, "pasted.png");
        QVERIFY(loaded && loaded->image == loadImage(path("good.png"))->image);
        const auto cut = loadImage(content.first(content.size() / 2), "pasted.png");
        TXN_FAILS_WITH(cut, ErrorCode::Unreadable);
        QVERIFY(cut.error().message.find("'pasted.png'") != std::string::npos);
        TXN_FAILS_WITH(loadImage(content.first(0), "pasted.png"), ErrorCode::Unreadable);
    }

    void deadDecoderIsReplaced() {
        QVERIFY(loadImage(path("good.png")));
        const auto before = decoders();
        signalDecoders(SIGKILL);
        QVERIFY(loadImage(path("good.png")));
        QVERIFY(!decoders().empty());
        QVERIFY(decoders() != before);
    }

    void silentDecoderIsAnErrorInTime() {
        QVERIFY(loadImage(path("good.png")));
        const auto before = decoders();
        signalDecoders(SIGSTOP);
        QElapsedTimer timer;
        timer.start();
        const auto loaded = loadImage(path("good.png"));
        const auto longest = 1.2 * static_cast<double>(decodingTime(5000, 4'200'000).count());
        TXN_AT_MOST(static_cast<double>(timer.elapsed()), longest);
        TXN_FAILS_WITH(loaded, ErrorCode::Unreadable);
        QVERIFY(loaded.error().message.find("good.png'") != std::string::npos);
        QVERIFY(loaded.error().message.find("far too long") != std::string::npos);
        // It is not kept, and the next picture has another one.
        QVERIFY(::kill(before.front(), 0) != 0);
        QVERIFY(loadImage(path("good.png")));
    }

    void decoderEndsWithItsProgram() {
        std::array<int, 2> pipe{};
        QVERIFY(::pipe2(pipe.data(), O_CLOEXEC) == 0);
        signalDecoders(SIGKILL); // the copy of this process should have one of its own
        const int code = inChild([&] {
            if (!loadImage(path("good.png")))
                return 1;
            const auto own = decodersOf(::getpid());
            const pid_t decoder = own.empty() ? 0 : own.front();
            return ::write(pipe[1], &decoder, sizeof(decoder)) == sizeof(decoder) ? 0 : 2;
        }); // ended by _exit, without any clearing up
        QCOMPARE(code, 0);
        pid_t decoder = 0;
        QVERIFY(::read(pipe[0], &decoder, sizeof(decoder)) == sizeof(decoder));
        QVERIFY(decoder > 0);
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists("/proc/" + QString::number(decoder) + "/exe"),
                                 5000);
        ::close(pipe[0]);
        ::close(pipe[1]);
    }

    void rightsAreGivenUp() {
        const QByteArray file = QFile::encodeName(m_folder.filePath("good.png"));
        const QByteArray other = QFile::encodeName(m_folder.filePath("other"));
        const auto code = inChild([&] {
            giveUpRights();
            int done = 0;
            const auto works = [&](bool worked, int bit) { done |= worked ? bit : 0; };
            works(::open(other.constData(), O_RDONLY | O_CREAT, 0600) >= 0, 1);
            works(::open(file.constData(), O_WRONLY) >= 0, 2);
            works(::unlink(other.constData()) == 0 || errno != EPERM, 4);
            works(::socket(AF_INET, SOCK_STREAM, 0) >= 0, 8);
            const pid_t child = ::fork();
            if (child == 0)
                ::_exit(0);
            works(child > 0, 16);
            char* const none[] = {nullptr};
            works(::execve("/bin/true", none, none) == 0, 32);
            works(::kill(::getppid(), 0) == 0, 64);
            // What it is there for goes on.
            works(::open(file.constData(), O_RDONLY) < 0, 128);
            return done;
        });
#ifdef TXN_SANITIZED
        QSKIP("system calls are not filtered under sanitizers");
#endif
        QCOMPARE(code, 0);
        // Threads start, too, as decoders want them.
        QCOMPARE(inChild([] {
                     giveUpRights();
                     int ran = 0;
                     std::thread([&] { ran = 42; }).join();
                     return ran;
                 }),
                 42);
    }

    void missingDecoderIsExplained() {
#ifdef TXN_THREAD_SANITIZED
        QSKIP("Qt starts no programs under ThreadSanitizer (LLVM 14)");
#endif
        QVERIFY(QDir(m_folder.path()).mkpath("lonely/bin"));
        const QString lonely = m_folder.filePath("lonely/bin/texton");
        QVERIFY(QFile::copy(TXN_TEXTON_PROGRAM, lonely));
        const auto run = [&] {
            QProcess program;
            program.start(lonely, {"info", QString::fromStdString(path("good.png").string())});
            program.waitForFinished();
            return std::pair(program.exitCode(), program.readAllStandardError());
        };
        const auto [code, message] = run();
        QVERIFY(code != 0);
        QVERIFY2(message.contains("texton-decode"), message.constData());
        QVERIFY2(message.contains("install Texton Studio again"), message.constData());
        QCOMPARE(message.count('\n'), 1);
        // As installed, it lies in a folder of its own.
        QVERIFY(QDir(m_folder.path()).mkpath("lonely/" TXN_HELPER_DIR));
        QVERIFY(QFile::copy(QFileInfo(TXN_TEXTON_PROGRAM).dir().filePath("texton-decode"),
                            m_folder.filePath("lonely/" TXN_HELPER_DIR "/texton-decode")));
        const auto [codeThen, messageThen] = run();
        QVERIFY2(codeThen == 0, messageThen.constData());
    }

    void startedByHandItSaysWhatItIs() {
#ifdef TXN_THREAD_SANITIZED
        QSKIP("Qt starts no programs under ThreadSanitizer (LLVM 14)");
#endif
        QProcess program;
        program.start(QFileInfo(TXN_TEXTON_PROGRAM).dir().filePath("texton-decode"), QStringList());
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitCode(), 2);
        QVERIFY(program.readAllStandardError().contains("started by it"));
    }

    // Messages

    void messagesComeBackAsTheyWere() {
        const auto request = requestFrom(toMessage(DecodeRequest{"a b\n.png", 12345}));
        QVERIFY(request);
        QCOMPARE(request->name, std::string("a b\n.png"));
        QVERIFY(request->maxSamples == 12345);
        const auto news = newsFrom(toMessage(DecodeNews{.samples = 99}));
        QVERIFY(news && !news->done && news->samples == 99);
        const auto end = newsFrom(toMessage(DecodeNews{.done = true, .descriptionBytes = 7}));
        QVERIFY(end && end->done && end->descriptionBytes == 7);

        const LoadedImage loaded = somePicture();
        const auto described = descriptionFrom(describe(loaded), 60);
        QVERIFY(described && *described);
        const PictureDescription& picture = **described;
        QVERIFY(picture.size == (Size{5, 3}) && picture.channels == 3 && picture.hasAlpha);
        QVERIFY(picture.samples() == 60);
        QVERIFY(picture.transfer == loaded.image.transfer());
        QVERIFY(picture.loaded.format == loaded.format);
        QVERIFY(picture.loaded.sampleFormat == loaded.sampleFormat);
        QVERIFY(picture.loaded.channelNames == loaded.channelNames);
        QVERIFY(picture.loaded.attributes == loaded.attributes);
        QVERIFY(picture.loaded.iccConverted);
        QVERIFY(!descriptionFrom(describe(loaded), 59));

        const auto error = descriptionFrom(describe(Error{ErrorCode::NotFound, "gone"}), 1);
        QVERIFY(error && !*error);
        QVERIFY(error->error().code == ErrorCode::NotFound);
        QCOMPARE(error->error().message, std::string("gone"));
    }

    void cutMessagesAreNone() {
        const auto every = [](const Message& whole, auto read) {
            for (std::size_t length = 0; length < whole.size(); ++length) {
                if (read(std::span(whole).first(length)))
                    return false;
            }
            Message longer = whole;
            longer.push_back(0);
            return !read(std::span<const std::uint8_t>(longer));
        };
        using Bytes = std::span<const std::uint8_t>;
        QVERIFY(every(toMessage(DecodeRequest{"name.png", 1}),
                      [](Bytes bytes) { return requestFrom(bytes).has_value(); }));
        QVERIFY(every(toMessage(DecodeNews{.samples = 3}),
                      [](Bytes bytes) { return newsFrom(bytes).has_value(); }));
        QVERIFY(every(describe(somePicture()),
                      [](Bytes bytes) { return descriptionFrom(bytes, 1000).has_value(); }));
        QVERIFY(every(describe(Error{ErrorCode::TooLarge, "too large"}),
                      [](Bytes bytes) { return descriptionFrom(bytes, 1000).has_value(); }));
    }

    /// Whatever the bytes, what is read keeps its promises.
    void spoiltMessagesPromiseNothingElse() {
        std::mt19937 dice(3);
        const Message whole = describe(somePicture());
        int read = 0;
        for (int i = 0; i < 20000; ++i) {
            Message spoilt = whole;
            for (unsigned n = 1 + dice() % 4; n > 0; --n)
                spoilt[dice() % spoilt.size()] = static_cast<std::uint8_t>(dice());
            const auto described = descriptionFrom(spoilt, 100);
            if (!described || !*described)
                continue;
            ++read;
            const PictureDescription& picture = **described;
            QVERIFY(picture.size.width >= 1 && picture.size.height >= 1);
            QVERIFY(picture.channels >= 1 && picture.samples() <= 100);
            QVERIFY(picture.loaded.format <= ImageFormat::WebP);
            QVERIFY(picture.loaded.sampleFormat <= SampleFormat::Float);
            (void)requestFrom(spoilt);
            (void)newsFrom(spoilt);
        }
        QVERIFY(read > 100);
    }

    void errorsOfADecoderAreOneLine() {
        QVERIFY(!descriptionFrom(describe(Error{ErrorCode::NotFound, "two\nlines"}), 1));
        QVERIFY(!descriptionFrom(describe(Error{ErrorCode::NotFound, "\033[2J"}), 1));
        QVERIFY(!descriptionFrom(describe(Error{ErrorCode::NotFound, std::string(9000, 'a')}), 1));
        QVERIFY(!descriptionFrom(describe(Error{ErrorCode::Cancelled, "cancelled"}), 1));
    }

    // Decoders that were taken over

    void honestDecoder() {
        const LoadedImage picture = somePicture();
        const auto answer = answerOf([&](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(toMessage(DecodeNews{.samples = 60})));
            QVERIFY(fake.messages.send(done(describe(picture))));
            fake.write(pictureBytes(picture));
        });
        const auto* loaded = std::get_if<LoadedImage>(&answer);
        QVERIFY(loaded != nullptr);
        QVERIFY(loaded->image == picture.image);
        QVERIFY(loaded->alpha == picture.alpha);
    }

    void lyingDecoder_data() {
        using Lie = std::function<void(FakeDecoder&)>;
        QTest::addColumn<Lie>("lie");
        QTest::addColumn<DecodeFailure>("failure");
        const auto row = [](const char* name, DecodeFailure failure, Lie lie) {
            QTest::newRow(name) << std::move(lie) << failure;
        };
        const auto close = [](FakeDecoder& fake) {
            fake.messages = DecodeChannel(FileDescriptor());
            fake.pictures = FileDescriptor();
        };
        const LoadedImage picture = somePicture();
        row("closes at once", DecodeFailure::Died, close);
        row("says nothing", DecodeFailure::TooSlow, [](FakeDecoder&) {});
        row("speaks in tongues", DecodeFailure::Nonsense, [](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(Message(3, 1)));
        });
        row("sends an endless message", DecodeFailure::Died, [](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(Message(kMaxMessageBytes + 1)));
        });
        row("promises a huge description", DecodeFailure::Nonsense, [](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(
                toMessage(DecodeNews{.done = true, .descriptionBytes = kMaxDescriptionBytes + 1})));
        });
        row("describes nothing", DecodeFailure::Nonsense, [](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(done({})));
        });
        row("describes a description only", DecodeFailure::TooSlow, [=](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(done(describe(picture))));
            fake.write(describe(picture));
        });
        row("dies amid the samples", DecodeFailure::Died, [=](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(done(describe(picture))));
            Message bytes = pictureBytes(picture);
            bytes.pop_back();
            fake.write(bytes);
            close(fake);
        });
        row("puts its reader off for ever", DecodeFailure::TooSlow, [=](FakeDecoder& fake) {
            for (int i = 0; i < 100; ++i)
                QVERIFY(fake.messages.send(toMessage(DecodeNews{.samples = ~std::uint64_t{0}})));
        });
        LoadedImage large = picture;
        large.image = Image({40, 40}, 1);
        row("sends more than was asked for", DecodeFailure::Nonsense, [=](FakeDecoder& fake) {
            QVERIFY(fake.messages.send(done(describe(large))));
            fake.write(describe(large));
        });
        row("writes to the user's terminal", DecodeFailure::Nonsense, [](FakeDecoder& fake) {
            const Message error = describe(Error{ErrorCode::Unreadable, "\a\n"});
            QVERIFY(fake.messages.send(done(error)));
            fake.write(error);
        });
    }
    void lyingDecoder() {
        QFETCH(std::function<void(FakeDecoder&)>, lie);
        QFETCH(DecodeFailure, failure);
        const LoadOptions options{.maxSamples = 1000};
        QElapsedTimer timer;
        timer.start();
        const auto answer = answerOf(lie, options);
        const auto longest = 1.2 * static_cast<double>(decodingTime(5000, 4'200'000).count());
        TXN_AT_MOST(static_cast<double>(timer.elapsed()), longest);
        const auto* failed = std::get_if<DecodeFailure>(&answer);
        QVERIFY(failed != nullptr);
        QVERIFY(*failed == failure);
    }

    void timeGrowsWithThePicture() {
        using std::chrono::milliseconds;
        QVERIFY(decodingTime(0, 0) >= milliseconds(1000));
#ifndef TXN_SANITIZED
        QVERIFY(decodingTime(1 << 20U, kSamplesBeforeHeader) < milliseconds(2000));
#endif
        QVERIFY(decodingTime(0, std::uint64_t{1} << 28U) > std::chrono::seconds(20));
    }
};

QTEST_GUILESS_MAIN(TestDecoder)
#include "TestDecoder.moc"
