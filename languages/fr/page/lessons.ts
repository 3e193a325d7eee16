/// Lessons in French: their panel and their list.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {fixed, count} = measuresOf("fr")
const seconds = (time: number | null) => (time === null ? "" : ` à ${fixed(time, 1)} s`)
const measure = (value: number | null) => {
  const size = Math.abs(value ?? 0)
  return `${fixed(size, 2)} mètre${size < 2 ? "" : "s"}`
}

export const lessons: Words["lessons"] = {
  title: "Leçons",
  lead: "De courtes leçons, chacune avec une nouvelle idée. Tu continues là où tu étais.",
  loading: "Recherche des leçons…",
  failed:
    "Les leçons n’ont pas pu être chargées. Le service de Rosy ne répond pas ; réessaie dans un moment.",
  missing: (name: string) => `Il n’y a pas de leçon appelée ${name}.`,
  damaged: (name: string, at: string) =>
    `${name} ne peut pas être ouvert comme leçon : il manque quelque chose ou quelque chose est faux à ${at}.`,
  damagedHint: "Demande encore une fois le fichier, ou corrige-le à cet endroit et ouvre-le à nouveau.",
  newer: (name: string) => `${name} ne peut pas être ouvert : c’est une leçon d’un Rosy plus récent.`,
  newerHint: (version: number, newest: number) =>
    `Elle a la version ${version}, et ce Rosy lit jusqu’à la version ${newest}. Mets Rosy à jour pour l’ouvrir.`,
  linked: "Ce lien",
  link: "Lien vers cette leçon",
  courses: {
    drive: "Rouler : un programme est une valeur",
    react: "Réagir : il se passe des choses",
    remember: "Se souvenir : ce qui était avant",
    tasks: "Tâches : une chose après l’autre",
    algebra: "Algèbre : une fonction a un graphe",
  },
  otherLessons: "Autres leçons",
  finished: "terminée",
  stepsDone: (done: number, all: number) => `${done} étape${done < 2 ? "" : "s"} sur ${all}`,
  panel: "Leçon",
  number: (n: number) => `Leçon ${n}`,
  leave: "Quitter la leçon",
  /// A colon follows, and French puts a space before it.
  kinds: {
    predict: "Devine ",
    run: "Démarre ",
    investigate: "Regarde bien ",
    modify: "Change ",
    make: "Construis ",
  },
  yourGuess: (answer: string) => `Tu as deviné : ${answer}`,
  done: "fait",
  open: "encore à faire",
  missed: "pas encore",
  go: "Étape suivante",
  nextLesson: "Leçon suivante",
  freePlay: "Jouer librement avec ce programme",
  again: "Recommencer cette étape",
  hint: "Donne-moi un indice",
  moreHint: "Encore un indice",
  notRun: (name: string) =>
    `\`${name}\` est définie, mais rien ne l’utilise encore. Est-ce que \`simulate\` l’exécute ?`,
  notTaken: (type: string) => `Aucune de tes fonctions ne prend encore une valeur de type \`${type}\`.`,
  notGiven: (type: string) => `Rien dans ton programme ne donne encore une valeur de type \`${type}\`.`,
  mendFirst: "Il y a une erreur dans le programme. Corrige-la d’abord : une carte dit quoi faire.",
  pressRun: "Appuie sur Démarrer, et tout est vérifié pendant que le robot roule.",
  letItRun: (time: number) =>
    `Laisse-le tourner pendant ${count(time, {one: n => `${n} seconde`, other: n => `${n} secondes`})}.`,
  learned: "Ce que tu as appris",
  wellDone: "Leçon terminée !",
  seen: {
    "goal-late": (_n, time, name) => `« ${name} » n’a été atteint que${seconds(time)}.`,
    happened: (_n, time, name) => `\`${name}\` est arrivé${seconds(time)}.`,
    "goal-missed": (_n, time, name) => `« ${name} » a été manqué${seconds(time)}.`,
    "goal-open": (_n, time, name) => `« ${name} » était encore à faire${seconds(time)}.`,
    away: (n, time) => `Il en était à ${measure(n)}${seconds(time)}.`,
    turned: (n, time) => {
      const degrees = Math.round(Math.abs(n ?? 0))
      const side = (n ?? 0) > 0 ? "droite" : "gauche"
      return `Il regardait ${degrees} degré${degrees < 2 ? "" : "s"} trop à ${side}${seconds(time)}.`
    },
    "too-short": (_n, time) => `Le programme s’est terminé avant ${time ?? 0} s.`,
    moved: (_n, time) => `Il bougeait encore${seconds(time)}.`,
    drove: n => `Il a parcouru ${measure(n)}.`,
    fastest: (n, time) => `Sa vitesse en ${time ?? 0} s était au plus de ${measure(n)} par seconde.`,
    "fastest-back": (n, time) =>
      (n ?? 0) === 0
        ? "Il n’a pas reculé."
        : `En reculant, sa vitesse en ${time ?? 0} s était au plus de ${measure(n)} par seconde.`,
    "came-far": n => `Il s’est éloigné de ${measure(n)} de son départ.`,
    "not-back": n => `À la fin, il était à ${measure(n)} de son départ.`,
    "ends-far": n => `À la fin, il en était à ${measure(n)}.`,
    "not-faster": (_n, time, name) =>
      `\`${name}\` est arrivé${seconds(time)}, et il n’est pas devenu plus rapide.`,
    varied: n => `Nombre de valeurs différentes envoyées : ${n ?? 0}.`,
    "not-again": (n, _t, name) =>
      `\`${name}\` est arrivé (${n ?? 0} fois), et ce n’était plus jamais comme au début.`,
    miscounted: (n, time, name) => `Il a dit ${name}${seconds(time)}, et c’était le numéro ${n ?? 0}.`,
    "not-measured": n => `Distance parcourue : ${Math.round(n ?? 0)} cm, et aucun nombre pareil n’a été dit.`,
    "goes-on": (_n, time) => `Le programme n’était pas terminé${seconds(time)}.`,
    "not-said": (_n, _t, name) => `« ${name} » n’a pas été dit.`,
    "not-sent": (_n, _t, name) => `\`${name}\` n’a pas été envoyé.`,
    "not-happened": (n, _t, name) =>
      (n ?? 0) === 0 ? `\`${name}\` n’est pas arrivé.` : `\`${name}\` n’est arrivé que ${n} fois.`,
    "no-answer": (_n, time, name) =>
      `\`${name}\` est arrivé${seconds(time)}, et ce qui devait suivre n’est pas venu.`,
    answer: (_n, time, name) =>
      `\`${name}\` est arrivé${seconds(time)}, et il s’est passé ensuite quelque chose de trop.`,
    functions: n =>
      (n ?? 0) === 0
        ? "Le programme n’a aucune fonction à lui."
        : `Le programme a ${count(n ?? 0, {one: "une seule fonction à lui", other: n => `${n} fonctions à lui`})}.`,
    "gives-not": (_n, _t, name) => `\`${name}\` n’envoie pas cela.`,
    "no-function": (_n, _t, name) => `Aucune fonction ne parle de \`${name}\`.`,
    "not-never-falls": (_n, time) => `Une roue était au-dessus d’un trou${seconds(time)}.`,
    "not-never-pushes": n => {
      const time = Math.abs(n ?? 0)
      return `Il a poussé contre quelque chose pendant ${fixed(time, 2)} seconde${time < 2 ? "" : "s"}.`
    },
    "not-reaches-goal": (_n, time) => `Il n’était pas au but${seconds(time)}.`,
    "not-returns-to-start": n => `En revenant, il est arrivé à ${measure(n)} du départ.`,
    "not-covers": n => `Il est passé sur ${Math.round(n ?? 0)} % du sol.`,
    "not-room-goals": (_n, time) => `Un but de la salle restait à atteindre${seconds(time)}.`,
  },
}
