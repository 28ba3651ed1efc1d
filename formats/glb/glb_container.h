#pragma once
// The parts of a binary glTF file (Khronos glTF 2.0, section 4.4): a chunk of JSON and one buffer, little-endian.

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace toile {

// One buffer, filled view by view; every view starts at a multiple of four bytes.
class GlbBuffer {
 public:
  struct View {
    std::size_t offset = 0, length = 0;
  };
  View add(const Eigen::Matrix3Xf& columns);
  View add(const Eigen::VectorXf& values);
  View add(const Eigen::Matrix<std::uint32_t, 3, Eigen::Dynamic>& columns);
  View add(const Eigen::Matrix<std::uint16_t, 4, Eigen::Dynamic>& columns);
  const std::string& bytes() const { return bytes_; }

 private:
  View add_bytes(const void* data, std::size_t length);
  std::string bytes_;
};

// The whole file. `json` names the buffer's length in buffers[0].byteLength.
std::string glb_bytes(const std::string& json, const GlbBuffer& buffer);

}  // namespace toile
