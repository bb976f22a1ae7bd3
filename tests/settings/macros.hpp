// Names that other people's headers define as macros, defined here the way they do it, for every header of lobe to live
// with. Included after the headers of the standard library and of GLM, which nobody can ask to be proof against them.
#pragma once

// windows.h: minwindef.h, rpcndr.h, combaseapi.h, wingdi.h, winnt.h, winerror.h, dlgs.h; <math.h> of MSVC
#define near
#define far
#define pascal
#define cdecl
#define CALLBACK
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define STRICT 1
#define small char
#define hyper __int64
#define interface struct
#define PURE = 0
#define THIS void
#define ERROR 0
#define DELETE 0x00010000L
#define INFINITE 0xFFFFFFFF
#define IGNORE 0
#define ABSOLUTE 1
#define RELATIVE 2
#define TRANSPARENT 1
#define OPAQUE 2
#define DIFFERENCE 11
#define DOMAIN 1
#define SING 2
#define OVERFLOW 3
#define UNDERFLOW 4
#define rad1 0x0420
#define rad2 0x0421
#define grp1 0x0430
#define frm1 0x0434
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

// X11: X.h, Xlib.h
#define None 0L
#define Always 2
#define Above 0
#define Below 1
#define Complex 0
#define Convex 2
#define Unsorted 0
#define Success 0
#define Status int
#define Bool int
#define True 1
#define False 0

// complex.h, Unreal Engine, Apple's AssertMacros.h and Objective-C, Qt, Arduino, sys/sysmacros.h, gnu++'s own
#define I _Complex_I
#define check(expr)                                                                                                    \
    {                                                                                                                  \
        if (!(expr)) __builtin_trap();                                                                                 \
    }
#define verify(expr)                                                                                                   \
    {                                                                                                                  \
        if (!(expr)) __builtin_trap();                                                                                 \
    }
#define require(expr, label)                                                                                           \
    do {                                                                                                               \
        if (!(expr)) goto label;                                                                                       \
    } while (0)
#define ensure(expr) (expr)
#define checkf(expr, ...)                                                                                              \
    {                                                                                                                  \
        if (!(expr)) __builtin_trap();                                                                                 \
    }
#define PI (3.1415926535897932f)
#define TEXT(x) u##x
#define nil nullptr
#define YES true
#define NO false
#define signals public
#define slots
#define emit
#define foreach(variable, container) for (variable : container)
#define forever for (;;)
#define PROGMEM
#define HIGH 1
#define LOW 0
#define B1 1
#define F(string_literal) (string_literal)
#define sq(x) ((x) * (x))
#define radians(deg) ((deg)*0.01745f)
#define degrees(rad) ((rad)*57.2957f)
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define major(dev) ((dev) >> 8)
#define minor(dev) ((dev)&0xff)
#define linux 1
#define unix 1
#define bit(b) (1UL << (b))
