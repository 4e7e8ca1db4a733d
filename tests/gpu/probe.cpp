// SPDX-License-Identifier: BSD-3-Clause
// Whether a compiler can offload, as offload.cpp does: a region of OpenMP for another machine.
int main()
{
    int x = 1;
#pragma omp target map(tofrom : x)
    x -= 1;
    return x;
}
