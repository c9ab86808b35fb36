// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/SkdPackedMesh.h"

#include "Cells/Read/SkdCellReader.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObjectTypes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <vector>

namespace skdtree
{
namespace
{
/// Names of arrays in the list: what it is, then the array's own name.
const std::string PointPrefix = "point ";
const std::string CellPrefix = "cell ";
const std::string FieldPrefix = "field ";
const std::string KindNames[4] = { "verts", "lines", "polys", "strips" };

/// The attributes of a data set are numbers of vtkDataSetAttributes, -1: none.
std::string AttributePrefix(const std::string& prefix, int attribute)
{
  return prefix + std::to_string(attribute) + " ";
}

//------------------------------------------------------------------------------
class Packer
{
public:
  explicit Packer(vtkTable* table)
    : List(table->GetFieldData())
  {
  }

  void Add(const std::string& name, vtkAbstractArray* array)
  {
    if (!array)
    {
      return;
    }
    const bool isPlain = array->HasStandardMemoryLayout();
    auto copy = vtkSmartPointer<vtkAbstractArray>::Take(
      isPlain ? array->NewInstance() : vtkAbstractArray::CreateArray(array->GetDataType()));
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (isPlain && numbers)
    {
      vtkDataArray::SafeDownCast(copy)->ShallowCopy(numbers);
    }
    else
    {
      copy->DeepCopy(array);
    }
    copy->SetName(name.c_str());
    this->List->AddArray(copy);
  }

  template <class Array, class Value>
  void AddNumbers(const std::string& name, const Value* values, vtkIdType number)
  {
    vtkNew<Array> array;
    array->SetNumberOfValues(number);
    std::copy_n(values, number, array->GetPointer(0));
    this->Add(name, array);
  }

  void AddPoints(vtkPoints* points) { this->Add("points", points ? points->GetData() : nullptr); }

  void AddCells(const std::string& name, vtkCellArray* cells)
  {
    if (cells && cells->GetNumberOfCells() > 0)
    {
      this->Add(name + " offsets", cells->GetOffsetsArray());
      this->Add(name + " ids", cells->GetConnectivityArray());
    }
  }

  void AddAttributes(const std::string& prefix, vtkDataSetAttributes* data)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const char* name = array->GetName();
      this->Add(AttributePrefix(prefix, data->IsArrayAnAttribute(i)) + (name ? name : ""), array);
    }
  }

  void AddField(vtkFieldData* field)
  {
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      const char* name = field->GetAbstractArray(i)->GetName();
      this->Add(FieldPrefix + (name ? name : ""), field->GetAbstractArray(i));
    }
  }

private:
  vtkFieldData* List;
};

void PackGeometry(vtkPolyData* mesh, Packer& packer)
{
  packer.AddPoints(mesh->GetPoints());
  vtkCellArray* const kinds[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  for (int kind = 0; kind < 4; ++kind)
  {
    packer.AddCells(KindNames[kind], kinds[kind]);
  }
}

/// The faces of all polyhedra in turn, each as its length and VTK's stream of faces: the versions
/// of VTK store them in different ways.
void PackPolyhedra(vtkUnstructuredGrid* grid, const vtkUnsignedCharArray* types, Packer& packer)
{
  vtkNew<vtkIdTypeArray> streams;
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < types->GetNumberOfValues(); ++cell)
  {
    if (types->GetValue(cell) == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(cell, stream);
      streams->InsertNextValue(stream->GetNumberOfIds());
      std::for_each(
        stream->begin(), stream->end(), [&](vtkIdType id) { streams->InsertNextValue(id); });
    }
  }
  if (streams->GetNumberOfValues() > 0)
  {
    packer.Add("faces", streams);
  }
}

void PackGeometry(vtkUnstructuredGrid* grid, Packer& packer)
{
  packer.AddPoints(grid->GetPoints());
  packer.AddCells("cells", grid->GetCells());
  const SkdCellReader reader(grid);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    types->SetValue(cell, static_cast<unsigned char>(reader.TypeOf(cell)));
  }
  packer.Add("types", types);
  PackPolyhedra(grid, types, packer);
}

