#include "engine/io/png.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>

#include <png.h>

namespace sinew {
namespace {

// libpng reports an error by longjmp, which skips destructors. So every function below that calls setjmp, and every
// callback that libpng calls, keeps nothing alive that has a destructor across a call that may jump; what is to be
// freed belongs to the caller of those functions.

struct Failure {
  char reason[128] = {};
};

[[noreturn]] void keep_reason_and_jump(png_structp png, png_const_charp reason) {
  auto* failure = static_cast<Failure*>(png_get_error_ptr(png));
  std::strncpy(failure->reason, reason, sizeof failure->reason - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// ---- Writing ----

/// Fixed so that a picture's bytes do not depend on what libpng guesses from it. Which filter and level: see
/// encode_png.
constexpr int row_filter = PNG_FILTER_UP;
constexpr int compression_level = 1;

class PngWriter {
 public:
  PngWriter() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure_, keep_reason_and_jump, ignore_warning)) {
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  bool ready() const { return info_ != nullptr; }
  const char* reason() const { return failure_.reason; }

  bool write(const unsigned char* rgba, int width, int height, std::span<png_text> texts, bool keep_alpha, Bytes& out) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_write_fn(png_, &out, append, nullptr);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, row_filter);
    png_set_compression_level(png_, compression_level);
    png_set_compression_buffer_size(png_, 1 << 16);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 keep_alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png_, info_);
    if (!keep_alpha) png_set_filler(png_, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < height; ++y) png_write_row(png_, rgba + std::size_t{4} * y * width);
    png_write_end(png_, nullptr);
    return true;
  }

 private:
  static void append(png_structp png, png_bytep data, std::size_t size) {
    auto* out = static_cast<Bytes*>(png_get_io_ptr(png));
    bool appended = true;
    try {
      out->insert(out->end(), data, data + size);
    } catch (const std::bad_alloc&) {
      appended = false;
    }
    if (!appended) png_error(png, "out of memory");
  }

  Failure failure_;
  png_structp png_;
  png_infop info_;
};

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
}

bool can_be_keyword(const std::string& keyword) {
  const bool printable =
      std::all_of(keyword.begin(), keyword.end(), [](unsigned char c) { return c >= 0x20 && c < 0x7F; });
  return printable && !keyword.empty() && keyword.size() <= 79 && keyword.front() != ' ' && keyword.back() != ' ' &&
         keyword.find("  ") == std::string::npos;
}

png_text written_text(const PngText& text) {
  png_text out{};
  const bool ascii = is_ascii(text.text);
  out.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
  // libpng's fields are not const, yet it only copies from them.
  out.key = const_cast<char*>(text.keyword.c_str());
  out.text = const_cast<char*>(text.text.c_str());
  (ascii ? out.text_length : out.itxt_length) = text.text.size();
  return out;
}

// ---- Reading ----

/// The bytes that libpng has not asked for yet.
struct Source {
  std::span<const unsigned char> rest;
};

/// Deflate never stores less than one byte for about 1030: a file shorter than this share of its picture is cut short,
/// or made to fill the memory.
constexpr std::size_t most_deflated = 1100;

class PngReader {
 public:
  PngReader() : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure_, keep_reason_and_jump, ignore_warning)) {
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  bool ready() const { return info_ != nullptr; }
  const char* reason() const { return failure_.reason; }

  bool read_header(Source& source) {
    const std::size_t size = source.rest.size();
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, &source, take);
    png_set_user_limits(png_, largest_png_side, largest_png_side);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png_, info_);
    if (png_get_rowbytes(png_, info_) * height() / most_deflated > size) png_error(png_, "cut short");
    return true;
  }

  /// `rows` are the picture's, [height], each of width * 4 bytes.
  bool read_picture(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    png_read_image(png_, rows);
    png_read_end(png_, info_);
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }

  std::span<const png_text> texts() const {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png_, info_, &texts, &count);
    return {texts, static_cast<std::size_t>(count)};
  }

 private:
  static void take(png_structp png, png_bytep data, std::size_t size) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (source->rest.size() < size) png_error(png, "cut short");
    std::memcpy(data, source->rest.data(), size);
    source->rest = source->rest.subspan(size);
  }

  Failure failure_;
  png_structp png_;
  png_infop info_;
};

