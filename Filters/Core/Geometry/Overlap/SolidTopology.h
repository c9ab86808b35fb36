// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_Overlap_SolidTopology_h
#define skd_Geometry_Overlap_SolidTopology_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace skd
{

/// Which corners of a convex polyhedron make its faces, counter-clockwise seen from without, and
/// which three neighbours each corner has.
///
/// Neighbours are in such an order that who comes to a corner from one of them and goes to the next
/// one walks around a face.
struct SolidTopology
{
  ///@{
  /// Of what is cut, and of what it is cut by.
  static constexpr int MostCorners = 32;
  static constexpr int MostFaces = 18;
  ///@}

  int Size = 0; ///< corners
  std::vector<std::array<std::uint8_t, 3>> Neighbours;
  std::vector<std::vector<int>> Faces;

  SolidTopology() = default;

  /// Of faces as `Neighbours` needs them; IsSimple() says whether they are.
  SolidTopology(int size, std::vector<std::vector<int>> faces)
    : Size(size)
    , Faces(std::move(faces))
  {
    for (int corner = 0; corner < this->Size; ++corner)
    {
      std::array<std::uint8_t, 3> neighbours;
      if (!this->FindNeighbours(corner, neighbours))
      {
        this->Neighbours.clear();
        return;
      }
      this->Neighbours.push_back(neighbours);
    }
  }

  /// Whether each corner has exactly three faces and neighbours: then it can be cut.
  bool IsSimple() const { return this->Size > 3 && !this->Neighbours.empty(); }

  static const SolidTopology& Tetrahedron()
  {
    static const SolidTopology tetrahedron(
      4, { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
    return tetrahedron;
  }
  /// In VTK's order.
  static const SolidTopology& Hexahedron()
  {
    static const SolidTopology hexahedron(8,
      { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
        { 4, 5, 6, 7 } });
    return hexahedron;
  }
  /// As two triangles above each other, counter-clockwise seen from above, the lower one first.
  static const SolidTopology& Wedge()
  {
    static const SolidTopology wedge(
      6, { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } });
    return wedge;
  }

private:
  /// From a neighbour on to the one after the corner in the face that comes from there.
  bool FindNeighbours(int corner, std::array<std::uint8_t, 3>& neighbours) const
  {
    std::array<std::array<int, 2>, 3> directions; // from, to
    int number = 0;
    for (const std::vector<int>& face : this->Faces)
    {
      const auto at = std::find(face.begin(), face.end(), corner);
      if (at != face.end())
      {
        if (number == 3)
        {
          return false;
        }
        directions[number++] = { at == face.begin() ? face.back() : *(at - 1),
          at + 1 == face.end() ? face.front() : *(at + 1) };
      }
    }
    if (number != 3)
    {
      return false;
    }
    int from = directions[0][0];
    for (int i = 0; i < 3; ++i)
    {
      neighbours[i] = static_cast<std::uint8_t>(from);
      const auto direction = std::find_if(
        directions.begin(), directions.end(), [from](const auto& w) { return w[0] == from; });
      if (direction == directions.end())
      {
        return false;
      }
      from = (*direction)[1];
    }
    return from == neighbours[0] && neighbours[0] != neighbours[1] &&
      neighbours[1] != neighbours[2] && neighbours[2] != neighbours[0];
  }
};

}

#endif
