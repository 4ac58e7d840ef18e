// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLumiStructureAlgorithm
 * @brief What the filters share that build a structure over a surface and ask it about rays.
 *
 * It holds which structure is built and how, what is promised of it, and the threads and ranks that
 * work on it. A choice that the structure at hand does not have (GridDensity of a tree, say) is
 * without effect. One that this build lacks, or that is out of the range of the cores, is one
 * error.
 *
 * @sa vtkLumiRayAlgorithm, vtkLumiIrradiance
 */
#ifndef vtkLumiStructureAlgorithm_h
#define vtkLumiStructureAlgorithm_h

#include "LumitreeFiltersRaysModule.h" // for export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for the implementation

#ifndef VTK_ABI_NAMESPACE_BEGIN // before VTK 9.3
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class LUMITREEFILTERSRAYS_EXPORT vtkLumiStructureAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLumiStructureAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the surface is organised for rays.
   */
  enum Structures
  {
    Auto = 0, ///< the cheapest that the scene needs
    BruteForce = 1,
    Bvh = 2,
    WideBvh = 3,
    Grid = 4,
    Octree = 5,
    KdTree = 6,
    BspTree = 7,
    Embree = 8,
    Cgal = 9,
    CgalEpick = 10,
    CgalCartesian = 11
  };

  /**
   * What is promised about the primitives hit and their order.
   */
  enum Precisions
  {
    Fast = 0,       ///< floating point as it comes: may leak at edges
    Watertight = 1, ///< nothing passes through a closed mesh
    Exact = 2,      ///< what rational arithmetic on the stored numbers says
    Automatic = 3   ///< the most exact that the structure promises: Exact of all but references
  };

  /**
   * How a bounding volume hierarchy is split.
   */
  enum BvhBuilds
  {
    LongestAxisMedian = 0, ///< longest axis, object in the middle
    BinnedSah = 1,         ///< surface-area heuristic over bins
    SweepSah = 2,          ///< the same over every division
    SpatialSplits = 3,     ///< the same, and triangles may be split between two nodes
    Morton = 4             ///< along a space-filling curve: the quickest to build
  };

  /**
   * How a KD-tree is split.
   */
  enum KdBuilds
  {
    SpatialMedian = 0, ///< longest axis of the cell, in the middle
    Sah = 1            ///< surface-area heuristic
  };

  ///@{
  /**
   * The structure to build, one of Structures. One that this build lacks is an error. Default Auto.
   */
  vtkSetClampMacro(Structure, int, Auto, CgalCartesian);
  vtkGetMacro(Structure, int);
  ///@}

  ///@{
  /**
   * One of Precisions. One that the structure cannot promise is an error. Default Automatic.
   */
  vtkSetClampMacro(Precision, int, Fast, Automatic);
  vtkGetMacro(Precision, int);
  ///@}

  ///@{
  /**
   * How a bounding volume hierarchy is split, one of BvhBuilds. Default BinnedSah.
   */
  vtkSetClampMacro(BvhBuild, int, LongestAxisMedian, Morton);
  vtkGetMacro(BvhBuild, int);
  ///@}

  ///@{
  /**
   * How a KD-tree is split, one of KdBuilds. Default Sah.
   */
  vtkSetClampMacro(KdBuild, int, SpatialMedian, Sah);
  vtkGetMacro(KdBuild, int);
  ///@}

  ///@{
  /**
   * Trees: nodes with more primitives than this are split. Range 1 to 1024, default 4.
   */
  vtkSetClampMacro(LeafSize, int, 1, 1024);
  vtkGetMacro(LeafSize, int);
  ///@}

  ///@{
  /**
   * Trees: a node as deep as this is a leaf, whatever it holds; the root has depth 0. Range 1 to
   * 64, default 64.
   */
  vtkSetClampMacro(MaxDepth, int, 1, 64);
  vtkGetMacro(MaxDepth, int);
  ///@}

  ///@{
  /**
   * Grid: cells per primitive when GridResolution is automatic. Above 0, at most 1000; anything
   * else is an error. Default 0.5.
   */
  vtkSetMacro(GridDensity, double);
  vtkGetMacro(GridDensity, double);
  ///@}

  ///@{
  /**
   * Grid: cells along x, y and z, each from 1 to 2^20; 0, 0, 0 means automatic, by GridDensity.
   * Anything else is an error. Default 0, 0, 0.
   */
  vtkSetVector3Macro(GridResolution, int);
  vtkGetVector3Macro(GridResolution, int);
  ///@}

  ///@{
  /**
   * Grid, octree, KD- and BSP-tree: whether a ray remembers the primitives it was tested against of
   * late and leaves out blocks that hold no others. Hits are the same, tests are fewer. It pays
   * where large things lie in many cells, and costs a little elsewhere. Default off.
   */
  vtkSetMacro(Mailboxing, bool);
  vtkGetMacro(Mailboxing, bool);
  vtkBooleanMacro(Mailboxing, bool);
  ///@}

  ///@{
  /**
   * Whether a bounding volume hierarchy is fitted to points that have moved since this filter last
   * ran, while the cells are the same, in place of being built again: far quicker, with the same
   * hits. What rays cost grows as points move against each other; where the surface-area cost has
   * become more than RefitLimit times that of the tree as it was built, it is built again. Grids,
   * octrees, KD- and BSP-trees and SpatialSplits are always built again. Default on.
   */
  vtkSetMacro(Refit, bool);
  vtkGetMacro(Refit, bool);
  vtkBooleanMacro(Refit, bool);
  ///@}

  ///@{
  /**
   * See Refit. Range 1 to 1e300, default 2.
   */
  vtkSetClampMacro(RefitLimit, double, 1.0, 1e300);
  vtkGetMacro(RefitLimit, double);
  ///@}

  /**
   * What is done with StructureFile.
   */
  enum StructureFileUses
  {
    LoadOrBuild = 0, ///< loaded where it is of this surface and these choices; else the structure
                     ///< is built, and saved there if there is no file
    Load = 1,        ///< loaded, whatever choices; an error where it is of another surface
    Save = 2         ///< the structure is saved there, over one saved before
  };

  ///@{
  /**
   * A file that keeps the structure from one session to the next, as StructureFileUse says; empty:
   * none. A file that is damaged or no saved structure is an error, and never overwritten. Saved
   * structures are checked against the surface: no file makes a wrong hit. Where a filter builds
   * structures over two surfaces, it is of that whose parts are asked about, not of the occluders.
   * Default empty.
   */
  void SetStructureFile(const char* path);
  const char* GetStructureFile();
  ///@}

  ///@{
  /**
   * One of StructureFileUses. Default LoadOrBuild.
   */
  vtkSetClampMacro(StructureFileUse, int, LoadOrBuild, Save);
  vtkGetMacro(StructureFileUse, int);
  ///@}

  ///@{
  /**
   * Threads to use; 0 means VTK_SMP_MAX_THREADS when that is set, else as many as this process may
   * use. Range 0 to 4096, default 0.
   */
  vtkSetClampMacro(NumberOfThreads, int, 0, 4096);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Over whose ranks the inputs are spread; null means that this process holds all of them.
   * Default vtkMultiProcessController::GetGlobalController().
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkLumiStructureAlgorithm();
  ~vtkLumiStructureAlgorithm() override;

private:
  vtkLumiStructureAlgorithm(const vtkLumiStructureAlgorithm&) = delete;
  void operator=(const vtkLumiStructureAlgorithm&) = delete;

  int Structure = Auto;
  int Precision = Automatic;
  int BvhBuild = BinnedSah;
  int KdBuild = Sah;
  int LeafSize = 4;
  int MaxDepth = 64;
  double GridDensity = 0.5;
  int GridResolution[3] = { 0, 0, 0 };
  int NumberOfThreads = 0;
  bool Mailboxing = false;
  bool Refit = true;
  double RefitLimit = 2.0;
  int StructureFileUse = LoadOrBuild;

  struct Settings;
  std::unique_ptr<Settings> Held;
};
VTK_ABI_NAMESPACE_END

#endif
