// SPDX-License-Identifier: MIT
// The package's entry: what polhode.js has, and the version, which is that of package.json.
export * from "./polhode.js";
export const version = "0.2.0";