std::string utf8_from_latin1(std::string_view latin1) {
  std::string out;
  for (const unsigned char c : latin1) {
    if (c < 0x80) {
      out.push_back(static_cast<char>(c));
    } else {
      out.push_back(static_cast<char>(0xC0 | c >> 6));
      out.push_back(static_cast<char>(0x80 | (c & 0x3F)));
    }
  }
  return out;
}

PngText read_text(const png_text& text) {
  const bool international = text.compression >= PNG_ITXT_COMPRESSION_NONE;
  if (text.text == nullptr) return {text.key, ""};
  if (international) return {text.key, std::string(text.text, text.itxt_length)};
  return {text.key, utf8_from_latin1({text.text, text.text_length})};
}

}  // namespace

// Measured on a shaded figure of 1280 x 720 pixels: every fixed filter at level 1 takes about 10 ms, and `Up` gives the
// smallest file of the fast ones (0.9 of `None`). Choosing a filter row by row takes twice as long for the same size,
// level 6 three times as long for two thirds of it.
Result<Bytes> encode_png(std::span<const unsigned char> rgba, int width, int height, std::span<const PngText> texts,
                         bool keep_alpha) {
  if (width < 1 || height < 1 || width > largest_png_side || height > largest_png_side)
    return failure(ErrorKind::cannot_write, "a PNG of {} x {} pixels cannot be written: each side is 1 to {}", width,
                   height, largest_png_side);
  if (rgba.size() != std::size_t{4} * width * height)
    return failure(ErrorKind::cannot_write, "a PNG of {} x {} pixels needs {} bytes, not {}", width, height,
                   std::size_t{4} * width * height, rgba.size());
  std::vector<png_text> written_texts;
  for (const PngText& text : texts) {
    if (!can_be_keyword(text.keyword) || text.text.find('\0') != std::string::npos)
      return failure(ErrorKind::cannot_write,
                     "the PNG text \"{}\" cannot be written: keywords are 1 to 79 printable ASCII characters without "
                     "outer or double spaces, texts have no NUL",
                     text.keyword);
    written_texts.push_back(written_text(text));
  }

  PngWriter writer;
  Bytes file;
  file.reserve(rgba.size() / 8);
  if (!writer.ready()) return failure(ErrorKind::cannot_write, "PNG: libpng does not start");
  if (!writer.write(rgba.data(), width, height, written_texts, keep_alpha, file))
    return failure(ErrorKind::cannot_write, "PNG: {}", writer.reason());
  return file;
}

Result<DecodedPng> decode_png(std::span<const unsigned char> file) {
  if (file.size() < 8 || png_sig_cmp(file.data(), 0, 8) != 0)
    return bad_input("not a PNG picture: its first 8 bytes are not PNG's signature");
  PngReader reader;
  if (!reader.ready()) return bad_input("PNG: libpng does not start");
  Source source{file};
  if (!reader.read_header(source)) return bad_input("damaged PNG: {}", reader.reason());

  DecodedPng decoded;
  decoded.width = static_cast<int>(reader.width());
  decoded.height = static_cast<int>(reader.height());
  decoded.rgba.resize(reader.width() * reader.height() * 4);
  std::vector<png_bytep> rows(reader.height());
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = decoded.rgba.data() + y * reader.width() * 4;
  if (!reader.read_picture(rows.data())) return bad_input("damaged PNG: {}", reader.reason());
  for (const png_text& text : reader.texts()) decoded.texts.push_back(read_text(text));
  return decoded;
}

}  // namespace sinew
