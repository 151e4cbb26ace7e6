// SPDX-License-Identifier: CC0-1.0
out vec4 color;

void main() {
    color = vec4(1.0);
}
