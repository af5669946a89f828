/*=========================================================================
 *
 *  Copyright The DelaunayRefinement Contributors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#include "itkCommandRun.h"
#include "itkCommandTestImages.h"

#include <limits>

namespace
{
using namespace itk::DelaunayRefinementTest;

class CommandInput : public testing::Test
{
protected:
  CommandRun
  Run(const std::string & image, const std::vector<std::string> & options = { "--delta", "4" })
  {
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), { image, m_Output });
    return RunCommand(arguments);
  }

  void
  ExpectNothingWritten() const
  {
    EXPECT_FALSE(std::filesystem::exists(m_Output));
    for (const std::string & name : m_Folder.List())
    {
      EXPECT_NE(name.front(), '.') << name << " was left behind";
    }
  }

  /** The file is refused when so many bytes are cut off its end, and taken when it is whole. */
  void
  ExpectTruncationNoticed(const std::string & image, const std::string & dataFile, std::size_t fewest)
  {
    const std::string whole = ReadBytes(dataFile);
    for (const std::size_t missing : { fewest, whole.size() / 2, whole.size() - whole.size() / 10 })
    {
      WriteBytes(dataFile, whole.substr(0, whole.size() - missing));
      ExpectRefusal(this->Run(image), 1, { image, "truncated" });
      this->ExpectNothingWritten();
    }
    WriteBytes(dataFile, whole);
    ExpectSuccess(this->Run(image));
    std::filesystem::remove(m_Output);
  }

  TemporaryFolder m_Folder;
  std::string     m_Output = m_Folder / "mesh.vtu";
};

TEST_F(CommandInput, NoSuchFile)
{
  ExpectRefusal(this->Run(m_Folder / "none.nii.gz"), 1, { m_Folder / "none.nii.gz" });
}

TEST_F(CommandInput, AFolder)
{
  std::filesystem::create_directory(m_Folder / "images");
  ExpectRefusal(this->Run(m_Folder / "images"), 1, { m_Folder / "images", "folder" });
}

TEST_F(CommandInput, NoImage)
{
  WriteBytes(m_Folder / "text.nrrd", "This is no image.\n");
  WriteBytes(m_Folder / "empty.mha", "");
  WriteBytes(m_Folder / "text.txt", "This is no image.\n");
  for (const char * name : { "text.nrrd", "empty.mha", "text.txt" })
  {
    ExpectRefusal(this->Run(m_Folder / name), 1, { m_Folder / name });
  }
}

TEST_F(CommandInput, WhatReadersPrintIsNotRepeated)
{
  WriteBytes(m_Folder / "broken.mha", "ObjectType = Image\nNDims = 3\nDimSize = 4 4\n");
  ExpectRefusal(this->Run(m_Folder / "broken.mha"), 1, { m_Folder / "broken.mha" });
}

