/// One image run often, with other values and by several threads at once.

#include "driver/image.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "cl/text.hpp"
#include "geom/region.hpp"
#include "report/report.hpp"

namespace obrys::driver {
namespace {

/// A turned groove in layers, by a subprogram with parameters, and one that is never called and has an error.
std::shared_ptr<Memory> groove() {
    auto memory = std::make_shared<Memory>();
    memory->put("groove.job.toml", R"(program = "GROOVE.MPF"
control = "sinumerik-840d"
machine = "lathe-generic"
[stock]
bar = { diameter = 60, length = 100, z_max = 0 }
[[tool]]
number = 1
kind = "groove"
width = 3.0
corner_radius = 0.2
reference = "left"
)");
    memory->put("GROOVE.MPF", R"(DEF REAL DEPTH
R1=4
T1 D1
G95 S500 M3 F0.1
G0 X70 Z-40
IF R1>100
NEVER
ENDIF
DEPTH=60
LAYER: DEPTH=DEPTH-R1
STEP(DEPTH)
IF DEPTH>20 GOTOB LAYER
G0 X70
M30
)");
    memory->put("STEP.SPF", "PROC STEP(REAL X_TO)\nG1 X=X_TO\nG0 X62\nM17\n");
    memory->put("NEVER.SPF", "PROC NEVER\nG1 X=(\nM17\n");
    return memory;
}

Request request_for(std::shared_ptr<const Storage> storage, std::string input) {
    Request request;
    request.input = std::move(input);
    request.folders = std::make_shared<Folders>(std::move(storage));
    return request;
}

std::string checked(const Image& image, const Inputs& inputs = {}) {
    const auto session = image.run(inputs);
    const Checked c = check_against(*session, image.setup_for(*session));
    return report::to_json({session->sources,
                            c.result,
                            c.setup,
                            session->stacks,
                            session->program,
                            session->control,
                            "",
                            {},
                            {},
                            session->input,
                            {}},
                           true);
}

TEST(Image, IsCheckedAsTheProgramIs) {
    const Request request = request_for(groove(), "groove.job.toml");
    const auto image = Image::prepare(request);
    for (const base::Diagnostic& d : image->session().diagnostics.all())
        ASSERT_NE(d.severity, base::Severity::error) << base::render(d, image->session().sources);
    ASSERT_TRUE(image->usable());
    Session whole;
    ASSERT_TRUE(open(request, whole));
    const Checked c = check_program(whole, 0);
    EXPECT_GT(c.result.stats.feed_moves, 5u);
    const report::Subject subject{
        whole.sources, c.result, c.setup, whole.stacks, whole.program, whole.control, "", {}, {}, whole.input, {}};
    EXPECT_EQ(checked(*image), report::to_json(subject, true));
}

TEST(Image, OtherValuesCountForTheirRunAlone) {
    const auto image = Image::prepare(request_for(groove(), "groove.job.toml"));
    ASSERT_TRUE(image->usable());
    const std::string before = checked(*image), other = checked(*image, {{{"R1", 2, nowhere}}, {}});
    EXPECT_NE(before, other);
    EXPECT_EQ(checked(*image), before);
}

TEST(Image, WhatIsWrongWithACalledProgramIsSaidByTheRunThatCallsIt) {
    const auto image = Image::prepare(request_for(groove(), "groove.job.toml"));
    const auto runs = [&](double r1) {
        const auto session = image->run({{{"R1", r1, nowhere}}, {}});
        static_cast<void>(interpret(*session, [](const cl::Record&) {}));
        return session->diagnostics.has_errors();
    };
    EXPECT_FALSE(runs(4));
    EXPECT_TRUE(runs(101));
    EXPECT_FALSE(runs(4));
}

TEST(Image, TwoThreadsRunItAThousandTimes) {
    const auto image = Image::prepare(request_for(groove(), "groove.job.toml"));
    ASSERT_TRUE(image->usable());
    const std::string four = checked(*image), two = checked(*image, {{{"R1", 2, nowhere}}, {}});
    const auto run = [&](bool second) {
        for (int i = 0; i < 500; ++i) {
            const bool other = (i % 2 == 0) == second;
            if (checked(*image, other ? Inputs{{{"R1", 2, nowhere}}, {}} : Inputs{}) != (other ? two : four))
                return false;
        }
        return true;
    };
    bool good = false;
    std::thread beside([&] { good = run(true); });
    EXPECT_TRUE(run(false));
    beside.join();
    EXPECT_TRUE(good);
}

TEST(Image, APartThatAProgramDrawsFollowsTheValues) {
    const auto memory = groove();
    memory->put("PART.MPF", "R1=4\nG0 X60 Z-60\nG1 Z-50\nX=60-2*R1\nZ-30\nX60\nZ0\nM30\n");
    std::string job;
    ASSERT_EQ(memory->read("groove.job.toml", 0, job), 0);
    job.insert(job.find("[[tool]]"), "[part]\nprogram = \"PART.MPF\"\n");
    memory->put("groove.job.toml", job);
    const Request plain = request_for(memory, "groove.job.toml");
    const auto image = Image::prepare(plain);
    for (const base::Diagnostic& d : image->session().diagnostics.all())
        ASSERT_NE(d.severity, base::Severity::error) << base::render(d, image->session().sources);
    ASSERT_TRUE(image->usable());
    const auto area = [](const std::optional<geom::Region>& part) { return part ? geom::area(*part) : 0; };
    const auto with = [&](const Inputs& inputs) {
        const auto run = image->run(inputs);
        return area(image->setup_for(*run).part);
    };
    Request set = plain;
    set.set = {"R1=2"};
    EXPECT_EQ(with({{{"R1", 2, nowhere}}, {}}), area(Image::prepare(set)->setup_for(*Image::prepare(set)->run()).part));
    EXPECT_NE(with({{{"R1", 2, nowhere}}, {}}), with({}));
}

TEST(Image, ACalledFileThatCannotBeReadIsSaidByTheRun) {
    const auto memory = groove();
    memory->put("STEP.SPF", " \n");
    const auto image = Image::prepare(request_for(memory, "groove.job.toml"));
    ASSERT_TRUE(image->usable());
    const std::string first = checked(*image);
    EXPECT_NE(first.find("STEP.SPF is empty"), std::string::npos);
    EXPECT_EQ(checked(*image), first);
}

/// A text may define what another file is called: whichever the run comes to first counts, read ahead or not.
TEST(Image, ReadingAheadFindsNoOtherProgram) {
    auto memory = std::make_shared<Memory>();
    memory->put("main.ngc", "o1 if [#5399 GT 9]\no<x> call\no1 endif\nG0 X0\no<common> call\nM2\n");
    memory->put("x.ngc", "o<x> sub\no<x> endsub\no<common> sub\nG0 X1\no<common> endsub\nM2\n");
    memory->put("common.ngc", "o<common> sub\nG0 X2\no<common> endsub\nM2\n");
    Request request = request_for(memory, "main.ngc");
    request.control = "linuxcnc";
    const auto moves = [](Session& s) {
        std::string all;
        static_cast<void>(interpret(s, [&](cl::Record r) {
            r.from = {};  // files have other numbers
            all += cl::to_text(r) + "\n";
        }));
        return all;
    };
    Session whole;
    ASSERT_TRUE(open(request, whole));
    EXPECT_EQ(moves(*Image::prepare(request)->run()), moves(whole));
}

TEST(Image, NeedsNothingThatWasReadAgain) {
    const auto memory = groove();
    const auto image = Image::prepare(request_for(memory, "groove.job.toml"));
    const std::string before = checked(*image);
    for (const char* name : {"GROOVE.MPF", "STEP.SPF", "groove.job.toml"}) EXPECT_TRUE(memory->remove(name));
    EXPECT_EQ(checked(*image), before);
}

}  // namespace
}  // namespace obrys::driver
