/// Words of the dialog that tests a program in many rooms, in French.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, metres, count} = measuresOf("fr")

export const roomTests: Words["roomTests"] = {
  menu: "Tester dans plusieurs salles…",
  title: "Tester dans plusieurs salles",
  lead: "Ton programme fonctionne-t-il dans des salles qu’il n’a jamais vues ?",
  hold: "Ceci doit être vrai dans chaque salle :",
  properties: {
    "reaches-goal": "Il atteint le but",
    "never-falls": "Il ne tombe jamais dans un trou",
    "never-pushes": "Il ne pousse jamais contre quelque chose plus de",
    "returns-to-start": "Il quitte son départ et y revient",
    covers: "Il passe sur cette part du sol :",
    "room-goals": "Il fait tout ce que la salle demande",
  },
  units: {"never-pushes": "secondes", covers: "pour cent"},
  family: "Salles",
  families: {
    obstacles: "avec des obstacles",
    maze: "labyrinthes",
    pits: "avec des trous",
    like: "comme la salle d’ici",
  },
  howMany: "Combien",
  start: "Tester",
  otherRooms: "Tester dans d’autres salles",
  cancel: "Arrêter le test",
  noProperty: "Choisis quelque chose qui doit être vrai.",
  noConnection: "Rosy n’est pas connecté. Il réessaie tout seul.",
  lost: "La connexion est perdue, et le test avec elle. Réessaie.",
  waiting: "Le test commence…",
  queued: place => `D’autres sont en train de tester. Ta place dans la file : ${place}.`,
  progress: (done, rooms, passed) =>
    `${done} sur ${count(rooms, {one: n => `${n} salle`, other: n => `${n} salles`})}, ${count(passed, {one: n => `${n} réussie`, other: n => `${n} réussies`})}`,
  shrinking: tried =>
    `Recherche de la plus petite salle où cela échoue : ${count(tried, {one: n => `${n} salle essayée`, other: n => `${n} salles essayées`})}`,
  refused: "Le programme ne peut pas encore démarrer :",
  allPassed: rooms =>
    rooms === 1 ? "Cela marche dans la salle." : `Cela marche dans toutes les ${rooms} salles.`,
  passed: (passed, rooms) =>
    `Cela marche dans ${count(passed, {one: n => `${n} salle`, other: n => `${n} salles`})} sur ${rooms}.`,
  smallest: "La plus petite salle où cela échoue",
  things: (things, of) =>
    things === 0
      ? "Cela échoue même quand la salle est vide."
      : things === of
        ? "Il n’y a rien à y enlever."
        : `Sur ${of} objets, ${count(things, {one: "un seul suffit", other: n => `${n} suffisent`})} pour cela.`,
  openSmallest: "Ouvrir et démarrer",
  failures: "Salles où cela échoue, la pire d’abord",
  picture: "Image",
  room: "Salle",
  what: "Ce qui s’est passé",
  open: "Ouvrir et démarrer",
  openNamed: room => `Ouvrir la salle ${room} et démarrer`,
  more: n =>
    count(n, {
      one: n => `Cela échoue dans ${n} autre salle.`,
      other: n => `Cela échoue dans ${n} autres salles.`,
    }),
  back: "Retour à ma salle",
  found: {
    "reaches-goal": share => `Il a fait ${short(share * 100, 0)} % du chemin vers le but.`,
    "never-falls": time => `Il est tombé après ${seconds(time, 1)}.`,
    "never-pushes": (push, time) =>
      `Il a poussé pendant ${seconds(push, 1)}, jusqu’à ${seconds(time, 1)} après le départ.`,
    "returns-to-start": distance =>
      distance === 0
        ? "Il est resté près de son départ."
        : `En revenant, il est arrivé à ${metres(distance)} de son départ.`,
    covers: share => `Il est passé sur ${short(share, 0)} % du sol.`,
    "room-goals": share => `Il a fait ${short(share * 100, 0)} % de ce que la salle demande.`,
  },
}
