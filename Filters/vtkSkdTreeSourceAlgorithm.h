// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSourceAlgorithm
 * @brief   base class of filters that search a second mesh
 *
 * Two input ports, each any vtkDataSet or composite of them: the Input, which has the queries, and
 * the Source, which is searched. Each process requests the whole Source, whatever piece of the
 * output is requested, because the answer may be anywhere in it. Without a Source the Input is
 * searched and requested as a whole.
 *
 * A subclass defines its output ports and implements RequestData.
 */

#ifndef vtkSkdTreeSourceAlgorithm_h
#define vtkSkdTreeSourceAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSkdTreeVersion.h" // For the differences between VTK's versions

#include <initializer_list> // For std::initializer_list
#include <vector>           // For std::vector

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSourceAlgorithm : public vtkPassInputTypeAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeSourceAlgorithm, vtkPassInputTypeAlgorithm);

  //@{
  /**
   * The mesh that is searched (port 1).
   */
  void SetSourceConnection(vtkAlgorithmOutput* algOutput);
  void SetSourceData(vtkDataObject* source);
  //@}

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  enum class SourceUse
  {
    Required,
    Optional
  };

  /// Type of an output port: that of the Input.
  static constexpr int LIKE_INPUT = -1;

  /// A vtkUnstructuredGrid or, for a composite Input, a vtkMultiBlockDataSet of several.
  static constexpr int GRID_OR_BLOCKS = -2;

  /// One type for each output port: VTK_POLY_DATA etc., or one of the above.
  vtkSkdTreeSourceAlgorithm(SourceUse use, std::initializer_list<int> outputTypes);
  ~vtkSkdTreeSourceAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// For subclasses in which each process needs the whole Input, too.
  bool WholeInput = false;

private:
  static int TypeFor(int outputType, vtkDataObject* input);

  vtkSkdTreeSourceAlgorithm(const vtkSkdTreeSourceAlgorithm&) = delete;
  void operator=(const vtkSkdTreeSourceAlgorithm&) = delete;

  SourceUse Use;
  std::vector<int> OutputTypes;
};

VTK_ABI_NAMESPACE_END
#endif
