/// Le sac à dos.

import type {Words} from "../../../editor/src/words/index.ts"

export const backpack: Words["backpack"] = {
  title: "Sac à dos",
  lead: "Ce que tu mets ici, chaque programme de ce navigateur peut le reprendre.",
  empty: "Le sac à dos est vide.",
  with: names => `avec ${names}`,
  take: "Sortir dans ce programme",
  takeOf: name => `Sortir ${name} dans ce programme`,
  removeOf: name => `Retirer ${name} du sac à dos`,
  from: "De ce programme :",
  putIn: "Mettre dedans",
  put: name => `Mettre ${name} dans le sac à dos`,
  open: "Ouvrir le sac à dos",
  packed: name => `${name} est dans le sac à dos.`,
  cameAlong: names => `Ce qu’il lui faut est venu avec : ${names}`,
  notPacked: name => `${name} ne peut pas aller dans le sac à dos.`,
  notPackedHint: "Son texte n’est pas fini. Répare-le d’abord.",
  onlyDefinitions: "Seule une définition va dans le sac à dos : un bloc qui a son propre nom.",
  full: "Le sac à dos ne peut pas être enregistré.",
  fullHint:
    "Ce navigateur n’a plus de place. Retire quelque chose du sac à dos ou supprime d’anciens programmes.",
  notUnpacked: name => `${name} ne peut pas sortir dans ce programme.`,
  unpacked: names => `Nouveau dans ton programme : ${names}.`,
  present: names => `Ton programme a déjà ceci : ${names}.`,
  renamed: (from, to) => `${from} s’appelle ici ${to}, parce qu’il y avait déjà un autre ${from}.`,
}
