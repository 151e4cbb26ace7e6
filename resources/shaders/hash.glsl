// SPDX-License-Identifier: CC0-1.0

// Four 32-bit words to four well mixed ones: pcg4d (Jarzynski and Olano, "Hash Functions for GPU
// Rendering", JCGT 2020). The same bits as the hash of the CPU.
uvec4 txnHash(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Uniform in [0, 1), 24 bits: exact in single precision.
float txnUnit(uint bits) {
    return float(bits >> 8u) * (1.0 / 16777216.0);
}

// Poisson(1) distributed count from 32 uniform bits: how many of the thresholds
// round(2^32 P(N <= n)) the bits reach.
int txnPoissonCount(uint bits) {
    if (bits < 3160060337u)
        return bits < 1580030169u ? 0 : 1;
    if (bits < 4213413783u)
        return bits < 3950075422u ? 2 : 3;
    return 4 + int(bits >= 4279248374u) + int(bits >= 4292415292u) + int(bits >= 4294609778u) +
           int(bits >= 4294923276u) + int(bits >= 4294962463u) + int(bits >= 4294966817u) +
           int(bits >= 4294967253u) + int(bits >= 4294967292u);
}

// The cell of a period, in cells, that stands for a cell of the plane. period 0: there is none.
uint txnWrapped(int cell, int period) {
    if (period == 0)
        return uint(cell);
    // Of negative numbers, % is the driver's choice; ~cell is -cell - 1.
    uint p = uint(period);
    return cell >= 0 ? uint(cell) % p : p - 1u - uint(~cell) % p;
}
