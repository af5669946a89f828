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
#ifndef itkDelaunayRefinementWideLoops_h
#define itkDelaunayRefinementWideLoops_h

/** Before a function whose loops do the same to many numbers: it is compiled for wider registers too, and the processor
 * has its choice. Without fused operations, so that all processors compute the same. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#  define ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS __attribute__((target_clones("avx2", "default")))
#else
#  define ITK_DELAUNAY_REFINEMENT_WIDE_LOOPS
#endif

#endif
