#include "engine/io/film.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <random>

#include <gtest/gtest.h>

#include "engine/core/files.h"
#include "engine/io/film_kind.h"
#include "tests/support/film_reader.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using test::read_film;
using test::ReadFilm;

/// A square that wanders over a flat ground, each frame a little redder and less blue than the one before.
Picture moving_square(int width, int height, int frame) {
  Picture picture{width, height, {}};
  const int side = height / 3, left = frame % (width - side + 1), top = height / 4;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool inside = x >= left && x < left + side && y >= top && y < top + side;
      const auto red = static_cast<std::uint8_t>(60 + 5 * frame), blue = static_cast<std::uint8_t>(180 - 5 * frame);
      if (inside)
        picture.rgba.insert(picture.rgba.end(), {230, 180, 150, 255});
      else
        picture.rgba.insert(picture.rgba.end(), {red, 120, blue, 255});
    }
  return picture;
}

Picture noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  for (std::uint8_t& byte : picture.rgba) byte = static_cast<std::uint8_t>(random());
  return picture;
}

std::array<double, 4> mean(const Picture& picture) {
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) sum[i % 4] += picture.rgba[i];
  for (double& channel : sum) channel /= double(picture.width) * picture.height;
  return sum;
}

std::array<int, 4> pixel(const Picture& picture, int x, int y) {
  const std::uint8_t* p = picture.rgba.data() + std::size_t{4} * (std::size_t(y) * picture.width + x);
  return {p[0], p[1], p[2], p[3]};
}

/// A folder of its own for each test.
class Film : public testing::TestWithParam<const char*> {
 protected:
  Film() : folder_(fs::path(testing::TempDir()) / fmt::format("sinew_film_{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Film() override { fs::remove_all(folder_); }

  std::string named(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  /// The notes of the finished film.
  static std::vector<std::string> write(const std::string& file, const std::vector<Picture>& pictures,
                                        double fps = 24.0, bool keep_alpha = false) {
    auto film = FilmWriter::create(file, {pictures.front().width, pictures.front().height, fps, keep_alpha});
    EXPECT_TRUE(film) << film.error().message;
    if (!film) return {};
    for (const Picture& picture : pictures) {
      const auto added = film->add(picture);
      EXPECT_TRUE(added) << added.error().message;
    }
    const auto finished = film->finish();
    EXPECT_TRUE(finished) << finished.error().message;
    return film->notes();
  }

  template <class T>
  static void expect_refused(const Result<T>& result, ErrorKind kind, const std::string& part) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, kind);
    EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  }

  fs::path folder_;
};

using EachFilm = Film;
INSTANTIATE_TEST_SUITE_P(Endings, EachFilm, testing::Values("a.mp4", "a.webm", "a.gif"),
                         [](const auto& info) { return std::string(info.param).substr(2); });

std::vector<Picture> moving_squares(int width, int height, int count) {
  std::vector<Picture> pictures;
  for (int i = 0; i < count; ++i) pictures.push_back(moving_square(width, height, i));
  return pictures;
}

TEST_P(EachFilm, ComesBack) {
  const auto pictures = moving_squares(64, 48, 24);
  const std::string file = named(GetParam());
  EXPECT_TRUE(write(file, pictures).empty());
  const ReadFilm film = read_film(file);
  ASSERT_EQ(film.problem, "");
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(film.width, 64);
  EXPECT_EQ(film.height, 48);
  EXPECT_NEAR(film.duration, 1.0, 1e-6);
  ASSERT_EQ(film.frames.size(), 24u);
  // A .gif counts hundredths of a second, a .webm thousandths.
  const double time_tolerance = film.codec == "gif" ? 0.00501 : film.codec == "vp9" ? 0.000501 : 1e-9;
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_NEAR(film.frames[i].seconds, double(i) / 24.0, time_tolerance);
    const auto expected = mean(pictures[i]), found = mean(film.frames[i].picture);
    // Eight bits of limited range round to 1.2 levels, and the encoders' quality leaves as much again. Half of what one
    // frame differs from the next, so that frames out of order do not pass.
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(found[c], expected[c], 2.4) << "frame " << i << " channel " << c;
  }
}

TEST_P(EachFilm, MayBeOnePicture) {
  write(named(GetParam()), moving_squares(64, 48, 1));
  const ReadFilm film = read_film(named(GetParam()));
  ASSERT_EQ(film.problem, "");
  EXPECT_EQ(film.frames.size(), 1u);
  // In hundredths of a second a twenty-fourth is 4.
  EXPECT_NEAR(film.duration, 1.0 / 24.0, 0.002);
}

