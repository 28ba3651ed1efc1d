#include "edit/edit_memory.h"

#include "geometry/topology.h"

namespace toile {

const ContactRegion& source_contact(const EditInput& input, EditMemory& memory) {
  return memory.once("contact", [&] { return contact_region(input); });
}

const std::vector<RelativePlace>& source_places(const EditInput& input, EditMemory& memory) {
  return memory.once("places", [&] { return relative_places(input.body, input.drape, input.garment.triangles); });
}

const std::vector<SourceTriangle>& source_shape(const EditInput& input, EditMemory& memory) {
  return memory.once("shape", [&] { return source_triangles(input.drape, input.garment.triangles); });
}

const LevelMesh& garment_edges(const EditInput& input, EditMemory& memory) {
  return memory.once("edges", [&] { return level_mesh(input.garment.triangles); });
}

const VertexNeighbours& garment_neighbours(const EditInput& input, EditMemory& memory) {
  return memory.once("neighbours", [&] { return neighbours_of(garment_edges(input, memory), input.drape.cols()); });
}

const std::vector<VertexLoop>& garment_boundary(const EditInput& input, EditMemory& memory) {
  return memory.once("boundary", [&] { return boundary_loops(input.garment.triangles); });
}

}  // namespace toile