void PackGeometry(vtkImageData* image, Packer& packer)
{
  packer.AddNumbers<vtkIntArray>("extent", image->GetExtent(), 6);
  packer.AddNumbers<vtkDoubleArray>("origin", image->GetOrigin(), 3);
  packer.AddNumbers<vtkDoubleArray>("spacing", image->GetSpacing(), 3);
  packer.AddNumbers<vtkDoubleArray>("direction", image->GetDirectionMatrix()->GetData(), 9);
}

void PackGeometry(vtkRectilinearGrid* grid, Packer& packer)
{
  packer.AddNumbers<vtkIntArray>("extent", grid->GetExtent(), 6);
  packer.Add("x", grid->GetXCoordinates());
  packer.Add("y", grid->GetYCoordinates());
  packer.Add("z", grid->GetZCoordinates());
}

void PackGeometry(vtkStructuredGrid* grid, Packer& packer)
{
  packer.AddNumbers<vtkIntArray>("extent", grid->GetExtent(), 6);
  packer.AddPoints(grid->GetPoints());
}

/// Of a type without a form of its own: points and cells as vtkDataSet gives them.
vtkSmartPointer<vtkUnstructuredGrid> GridOf(vtkDataSet* mesh)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->Allocate(mesh->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    grid->InsertNextCell(mesh->GetCellType(cell), ids);
  }
  grid->GetPointData()->ShallowCopy(mesh->GetPointData());
  grid->GetCellData()->ShallowCopy(mesh->GetCellData());
  grid->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return grid;
}

template <class Mesh>
bool PackIf(vtkDataSet* data, Packer& packer)
{
  Mesh* mesh = Mesh::SafeDownCast(data);
  if (mesh)
  {
    PackGeometry(mesh, packer);
  }
  return mesh != nullptr;
}

//------------------------------------------------------------------------------
/// Names are read once: arrays get their own names back, which may be any.
class Unpacker
{
public:
  explicit Unpacker(vtkTable* table)
  {
    vtkFieldData* list = table->GetFieldData();
    for (int i = 0; i < list->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = list->GetAbstractArray(i);
      this->Entries.push_back({ array->GetName(), array });
    }
  }

  template <class Array>
  Array* Get(const std::string& name) const
  {
    const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
      [&name](const Entry& entry) { return entry.Name == name; });
    return found == this->Entries.end() ? nullptr : Array::SafeDownCast(found->Array);
  }

  vtkSmartPointer<vtkPoints> GetPoints() const
  {
    vtkSmartPointer<vtkPoints> points;
    if (auto* coordinates = this->Get<vtkDataArray>("points"))
    {
      points = vtkSmartPointer<vtkPoints>::New();
      points->SetData(coordinates);
    }
    return points;
  }

  vtkSmartPointer<vtkCellArray> GetCells(const std::string& name) const
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    if (auto* offsets = this->Get<vtkDataArray>(name + " offsets"))
    {
      cells->SetData(offsets, this->Get<vtkDataArray>(name + " ids"));
    }
    return cells;
  }

  int* GetExtent() const { return this->Get<vtkIntArray>("extent")->GetPointer(0); }

  const double* GetNumbers(const std::string& name) const
  {
    return this->Get<vtkDoubleArray>(name)->GetPointer(0);
  }

  void PutAttributes(const std::string& prefix, vtkDataSetAttributes* into) const
  {
    for (const Entry& entry : this->Entries)
    {
      if (entry.Name.compare(0, prefix.size(), prefix) == 0)
      {
        const std::string rest = entry.Name.substr(prefix.size());
        std::size_t digits = 0;
        const int attribute = std::stoi(rest, &digits);
        entry.Array->SetName(rest.substr(digits + 1).c_str());
        const int index = into->AddArray(entry.Array);
        if (attribute >= 0)
        {
          into->SetActiveAttribute(index, attribute);
        }
      }
    }
  }

  void PutField(vtkFieldData* into) const
  {
    for (const Entry& entry : this->Entries)
    {
      if (entry.Name.compare(0, FieldPrefix.size(), FieldPrefix) == 0)
      {
        entry.Array->SetName(entry.Name.substr(FieldPrefix.size()).c_str());
        into->AddArray(entry.Array);
      }
    }
  }

private:
  struct Entry
  {
    std::string Name;
    vtkAbstractArray* Array;
  };
  std::vector<Entry> Entries;
};

