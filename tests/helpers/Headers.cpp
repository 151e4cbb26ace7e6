// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing of its own: it carries the headers that the tests share when they are precompiled.
