#pragma once
// Which BLAS the process runs on: the factorizations take two to five times longer on the reference BLAS.
#include <string>

namespace burnish {

/// "OpenBLAS ..." with its version and build as OpenBLAS itself reports them, else "reference or unknown
/// BLAS".
std::string blas_name();

/// Versions of CHOLMOD and UMFPACK compiled against, "CHOLMOD 3.0.14, UMFPACK 5.7.9".
std::string sparse_solver_versions();

/// True unless OpenBLAS is found in the process. Worth a notice to the user; another fast BLAS (MKL, BLIS) is
/// not recognized and counts as reference.
bool is_reference_blas();

/// Kernels of OpenBLAS that suit this processor better than those it has taken, "" if it knows the processor. One that is younger than the
/// library gets "Prescott", without AVX: "SkylakeX" where it has AVX-512, "Haswell" where it has AVX2.
std::string better_blas_kernels(const std::string& taken);

/// Lets OpenBLAS work with better_blas_kernels from now on, in the whole process; a choice by OPENBLAS_CORETYPE stays.
/// Not while another thread is in a function of the BLAS.
/// @return their name, "" if nothing was changed
std::string take_blas_kernels();

/// Number of threads of OpenBLAS from now on, in the whole process; 1 is best for matrices of this size.
/// @return false if there is no OpenBLAS to set (nothing is done)
/// @throws std::invalid_argument if count < 1
bool set_blas_threads(int count);

} // namespace burnish
