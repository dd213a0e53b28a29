// Print the report of Khronos' validator on one file as JSON: node validate.cjs FOLDER_WITH_NODE_MODULES FILE
const fs = require("fs");
const path = require("path");

const [folder, file] = process.argv.slice(2);
const validator = require(path.join(folder, "node_modules", "gltf-validator"));
validator.validateBytes(new Uint8Array(fs.readFileSync(file))).then((report) => console.log(JSON.stringify(report)));
