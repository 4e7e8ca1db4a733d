/* SPDX-License-Identifier: BSD-3-Clause */
/* Visibility of the symbols of the libraries. */
#ifndef PW85_EXPORT_H_INCLUDED
#define PW85_EXPORT_H_INCLUDED

#if defined(_WIN32) && defined(PW85_BUILDING)
#define PW85_API __declspec(dllexport)
#elif defined(__GNUC__)
#define PW85_API __attribute__((visibility("default")))
#else
#define PW85_API
#endif

#endif