void UnpackGeometry(const Unpacker& list, vtkPolyData* mesh)
{
  mesh->SetPoints(list.GetPoints());
  mesh->SetVerts(list.GetCells(KindNames[0]));
  mesh->SetLines(list.GetCells(KindNames[1]));
  mesh->SetPolys(list.GetCells(KindNames[2]));
  mesh->SetStrips(list.GetCells(KindNames[3]));
}

void UnpackGeometry(const Unpacker& list, vtkUnstructuredGrid* grid)
{
  auto* types = list.Get<vtkUnsignedCharArray>("types");
  const vtkSmartPointer<vtkCellArray> cells = list.GetCells("cells");
  grid->SetPoints(list.GetPoints());
  auto* faces = list.Get<vtkIdTypeArray>("faces");
  if (!faces)
  {
    grid->SetCells(types, cells);
    return;
  }
  grid->Allocate(types->GetNumberOfValues());
  vtkNew<vtkIdList> ids;
  vtkIdType next = 0;
  for (vtkIdType cell = 0; cell < types->GetNumberOfValues(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    if (types->GetValue(cell) == VTK_POLYHEDRON)
    {
      ids->SetNumberOfIds(faces->GetValue(next));
      std::copy_n(faces->GetPointer(next + 1), ids->GetNumberOfIds(), ids->GetPointer(0));
      next += 1 + ids->GetNumberOfIds();
    }
    grid->InsertNextCell(types->GetValue(cell), ids);
  }
}

void UnpackGeometry(const Unpacker& list, vtkImageData* image)
{
  image->SetExtent(list.GetExtent());
  image->SetOrigin(list.GetNumbers("origin"));
  image->SetSpacing(list.GetNumbers("spacing"));
  image->SetDirectionMatrix(list.GetNumbers("direction"));
}

void UnpackGeometry(const Unpacker& list, vtkRectilinearGrid* grid)
{
  grid->SetExtent(list.GetExtent());
  grid->SetXCoordinates(list.Get<vtkDataArray>("x"));
  grid->SetYCoordinates(list.Get<vtkDataArray>("y"));
  grid->SetZCoordinates(list.Get<vtkDataArray>("z"));
}

void UnpackGeometry(const Unpacker& list, vtkStructuredGrid* grid)
{
  grid->SetExtent(list.GetExtent());
  grid->SetPoints(list.GetPoints());
}

template <class Mesh>
bool UnpackIf(const Unpacker& list, vtkDataSet* data)
{
  Mesh* mesh = Mesh::SafeDownCast(data);
  if (mesh)
  {
    UnpackGeometry(list, mesh);
  }
  return mesh != nullptr;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> SkdPack(vtkDataSet* mesh)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  Packer packer(table);
  const bool isPacked = PackIf<vtkPolyData>(mesh, packer) ||
    PackIf<vtkUnstructuredGrid>(mesh, packer) || PackIf<vtkImageData>(mesh, packer) ||
    PackIf<vtkRectilinearGrid>(mesh, packer) || PackIf<vtkStructuredGrid>(mesh, packer);
  if (!isPacked)
  {
    return SkdPack(GridOf(mesh));
  }
  const int type = mesh->GetDataObjectType();
  packer.AddNumbers<vtkIntArray>("type", &type, 1);
  packer.AddAttributes(PointPrefix, mesh->GetPointData());
  packer.AddAttributes(CellPrefix, mesh->GetCellData());
  packer.AddField(mesh->GetFieldData());
  return table;
}

vtkSmartPointer<vtkDataSet> SkdUnpack(vtkTable* packed)
{
  const Unpacker list(packed);
  const int type = list.Get<vtkIntArray>("type")->GetValue(0);
  const auto object = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
  vtkSmartPointer<vtkDataSet> mesh = vtkDataSet::SafeDownCast(object);
  UnpackIf<vtkPolyData>(list, mesh) || UnpackIf<vtkUnstructuredGrid>(list, mesh) ||
    UnpackIf<vtkImageData>(list, mesh) || UnpackIf<vtkRectilinearGrid>(list, mesh) ||
    UnpackIf<vtkStructuredGrid>(list, mesh);
  list.PutAttributes(PointPrefix, mesh->GetPointData());
  list.PutAttributes(CellPrefix, mesh->GetCellData());
  list.PutField(mesh->GetFieldData());
  return mesh;
}
}