TEST_F(CommandInput, OtherDimensions)
{
  WriteBytes(m_Folder / "flat.mha",
             "NDims = 2\nDimSize = 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + std::string(16, '\1'));
  ExpectRefusal(this->Run(m_Folder / "flat.mha"), 1, { "2 dimensions" });
  WriteBytes(m_Folder / "series.mha",
             "NDims = 4\nDimSize = 4 4 4 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
               std::string(128, '\1'));
  ExpectRefusal(this->Run(m_Folder / "series.mha"), 1, { "4 dimensions" });
  WriteBytes(m_Folder / "one.mha",
             "NDims = 4\nDimSize = 24 24 24 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
               MakeBall().Bytes());
  ExpectSuccess(this->Run(m_Folder / "one.mha"));
}

TEST_F(CommandInput, SeveralNumbersAVoxel)
{
  WriteBytes(m_Folder / "color.mha",
             "NDims = 3\nDimSize = 4 4 4\nElementNumberOfChannels = 3\nElementType = MET_UCHAR\n"
             "ElementDataFile = LOCAL\n" +
               std::string(192, '\1'));
  ExpectRefusal(this->Run(m_Folder / "color.mha"), 1, { "scalars" });
}

TEST_F(CommandInput, SingularDirections)
{
  const std::string header = "NRRD0005\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 24 24 24\n"
                             "encoding: raw\nspace origin: (0,0,0)\n";
  for (const char * directions :
       { "(1,0,0) (0,1,0) (0,0,0)", "(1,0,0) (0,1,0) (0,1,0)", "(1,0,0) (0,1,0) (1,1,0)", "(1,0,0) (0,1,0) (0,0,nan)" })
  {
    WriteBytes(m_Folder / "ball.nrrd", header + "space directions: " + directions + "\n\n" + MakeBall().Bytes());
    ExpectRefusal(this->Run(m_Folder / "ball.nrrd"), 1, { "direction" });
  }
  WriteBytes(m_Folder / "ball.nrrd", header + "space directions: (1,0,0) (0,0,1) (0,-1,0)\n\n" + MakeBall().Bytes());
  ExpectSuccess(this->Run(m_Folder / "ball.nrrd"));
}

TEST_F(CommandInput, WordsOfTheFilterBecomeOptions)
{
  const std::string distances = WriteMetaImage(m_Folder / "distances.mha", MakeDistances());
  ExpectRefusal(this->Run(distances), 1, { "--iso-value", "--threshold" });
  ExpectRefusal(this->Run(distances, { "--iso-value", "500" }), 1, { "--iso-value", "500" });

  const std::string nested = WriteMetaImage(m_Folder / "nested.mha", MakeNestedBalls());
  ExpectRefusal(this->Run(nested, { "--delta-for", "9=1" }), 1, { "9", "--delta-for" });
  ExpectRefusal(this->Run(nested, { "--smoothing", "1", "--iso-value", "2" }), 1, { "--smoothing", "--iso-value" });
  ExpectRefusal(
    this->Run(nested, { "--smoothing", "1", "--interpolator", "nearest" }), 1, { "--smoothing", "--interpolator" });
  ExpectRefusal(this->Run(nested, { "--labels", "9" }), 1, { "9", "--labels" });
  ExpectRefusal(this->Run(nested, { "--labels", "4711" }), 1, { "4711", "255", "--labels" });
  ExpectRefusal(
    this->Run(nested, { "--merge-labels", "--delta", "1", "--max-vertices", "50" }), 1, { "--max-vertices", "50" });
  ExpectRefusal(this->Run(nested, { "--merge-labels", "--delta", "0.0001" }), 1, { "--delta", "memory" });

  ExpectRefusal(this->Run(nested, { "--topology" }), 1, { "--topology", "--merge-labels" });
  ExpectRefusal(
    this->Run(nested, { "--topology", "--allow-non-manifold" }), 1, { "--topology", "--allow-non-manifold" });
  ExpectRefusal(this->Run(nested, { "--delta", "2", "--delta-min", "3" }), 1, { "--delta-min", "--delta" });
  ExpectRefusal(this->Run(nested, { "--hausdorff-bound", "0.01" }), 1, { "--hausdorff-bound" });
  ExpectRefusal(this->Run(nested, { "--size-field", m_Folder / "no.mha" }), 1, { m_Folder / "no.mha" });
  ExpectRefusal(this->Run(nested, { "--size-field", distances }), 1, { "--size-field", "positive" });

  const std::string empty = WriteMetaImage(m_Folder / "empty.mha", TestVolume<std::uint8_t>());
  ExpectRefusal(this->Run(empty), 1, { "no object" });
  this->ExpectNothingWritten();
}

TEST_F(CommandInput, NotANumber)
{
  TestVolume<float> volume = MakeDistances();
  volume.At(3, 4, 5) = std::numeric_limits<float>::quiet_NaN();
  ExpectRefusal(this->Run(WriteMetaImage(m_Folder / "nan.mha", volume), { "--iso-value", "-8" }), 1, { "NaN" });
}

TEST_F(CommandInput, TruncatedMetaImage)
{
  const std::string image = WriteMetaImage(m_Folder / "ball.mha", MakeBall());
  this->ExpectTruncationNoticed(image, image, 1);

  WriteBytes(m_Folder / "ball.mhd", MetaHeader(MakeBall(), "ball.raw"));
  WriteBytes(m_Folder / "ball.raw", MakeBall().Bytes());
  this->ExpectTruncationNoticed(m_Folder / "ball.mhd", m_Folder / "ball.raw", 1);
}

TEST_F(CommandInput, TruncatedCompressedMetaImage)
{
  const std::string zipped = Gzip(MakeBall().Bytes());
  const std::string image = m_Folder / "ball.mha";
  WriteBytes(image,
             MetaHeader(MakeBall(),
                        "LOCAL",
                        "CompressedData = True\nCompressedDataSize = " + std::to_string(zipped.size()) + "\n") +
               zipped);
  this->ExpectTruncationNoticed(image, image, 1);

  // Without the size, ITK takes the whole file for the compressed voxels; a checksum of 8 bytes is at its end.
  WriteBytes(m_Folder / "ball.mhd", MetaHeader(MakeBall(), "ball.zraw", "CompressedData = True\n"));
  WriteBytes(m_Folder / "ball.zraw", zipped);
  this->ExpectTruncationNoticed(m_Folder / "ball.mhd", m_Folder / "ball.zraw", 9);
  WriteBytes(image, MetaHeader(MakeBall(), "LOCAL", "CompressedData = True\n") + zipped);
  ExpectRefusal(this->Run(image), 1, { image, "damaged" });
}

TEST_F(CommandInput, TruncatedNifti)
{
  const TestVolume<std::uint8_t> ball = MakeBall();
  const std::string              image = NiftiHeaderBytes(ball.size, true) + ball.Bytes();
  WriteBytes(m_Folder / "ball.nii", image);
  this->ExpectTruncationNoticed(m_Folder / "ball.nii", m_Folder / "ball.nii", 1);

  WriteBytes(m_Folder / "zipped.nii.gz", Gzip(image));
  this->ExpectTruncationNoticed(m_Folder / "zipped.nii.gz", m_Folder / "zipped.nii.gz", 9);

  WriteBytes(m_Folder / "pair.hdr", NiftiHeaderBytes(ball.size, false));
  WriteBytes(m_Folder / "pair.img", ball.Bytes());
  this->ExpectTruncationNoticed(m_Folder / "pair.hdr", m_Folder / "pair.img", 1);
  this->ExpectTruncationNoticed(m_Folder / "pair.img", m_Folder / "pair.img", 1);
}

TEST_F(CommandInput, TruncatedNrrd)
{
  const std::string image = m_Folder / "ball.nrrd";
  WriteBytes(image, "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nencoding: raw\n\n" + MakeBall().Bytes());
  this->ExpectTruncationNoticed(image, image, 1);
}

TEST_F(CommandInput, TruncatedVtk)
{
  const std::string image = m_Folder / "ball.vtk";
  WriteBytes(image,
             "# vtk DataFile Version 3.0\nball\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 24 24 24\n"
             "SPACING 1 1 1\nORIGIN 0 0 0\nPOINT_DATA 13824\nSCALARS voxels unsigned_char 1\nLOOKUP_TABLE default\n" +
               MakeBall().Bytes());
  this->ExpectTruncationNoticed(image, image, 1);
}
} // namespace
