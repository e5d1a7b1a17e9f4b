#include "engine/motion/library.h"

#include <fstream>

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "engine/motion/apex.h"
#include "engine/motion/library_edit.h"
#include "engine/motion/library_schema.h"
#include "tests/motion/made_up_motion.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class Library : public testing::Test {
 protected:
  Library() : folder_(fs::temp_directory_path() / fmt::format("sinew-library-{}", ::getpid())) {
    fs::remove_all(folder_);
  }
  ~Library() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "deep" / "motions.db"; }
  MotionLibrary library() const { return std::move(*MotionLibrary::open(file(), true)); }

  static StoredClip clip(const std::string& name, int frames = 60) {
    StoredClip clip;
    clip.entry.name = name;
    clip.entry.tags = {"calm", "arms"};
    clip.entry.emotion = "laugh";
    clip.entry.licence = "CC0-1.0";
    clip.motion = test::made_up_motion(name, frames);
    return clip;
  }

  fs::path folder_;
};

TEST_F(Library, GivesBackWhatItWasGiven) {
  MotionLibrary open = library();
  StoredClip given = clip("wave");
  CurveFitOptions options;
  options.tolerance = 0.2;
  given.curves = fit_motion(given.motion, options).clip;
  given.entry.apex = 0.5;
  ASSERT_TRUE(open.add(given));
  const auto back = open.load("wave");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->entry.tags, (std::vector<std::string>{"arms", "calm"}));
  EXPECT_EQ(back->entry.emotion, "laugh");
  EXPECT_EQ(back->entry.apex, 0.5);
  ASSERT_EQ(back->motion.frames.size(), given.motion.frames.size());
  for (std::size_t i = 0; i < given.motion.frames.size(); ++i) {
    EXPECT_EQ(back->motion.frames[i].root, given.motion.frames[i].root);
    EXPECT_EQ(back->motion.frames[i].rotations, given.motion.frames[i].rotations);
  }
  ASSERT_TRUE(back->curves);
  for (std::size_t j = 0; j < 5; ++j)
    for (int axis = 0; axis < 3; ++axis)
      for (double t = 0.0; t < 2.0; t += 0.01)
        // Value and slope at the cuts are kept, Legendre's coefficients made of them again.
        EXPECT_NEAR(back->curves->joints[j].angles[axis].value(t), given.curves->joints[j].angles[axis].value(t), 1e-9);
}

TEST_F(Library, FindsByNameTagEmotionAndDuration) {
  MotionLibrary open = library();
  ASSERT_TRUE(open.add(clip("Short wave", 10)));
  ASSERT_TRUE(open.add(clip("long wave", 100)));
  const auto found = [&](const ClipQuery& query) { return open.list(query)->size(); };
  EXPECT_EQ(found({}), 2u);
  EXPECT_EQ(found({"short", "", "", {}, {}}), 1u);
  EXPECT_EQ(found({"wave", "calm", "laugh", {}, {}}), 2u);
  EXPECT_EQ(found({"", "loud", "", {}, {}}), 0u);
  EXPECT_EQ(found({"", "", "", 1.0, {}}), 1u);
  EXPECT_EQ(found({"", "", "", {}, 1.0}), 1u);
}

TEST_F(Library, KeepsNothingOfAChangeThatWasNotCommitted) {
  {
    MotionLibrary open = library();
    ASSERT_TRUE(open.add(clip("first")));
    ASSERT_TRUE(open.begin());
    ASSERT_TRUE(open.add(clip("second")));
    // Another program reads what was there before.
    const auto reader = MotionLibrary::open(file(), false);
    ASSERT_TRUE(reader) << reader.error().message;
    EXPECT_EQ(reader->list()->size(), 1u);
  }
  EXPECT_EQ(library().list()->size(), 1u);
}

