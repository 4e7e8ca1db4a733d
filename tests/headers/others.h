/* SPDX-License-Identifier: BSD-3-Clause */
/* Macros that other libraries define, for names that are not theirs alone: those of the real
   windows.h and Xlib.h where these are, and otherwise those of their documentation. */
#ifndef PW85_TESTS_OTHERS_H_INCLUDED
#define PW85_TESTS_OTHERS_H_INCLUDED

#ifdef _WIN32
#include <windows.h>
#else
#define near
#define far
#define hyper __int64
#define interface struct
#define pascal
#define cdecl
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define CALLBACK
#define ERROR 0
#define NO_ERROR 0
#define DELETE 0x00010000
#define DIFFERENCE 11
#define DOMAIN 1
#define OVERFLOW 3
#define STRICT 1
#define TRUE 1
#define FALSE 0
#endif
/* Microsoft's windows.h defines these in C++, too: min and max unless NOMINMAX is defined. */
#undef small
#undef min
#undef max
#define small char
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

#if defined(__has_include) && !defined(_WIN32)
#if __has_include(<X11/Xlib.h>)
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#endif
#endif
#ifndef None
#define None 0L
#define Success 0
#define Status int
#define Bool int
#define True 1
#define False 0
#define Always 2
#define Above 0
#define Below 1
#define Complex 0
#define Convex 2
#define Nonconvex 1
#define Opposite 4
#define Unsorted 0
#define CurrentTime 0L
#endif

/* Qt's keywords, unless QT_NO_KEYWORDS is defined. */
#define signals public
#define slots
#define emit
#define foreach(variable, container) for (variable : container)
#define forever for (;;)

#endif
