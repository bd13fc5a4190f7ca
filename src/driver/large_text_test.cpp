#include "driver/large_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "driver/programs.hpp"

namespace obrys::driver {
namespace {

constexpr std::size_t piece = base::Store::piece;

/// A folder that goes with the test.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("obrys_large_" + std::to_string(std::random_device{}()));
    Folder() { fs::create_directories(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    [[nodiscard]] fs::path write(const std::string& name, std::string_view text) const {
        std::ofstream(path / name, std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
        return path / name;
    }
};

/// Lines of many lengths with all line ends, up to `size` bytes.
std::string lines(std::size_t size, unsigned seed, std::string_view odd) {
    std::mt19937 rnd(seed);
    const char* ends[] = {"\n", "\r\n", "\r", "\n\n", "\r\r\n"};
    std::string text;
    while (text.size() < size) {
        text += "N" + std::to_string(text.size()) + " G1 X" + std::to_string(rnd() % 9000);
        if (rnd() % 50 == 0) text += " ; " + std::string(odd);
        if (rnd() % 900 == 0) text += std::string(rnd() % 3000, ' ') + ";";
        text += ends[rnd() % 50 < 46 ? 0 : rnd() % 5];
    }
    text.resize(size);
    return text;
}

/// Everything that `Sources` says of file `a` and of `b` is the same.
void expect_alike(const base::Sources& s, std::uint32_t a, std::uint32_t b, std::size_t size, unsigned seed) {
    std::mt19937 rnd(seed);
    EXPECT_EQ(s[a].utf8, s[b].utf8);
    for (int i = 0; i < 400; ++i) {
        const auto at = static_cast<std::uint32_t>(i < 8 ? size + 2 - static_cast<unsigned>(i) % 5 : rnd() % size);
        const base::Span in_a{a, at, static_cast<std::uint32_t>(at + rnd() % 300)}, in_b{b, in_a.begin, in_a.end};
        const base::Position p = s.position(in_a), q = s.position(in_b);
        ASSERT_EQ(p.line, q.line) << "seed " << seed << " at " << at;
        ASSERT_EQ(p.column, q.column) << "seed " << seed << " at " << at;
        ASSERT_EQ(s.line(a, p.line), s.line(b, p.line)) << "seed " << seed << " at " << at;
        ASSERT_EQ(s.text(in_a), s.text(in_b)) << "seed " << seed << " at " << at;
        ASSERT_EQ(s.block_number(a, at), s.block_number(b, at)) << "seed " << seed << " at " << at;
    }
}

TEST(LargeText, SaysTheSameOncePiecesAreAside) {
    const Folder folder;
    const std::size_t sizes[] = {piece + 1, 2 * piece - 3, large_text};
    unsigned seed = 1;
    for (const std::size_t size : sizes)
        for (const char* mark : {"", "\xEF\xBB\xBF"})
            for (const char* odd : {"gr\xC3\xBC\xC3\x9F", "gr\xFC\xDF"}) {
                const std::string text = std::string(mark) + lines(size, ++seed, odd);
                const fs::path path = folder.write("A.MPF", text);
                base::Sources s;
                const auto whole = s.add("B.MPF", text, base::BlockNumbers::n_word);
                auto store = read_large_text(path.string(), "A.MPF", text.size());
                ASSERT_NE(store, nullptr);
                const auto file = s.add("A.MPF", std::move(store), base::BlockNumbers::n_word);
                ASSERT_EQ(s[file].text, s[whole].text);
                ASSERT_EQ(s[file].text.data()[s[file].text.size()], '\0');
                s.lay_aside(file, static_cast<std::uint32_t>(size));
                expect_alike(s, whole, file, size, seed);
                s.lay_aside(file, static_cast<std::uint32_t>(size / 2));
                expect_alike(s, whole, file, size, seed + 1000);
                s.fetch(file);
                EXPECT_EQ(s[file].text, s[whole].text);
            }
}

/// A large text whose first pieces are aside.
struct Aside {
    Folder folder;
    std::string text = lines(3 * piece, 7, "x");
    fs::path path = folder.write("A.MPF", text);
    base::Sources sources;
    std::uint32_t file = 0;

    Aside() {
        file = sources.add("A.MPF", read_large_text(path.string(), "A.MPF", text.size()));
        sources.lay_aside(file, static_cast<std::uint32_t>(2 * piece + 5));
    }
    [[nodiscard]] std::string_view sample() const { return sources.text({file, 100, 200}); }
};

TEST(LargeText, AChangedFileIsNotTakenForTheOneThatWasRead) {
    Aside a;
    std::string changed = a.text;
    changed[piece / 2] = changed[piece / 2] == 'X' ? 'Y' : 'X';
    std::ofstream(a.path, std::ios::binary | std::ios::in).write(changed.data(), static_cast<std::streamsize>(piece));
    EXPECT_THROW(static_cast<void>(a.sample()), std::runtime_error);
    EXPECT_THROW(static_cast<void>(a.sources.position({a.file, 100, 200})), std::runtime_error);
    EXPECT_EQ(a.sources.text({a.file, 2 * piece + 9, 2 * piece + 99}), a.text.substr(2 * piece + 9, 90));
}

TEST(LargeText, AFileCutShortIsNotTakenForTheOneThatWasRead) {
    Aside a;
    fs::resize_file(a.path, 50);
    EXPECT_THROW(static_cast<void>(a.sample()), std::runtime_error);
}

TEST(LargeText, AFileThatIsReplacedRemovedOrWrittenAgainUnchangedDoesNoHarm) {
    Aside replaced, removed, again;
    fs::rename(replaced.folder.write("B.MPF", lines(3 * piece, 8, "x")), replaced.path);
    fs::remove(removed.path);
    static_cast<void>(again.folder.write("A.MPF", again.text));
    for (const Aside* a : {&replaced, &removed, &again})
        EXPECT_EQ(a->sample(), std::string_view(a->text).substr(100, 100));
}

TEST(LargeText, SmallFilesAndLargeOnesAreLoadedAlike) {
    const Folder folder;
    for (const std::size_t size : {std::size_t{3000}, std::size_t{large_text} - 1, std::size_t{large_text}}) {
        base::Sources s;
        base::Diagnostics d;
        std::string text = lines(size, 3, "x");
        const auto file = load(*disk(), folder.write("A.MPF", text), s, d);
        ASSERT_TRUE(file.has_value());
        s.lay_aside(*file, static_cast<std::uint32_t>(size));
        s.fetch(*file);
        EXPECT_EQ(s[*file].text, text);
        text[99] = '\0';
        EXPECT_FALSE(load(*disk(), folder.write("B.MPF", text), s, d).has_value());
        EXPECT_FALSE(load(*disk(), folder.write("C.MPF", std::string(size, ' ')), s, d).has_value());
        ASSERT_EQ(d.all().size(), 2U);
        EXPECT_EQ(d.all()[0].code, base::codes::file_binary);
        EXPECT_EQ(d.all()[1].code, base::codes::file_empty);
    }
}

/// Reads the text once as one that stays and once as one that is laid aside: tree and complaints are the same.
void expect_same_tree(const Language& language, const std::string& text) {
    const Folder folder;
    base::Sources s;
    program::Names names;
    base::Diagnostics d[2];
    const auto whole = s.add("A.X", text);
    const auto file = s.add("A.X", read_large_text(folder.write("A.X", text).string(), "A.X", text.size()));
    const std::vector<program::Unit> a = language.read(whole, s, names, d[0], nullptr),
                                     b = language.read(file, s, names, d[1], nullptr);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].labels, b[i].labels);
        EXPECT_FALSE(a[i].labels.empty());
        ASSERT_EQ(a[i].statements.size(), b[i].statements.size());
        for (std::size_t k = 0; k < a[i].statements.size(); ++k) {
            const program::Statement &p = a[i].statements[k], &q = b[i].statements[k];
            ASSERT_TRUE(p.begin == q.begin && p.first == q.first && p.length == q.length && p.kind == q.kind &&
                        p.flags == q.flags);
        }
        ASSERT_EQ(a[i].words.size(), b[i].words.size());
        for (std::size_t k = 0; k < a[i].words.size(); ++k) {
            const program::Word &p = a[i].words[k], &q = b[i].words[k];
            ASSERT_TRUE(p.code == q.code && p.form == q.form && p.offset == q.offset && p.length == q.length &&
                        p.payload == q.payload);
        }
        EXPECT_GT(a[i].statements.size(), 100'000U);
    }
    ASSERT_EQ(d[0].all().size(), d[1].all().size());
    EXPECT_GT(d[0].all().size(), 0U);
    for (std::size_t i = 0; i < d[0].all().size(); ++i)
        EXPECT_EQ(base::render(d[0].all()[i], s), base::render(d[1].all()[i], s));
}

std::string repeated(std::string head, std::string_view body, std::string_view tail) {
    while (head.size() < 3 * piece) head += body;
    return head + std::string(tail);
}

TEST(LargeText, ReadersDoNotMissWhatIsAside) {
    const auto& sinumerik = find_control("sinumerik-840d")->languages;
    const auto& heidenhain = find_control("heidenhain-itnc530")->languages;
    // what is opened at the begin and never closed, and a jump back to a block number: readers look far back for these
    expect_same_tree(sinumerik[0], repeated("N5 G1 X1\nWHILE R1<5\n", "N10 G1 X1.5 Y2 Z3\nR1=R1+1\nN20 X=R1\nZ1 ??\n\n",
                                            "GOTOB N5\nM30\n"));
    expect_same_tree(heidenhain[0], repeated("0 BEGIN PGM A MM\n1 LBL 7\n", "2 L X+1 Y+2.5 FMAX\n3 Q1 = Q1 + 1\n",
                                             "4 L ?\n5 CALL LBL 7 REP 2\n6 L M30\n"));
    expect_same_tree(heidenhain[1], repeated("%A G71 *\nN1 G98 L7 *\n", "N2 G01 X+1 Y+2.5 F100 *\nN3 G00 Z+Q1 *\n",
                                             "N4 G01 X? *\nN5 L7,2 *\nN99999999 %A G71 *\n"));
}

}  // namespace
}  // namespace obrys::driver
