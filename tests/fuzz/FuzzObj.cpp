// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/MeshPromises.h"

namespace txn::fuzz {

bool readOne(std::string_view bytes) {
    return keepsPromises(readMesh(std::string(bytes), "fuzz.obj"));
}

std::vector<std::string> seeds() {
    return {
        "# plain\no part\ng group\ns 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "vn 0 0 1\nusemtl none\nf 1/1/1 2/2/1 3/3/1 4/4/1\nf -4//-1 -3//-1 -2//-1\n",
        "v 0 0 0 1\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2e0 0\nvt .5 .5 0\nf 1/1 2/1 \\\n 3/1 4/1 "
        "5/1 # a crown\r\n",
    };
}

} // namespace txn::fuzz