TEST_P(EachFilm, KeepsNtscRates) {
  write(named(GetParam()), moving_squares(64, 48, 3), 23.976);
  const ReadFilm film = read_film(named(GetParam()));
  ASSERT_EQ(film.problem, "");
  ASSERT_EQ(film.frames.size(), 3u);
  EXPECT_NEAR(film.frames[2].seconds, 2 * 1001.0 / 24000.0, film.codec == "gif" ? 0.005 : 0.0005);
  if (film.codec == "gif") return;  // it states no rate
  // A .webm states how many nanoseconds a frame lasts.
  EXPECT_NEAR(av_q2d(film.fps), 24000.0 / 1001.0, film.codec == "vp9" ? 1e-5 : 1e-12);
}

TEST_P(EachFilm, TheSamePicturesGiveTheSameBytes) {
  std::vector<Picture> pictures;
  for (unsigned i = 0; i < 12; ++i)
    pictures.push_back(i % 2 == 0 ? noise(320, 180, i) : moving_square(320, 180, int(i)));
  write(named(GetParam()), pictures);
  const Bytes first = read_file(named(GetParam())).value();
  for (int again = 0; again < 3; ++again) {
    write(named(GetParam()), pictures);
    EXPECT_EQ(read_file(named(GetParam())).value(), first);
  }
}

TEST_P(EachFilm, MayBeOfAnySize) {
  const bool padded = std::string(GetParam()).ends_with(".mp4");
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{65, 49}, std::pair{17, 2}, std::pair{64, 33}}) {
    const auto notes = write(named(GetParam()), {noise(width, height, 1), noise(width, height, 2)});
    const ReadFilm film = read_film(named(GetParam()));
    ASSERT_EQ(film.problem, "");
    EXPECT_EQ(film.width, padded ? width + width % 2 : width);
    EXPECT_EQ(film.height, padded ? height + height % 2 : height);
    EXPECT_EQ(film.frames.size(), 2u);
    EXPECT_EQ(notes.size(), padded ? 1u : 0u);
  }
}

