#include <gtest/gtest.h>
#include "base/number.hpp"
#include "shop/files/obrys/job_testing.hpp"
#include "shop/files/obrys/machine_file.hpp"

namespace obrys::shop {
namespace {

TEST(JobFile, AMisspeltKeyIsShownWithTheNearestOne) {
    EXPECT_EQ(job_complaints("program = \"A.MPF\"\n[[tool]]\nnumber = 1\nkind = \"groove\"\nwidth = 3\nwidht = 3\n"),
              "job.toml:6:1: error: unknown key 'widht' in [[tool]] [job-file]\n"
              "  widht = 3\n"
              "  ^~~~~\n"
              "  remedy: did you mean 'width'?\n");
}

TEST(JobFile, AWrongTypeMarksTheValue) {
    EXPECT_EQ(job_complaints("program = \"A\"\n[[tool]]\nnumber = 1\nkind = \"groove\"\nwidth = \"3 mm\"  # note\n"),
              "job.toml:5:9: error: 'width' must be a number, not text [job-value]\n"
              "  width = \"3 mm\"  # note\n"
              "          ^~~~~~\n");
}

TEST(JobFile, WhatIsNotTomlIsMarked) {
    const std::string text = job_complaints("program = \"A\"\nwidth = = 3\n");
    EXPECT_EQ(text.substr(0, text.find(": Error")), "job.toml:2:9: error: this is not valid TOML");
    EXPECT_NE(text.find("[job-file]\n  width = = 3\n          ^"), std::string::npos) << text;
}

TEST(JobFile, AnUnknownMachineListsTheShippedOnes) {
    EXPECT_EQ(job_complaints("program = \"A.MPF\"\nmachine = \"lathe-genric\"\n"),
              "job.toml:2:11: error: there is no shipped machine \"lathe-genric\" [job-value]\n"
              "  machine = \"lathe-genric\"\n"
              "            ^~~~~~~~~~~~~~\n"
              "  remedy: did you mean \"lathe-generic\"? shipped: fv25cnc-a, hermle-u1130, lathe-generic, "
              "mill-generic, vmc500; the name of a machine file ends in .toml\n");
}

TEST(JobFile, ADuplicateToolNamesBothPlaces) {
    EXPECT_EQ(
        job_complaints("program = \"A\"\n[[tool]]\nnumber = 1\nkind = \"mill\"\n[[tool]]\nnumber = 1\nkind = \"mill\"\n"
                       "[[tool]]\nnumber = 1\nedge = 2\nkind = \"mill\"\n"),
        "job.toml:6:10: error: tool 1 edge 1 is defined twice [job-value]\n"
        "  number = 1\n"
        "           ^\n"
        "job.toml:2:1: note: first defined here\n"
        "  [[tool]]\n"
        "  ^\n");
}

TEST(JobFile, AllMistakesOfAFileAreFound) {
    EXPECT_EQ(
        job_places(
            "control = 7\nskip = [10, \"a\"]\nsearch = [1]\nmachin = \"x\"\n[budget]\nblocks = 0\nseconds = -1\n"
            "[check]\ngouge = nan\nrapid = -0.1\n[set]\nR1 = \"a\"\nR2 = 1\nr2 = 2\n[datum]\nG99 = {}\nG54 = {a = 1}\n"
            "[defaults]\nplane = 20\ninch = 1\n[stock]\n[part]\nprogram = \"\"\nprofile = []\n[allowance]\nnormal = "
            "inf\n"),
        "1:11: 'control' must be text, not a whole number\n"
        "2:9: a skip level is a whole number from 0 to 9\n"
        "2:13: a skip level is a whole number from 0 to 9\n"
        "3:11: an item of 'search' must be text, not a whole number\n"
        "4:1: unknown key 'machin' in the job file\n"
        "6:10: 'blocks' must lie between 1 and 1000000000000000, it is 0\n"
        "7:11: 'seconds' must be greater than 0, not -1\n"
        "9:9: 'gouge' must be a finite number\n"
        "10:9: 'rapid' must not be negative, it is -0.1\n"
        "12:6: 'R1' must be a number, not text\n"
        "14:1: 'r2' is set twice (capitals and small letters are the same)\n"
        "16:1: unknown key 'G99' in [datum]\n"
        "17:8: unknown key 'a' in 'G54'\n"
        "19:9: 'plane' must lie between 17 and 19, it is 20\n"
        "20:8: 'inch' must be true or false, not a whole number\n"
        "21:1: [stock] says nothing\n"
        "23:1: [part] has both 'profile' and 'program'\n"
        "23:11: 'program' is empty\n"
        "24:1: the profile is empty\n"
        "26:10: 'normal' must be a finite number\n");
}

TEST(JobFile, MistakesOfTools) {
    const std::string head = "program = \"A\"\n[[tool]]\nnumber = 1\n";
    EXPECT_EQ(job_places(head + "kind = \"groove\"\nwidth = -3\n"), "5:9: 'width' must be greater than 0, not -3\n");
    EXPECT_EQ(job_places(head + "kind = \"groove\"\n"), "2:1: [[tool]] has no 'width'\n");
    EXPECT_EQ(job_places(head + "kind = \"groov\"\n"), "4:8: 'kind' cannot be \"groov\"\n");
    EXPECT_EQ(job_places(head), "2:1: [[tool]] has no 'kind'\n");
    EXPECT_EQ(job_places("program = \"A\"\ntool = 3\n"), "2:8: 'tool' must be a table, not a whole number\n");
    EXPECT_EQ(job_places("program = \"A\"\n[[tool]]\nkind = \"mill\"\n"), "2:1: [[tool]] has no 'number'\n");
    EXPECT_EQ(job_places(head + "kind = \"groove\"\nwidth = 2\ncorner_radius = 1.5\n"),
              "6:17: the corner radii (3 mm together) do not fit on a width of 2 mm\n");
    EXPECT_EQ(job_places(head + "kind = \"groove\"\nwidth = 2\ncorner_radius = 1\ncutting_depth = 0.5\n"),
              "7:17: 'cutting_depth' is smaller than a corner radius\n");
    EXPECT_EQ(job_places(head + "kind = \"groove\"\nwidth = 2\nnose_radius = 1\n"),
              "6:1: 'nose_radius' means nothing for a tool of kind \"groove\"\n");
    EXPECT_EQ(job_places(head + "kind = \"turning\"\norientation = 10\n"),
              "5:15: 'orientation' must lie between 1 and 9, it is 10\n");
    EXPECT_EQ(job_places(head + "kind = \"turning\"\ntip_angle = 180\n"),
              "5:13: 'tip_angle' must be less than 180 degrees\n");
    EXPECT_EQ(job_places(head + "kind = \"turning\"\nentering_angle = 120\n"),
              "5:18: 'tip_angle' and 'entering_angle' are more than 180 degrees together: the second edge would cut "
              "below the tip\n");
    EXPECT_EQ(job_places(head + "kind = \"turning\"\norientation = 9\ndirection = \"face\"\n"),
              "6:13: a turning insert has the 'direction' \"out\" or \"in\"\n");
    EXPECT_EQ(job_places(head + "kind = \"mill\"\nparameters = {DP26 = 1, DP1 = \"a\"}\n"),
              "5:15: unknown key 'DP26' in 'parameters'\n5:31: 'DP1' must be a number, not text\n");
}

TEST(JobFile, ColumnsCountCharacters) {
    EXPECT_EQ(job_places("program = \"žluť.mpf\"\nx = {\"š\" = 1, y = 1}\n"), "2:1: unknown key 'x' in the job file\n");
    EXPECT_EQ(job_places("program = \"A\"\nstock = {\"š\" = 1, bar = 1}\n"),
              "2:10: unknown key 'š' in [stock]\n2:25: 'bar' must be a table, not a whole number\n");
    EXPECT_EQ(job_places("program = \"\x9E\"\nstock = {\"\x9A\" = 1, bar = 1}\n"),
              "2:10: unknown key 'š' in [stock]\n2:25: 'bar' must be a table, not a whole number\n");
}

TEST(JobFile, ColumnsCountCharactersFarIntoALine) {
    // Each place stands after a text of so many characters, of one or two bytes; the mistake behind it is found there.
    for (const std::size_t n : {1U, 40U, 63U, 64U, 65U, 127U, 128U, 500U, 5000U})
        for (const std::string letter : {"a", "\u017E", "\x9E"}) {
            std::string name;
            for (std::size_t i = 0; i < n; ++i) name += letter;
            const std::string text = "# \n\nprogram = \"A\"\nstock = {\"" + name + "\" = 1, bar = 1}\n";
            const std::string column = std::to_string(24 + n);
            const std::string places = job_places(text);
            EXPECT_NE(places.find("4:" + column + ": 'bar'"), std::string::npos) << places.substr(0, 300);
        }
}

}  // namespace
}  // namespace obrys::shop
