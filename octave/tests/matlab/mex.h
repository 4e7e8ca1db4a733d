/* SPDX-License-Identifier: BSD-3-Clause */
/* Declarations as the manual of MATLAB has them, of the functions of its C Matrix API and C MEX API
 * that octave/src may call: a test compiles the sources with this header, too. Functions that
 * Octave alone has, or MATLAB alone, are not here. */
#ifndef MEX_H_INCLUDED
#define MEX_H_INCLUDED

#include <stdbool.h>
#include <stddef.h>

typedef struct mxArray_tag mxArray;
typedef size_t mwSize;
typedef bool mxLogical;
typedef enum { mxREAL, mxCOMPLEX } mxComplexity;

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, const mxArray *prhs[]);
int mexCallMATLAB(int nlhs, mxArray *plhs[], int nrhs, mxArray *prhs[], const char *functionName);

mxArray *mxCreateDoubleMatrix(mwSize m, mwSize n, mxComplexity ComplexFlag);
mxArray *mxCreateLogicalMatrix(mwSize m, mwSize n);
mxArray *mxCreateLogicalScalar(mxLogical value);
mxArray *mxCreateString(const char *str);

const char *mxGetClassName(const mxArray *pm);
mxLogical *mxGetLogicals(const mxArray *pa);
size_t mxGetM(const mxArray *pm);
size_t mxGetN(const mxArray *pm);
mwSize mxGetNumberOfDimensions(const mxArray *pm);
size_t mxGetNumberOfElements(const mxArray *pm);
double *mxGetPr(const mxArray *pm);
double mxGetScalar(const mxArray *pm);
int mxGetString(const mxArray *pm, char *str, mwSize strlen);

bool mxIsChar(const mxArray *pm);
bool mxIsComplex(const mxArray *pm);
bool mxIsDouble(const mxArray *pm);
bool mxIsLogical(const mxArray *pm);
bool mxIsNumeric(const mxArray *pm);
bool mxIsSparse(const mxArray *pm);

void *mxMalloc(mwSize n);

#endif