TEST_F(Library, RefusesWhatItDoesNotHaveOrHasAlready) {
  MotionLibrary open = library();
  ASSERT_TRUE(open.add(clip("wave")));
  const auto missing = open.load("waev");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::bad_input);
  EXPECT_NE(missing.error().message.find("did you mean \"wave\""), std::string::npos) << missing.error().message;
  EXPECT_FALSE(open.add(clip("wave")));
  EXPECT_TRUE(open.add(clip("wave"), true));
  EXPECT_EQ(open.list()->size(), 1u);
}

TEST_F(Library, RefusesFilesThatAreNoLibrary) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "text.db") << "this is no database, and long enough to be looked at as one by anybody";
  SQLite::Database(folder_ / "other.db", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE t (x)");
  for (const char* name : {"text.db", "other.db", "absent.db"}) {
    const auto opened = MotionLibrary::open(folder_ / name, false);
    ASSERT_FALSE(opened) << name;
    EXPECT_EQ(opened.error().kind, ErrorKind::bad_input);
    EXPECT_NE(opened.error().message.find(name), std::string::npos);
  }
}

TEST_F(Library, BringsAnOldLibraryToThePresentSchema) {
  { library(); }
  {
    SQLite::Database database(file(), SQLite::OPEN_READWRITE);
    database.exec(
        "DROP INDEX tags_by_tag; DROP INDEX clips_by_emotion; ALTER TABLE clips DROP COLUMN apex;"
        "PRAGMA user_version = 1");
  }
  EXPECT_FALSE(MotionLibrary::open(file(), false));
  MotionLibrary open = library();
  StoredClip given = clip("wave");
  given.entry.apex = 1.0;
  EXPECT_TRUE(open.add(given));
  SQLite::Database database(file(), SQLite::OPEN_READWRITE);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), library_version);
  database.exec("PRAGMA user_version = 99");
  const auto newer = MotionLibrary::open(file(), true);
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().message.find("99"), std::string::npos);
}

TEST_F(Library, FindsTheApex) {
  StoredClip given = clip("wave", 30);
  for (MotionFrame& frame : given.motion.frames) frame.rotations = given.motion.frames[0].rotations;
  given.motion.frames[17].rotations[2] = axis_rotation(0, 1.0);
  given.motion.frames[23].rotations[2] = axis_rotation(0, 0.5);
  EXPECT_NEAR(apex_of(given), 17 / 30.0, 1e-12);
  given.entry.apex = 0.25;
  EXPECT_EQ(apex_of(given), 0.25);
}

TEST_F(Library, KeepsEditsAndReplaysThem) {
  MotionLibrary open = library();
  ASSERT_TRUE(open.add(clip("wave")));
  const auto edit = nlohmann::json::parse(R"([{"operation": "scale", "joint": "LeftArm", "factor": 1.5},
                                              {"operation": "warp", "factor": 1.2}])");
  const auto more = nlohmann::json::parse(R"([{"operation": "mirror"}])");
  ASSERT_TRUE(edit_clip(open, "wave", "larger", edit, false));
  ASSERT_TRUE(edit_clip(open, "larger", "mirrored", more, false));
  const auto made = open.load("mirrored");
  ASSERT_TRUE(made);
  EXPECT_EQ(made->entry.parent, "larger");
  const auto all = edits_of(open, "mirrored");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->size(), 3u);
  ASSERT_TRUE(edit_clip(open, "wave", "again", *all, false));
  const auto again = open.load("again");
  // Two steps or one: the curves between are read with other roundings, which a fit may answer within its tolerance.
  for (std::size_t j = 0; j < 5; ++j)
    for (int axis = 0; axis < 3; ++axis)
      for (double t = 0.0; t < 2.0; t += 0.1)
        EXPECT_NEAR(again->curves->joints[j].angles[axis].value(t), made->curves->joints[j].angles[axis].value(t), 0.2);
  EXPECT_FALSE(edits_of(open, "wave"));
}

}  // namespace
}  // namespace sinew
