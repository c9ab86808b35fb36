// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeSourceAlgorithm
 * @brief   base class of filters that search a second mesh
 *
 * Two input ports, each any vtkDataSet or composite of them: the Input, which has the queries, and
 * the Source, which is searched. Without a Source the Input is searched.
 *
 * Time: the outputs have the time steps of all inputs together, and each input is asked for the
 * requested time.
 *
 * Several processes: each process asks the pipeline for its own piece of all inputs, as VTK's
 * filters do. What is searched is gathered from the pieces of all processes, because an answer may
 * be anywhere in it, and kept while no piece changes: memory for all of it on each process. Filters
 * whose answers are near the Input can do with the cells there: see SetSourceDistribution. Ghost
 * cells, and cells and points that several pieces have, count once; ids of cells are those of the
 * pieces in the order of the processes. Where the output's pieces are not those of the processes,
 * the pipeline is asked for the whole. All processes must execute together: a source that sets its
 * data itself calls Modified() on all of them, also where its piece is the same as before; if it
 * does so on some alone, these wait for the others.
 *
 * A subclass defines its output ports and implements RequestData.
 */

#ifndef vtkSkdTreeSourceAlgorithm_h
#define vtkSkdTreeSourceAlgorithm_h

#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSkdTreeSetWithin.h" // For properties that have a range
#include "vtkSkdTreeVersion.h"   // For the differences between VTK's versions

#include <initializer_list> // For std::initializer_list
#include <memory>           // For std::unique_ptr
#include <vector>           // For std::vector

namespace skdtree
{
class SkdFilterInputs;
struct SkdSearchRange;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeSourceAlgorithm : public vtkPassInputTypeAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeSourceAlgorithm, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SourceDistributions
  {
    SOURCE_AUTOMATIC = 0,
    SOURCE_REPLICATED = 1,
    SOURCE_EXCHANGED = 2
  };

  //@{
  /**
   * What each process gets of a Source that lies in pieces on several. SOURCE_REPLICATED: all of
   * it, gathered from all processes. SOURCE_EXCHANGED: what its own part of the Input needs, where
   * the filter can do with that, which its class says; memory does not grow with the number of
   * processes. Others gather. SOURCE_AUTOMATIC (default): replicated while all pieces together take
   * at most 64 MB, because one exchange of everything then takes fewer messages than to find out
   * what is needed where. Answers are the same. With one process it means nothing.
   */
  vtkSkdTreeChoiceMacro(SourceDistribution, SOURCE_AUTOMATIC, SOURCE_EXCHANGED);
  //@}

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

  int SourceDistribution = SOURCE_AUTOMATIC;

  /// For subclasses in which each process needs the whole Input, too.
  bool WholeInput = false;

  /// Whether an input is needed as a whole: the Source, the Input if there is no Source, and where
  /// WholeInput is set. The same on all processes.
  virtual bool NeedsWhole(int port);

  /// Whether with several processes a process needs of the Source no more than the cells whose
  /// boxes come near its own part of the Input, and how near. Such a filter states ids by
  /// SkdJoinedIds. False by default.
  virtual bool NeedsNearbySource(skdtree::SkdSearchRange& range);

  /// For subclasses that can send questions to the processes that have the pieces of an input: for
  /// which inputs, with the present properties.
  virtual bool CanAskPieces(int port);

  /// For subclasses that list what they find by the cells of the Input, each once, and leave out
  /// ghosts: whether they do so with the present properties. Those that give cells of the Input
  /// an answer, too, ask in RequestData which of them this process is to list, by block (see
  /// SkdFilterInputs::FindCounted).
  virtual bool ListsByInputCells();
  std::vector<std::vector<unsigned char>> FindListedCells(vtkInformationVector* outputs);

  /// For those that list by the points of the Input: the same of points.
  std::vector<std::vector<unsigned char>> FindListedPoints(vtkInformationVector* outputs);

  /// Whether the Input is needed as a whole and this is not the first process, which outputs all.
  bool IsLeftToFirst(vtkInformationVector* outputs);

  std::unique_ptr<skdtree::SkdFilterInputs> Inputs;

  /// For subclasses that can use any finite coordinates: others leave out those whose squares
  /// overflow, which are warned about.
  bool AnyMagnitude = false;

private:
  static int TypeFor(int outputType, vtkDataObject* input);

  vtkSkdTreeSourceAlgorithm(const vtkSkdTreeSourceAlgorithm&) = delete;
  void operator=(const vtkSkdTreeSourceAlgorithm&) = delete;

  SourceUse Use;
  std::vector<int> OutputTypes;
};

VTK_ABI_NAMESPACE_END
#endif
