/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sha256.c - SHA-256, by FIPS 180-4, section 6.2.
*/
#include <stdio.h>
#include <string.h>

#include "sha256.h"

#define BLOCK 64

typedef unsigned long word; /* of 32 bits, kept in at least as many */

#define MASK 0xffffffffUL
#define ROTATE(x, n) (((x) >> (n) | (x) << (32 - (n))) & MASK)

/* Section 4.2.2: the fractions of the cube roots of the first 64 primes. */
static const word K[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

/* Section 6.2.2: the schedule of a block. */
static void schedule(const unsigned char *block, word W[64])
{
    int t;

    for (t = 0; t < 16; t++)
        W[t] = (word)block[4 * t] << 24 | (word)block[4 * t + 1] << 16 |
               (word)block[4 * t + 2] << 8 | (word)block[4 * t + 3];
    for (; t < 64; t++) {
        word s0 = ROTATE(W[t - 15], 7) ^ ROTATE(W[t - 15], 18) ^ W[t - 15] >> 3;
        word s1 = ROTATE(W[t - 2], 17) ^ ROTATE(W[t - 2], 19) ^ W[t - 2] >> 10;

        W[t] = (s1 + W[t - 7] + s0 + W[t - 16]) & MASK;
    }
}

static void add_block(word H[8], const unsigned char *block)
{
    word W[64], v[8], T1, T2; /* v: a to h */
    int t;

    schedule(block, W);
    memcpy(v, H, sizeof v);
    for (t = 0; t < 64; t++) {
        T1 = v[7] + (ROTATE(v[4], 6) ^ ROTATE(v[4], 11) ^ ROTATE(v[4], 25)) +
             ((v[4] & v[5]) ^ (~v[4] & v[6])) + K[t] + W[t];
        T2 = (ROTATE(v[0], 2) ^ ROTATE(v[0], 13) ^ ROTATE(v[0], 22)) +
             ((v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]));
        memmove(v + 1, v, 7 * sizeof v[0]);
        v[4] = (v[4] + T1) & MASK;
        v[0] = (T1 + T2) & MASK;
    }
    for (t = 0; t < 8; t++)
        H[t] = (H[t] + v[t]) & MASK;
}

/* Section 5.1.1: the last block, or two, end in a bit 1, zeros, and the length in bits. */
static void add_end(word H[8], const unsigned char *rest, size_t length)
{
    unsigned char last[2 * BLOCK];
    size_t n = length % BLOCK, end = n < BLOCK - 8 ? BLOCK : 2 * BLOCK, i;

    memset(last, 0, sizeof last);
    memcpy(last, rest, n);
    last[n] = 0x80;
    last[end - 1] = (unsigned char)(length << 3 & 0xff);
    length >>= 5;
    for (i = 2; i <= 8; i++, length >>= 8)
        last[end - i] = (unsigned char)(length & 0xff);
    for (i = 0; i < end; i += BLOCK)
        add_block(H, last + i);
}

char *sha256_of(const char *bytes, size_t length, char out[SHA256_SIZE])
{
    /* section 5.3.3 */
    word H[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const unsigned char *block = (const unsigned char *)bytes;
    size_t left = length;
    int i;

    for (; left >= BLOCK; left -= BLOCK, block += BLOCK)
        add_block(H, block);
    add_end(H, left ? block : (const unsigned char *)"", length);
    for (i = 0; i < 8; i++)
        sprintf(out + 8 * i, "%08lx", H[i]);
    return out;
}
