#include <zlib.h>

#include "formats/svg_read/element.h"

namespace toile::svg {

bool is_gzip(std::string_view bytes) { return bytes.size() > 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

Loaded<std::string> unzipped(std::string_view bytes, const std::string& name, std::size_t limit) {
  Loaded<std::string> loaded;
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::runtime_error("zlib does not start");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string plain;
  char block[1 << 16];
  int state = Z_OK;
  while (state == Z_OK && plain.size() <= limit) {
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof block;
    state = inflate(&stream, Z_NO_FLUSH);
    plain.append(block, sizeof block - stream.avail_out);
  }
  inflateEnd(&stream);
  if (plain.size() > limit)
    loaded.report.error("svg.too-large", name, "the file unpacks to more than " + std::to_string(limit >> 20) + " MB",
                        "take pictures out of it, or split it");
  else if (state != Z_STREAM_END)
    loaded.report.error("svg.broken-gzip", name, "the compressed file is cut off or damaged", "export it again");
  else
    loaded.value = std::move(plain);
  return loaded;
}

}  // namespace toile::svg
