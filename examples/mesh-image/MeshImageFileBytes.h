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
#ifndef MeshImageFileBytes_h
#define MeshImageFileBytes_h

#include <cstdint>
#include <string>

namespace meshimage
{
/** The first \c count bytes, unzipped if the file is; fewer if there are no more. */
std::string
ReadHead(const std::string & fileName, std::size_t count);

/** Whether the file has at least this many bytes after its first \c offset bytes. Of a gzipped file the bytes count
 * that it unzips to, offset included. */
bool
HoldsBytes(const std::string & fileName, std::uint64_t offset, std::uint64_t wanted);

/** Whether the file is a zlib or gzip stream that inflates to at least this many bytes. */
bool
InflatesToBytes(const std::string & fileName, std::uint64_t wanted);

/** Whether at least this many words of text, with white space between them, begin at \c offset. */
bool
HoldsWords(const std::string & fileName, std::uint64_t offset, std::uint64_t wanted);
} // namespace meshimage

#endif