TEST_P(EachFilm, DroppedLeavesWhatStoodThere) {
  const std::string file = named(GetParam());
  ASSERT_TRUE(write_file(file, std::string("before")));
  {
    auto film = FilmWriter::create(file, {64, 48});
    ASSERT_TRUE(film) << film.error().message;
    for (const Picture& picture : moving_squares(64, 48, 20)) EXPECT_TRUE(film->add(picture));
    FilmWriter moved = std::move(*film);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(read_file(file).value().size(), 6u);
}

TEST_P(EachFilm, NeedsAPicture) {
  {
    auto film = FilmWriter::create(named(GetParam()), {64, 48});
    ASSERT_TRUE(film) << film.error().message;
    expect_refused(film->finish(), ErrorKind::bad_input, "at least one picture");
  }
  EXPECT_EQ(files(), 0u);
}

TEST_P(EachFilm, TakesPicturesOfItsSizeOnly) {
  auto film = FilmWriter::create(named(GetParam()), {64, 48});
  ASSERT_TRUE(film) << film.error().message;
  EXPECT_TRUE(film->add(noise(64, 48, 1)));
  expect_refused(film->add(noise(48, 64, 1)), ErrorKind::bad_input, "picture 1 is 48 x 64");
  expect_refused(film->add(noise(64, 48, 1)), ErrorKind::bad_input, "picture 1 is 48 x 64");
  expect_refused(film->finish(), ErrorKind::bad_input, "picture 1 is 48 x 64");
}

TEST_P(EachFilm, AFullDiskIsReported) {
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  // The first limit stops what is written at the very end, the second what is written on the way.
  for (const auto& [limit, count] : {std::pair{100, 1}, std::pair{100'000, 40}}) {
    const rlimit small{rlim_t(limit), old.rlim_max};
    auto film = FilmWriter::create(named(GetParam()), {320, 180});
    ASSERT_TRUE(film) << film.error().message;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    for (int i = 0; i < count; ++i) (void)film->add(noise(320, 180, unsigned(i)));
    const auto finished = film->finish();
    ::setrlimit(RLIMIT_FSIZE, &old);
    expect_refused(finished, ErrorKind::cannot_write, named(GetParam()) + ": cannot be written: File too large");
  }
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(files(), 0u);
}

TEST_P(EachFilm, NeedsAFolderThatIsThere) {
  const fs::path name = GetParam();
  expect_refused(FilmWriter::create(folder_ / "none" / name, {64, 48}), ErrorKind::cannot_write, "does not exist");
  fs::create_directories(folder_ / name);
  expect_refused(FilmWriter::create(folder_ / name, {64, 48}), ErrorKind::cannot_write, "is a folder");
}

TEST_P(EachFilm, RefusesSizesAndRatesOutOfRange) {
  const std::string file = named(GetParam());
  expect_refused(FilmWriter::create(file, {0, 48}), ErrorKind::bad_input, "each side is 1 to 16384");
  expect_refused(FilmWriter::create(file, {64, 16385}), ErrorKind::bad_input, "each side is 1 to 16384");
  for (const double fps : {0.0, -24.0, 1e-3, 1e4, std::nan("")})
    expect_refused(FilmWriter::create(file, {64, 48, fps}), ErrorKind::bad_input, "0.01 to 1000");
  EXPECT_EQ(files(), 0u);
}

TEST_P(EachFilm, IsQuiet) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  write(named(GetParam()), {noise(63, 47, 1)}, 1000.0, true);
  // More pixels than FFmpeg ever takes.
  expect_refused(FilmWriter::create(named(GetParam()), {16384, 16384}), ErrorKind::cannot_write, "16384");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Film, NamesSayWhatIsWritten) {
  for (const char* good : {"a.mp4", "A.MP4", "some/where/b.webm", "c.d.Gif"})
    EXPECT_TRUE(check_film_name(good)) << good;
  for (const char* bad : {"a.avi", "a", "", ".mp4", "mp4", "a.mp4/"})
    expect_refused(check_film_name(bad), ErrorKind::usage, ".mp4, .webm or .gif");
  expect_refused(FilmWriter::create(named("a.mov"), {64, 48}), ErrorKind::usage, ".mp4, .webm or .gif");
}

TEST_F(Film, AMissingEncoderIsSaidWithWhatToInstall) {
  FilmKind kind = **film_kind("a.mp4");
  EXPECT_TRUE(check_encoder(kind, "a.mp4"));
  kind.encoder = "libx266";
  expect_refused(check_encoder(kind, "shots/a.mp4"), ErrorKind::cannot_write, "shots/a.mp4");
  expect_refused(check_encoder(kind, "a.mp4"), ErrorKind::cannot_write, "encoder libx266; install");
  expect_refused(check_encoder(kind, "a.mp4"), ErrorKind::cannot_write, "Debian: libavcodec");
  kind = **film_kind("a.mp4");
  kind.muxer = "none";
  expect_refused(check_encoder(kind, "a.mp4"), ErrorKind::cannot_write, ".mp4");
}

TEST_F(Film, NamesMayHoldAnything) {
  for (const char* name : {"pipe:1.mp4", "größe 50%d.webm", "-a.gif"}) {
    write(named(name), moving_squares(64, 48, 2));
    EXPECT_EQ(read_film(named(name)).frames.size(), 2u) << name;
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  write("here.mp4", moving_squares(64, 48, 2));
  fs::current_path(before);
  EXPECT_EQ(files(), 4u);
}

TEST_F(Film, RatesAreTheRatiosThatWereMeant) {
  const auto expect = [](double fps, int numerator, int denominator) {
    EXPECT_EQ(frame_rate(fps).num, numerator) << fps;
    EXPECT_EQ(frame_rate(fps).den, denominator) << fps;
  };
  for (const double film : {23.976, 23.98, 23.9760239760}) expect(film, 24000, 1001);
  for (const double television : {29.97, 29.97002997}) expect(television, 30000, 1001);
  for (const double fast : {59.94, 59.9401}) expect(fast, 60000, 1001);
  for (const int whole : {1, 12, 24, 25, 30, 48, 50, 60, 100, 120, 1000}) expect(whole, whole, 1);
  expect(12.5, 25, 2);
  expect(23.95, 479, 20);
  expect(14.985, 2997, 200);
  expect(0.01, 1, 100);
}

TEST_F(Film, Mp4SaysItsColoursAndStartsAtOnce) {
  write(named("a.mp4"), moving_squares(64, 48, 24));
  const ReadFilm film = read_film(named("a.mp4"));
  EXPECT_EQ(film.codec, "h264");
  EXPECT_EQ(film.matrix, AVCOL_SPC_BT709);
  EXPECT_EQ(film.range, AVCOL_RANGE_MPEG);
  const Bytes bytes = read_file(named("a.mp4")).value();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_LT(text.find("moov"), text.find("mdat"));
}

TEST_F(Film, Mp4RepeatsTheLastColumnAndRow) {
  Picture picture = moving_square(33, 31, 0);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    if (i / 4 % 33 >= 24) std::copy_n(std::array<std::uint8_t, 3>{20, 200, 40}.data(), 3, picture.rgba.data() + i);
  const auto notes = write(named("a.mp4"), {picture});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("33 x 31 became 34 x 32"), std::string::npos) << notes[0];
  const ReadFilm film = read_film(named("a.mp4"));
  ASSERT_EQ(film.frames.size(), 1u);
  for (const auto& [x, y] : {std::pair{33, 0}, std::pair{33, 31}, std::pair{28, 31}}) {
    const auto found = pixel(film.frames[0].picture, x, y);
    // A single pixel of a flat area, not a mean: the encoder's rounding is seen in full.
    EXPECT_NEAR(found[0], 20, 6);
    EXPECT_NEAR(found[1], 200, 6);
    EXPECT_NEAR(found[2], 40, 6);
  }
}

/// Left half clear, right half opaque, a colour of its own under the clear half.
Picture half_clear() {
  Picture picture{64, 48, {}};
  for (int i = 0; i < 64 * 48; ++i) {
    if (i % 64 < 32)
      picture.rgba.insert(picture.rgba.end(), {40, 40, 200, 0});
    else
      picture.rgba.insert(picture.rgba.end(), {200, 40, 40, 255});
  }
  return picture;
}

TEST_F(Film, TransparencyIsKeptWhereAskedForAndPossible) {
  const std::vector<Picture> pictures(3, half_clear());
  for (const char* name : {"a.webm", "a.gif"}) {
    EXPECT_TRUE(write(named(name), pictures, 24.0, true).empty());
    const ReadFilm film = read_film(named(name));
    ASSERT_EQ(film.frames.size(), 3u) << film.problem;
    for (const test::FilmFrame& frame : film.frames) {
      // VP9 codes alpha as it codes brightness: close, not exact.
      EXPECT_NEAR(pixel(frame.picture, 8, 24)[3], 0, 3) << name;
      EXPECT_NEAR(pixel(frame.picture, 56, 24)[3], 255, 3) << name;
    }
  }
  const auto notes = write(named("a.mp4"), pictures, 24.0, true);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("transparency is lost"), std::string::npos) << notes[0];
}

TEST_P(EachFilm, DropsTransparencyUnlessAsked) {
  write(named(GetParam()), {half_clear(), half_clear()});
  const ReadFilm film = read_film(named(GetParam()));
  ASSERT_EQ(film.frames.size(), 2u) << film.problem;
  const auto clear = pixel(film.frames[1].picture, 8, 24);
  EXPECT_EQ(clear[3], 255);
  // One pixel of a flat area: see above.
  EXPECT_NEAR(clear[0], 40, 6);
  EXPECT_NEAR(clear[2], 200, 6);
}

TEST_F(Film, GifDelaysDoNotDrift) {
  write(named("a.gif"), moving_squares(64, 48, 24), 24.0);
  const ReadFilm film = read_film(named("a.gif"));
  for (std::size_t i = 0; i < film.frames.size(); ++i)
    EXPECT_EQ(std::lround(film.frames[i].seconds * 100.0), std::lround(double(i) * 100.0 / 24.0)) << i;
}

TEST_F(Film, GifLoopsForever) {
  write(named("a.gif"), moving_squares(64, 48, 2));
  const Bytes bytes = read_file(named("a.gif")).value();
  const std::string text(bytes.begin(), bytes.end());
  // The extension's sub-block: 3 bytes, number 1, the count of loops in two bytes, 0 for no end.
  EXPECT_NE(text.find(std::string("NETSCAPE2.0\x03\x01\x00\x00\x00", 16)), std::string::npos);
}

TEST_F(Film, GifLeavesOutWhatNoPlayerShows) {
  const auto notes = write(named("a.gif"), moving_squares(64, 48, 20), 100.0);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("10 of 20 pictures are left out: .gif shows at most 50 a second"), std::string::npos)
      << notes[0];
  const ReadFilm film = read_film(named("a.gif"));
  EXPECT_EQ(film.frames.size(), 10u);
  EXPECT_NEAR(film.duration, 0.2, 1e-6);
}

}  // namespace
}  // namespace sinew
