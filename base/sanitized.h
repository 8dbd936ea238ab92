// LANCER_SANITIZED is defined in a program that the address sanitizer watches: its shadow memory is
// larger than any limit, and its checks make system calls of their own.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define LANCER_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LANCER_SANITIZED 1
#endif
#endif
