/// La mochila.

import type {Words} from "../../../editor/src/words/index.ts"

export const backpack: Words["backpack"] = {
  title: "Mochila",
  lead: "Lo que guardas aquí, lo puede sacar cualquier programa de este navegador.",
  empty: "La mochila está vacía.",
  with: names => `con ${names}`,
  take: "Sacar a este programa",
  takeOf: name => `Sacar ${name} a este programa`,
  removeOf: name => `Quitar ${name} de la mochila`,
  from: "De este programa:",
  putIn: "Guardar",
  put: name => `Guardar ${name} en la mochila`,
  open: "Abrir la mochila",
  packed: name => `${name} está en la mochila.`,
  cameAlong: names => `Lo que necesita vino también: ${names}`,
  notPacked: name => `${name} no se puede guardar en la mochila.`,
  notPackedHint: "Su texto está sin terminar. Arréglalo primero.",
  onlyDefinitions: "En la mochila solo entra una definición: un bloque con su propio nombre.",
  full: "La mochila no se puede guardar.",
  fullHint: "Este navegador no tiene más sitio. Quita algo de la mochila o elimina programas viejos.",
  notUnpacked: name => `${name} no se puede sacar a este programa.`,
  unpacked: names => `Nuevo en tu programa: ${names}.`,
  present: names => `Tu programa ya tiene esto: ${names}.`,
  renamed: (from, to) => `${from} se llama aquí ${to}, porque ya había otro ${from}.`,
}
