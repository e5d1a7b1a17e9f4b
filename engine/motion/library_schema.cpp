#include "engine/motion/library_schema.h"

#include <array>

#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

namespace sinew {
namespace {

/// What brings a library from each version to the next; 0 is an empty database.
constexpr std::array<const char*, library_version> steps{
    R"(CREATE TABLE skeletons (id INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE, joints TEXT NOT NULL);
       CREATE TABLE clips (
         id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, skeleton INTEGER NOT NULL REFERENCES skeletons(id),
         frames INTEGER NOT NULL, frame_time REAL NOT NULL, samples BLOB NOT NULL,
         emotion TEXT NOT NULL DEFAULT '', source TEXT NOT NULL DEFAULT '', licence TEXT NOT NULL DEFAULT '',
         parent TEXT NOT NULL DEFAULT '', edit TEXT NOT NULL DEFAULT '');
       CREATE TABLE tags (
         clip INTEGER NOT NULL REFERENCES clips(id) ON DELETE CASCADE, tag TEXT NOT NULL, PRIMARY KEY (clip, tag));
       CREATE TABLE curves (
         clip INTEGER NOT NULL REFERENCES clips(id) ON DELETE CASCADE, joint INTEGER NOT NULL, axis INTEGER NOT NULL,
         rotation_order TEXT NOT NULL, cuts BLOB NOT NULL, coefficients BLOB NOT NULL,
         PRIMARY KEY (clip, joint, axis));)",
    R"(ALTER TABLE clips ADD COLUMN apex REAL;
       CREATE INDEX clips_by_emotion ON clips(emotion);
       CREATE INDEX tags_by_tag ON tags(tag);)",
};

}  // namespace

void migrate_library(SQLite::Database& database) {
  // Another program may be about to do the same: whoever has the lock looks again.
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  for (int step = version; step < library_version; ++step) database.exec(steps[step]);
  database.exec(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", library_application_id, library_version));
  transaction.commit();
}

}  // namespace sinew
