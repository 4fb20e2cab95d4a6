// The table of quantities, which the server writes, as the module that the page's modules import.

import { registerHooks } from "node:module";

const address = "quantities:";
const source = `export default ${process.env.QUANTITIES};`;

registerHooks({
  resolve: (name, context, next) => (name.endsWith("/quantities.js") ? { url: address, shortCircuit: true } : next(name, context)),
  load: (url, context, next) => (url === address ? { format: "module", source, shortCircuit: true } : next(url, context)),
});
