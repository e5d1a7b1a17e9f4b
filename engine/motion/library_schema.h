#pragma once
/// The library's tables and their versions.

#include <SQLiteCpp/Database.h>

namespace sinew {

constexpr int library_version = 2;
constexpr int library_application_id = 0x53696e77;  ///< "Sinw", in the file's header

/// Makes the tables of an empty database, or changes an older library's, in one transaction. Throws SQLite::Exception.
void migrate_library(SQLite::Database& database);

}  // namespace sinew
