// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/NamedMeshes.h"

namespace skdtest
{

std::vector<NamedMesh> CurveMeshes()
{
  return { { "Vertices", [] { return MakePolyData(Cloud(300, VTK_VERTEX)); } },
    { "PolyVertices", [] { return MakePolyData(Cloud(300, VTK_POLY_VERTEX)); } },
    { "Lines", [] { return MakePolyData(Helix(200, VTK_LINE)); } },
    { "PolyLines", [] { return MakePolyData(Helix(200, VTK_POLY_LINE)); } } };
}

std::vector<NamedMesh> SurfaceMeshes()
{
  return { { "SphereTriangles", [] { return MakePolyData(SphereTriangles(8)); } },
    { "TorusTriangles", [] { return MakePolyData(TorusTriangles(24, 12)); } },
    { "TorusQuads", [] { return MakePolyData(TorusQuads(24, 12)); } },
    { "WarpedQuads", [] { return MakePolyData(SphereQuads(6).Map(Bent)); } },
    { "FlatQuads", [] { return MakeGrid(Sheet(12, VTK_QUAD)); } },
    { "FlatTriangles", [] { return MakePolyData(Sheet(12, VTK_TRIANGLE)); } },
    { "FlatPixels", [] { return MakeGrid(Sheet(12, VTK_PIXEL)); } },
    { "FlatImage", [] { return MakeFlatImage(12, 1); } },
    { "Polygons", [] { return MakePolyData(Hexagons(8)); } },
    { "Strips", [] { return MakePolyData(Strips(10)); } },
    { "Overlapping", [] { return MakePolyData(TriangleSoup(400, 0.2)); } },
    { "ManyOnOnePlace", [] { return MakePolyData(TriangleSoup(200, 2.0)); } } };
}

std::vector<NamedMesh> VolumeMeshes()
{
  return { { "Tetrahedra", [] { return MakeGrid(Tetrahedra(4).Map(Bent)); } },
    { "Hexahedra", [] { return MakeGrid(Hexahedra(5).Map(Rotated)); } },
    { "WarpedHexahedra", [] { return MakeGrid(Hexahedra(5).Map(Bent)); } },
    { "InvertedHexahedra", [] { return MakeGrid(InvertedHexahedra(5).Map(Bent)); } },
    { "Voxels", [] { return MakeGrid(Voxels(5)); } },
    { "Wedges", [] { return MakeGrid(Wedges(4).Map(Bent)); } },
    { "Pyramids", [] { return MakeGrid(Pyramids(4).Map(Bent)); } },
    { "Polyhedra", [] { return MakeGrid(Polyhedra(3).Map(Rotated)); } },
    { "Mixed", [] { return MakeGrid(MixedCells(3)); } }, { "Image", [] { return MakeImage(6); } },
    { "TurnedImage", [] { return MakeRotatedImage(5); } },
    { "Rectilinear", [] { return MakeRectilinear(6); } },
    { "Structured", [] { return MakeStructured(5); } },
    { "ExplicitStructured", [] { return MakeExplicitStructured(5); } } };
}

std::vector<NamedMesh> AllMeshes()
{
  std::vector<NamedMesh> all = CurveMeshes();
  for (const auto& more : { SurfaceMeshes(), VolumeMeshes() })
  {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}
