/// The sentences and labels of the page in French.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, count} = measuresOf("fr")

export const page: Omit<
  Words,
  | "backpack"
  | "blocks"
  | "challenges"
  | "classroom"
  | "world"
  | "recordings"
  | "companions"
  | "diagram"
  | "film"
  | "graph"
  | "replies"
  | "roomTests"
  | "preview"
  | "runs"
  | "keys"
  | "lessons"
  | "lessonEditor"
  | "twin"
  | "welcome"
  | "why"
  | "blockly"
> = {
  rosy: "Rosy",
  run: "Démarrer",
  stop: "Arrêter",
  runHint: "Démarrer (Ctrl+Entrée)",
  stopHint: "Arrêter (Espace)",
  reset: "Remettre au départ",
  resetHint: "Remettre le robot à son point de départ",
  sameAgain: "Encore une fois, pareil",
  sameAgainHint: "Encore une fois, pareil : avec la même chance aux dés et les mêmes glissades des roues",
  pause: "Pause",
  resume: "Continuer",
  continueHere: "Continuer à partir d’ici",
  continueHint: "Continuer à partir de ce moment, avec le programme tel qu’il est maintenant",
  forward: "Un pas (0,02 s)",
  stepBefore: "Étape précédente : là où une fonction a commencé",
  stepAfter: "Étape suivante : là où une fonction commence",
  lookBack: "Revenir en arrière dans le temps",
  saveTable: "Enregistrer en tableau (CSV)",
  noRun: "Démarre le programme pour voir ses valeurs.",
  chartedValues: "Valeurs à dessiner",
  chartSpan: "Durée à dessiner",
  chartSpans: {20: "20 s", 60: "1 min", all: "Tout"},
  remembers: "Le programme retient",
  robotValues: "Le robot",
  time: "Temps",
  quantities: {
    speed: "Vitesse",
    turning: "Rotation",
    x: "x",
    y: "y",
    heading: "Direction",
    believedX: "x estimé",
    believedY: "y estimé",
    believedHeading: "Direction estimée",
  },
  readout: {
    time: "temps",
    heading: "direction",
    speed: "vitesse",
    bumpers: "pare-chocs",
    cliffs: "capteurs de vide",
    wheels: "roues",
    led1: "LED 1",
    led2: "LED 2",
  },
  sides: {left: "gauche", centre: "milieu", right: "droite"},
  senses: {
    bumper: ["enfoncé", "relâché"],
    cliff: ["trou", "sol"],
    wheel: ["en l’air", "au sol"],
    button: ["enfoncé", "relâché"],
  },
  led: n => `LED ${n}`,
  speed: "Vitesse",
  fastest: "max.",
  examples: "Exemples",
  undo: "Annuler",
  redo: "Rétablir",
  menu: "Plus",
  programName: "Nom du programme",
  unnamed: "mon programme",
  yourProgram: "Ton programme",
  saved: {saved: "enregistré", changed: "enregistrement…", failed: "non enregistré"},
  view: "Affichage",
  views: {blocks: "Blocs", both: "Blocs + Haskell", haskell: "Haskell", diagram: "Schéma"},
  regions: {blocks: "Blocs", haskell: "Haskell", diagram: "Schéma", room: "Salle"},
  region: "Montrer",
  canvasHeight: "Hauteur de la salle",
  arrange: {
    title: "Disposition",
    hint: "Mets les blocs, le Haskell et la salle où tu veux",
    choices: "Où sont les choses",
    beside: (one, other) => `${one} à côté de ${other}`,
    below: (one, other) => `${one} au-dessus de ${other}`,
    shown: "Ce que tu vois",
    reset: "Comme au début",
    how: "Tire sur les points en haut d’une partie, ou sur la limite entre deux parties.",
    move: region => `Déplacer : ${region}`,
    moveHint: "Tire-la à un autre endroit. Les flèches la déplacent de ce côté.",
    hide: region => `Cacher : ${region}`,
    border: (one, other) => `Limite entre ${one} et ${other}`,
  },
  room: "Salle",
  worldName: "Salle où rouler",
  ownWorld: "ma salle",
  soundOn: "Le son est activé",
  soundOff: "Le son est coupé",
  clock: "Temps écoulé",
  tabs: {
    console: "Console",
    charts: "Courbes",
    runs: "Exécutions",
    sensors: "Valeurs",
    problems: "Problèmes",
  },
  emptyConsole: "Ce que le robot détecte et dit apparaît ici.",
  moreEvents: n =>
    count(n, {
      one: n => `Montrer ${n} autre événement`,
      other: n => `Montrer ${n} autres événements`,
    }),
  fewerEvents: "Montrer seulement les événements les plus importants",
  noProblems: "Aucun problème.",
  times: n => `×${n}`,
  plays: "joue",
  pastedText: "Le texte collé",
  newName: old => `Nouveau nom pour ${old}`,
  rename: "Renommer",
  format: "Mettre le Haskell en forme",
  editor: {
    Find: "Chercher",
    Replace: "Remplacer par",
    next: "Suivant",
    previous: "Précédent",
    all: "Tout sélectionner",
    "match case": "Aa compte",
    "by word": "Mots entiers",
    regexp: "Motif",
    replace: "Remplacer",
    "replace all": "Tout remplacer",
    close: "Fermer",
    "current match": "trouvé ici",
    "replaced $ matches": "$ endroits changés",
    "replaced match on line $": "un endroit changé à la ligne $",
    "on line": "à la ligne",
    Diagnostics: "Problèmes",
    "No diagnostics": "Aucun problème",
    Completions: "Ce qui convient ici",
    "Control character": "Caractère invisible",
  },
  showIt: "Montre-moi",
  nothingToRun: "Rien ne s’exécute encore. Choisis un bloc pour `simulate`, puis appuie sur Démarrer.",
  nothingRuns: name => `Rien ne s’exécute encore. Exécuter \`${name}\` ?`,
  runIt: name => `Exécuter ${name}`,
  readMore: "En savoir plus",
  fromToolbox: "Dans la boîte à outils",
  writeType: signature => `Écrire son type : ${signature}`,
  compilerSays: "Ce que le compilateur a dit",
  givenInputs: "Elle a reçu",
  atTime: time => `à ${seconds(time, 2)}`,
  close: "Fermer",
  newProgram: "Nouveau programme",
  openFile: "Ouvrir un fichier…",
  saveFile: "Enregistrer dans un fichier",
  saveHaskell: "Enregistrer le Haskell",
  share: {
    menu: "Partager ou imprimer…",
    title: "Partager",
    lead: "Le lien contient tout le programme et sa salle. Rien n’est envoyé sur Internet.",
    making: "Le lien se prépare…",
    reach: {
      network:
        "L’adresse de cette page ne mène qu’à cet ordinateur. Le lien a donc son adresse sur le réseau : les autres peuvent l’ouvrir tant que Rosy tourne ici.",
      computer:
        "Ce lien ne mène qu’à cet ordinateur. Pour les autres, enregistre le programme dans un fichier, ou lance Rosy avec `--host 0.0.0.0` et partage à nouveau.",
    },
    link: "Lien",
    copy: "Copier",
    copied: "Copié.",
    notCopied: "Appuie sur Ctrl+C pour le copier.",
    code: "Le lien en code QR",
    codeHint: "Le code QR contient le programme et sa salle, mais pas la position des blocs.",
    noCode: "Ce programme est trop long pour un code QR. Le lien peut le contenir.",
    embed: "Pour le mettre dans ta propre page",
    page: "Enregistrer une page qui marche partout",
    pageHint:
      "Un seul fichier avec les blocs, le Haskell et le film de la dernière exécution. Il s’ouvre sans Rosy, depuis un disque ou un site web.",
    pageWithoutFilm:
      "Un seul fichier avec les blocs et le Haskell. Exécute d’abord le programme, et il contiendra aussi le film de l’exécution.",
    print: "Imprimer les blocs et le Haskell",
    openInRosy: "Ouvrir dans Rosy",
  },
  sharedPage: {
    film: "La dernière exécution",
    noFilm: "Le programme n’avait pas encore été exécuté quand cette page a été faite.",
    olderFilm: "Le film montre le programme avant ses dernières modifications.",
    play: "Lire",
    reach: {
      network:
        "Le lien marche pour les autres sur le même réseau, tant que Rosy tourne sur l’ordinateur où cette page a été faite.",
      computer: "Le lien ne marche que sur l’ordinateur où cette page a été faite, tant que Rosy y tourne.",
    },
    made: version => `Fait avec Rosy ${version}`,
  },
  driveByHand: "Conduire à la main (ROS)",
  help: {
    title: "Les noms de Haskell",
    lead: "Tous les programmes Haskell les connaissent. Chacun est montré avec son type et un exemple.",
  },
  guide: {
    menu: "Guide",
    teachers: "Pour les enseignants",
    isEnglish: "Cette page du guide n’existe qu’en anglais.",
    more: "En savoir plus dans le guide",
  },
  about: version => `À propos de Rosy ${version} : licences`,
  language: "Langue",
  theme: "Couleurs",
  themes: {auto: "Comme le système", light: "Clair", dark: "Sombre"},
  galleryTitle: "Exemples",
  galleryLead: "Ouvre un exemple, démarre-le, change-le. Ton propre programme est gardé.",
  galleryLoading: "Recherche des exemples…",
  galleryFailed:
    "Les exemples n’ont pas pu être chargés. Le service de Rosy ne répond pas ; réessaie dans un moment.",
  exampleLevels: {
    start: "Premiers pas",
    react: "Réagir et se souvenir",
    tasks: "Une chose après l’autre",
    large: "Programmes plus grands",
  },
  otherExamples: "Autres exemples",
  moreAbout: title => `Ce que montre ${title}`,
  again: "Réessayer",
  myPrograms: {
    title: "Mes programmes",
    lead: "Ce navigateur garde chaque programme que tu changes.",
    none: "Change un exemple ou commence un nouveau programme : il sera gardé ici.",
    open: "ouvert maintenant",
    rename: name => `Renommer ${name}`,
    newName: name => `Nouveau nom pour ${name}`,
    duplicate: name => `Dupliquer ${name}`,
    remove: name => `Supprimer ${name}`,
    removed: name => `${name} est supprimé.`,
    undo: "Annuler",
    deleted: "Programmes supprimés",
    restore: name => `Restaurer ${name}`,
    restoreShort: "Restaurer",
  },
  invite: {
    change: "Change",
    from: "+",
    to: "en",
    into: "-",
    after: "et démarre encore. Où va le robot maintenant ?",
  },
  haskellPane: "Le programme en Haskell",
  haskellKeys: "Échap puis Tab sort du texte. F8 va au problème suivant.",
  blocksPane: "Le programme en blocs",
  link: {
    connecting: "Recherche du robot…",
    lost: "La connexion avec Rosy est perdue. Elle revient toute seule ; ton programme est gardé.",
  },
  programComing: "Les blocs arrivent. La première fois est la plus longue ; ton navigateur les garde.",
  worker: {
    starting: "Le programme qui lit le Haskell démarre.",
    restarting:
      "Le programme qui lit le Haskell redémarre. Ton travail est gardé ; démarre à nouveau dans un moment.",
  },
  queued: place =>
    place === 1
      ? "La salle est pleine. Ton programme est le prochain."
      : `La salle est pleine. ${count(place - 1, {one: n => `${n} programme passe`, other: n => `${n} programmes passent`})} avant le tien.`,
  roomLabel: world =>
    `La salle ${world} vue d’en haut, avec le robot. Pendant que le programme tourne, les flèches déplacent le robot, virgule et point le tournent, et B prend plutôt un objet à pousser ; plus et moins changent le zoom, F le suit. W demande pourquoi il bouge ainsi, et P pourquoi il est là.`,
  sight: "Comment voir la salle",
  follow: "Suivre le robot",
  followHint: "Suivre le robot (F)",
  closer: "Plus près",
  further: "Plus loin",
  wholeRoom: "Toute la salle",
  sightMenu: "Trace, image et film",
  trail: "Trace",
  trails: {plain: "Une couleur", speed: "Vitesse", time: "Temps"},
  trailEnds: {speed: ["lent", "rapide"], time: ["départ", "maintenant"]},
  savePicture: "Enregistrer une image",
  startFilm: "Commencer un film",
  endFilm: "Terminer le film",
  robots: {
    title: "Quel robot ?",
    lead: "Le même programme fonctionne sur chacun d’eux.",
    choose: "Choisir un robot",
    simulated: "Robot simulé",
    simulatedShort: "Simulé",
    simulatedHint: "Il vit dans la salle de cette page, et rien ne peut se casser.",
    free: "libre",
    has: who => `pris par ${who}`,
    domain: domain => `domaine ROS 2 ${domain}`,
    charge: percent => `batterie ${percent} %`,
    volts: volts => `batterie ${short(volts, 1)} V`,
    several: "plusieurs robots sur les mêmes topics : donne à chacun un espace de noms (namespace)",
    discovers: "Un robot sur ROS 2 que l’on allume dans ce réseau apparaît ici tout seul.",
    yours: "c’est toi qui l’as",
    who: "Ton nom, pour que les autres le voient",
    locked: "Les robots sont verrouillés. La personne qui a lancé Rosy peut te dire le code.",
    code: "Code",
    unlock: "Ouvrir",
    take: "Prendre",
    leave: "Lâcher",
    leaveHint: "Le robot s’arrête, et d’autres peuvent le prendre",
    link: {connecting: "Recherche…", connected: "Connecté", lost: "Perdu, recherche…"},
    safetyOn: "Recule tout seul",
    safetyOnHint: "Il recule devant les murs et les trous avant que ton programme puisse rouler à nouveau.",
    safetyOff: "Ne recule pas",
    safetyOffHint:
      "Les règles de sécurité sont désactivées : surveille son chemin. Le bouclier au-dessus de la salle les active.",
    backing: "Recule…",
    limits: speed => `au plus ${short(speed, 2)} m/s`,
    estop: "Arrêt d’urgence",
    estopHint: "Arrêter le robot tout de suite (Espace)",
    stopped: "Il a été arrêté et ne bouge plus.",
    letDrive: "Le laisser rouler à nouveau",
    region: name => `Le robot ${name}`,
    floor: name =>
      `Le chemin du robot ${name}, tel qu’il le mesure lui-même ; plus et moins changent le zoom.`,
  },
  topics: {
    title: "Messages à la main",
    send: "Envoyer",
    runFirst: "Appuie d’abord sur Démarrer : seul un programme en marche reçoit des messages",
    ofRobot: topic => `Le robot envoie lui-même les messages sur ${topic}.`,
    computed: type =>
      `Le programme calcule le nom du topic de ${type}, donc il n’y a pas de formulaire : écris le nom en un seul texte.`,
  },
  safety: {
    name: "Règles de sécurité",
    on: "Les règles de sécurité sont activées : le robot recule devant les murs et les trous avant que ton programme continue, ici et sur de vrais robots",
    off: "Les règles de sécurité sont désactivées : seul ton programme conduit, ici et sur de vrais robots",
    overrides: "Règles de sécurité : recule…",
    tookOver: "Les règles de sécurité prennent le relais : recule",
  },
  blocked: {
    pushes: "Le robot pousse contre quelque chose et ne peut plus avancer.",
    withBumper: "Une fonction qui reçoit Bumper peut le détourner.",
    withoutBumper: "Il n’a pas de pare-chocs de ce côté : fais-le rouler autrement.",
  },
  goals: "Buts",
  goalStates: {open: "à faire", done: "réussi", missed: "manqué"},
  hands: "Toucher le robot",
  robotButton: n => `Appuyer sur le bouton ${n} du robot`,
  holdsThing: (kind, n) =>
    `${kind === "box" ? "Caisse" : "Tonneau"} ${n} : les flèches poussent cet objet. Échap reprend le robot.`,
  lift: "Soulever",
  liftHint: "Soulever le robot du sol, et le reposer",
  doing: {
    lookingBack: "Retour en arrière",
    standing: "En pause",
    ready: "Prêt",
    waiting: "Attend",
    queued: "Attend",
    compiling: "Démarre",
    running: "Actif",
  },
  ended: {
    done: "Terminé",
    error: "Arrêté par un problème",
    stuck: "Arrêté par un problème",
    hole: "Arrêté à un emplacement vide",
    stopped: "Arrêté",
    time: "Le temps est écoulé",
    refused: "Pas démarré",
    lost: "Connexion perdue",
  },
  notices: {
    diverged: {
      message: time => `Ton programme modifié fait autre chose à partir de ${time}.`,
      hint: "Il a tourné du début jusqu’au moment que tu as choisi.",
    },
    uncompared: {
      message: time => `Après ${time}, on ne sait pas si ton programme modifié fait autre chose.`,
      hint: "Les ordres d’une exécution sont gardés pendant une heure environ.",
    },
    notText: {
      message: name => `${name} ne contient pas de texte.`,
      hint: "Rosy ouvre des programmes : des fichiers qui finissent par .rosy ou .hs.",
    },
    olderEncoding: {
      message: ({name, encoding, number, line}) =>
        `${name} est dans l’encodage ${encoding}, pas en UTF-8 : voir la ligne ${number}, « ${line.trim()} ».`,
      hint: "Si la ligne est juste, lis le fichier ainsi. Rosy l’enregistre en UTF-8.",
      readAs: encoding => `Le lire en ${encoding}`,
    },
    emptyFile: {
      message: name => `${name} est vide.`,
      hint: "Il ne contient pas de programme à ouvrir.",
    },
    confusable: {
      message: (name, n, {character, plain, name: called}) =>
        `${name} : ${count(n, {one: "un caractère a l’air juste et ne l’est pas", other: k => `${k} caractères ont l’air justes et ne le sont pas. Le premier`})} : ${plain.trim() === "" ? `un caractère invisible (${called})` : `‘${character}’ (${called}) au lieu de ‘${plain}’`}.`,
      hint: "Les commentaires et les textes entre guillemets restent comme ils sont.",
      repair: "Réparer",
    },
    severalPrograms: {
      message: (name, n) => `${name} contient ${n} programmes.`,
      hint: unread =>
        unread === 0
          ? "Choisis-en un."
          : `Choisis-en un. ${count(unread, {one: "Un autre n’a pas pu être lu", other: n => `${n} autres n’ont pas pu être lus`})}.`,
    },
    noPrograms: name => `Il n’y a pas de programmes dans ${name}.`,
    tooManyFiles: {
      message: name => `${name} contient trop de choses.`,
      hint: "Rosy regarde au plus 2 000 fichiers et 20 millions de caractères. Dépose le dossier où se trouve ton programme.",
    },
    damagedArchive: {
      message: name => `${name} ne peut pas être décompressé.`,
      hint: "Il est abîmé ou protégé par un mot de passe. Décompresse-le sur ton ordinateur et dépose le dossier.",
    },
    notProgram: name => `${name} n’est pas un programme.`,
    tooLarge: {
      message: name => `${name} est trop grand.`,
      hint: "Un programme a au plus 200 000 caractères. Le tien est toujours ouvert.",
    },
    notWorld: name => `${name} n’est pas une salle que Rosy peut utiliser.`,
    exampleMissing: {
      message: name => `Il n’y a pas d’exemple ${name}.`,
      hint: "« Exemples », en haut, montre ceux qui existent.",
    },
    noFilm: {
      message: "Le film est vide.",
      hint: "Commence-le pendant que le robot roule, et termine-le plus tard.",
    },
    filmFailed: {
      message: "Le film n’a pas pu être fait.",
      hint: "Laisse le programme tourner un moment, ou essaie l’autre sorte de film.",
    },
    noReader: {
      message: "Il manque une partie de la page.",
      hint: "Recharge la page ; rien de ton travail n’est perdu.",
    },
    notFormatted: {
      message: left =>
        count(left, {
          one: n => `${n} définition est restée comme elle était.`,
          other: n => `${n} définitions sont restées comme elles étaient.`,
        }),
      hint: "Quelque chose n’y est pas terminé, ou la mise en forme aurait perdu quelque chose.",
    },
    otherMeaning: {
      message: name =>
        `Le texte Haskell de ${name} ne peut pas dire exactement ce changement des blocs. Il n’a pas été fait.`,
      hint: "Fais le changement dans le texte Haskell, ou construis cet endroit autrement.",
    },
    groupedOtherwise: {
      message: name =>
        `Après ce changement, le compilateur ne regroupe pas le texte Haskell de ${name} comme les blocs. Le programme est de nouveau comme avant.`,
    },
    unreadableEdit: {
      message: name =>
        `Après ce changement, le compilateur ne peut pas lire le texte Haskell de ${name}. Le programme est de nouveau comme avant.`,
    },
    unfinishedText: {
      message: name =>
        `Pas encore terminé dans le texte Haskell : ${name}. Ce changement des blocs n’a pas été fait.`,
      hint: "Termine la ligne dans le texte ou appuie sur Annuler, puis change les blocs. Les blocs que le texte dit déjà peuvent être changés.",
    },
    progressNotSaved: {
      message: "Ce navigateur n’a plus de place pour garder où tu en es dans la leçon.",
      hint: "Supprime des programmes dans « Mes programmes », puis fais l’étape suivante. Ton programme n’est pas concerné.",
    },
    notSaved: {
      message: "Ce navigateur n’a plus de place pour garder ton programme.",
      hint: "Supprime des programmes dans « Mes programmes », ou enregistre celui-ci dans un fichier avec le menu en haut à droite.",
    },
    madeWay: {
      message: names =>
        `Ce navigateur est plein : Rosy a retiré pour de bon ces programmes supprimés : ${names}.`,
      hint: "Supprime les programmes dont tu n’as plus besoin, et enregistre dans des fichiers ce que tu veux garder.",
    },
    robotGone: {
      message: name => `Tu n’as plus ${name}.`,
      hint: "Reprends-le quand tu en as besoin.",
    },
    outOfSight: {
      message: name => `${name} a été arrêté, car cette page n’était pas visible.`,
      hint: "Garde la page visible tant qu’un vrai robot roule.",
    },
    damagedLink: {
      message: "Ce lien est abîmé.",
      hint: "Copie le lien en entier et ouvre-le à nouveau.",
    },
    becameTwo: {
      message: name => `${name === "" ? "Ton programme" : name} a été changé dans deux onglets à la fois.`,
      hint: copy => `Maintenant, il y en a deux : celui-ci s’appelle ${copy}.`,
    },
    noStorage: {
      message: "Ce navigateur ne garde rien pour cette page.",
      hint: "Enregistre ton programme dans un fichier avant de fermer la page.",
    },
  },
}
