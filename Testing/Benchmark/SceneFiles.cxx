// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "vtkDataSetReader.h"
#include "vtkPLYReader.h"
#include "vtkPointSet.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>

namespace skdbench
{
namespace
{

template <class Reader>
vtkSmartPointer<vtkDataSet> Read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
}

vtkSmartPointer<vtkDataSet> ReadAny(const std::string& path)
{
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".vtp" ? Read<vtkXMLPolyDataReader>(path)
    : extension == ".vtu"    ? Read<vtkXMLUnstructuredGridReader>(path)
    : extension == ".vtk"    ? Read<vtkDataSetReader>(path)
    : extension == ".ply"    ? Read<vtkPLYReader>(path)
                             : nullptr;
}

}

Scene FileScene(const std::string& path)
{
  return { std::filesystem::path(path).stem().string(), [path] { return ReadAny(path); } };
}

std::vector<Scene> FolderScenes(const std::string& folder)
{
  std::vector<std::string> paths;
  std::error_code noFolder;
  for (const auto& entry : std::filesystem::directory_iterator(folder, noFolder))
  {
    const std::string extension = entry.path().extension().string();
    if (extension == ".vtp" || extension == ".vtu")
    {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Scene> scenes;
  std::transform(paths.begin(), paths.end(), std::back_inserter(scenes), FileScene);
  return scenes;
}

}
