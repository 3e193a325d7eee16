/// Worksheets of the first eight lessons, an activity without a computer for each, and two written tests, in French.

import type {WorksheetWords} from "../../en/page/worksheets.ts"

export const worksheets: WorksheetWords = {
  labels: {
    sheet: lesson => `Fiche : ${lesson}`,
    slides: course => `Diapositives : ${course}`,
    name: "Nom :",
    answer: "Ta réponse :",
    forTeachers: "Pour l’enseignant : les réponses",
    unplugged: title => `Sans ordinateur : ${title}`,
    test: number => `Test ${number}`,
    testLead:
      "20 minutes, sur papier, sans ordinateur. Un point par question. Coche une réponse ou écris un nombre.",
    marking:
      "Saisir les réponses dans un tableau : un nom, le test, puis les réponses dans l’ordre, et l’enregistrer en CSV. `./rosy class marks answers.csv -o marks.csv` compte les points. Un nombre peut différer un peu là où la clé le dit.",
  },
  cards: {
    title: "Cartes des blocs",
    lead: "Des cartes pour les blocs : en mots, dans la couleur de leur famille, et en Haskell. Les blocs qui ne vont que dans d’autres et les grands exemples n’en ont pas. Imprimées, huit cartes remplissent une feuille ; choisir les feuilles utiles et les découper. Les élèves posent un programme avec elles, lisent ceux des autres et le tapent.",
  },
  poster: {
    title: "Le langage sur une feuille",
    lead: "Les blocs des cartes avec leur Haskell, pour le mur. Ils remplissent une feuille A3 en largeur ; pour A4, laisser l’imprimante la réduire.",
    roles: {
      event: "Se produit à un moment :",
      state: "A toujours une valeur :",
      command: "Est envoyé au robot :",
    },
  },
  sheets: {
    "hello-robot": {
      tasks: [
        {
          say: "Le robot doit être 3 mètres plus loin après 10 secondes. Quel nombre ?",
          answer: "0,3 (dans le programme 0.3)",
        },
        {
          say: "Dessine où est `Velocity (-0.2) 0` après 5 secondes, et après 10.",
          answer: "1 mètre et 2 mètres derrière le départ",
        },
      ],
      unplugged: {
        title: "le robot qui ne s’arrête jamais",
        steps: [
          "Un élève est le robot et se tient sur une ligne. Un autre est le programme et tient une carte : 1 pas par seconde.",
          "La classe compte les secondes à voix haute. Le robot fait ce que dit la carte, tant que la carte est là.",
          "Le programme montre une autre carte : 2 pas, ou 1 pas en arrière. Question : quand le robot s’arrête-t-il ? (Quand une carte dit 0.)",
        ],
      },
    },
    "turn-on-the-spot": {
      tasks: [
        {
          say: "Combien de temps dure un tour complet avec `Velocity 0 0.5` ? Un tour complet fait 6,28.",
          answer: "environ 12,6 secondes",
        },
        {
          say: "Quel deuxième nombre tourne d’un quart (1,57) vers la droite en 2 secondes ?",
          answer: "environ −0,79",
        },
      ],
      unplugged: {
        title: "des radians avec une ficelle",
        steps: [
          "À deux, les élèves tracent un cercle à la craie avec une ficelle tenue au centre.",
          "Ils posent la même ficelle le long du cercle et marquent combien de fois elle tient : un peu plus de six fois.",
          "Une longueur de ficelle le long du cercle est un radian. Mettez-vous au centre et tournez d’un, puis de trois.",
        ],
      },
    },
    "round-the-box": {
      tasks: [
        {say: "Quel est le rayon du cercle de `Velocity 0.4 0.2` ?", answer: "2 mètres (0,4 divisé par 0,2)"},
        {
          say: "Trouve deux autres nombres pour le même cercle, deux fois moins vite.",
          answer: "`Velocity 0.2 0.1`",
        },
      ],
      unplugged: {
        title: "marcher en cercle",
        steps: [
          "Un élève fait un pas en avant, puis tourne un peu à gauche, encore et encore. D’autres marquent le chemin.",
          "Maintenant il tourne moins. Le cercle est-il plus grand ou plus petit ?",
          "Maintenant le pas et le virage se font en même temps : c’est ce que fait le robot.",
        ],
      },
    },
    "light-and-motion": {
      tasks: [
        {
          say: "Écris la valeur pour : reculer à 0,1, première lumière orange.",
          answer: "`(Velocity (-0.1) 0, Led1 Orange)`",
        },
        {
          say: "Dans un programme, `Led1 Red` et `Led1 Green` sont côte à côte. Qu’est-ce qui est étrange ?",
          answer: "Deux valeurs pour une lumière : elles se remplacent.",
        },
      ],
      unplugged: {
        title: "un orchestre",
        steps: [
          "Trois élèves reçoivent une carte : frapper dans les mains, taper du pied, fredonner. Tous commencent au mot « départ ».",
          "Ils se placent dans un autre ordre et recommencent. Qu’est-ce qui a changé ? (Rien.)",
          "Donner à un élève deux cartes impossibles ensemble : assis, debout. Que se passe-t-il ?",
        ],
      },
    },
    faster: {
      tasks: [
        {
          say: "La vitesse est 0, et 0,01 s’ajoute 50 fois par seconde. Quelle est-elle après 1 seconde ?",
          answer: "0,5 mètre par seconde",
        },
        {say: "Complète : `slower (Velocity vl va) = Velocity (vl ___ 0.01) va`", answer: "`-`"},
      ],
      unplugged: {
        title: "une machine à nombres",
        steps: [
          "Un élève derrière une table est une machine : un nombre entre sur un papier, et ressort plus 2.",
          "Ce qui sort entre de nouveau. La classe devine le nombre après cinq fois.",
          "D’autres règles : doubler, enlever un. Laquelle devient grande le plus vite ?",
        ],
      },
    },
    "stop-in-time": {
      tasks: [
        {say: "Que donne `go` pour x = 0,5, pour x = 0,99 et pour x = 1 ?", answer: "0,3, 0,3 et 0"},
        {
          say: "Ajoute une ligne : entre 1 et 1,5 il roule à 0,1.",
          answer: "`| x < 1.5 = Velocity 0.1 0` comme deuxième ligne",
        },
      ],
      unplugged: {
        title: "la classe décide",
        steps: [
          "Un élève marche. Après chaque pas, il dit à voix haute combien de pas il a faits.",
          "La classe est la fonction et répond chaque fois : « moins de 5 : avance, sinon : reste là ».",
          "On recule l’élève de deux pas, et on continue. Que répond la classe maintenant ?",
        ],
      },
    },
    bump: {
      tasks: [
        {say: "Le pare-chocs est enfoncé 3 fois et relâché 3 fois. Combien d’événements ?", answer: "6"},
        {
          say: "Événement ou état : un choc, la vitesse, un bouton, la position ?",
          answer: "événement, état, événement, état",
        },
      ],
      unplugged: {
        title: "frapper ou rien",
        steps: [
          "Lever une carte et la baisser : ce sont deux événements. La classe répond à chacun en frappant dans les mains.",
          "Nouvelle règle : frapper quand la carte monte, rien quand elle descend. « Rien » est aussi une réponse.",
          "Qui frappe tant que la carte est en l’air a pris un événement pour un état.",
        ],
      },
    },
    "which-side": {
      tasks: [
        {
          say: "Les cas dans cet ordre : tous les côtés, côté gauche. Quand le deuxième sert-il ?",
          answer: "Jamais : le premier convient à tout.",
        },
        {
          say: "Écris le motif pour : le pare-chocs droit est relâché.",
          answer: "`Bumper RightBumper Released`",
        },
      ],
      unplugged: {
        title: "la poste",
        steps: [
          "Des boîtes sont en rang : « lettres rouges », « lettres pour Ada », « toutes les autres ». Une lettre va dans la première boîte qui convient.",
          "Triez dix lettres. Où va une lettre rouge pour Ada ?",
          "Mettez « toutes les autres » en premier et triez de nouveau. Qu’y a-t-il dans les autres boîtes ?",
        ],
      },
    },
  },
  tests: {
    "1": [
      {
        ask: "Jusqu’où va le robot en 5 secondes, en centimètres ?",
        why: "0,3 mètre pendant chacune des 5 secondes.",
      },
      {
        ask: "Quand s’arrête-t-il de lui-même ?",
        answers: ["Après 1 mètre", "Après 5 secondes", "Jamais"],
        why: "Une vitesse vaut jusqu’à la suivante.",
      },
      {
        ask: "Quelle valeur roule en cercle vers la droite ?",
        answers: ["`Velocity 0.3 0`", "`Velocity 0 (-0.3)`", "`Velocity 0.3 (-0.3)`"],
        why: "Il avance et tourne à droite en même temps.",
      },
      {
        ask: "Que fait ce programme ?",
        answers: ["Il roule, puis la lumière vient", "Les deux dès le début", "Seulement la lumière"],
        why: "Les valeurs sont côte à côte.",
      },
      {
        ask: "Combien de fois vérifie-t-il si `x < 1` ?",
        answers: ["Une fois, au début", "À chaque message du robot", "Quand il arrive"],
        why: "Une fonction d’un état est appelée encore et encore.",
      },
      {
        ask: "Le robot se cogne 3 fois et se libère chaque fois. Combien de sons ?",
        why: "Enfoncé et relâché sont deux événements, trois fois.",
      },
      {
        ask: "Que fait le robot devant le mur ?",
        answers: ["Il continue à pousser", "Il recule", "Il s’arrête"],
        why: "`go` est envoyé encore et encore et remplace ce que `back` a envoyé.",
      },
      {
        ask: "Quand `back` répond-elle ?",
        answers: [
          "Quand un choc et un trou se sont produits tous les deux",
          "À chaque choc et à chaque changement du sol",
          "Seulement au premier qui arrive",
        ],
        why: "`Either` est l’un ou l’autre, chaque fois.",
      },
    ],
    "2": [
      {
        ask: "Le pare-chocs est enfoncé 3 fois. Quel nombre est alors dans la mémoire ?",
        why: "Elle commence à 0, et 2 s’ajoute chaque fois qu’il est enfoncé.",
      },
      {
        ask: "Que fait le robot après un choc ?",
        answers: ["Il recule", "Il s’arrête", "Il avance comme avant"],
        why: "`drive` ne regarde pas la mémoire.",
      },
      {
        ask: "Que fait le robot au début ?",
        answers: ["Il avance", "Il recule", "Il tourne"],
        why: "La mémoire commence par le premier cas.",
      },
      {
        ask: "Que fait le programme dans la seconde qui suit un choc ?",
        answers: ["Il attend une seconde", "Il compare l’horloge encore et encore", "Rien"],
        why: "Rien n’attend ; l’horloge décide.",
      },
      {
        ask: "Un programme avec `StdGen` est exécuté deux fois avec la même graine. Qu’est-ce qui change ?",
        answers: ["Rien", "Tout", "Seulement le premier virage"],
        why: "La même graine donne les mêmes nombres.",
      },
      {
        ask: "Quand commence `turn 90` ?",
        answers: ["En même temps que `drive`", "Quand `drive 100` est fini", "Après une seconde"],
        why: "Les étapes d’une tâche se suivent.",
      },
      {
        ask: "Combien de coins a la figure que parcourt le robot ?",
        why: "Cinq fois 72 degrés font un tour complet.",
      },
      {
        ask: "Quand ce programme est-il fini ?",
        answers: ["Après 5 mètres", "Quand les deux tâches sont finies", "Après 4 secondes"],
        why: "`race` finit avec la première ; 5 mètres durent plus longtemps.",
      },
    ],
  },
}
