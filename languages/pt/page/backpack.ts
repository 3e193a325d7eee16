/// A mochila.

import type {Words} from "../../../editor/src/words/index.ts"

export const backpack: Words["backpack"] = {
  title: "Mochila",
  lead: "O que você põe aqui, qualquer programa deste navegador pode pegar.",
  empty: "A mochila está vazia.",
  with: names => `com ${names}`,
  take: "Pegar para este programa",
  takeOf: name => `Pegar ${name} para este programa`,
  removeOf: name => `Tirar ${name} da mochila`,
  from: "Deste programa:",
  putIn: "Pôr na mochila",
  put: name => `Pôr ${name} na mochila`,
  open: "Abrir a mochila",
  packed: name => `${name} está na mochila.`,
  cameAlong: names => `O que ele precisa veio junto: ${names}`,
  notPacked: name => `${name} não pode ir para a mochila.`,
  notPackedHint: "O texto não está pronto. Conserte primeiro.",
  onlyDefinitions: "Na mochila só entra uma definição: um bloco com um nome próprio.",
  full: "Não foi possível guardar a mochila.",
  fullHint: "Este navegador não tem mais espaço. Tire algo da mochila ou apague programas antigos.",
  notUnpacked: name => `${name} não pode entrar neste programa.`,
  unpacked: names => `Novo no seu programa: ${names}.`,
  present: names => `Seu programa já tem isto: ${names}.`,
  renamed: (from, to) => `${from} se chama ${to} aqui, porque já havia outro ${from}.`,
}
