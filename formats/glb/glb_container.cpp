#include "formats/glb/glb_container.h"

#include <bit>
#include <limits>
#include <stdexcept>

namespace toile {
namespace {

static_assert(std::endian::native == std::endian::little, "buffers are written as they lie in memory");

void add_word(std::string& bytes, std::size_t value) {
  if (value > std::numeric_limits<std::uint32_t>::max()) throw std::invalid_argument("glb: more than 4 GB");
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 255U);
}

std::string padded(std::string bytes, char with) {
  bytes.append((4 - bytes.size() % 4) % 4, with);
  return bytes;
}

}  // namespace

GlbBuffer::View GlbBuffer::add_bytes(const void* data, std::size_t length) {
  bytes_ = padded(std::move(bytes_), '\0');
  const View view{bytes_.size(), length};
  bytes_.append(static_cast<const char*>(data), length);
  return view;
}

GlbBuffer::View GlbBuffer::add(const Eigen::Matrix3Xf& columns) {
  return add_bytes(columns.data(), sizeof(float) * static_cast<std::size_t>(columns.size()));
}

GlbBuffer::View GlbBuffer::add(const Eigen::VectorXf& values) {
  return add_bytes(values.data(), sizeof(float) * static_cast<std::size_t>(values.size()));
}

GlbBuffer::View GlbBuffer::add(const Eigen::Matrix<std::uint32_t, 3, Eigen::Dynamic>& columns) {
  return add_bytes(columns.data(), sizeof(std::uint32_t) * static_cast<std::size_t>(columns.size()));
}

GlbBuffer::View GlbBuffer::add(const Eigen::Matrix<std::uint16_t, 4, Eigen::Dynamic>& columns) {
  return add_bytes(columns.data(), sizeof(std::uint16_t) * static_cast<std::size_t>(columns.size()));
}

std::string glb_bytes(const std::string& json, const GlbBuffer& buffer) {
  const std::string text = padded(json, ' '), binary = padded(buffer.bytes(), '\0');
  std::string file = "glTF";
  add_word(file, 2);
  add_word(file, 12 + 8 + text.size() + 8 + binary.size());
  add_word(file, text.size());
  file += "JSON" + text;
  add_word(file, binary.size());
  file += std::string("BIN\0", 4) + binary;
  return file;
}

}  // namespace toile
