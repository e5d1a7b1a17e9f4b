#include "engine/motion/library.h"

#include <cstdlib>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include "engine/core/text.h"
#include "engine/motion/library_rows.h"
#include "engine/motion/library_schema.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr int patience_ms = 30'000;  ///< for another program that writes

Error error_of(const fs::path& file, const SQLite::Exception& error, bool write) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      return {ErrorKind::bad_input, file.string() + ": is no motion library (no SQLite file)"};
    case SQLITE_CORRUPT:
      return {ErrorKind::bad_input, file.string() + ": the library is damaged"};
    case SQLITE_BUSY:
      return {ErrorKind::cannot_write, fmt::format("{}: another program has been writing to the library for {} s",
                                                   file.string(), patience_ms / 1000)};
    default:
      return {write ? ErrorKind::cannot_write : ErrorKind::bad_input,
              fmt::format("{}: {}", file.string(), error.what())};
  }
}

std::span<const unsigned char> blob(const SQLite::Column& column) {
  return {static_cast<const unsigned char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

void bind_blob(SQLite::Statement& statement, const char* name, const Bytes& bytes) {
  statement.bind(name, static_cast<const void*>(bytes.data()), static_cast<int>(bytes.size()));
}

constexpr const char* entry_columns =
    "SELECT c.name, c.frames, c.frame_time, c.emotion, c.source, c.licence, c.apex, c.parent, c.edit,"
    " (SELECT json_array_length(joints, '$.joints') FROM skeletons WHERE id = c.skeleton),"
    " EXISTS (SELECT 1 FROM curves WHERE clip = c.id),"
    " (SELECT group_concat(tag, ',') FROM (SELECT tag FROM tags WHERE clip = c.id ORDER BY tag)), c.id, c.skeleton"
    " FROM clips c";

ClipEntry entry_of(SQLite::Statement& row) {
  ClipEntry entry;
  entry.name = row.getColumn(0).getString();
  entry.frames = static_cast<std::size_t>(row.getColumn(1).getInt64());
  entry.frame_time = row.getColumn(2).getDouble();
  entry.emotion = row.getColumn(3).getString();
  entry.source = row.getColumn(4).getString();
  entry.licence = row.getColumn(5).getString();
  if (!row.getColumn(6).isNull()) entry.apex = row.getColumn(6).getDouble();
  entry.parent = row.getColumn(7).getString();
  entry.edit = row.getColumn(8).getString();
  entry.joints = static_cast<std::size_t>(row.getColumn(9).getInt64());
  entry.fitted = row.getColumn(10).getInt() != 0;
  if (!row.getColumn(11).isNull()) entry.tags = split(row.getColumn(11).getString(), ',');
  return entry;
}

}  // namespace

struct MotionLibrary::Impl {
  fs::path file;
  SQLite::Database database;
  std::unique_ptr<SQLite::Transaction> transaction;

  /// Runs `call`, SQLite's failures as ours.
  template <class Call>
  auto guarded(bool write, Call&& call) -> decltype(call()) {
    try {
      return call();
    } catch (const SQLite::Exception& error) {
      return tl::unexpected<Error>(error_of(file, error, write));
    }
  }

  std::int64_t skeleton_id(const MotionSkeleton& skeleton);
  std::optional<std::int64_t> clip_id(const std::string& name);
  void put_curves(std::int64_t clip, const CurveClip& curves);
  void put_tags(std::int64_t clip, const ClipEntry& entry);
  Result<std::optional<CurveClip>> curves_of(std::int64_t clip, const ClipEntry& entry);
  tl::unexpected<Error> unknown(const std::string& name);
};

std::int64_t MotionLibrary::Impl::skeleton_id(const MotionSkeleton& skeleton) {
  const std::string text = skeleton_text(skeleton), hash = sha256(text);
  SQLite::Statement insert(database, "INSERT OR IGNORE INTO skeletons (hash, joints) VALUES (?, ?)");
  insert.bind(1, hash);
  insert.bind(2, text);
  insert.exec();
  SQLite::Statement find(database, "SELECT id FROM skeletons WHERE hash = ?");
  find.bind(1, hash);
  find.executeStep();
  return find.getColumn(0).getInt64();
}

std::optional<std::int64_t> MotionLibrary::Impl::clip_id(const std::string& name) {
  SQLite::Statement find(database, "SELECT id FROM clips WHERE name = ?");
  find.bind(1, name);
  if (!find.executeStep()) return std::nullopt;
  return find.getColumn(0).getInt64();
}

void MotionLibrary::Impl::put_curves(std::int64_t clip, const CurveClip& curves) {
  SQLite::Statement clear(database, "DELETE FROM curves WHERE clip = ?");
  clear.bind(1, clip);
  clear.exec();
  SQLite::Statement insert(database,
                           "INSERT INTO curves (clip, joint, axis, rotation_order, cuts, coefficients)"
                           " VALUES (:clip, :joint, :axis, :order, :cuts, :coefficients)");
  const auto put = [&](int joint, const std::string& order, const AxisCurves& axes) {
    for (int axis = 0; axis < 3; ++axis) {
      const Bytes cuts = cut_bytes(axes[axis]), coefficients = coefficient_bytes(axes[axis]);
      insert.bind(":clip", clip);
      insert.bind(":joint", joint);
      insert.bind(":axis", axis);
      insert.bind(":order", order);
      bind_blob(insert, ":cuts", cuts);
      bind_blob(insert, ":coefficients", coefficients);
      insert.exec();
      insert.reset();
    }
  };
  put(-1, "", curves.root);
  for (std::size_t j = 0; j < curves.joints.size(); ++j)
    put(static_cast<int>(j), order_name(curves.joints[j].order), curves.joints[j].angles);
}

void MotionLibrary::Impl::put_tags(std::int64_t clip, const ClipEntry& entry) {
  SQLite::Statement clear(database, "DELETE FROM tags WHERE clip = ?");
  clear.bind(1, clip);
  clear.exec();
  SQLite::Statement insert(database, "INSERT OR IGNORE INTO tags (clip, tag) VALUES (?, ?)");
  for (const std::string& tag : entry.tags) {
    insert.bind(1, clip);
    insert.bind(2, tag);
    insert.exec();
    insert.reset();
  }
}

Result<std::optional<CurveClip>> MotionLibrary::Impl::curves_of(std::int64_t clip, const ClipEntry& entry) {
  if (!entry.fitted) return std::optional<CurveClip>();
  CurveClip curves;
  curves.frame_time = entry.frame_time;
  curves.joints.resize(entry.joints);
  std::size_t found = 0;
  SQLite::Statement rows(database, "SELECT joint, axis, rotation_order, cuts, coefficients FROM curves WHERE clip = ?");
  for (rows.bind(1, clip); rows.executeStep(); ++found) {
    const int joint = rows.getColumn(0).getInt(), axis = rows.getColumn(1).getInt();
    if (joint < -1 || joint >= static_cast<int>(entry.joints) || axis < 0 || axis > 2)
      return bad_input("{}: clip \"{}\" has a curve of joint {}, axis {}", file.string(), entry.name, joint, axis);
    auto curve = parse_curve(blob(rows.getColumn(3)), blob(rows.getColumn(4)));
    if (!curve) return bad_input("{}: clip \"{}\": {}", file.string(), entry.name, curve.error().message);
    if (joint >= 0 && !parse_order(rows.getColumn(2).getString(), curves.joints[joint].order))
      return bad_input("{}: clip \"{}\": joint {} turns in no known order", file.string(), entry.name, joint);
    (joint < 0 ? curves.root : curves.joints[joint].angles)[axis] = std::move(*curve);
  }
  if (found != 3 * (entry.joints + 1))
    return bad_input("{}: clip \"{}\" has {} curves; expected {}", file.string(), entry.name, found,
                     3 * (entry.joints + 1));
  return curves;
}

tl::unexpected<Error> MotionLibrary::Impl::unknown(const std::string& name) {
  std::vector<std::string> known;
  SQLite::Statement rows(database, "SELECT name FROM clips ORDER BY name");
  while (rows.executeStep()) known.push_back(rows.getColumn(0).getString());
  return bad_input("{}: there is no clip \"{}\"{}; it has {} clips", file.string(), name, did_you_mean(name, known),
                   known.size());
}

fs::path default_library() {
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  const fs::path folder =
      data != nullptr && *data != '\0' ? fs::path(data) : fs::path(home != nullptr ? home : ".") / ".local/share";
  return folder / "sinew" / "motions.db";
}

Result<MotionLibrary> MotionLibrary::open(const fs::path& file, bool write) {
  std::error_code error;
  if (!write && !fs::exists(file, error))
    return bad_input("{}: there is no motion library; `sinew motion import` makes one", file.string());
  if (write && file.has_parent_path()) {
    fs::create_directories(file.parent_path(), error);
    if (error)
      return failure(ErrorKind::cannot_write, "{}: its folder cannot be made: {}", file.string(), error.message());
  }
  try {
    const int mode = write ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE : SQLite::OPEN_READONLY;
    auto impl = std::unique_ptr<Impl>(new Impl{file, SQLite::Database(file.string(), mode, patience_ms), nullptr});
    SQLite::Database& database = impl->database;
    const int version = database.execAndGet("PRAGMA user_version").getInt();
    const int application = database.execAndGet("PRAGMA application_id").getInt();
    const int tables = database.execAndGet("SELECT count(*) FROM sqlite_master").getInt();
    if (tables > 0 && application != library_application_id)
      return bad_input("{}: is an SQLite file, but no motion library", file.string());
    if (version > library_version)
      return bad_input("{}: the library has version {}, this program knows {}; use a newer one", file.string(), version,
                       library_version);
    if (write) {
      database.exec("PRAGMA journal_mode = WAL; PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL");
      if (version < library_version) migrate_library(database);
    } else if (version < library_version) {
      return bad_input("{}: the library has version {}; any `sinew motion import` or `edit` brings it to {}",
                       file.string(), version, library_version);
    }
    return MotionLibrary(std::move(impl));
  } catch (const SQLite::Exception& failed) {
    return tl::unexpected<Error>(error_of(file, failed, write));
  }
}

MotionLibrary::MotionLibrary(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MotionLibrary::MotionLibrary(MotionLibrary&&) noexcept = default;
MotionLibrary& MotionLibrary::operator=(MotionLibrary&&) noexcept = default;
MotionLibrary::~MotionLibrary() = default;

const fs::path& MotionLibrary::file() const { return impl_->file; }

Result<std::vector<ClipEntry>> MotionLibrary::list(const ClipQuery& query) const {
  return impl_->guarded(false, [&]() -> Result<std::vector<ClipEntry>> {
    SQLite::Statement rows(impl_->database,
                           std::string(entry_columns) +
                               " WHERE (:name = '' OR instr(lower(c.name), lower(:name)) > 0)"
                               " AND (:emotion = '' OR c.emotion = :emotion)"
                               " AND (:tag = '' OR EXISTS (SELECT 1 FROM tags WHERE clip = c.id AND tag = :tag))"
                               " AND (c.frames - 1) * c.frame_time BETWEEN :shortest AND :longest ORDER BY c.name");
    rows.bind(":name", query.name);
    rows.bind(":emotion", query.emotion);
    rows.bind(":tag", query.tag);
    rows.bind(":shortest", query.shortest.value_or(0.0));
    rows.bind(":longest", query.longest.value_or(1e300));
    std::vector<ClipEntry> entries;
    while (rows.executeStep()) entries.push_back(entry_of(rows));
    return entries;
  });
}

Result<StoredClip> MotionLibrary::load(const std::string& name) const {
  return impl_->guarded(false, [&]() -> Result<StoredClip> {
    SQLite::Statement row(impl_->database, std::string(entry_columns) + " WHERE c.name = ?");
    row.bind(1, name);
    if (!row.executeStep()) return impl_->unknown(name);
    StoredClip clip;
    clip.entry = entry_of(row);
    const std::int64_t id = row.getColumn(12).getInt64();
    SQLite::Statement data(impl_->database,
                           "SELECT s.joints, c.samples FROM clips c JOIN skeletons s ON s.id = c.skeleton"
                           " WHERE c.id = ?");
    data.bind(1, id);
    data.executeStep();
    const auto place = [&](const Error& error) {
      return bad_input("{}: clip \"{}\": {}", impl_->file.string(), name, error.message);
    };
    auto skeleton = parse_skeleton(data.getColumn(0).getString());
    if (!skeleton) return place(skeleton.error());
    auto frames = parse_samples(blob(data.getColumn(1)), clip.entry.frames, skeleton->joints.size());
    if (!frames) return place(frames.error());
    clip.motion = {name, std::move(*skeleton), clip.entry.frame_time, std::move(*frames), {}};
    auto curves = impl_->curves_of(id, clip.entry);
    if (!curves) return pass_on(std::move(curves));
    clip.curves = std::move(*curves);
    return clip;
  });
}

Result<void> MotionLibrary::begin() {
  return impl_->guarded(true, [&]() -> Result<void> {
    impl_->transaction = std::make_unique<SQLite::Transaction>(impl_->database, SQLite::TransactionBehavior::IMMEDIATE);
    return {};
  });
}

Result<void> MotionLibrary::commit() {
  return impl_->guarded(true, [&]() -> Result<void> {
    impl_->transaction->commit();
    impl_->transaction.reset();
    return {};
  });
}

Result<void> MotionLibrary::add(const StoredClip& clip, bool replace) {
  return impl_->guarded(true, [&]() -> Result<void> {
    const ClipEntry& entry = clip.entry;
    if (impl_->clip_id(entry.name)) {
      if (!replace)
        return bad_input("{}: there is a clip \"{}\" already; give another name, or replace it with --replace",
                         impl_->file.string(), entry.name);
      if (auto gone = remove(entry.name); !gone) return gone;
    }
    const Bytes samples = sample_bytes(clip.motion);
    SQLite::Statement insert(
        impl_->database,
        "INSERT INTO clips (name, skeleton, frames, frame_time, samples, emotion, source, licence, parent, edit, apex)"
        " VALUES (:name, :skeleton, :frames, :frame_time, :samples, :emotion, :source, :licence, :parent, :edit,"
        " :apex)");
    insert.bind(":name", entry.name);
    insert.bind(":skeleton", impl_->skeleton_id(clip.motion.skeleton));
    insert.bind(":frames", static_cast<std::int64_t>(clip.motion.frames.size()));
    insert.bind(":frame_time", clip.motion.frame_time);
    bind_blob(insert, ":samples", samples);
    insert.bind(":emotion", entry.emotion);
    insert.bind(":source", entry.source);
    insert.bind(":licence", entry.licence);
    insert.bind(":parent", entry.parent);
    insert.bind(":edit", entry.edit);
    if (entry.apex) insert.bind(":apex", *entry.apex);
    insert.exec();
    const std::int64_t id = impl_->database.getLastInsertRowid();
    impl_->put_tags(id, entry);
    if (clip.curves) impl_->put_curves(id, *clip.curves);
    return {};
  });
}

Result<void> MotionLibrary::set_curves(const std::string& name, const CurveClip& curves) {
  return impl_->guarded(true, [&]() -> Result<void> {
    const auto id = impl_->clip_id(name);
    if (!id) return impl_->unknown(name);
    impl_->put_curves(*id, curves);
    return {};
  });
}

Result<void> MotionLibrary::annotate(const ClipEntry& entry) {
  return impl_->guarded(true, [&]() -> Result<void> {
    const auto id = impl_->clip_id(entry.name);
    if (!id) return impl_->unknown(entry.name);
    SQLite::Statement update(impl_->database,
                             "UPDATE clips SET emotion = ?, source = ?, licence = ?, apex = ? WHERE id = ?");
    update.bind(1, entry.emotion);
    update.bind(2, entry.source);
    update.bind(3, entry.licence);
    if (entry.apex) update.bind(4, *entry.apex);
    update.bind(5, *id);
    update.exec();
    impl_->put_tags(*id, entry);
    return {};
  });
}

Result<void> MotionLibrary::remove(const std::string& name) {
  return impl_->guarded(true, [&]() -> Result<void> {
    const auto id = impl_->clip_id(name);
    if (!id) return impl_->unknown(name);
    SQLite::Statement erase(impl_->database, "DELETE FROM clips WHERE id = ?");
    erase.bind(1, *id);
    erase.exec();
    return {};
  });
}

}  // namespace sinew
