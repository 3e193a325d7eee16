/// What the pages for teachers say besides the lessons' own texts, in French.

import type {TeachingWords} from "../../en/page/teaching.ts"

export const teaching: TeachingWords = {
  labels: {
    about: (minutes, week) => `Environ ${minutes} minutes · semaine ${week}`,
    optional: (minutes, week) => `Environ ${minutes} minutes · au choix, dès la semaine ${week}`,
    aims: "Ce que les élèves savent ensuite",
    steps: "Ce qui est demandé",
    step: "étape",
    rightAnswer: "bonne réponse, ou ce qui est vérifié",
    begins: "La leçon commence par ce programme",
    ask: "Questions à poser",
    wrong: "Ce qui ne va pas",
    nearMisses:
      "Quelques essais qui ne réussissent pas, avec les lignes qui comptent et ce que la page en dit :",
    says: (check, seen) => `« ${check} » n’est pas fait. ${seen}`,
    solutions: "Solutions qui réussissent",
    others: "D’autres réussissent aussi :",
  },
  plan: {
    title: "Douze semaines",
    lead: "Un plan pour un trimestre, avec une rencontre de 45 minutes par semaine. Les élèves font les leçons de la page seuls ou à deux ; le reste du temps sert à parler, à travailler sur papier et à faire des projets. Avec deux rencontres par semaine, la deuxième est pour un projet.",
    columns: ["semaine", "leçons", "de quoi il s’agit", "préparer", "ensemble et sur papier"],
    handbook: "45 minutes ensemble",
    weeks: [
      "Démarrer la classe ; trois mots pour chaque élève. Imprimer la fiche.",
      "Une caisse ou un sac par terre, pour tourner autour.",
      "Un mètre de ruban adhésif par terre.",
      "Rien ; les élèves frappent dans les mains.",
      "Le projecteur, pour **Pourquoi ?**.",
      "Un jouet à soulever, s’il y en a un. Choisir les projets.",
      "Test 1 sur papier, 20 minutes. Un bout de papier et un crayon pour la « mémoire ».",
      "Trois cartes : Go, Back, Turn.",
      "Un dé pour deux élèves.",
      "Une recette de cuisine.",
      "Deux élèves qui font des choses en même temps.",
      "Test 2, le concours, et les projets sont montrés.",
    ],
    strand: (page, week) =>
      `**Avec les mathématiques :** dès la semaine ${week}, on peut ajouter la série [Algèbre](${page}), aussi en cours de mathématiques :`,
    after: projects =>
      `**Si le temps manque :** laisser la troisième leçon des semaines 6, 8, 9 et 11. **Si une classe est rapide :** commencer les [projets](${projects}) en semaine 5. Une leçon qui n’est pas finie s’ouvre la fois suivante à la même étape.`,
  },
  curricula: {
    title: "Ce que l’école doit enseigner",
    lead: "Des phrases des programmes scolaires, telles quelles et dans leur langue, et les leçons de la page où les élèves font ce qu’elles demandent. *En partie* veut dire que les leçons n’en enseignent pas tout. Seul ce qui a pu être cité est ici, et le choix des leçons est le nôtre : aucune autorité ne l’a vérifié. Les programmes changent : comparer chaque phrase avec l’édition en vigueur avant de s’appuyer sur elle.",
    columns: ["où", "phrase", "leçons"],
    part: "en partie",
    all: "toutes les leçons",
    incomplete:
      "Ce que ce document dit de la programmation pour chaque année n’a pas pu être cité et manque ici.",
    places: {
      csta: "États-Unis",
      england: "Angleterre",
      kmk: "Allemagne",
      "baden-7": "Allemagne : Bade-Wurtemberg, 7e année",
      baden: "Allemagne : Bade-Wurtemberg, Gymnasium",
      "cycle-4": "France : collège, cycle 4",
      snt: "France : lycée, seconde",
      spain: "Espagne",
      portugal: "Portugal",
    },
  },
  lessons: {
    "hello-robot": {
      often:
        "Les élèves attendent la fin du programme. Il n’y en a pas : une vitesse vaut jusqu’à la suivante.",
      ask: [
        "Où est-il après 10 secondes ?",
        "Quand s’arrête-t-il ?",
        "Quel nombre changes-tu pour aller deux fois plus loin ?",
      ],
    },
    "turn-on-the-spot": {
      often: "Le deuxième nombre est lu en degrés. Ce sont des radians par seconde : 3,14 est un demi-tour.",
      ask: [
        "La gauche, est-ce la tienne ou celle du robot ?",
        "Combien de temps dure un tour complet avec 0,5 ?",
        "Que fait un signe moins ?",
      ],
    },
    "round-the-box": {
      often:
        "Les élèves attendent un coin : d’abord tout droit, puis un virage. Les deux nombres agissent à la fois.",
      ask: [
        "Qu’est-ce qui agrandit le cercle ?",
        "Deux paires de nombres, le même cercle : lesquelles ?",
        "Quel est le cercle avec 0 comme deuxième nombre ?",
      ],
    },
    "light-and-motion": {
      often: "La deuxième valeur est prise pour une deuxième étape. Côte à côte veut dire en même temps.",
      ask: [
        "L’ordre compte-t-il ?",
        "Que fait un programme avec deux vitesses ?",
        "Que peux-tu faire en même temps, toi ?",
      ],
    },
    faster: {
      often: "`vl + 0.02` ressemble à une vitesse de 0,02. C’est ce qui s’ajoute, 50 fois par seconde.",
      ask: [
        "Que reçoit la fonction, et que donne-t-elle ?",
        "Combien de fois est-elle appelée ?",
        "Que ferait `vl - 0.02` ?",
      ],
    },
    "stop-in-time": {
      often:
        "Les élèves croient que le choix se fait une fois, au début. Il se fait de nouveau à chaque message.",
      ask: [
        "Combien vaut `x` maintenant, et maintenant ?",
        "Que se passe-t-il si tu reportes le robot en arrière ?",
        "Pourquoi pas `x == 2` ?",
      ],
    },
    bump: {
      often: "Un choc, ce sont deux événements, enfoncé et relâché ; on entend donc deux sons.",
      ask: [
        "Combien d’événements y a-t-il eu ?",
        "Qu’envoie `Nothing` ?",
        "Quelle différence entre `Nothing` et une lumière éteinte ?",
      ],
    },
    "which-side": {
      often: "Un cas qui convient à tout est le premier, et les autres ne servent jamais.",
      ask: ["Quel cas convient à cet événement ?", "Et si deux cas conviennent ?", "Que veut dire `_` ici ?"],
    },
    "two-wills": {
      often:
        "Les élèves échangent les fonctions : la suivante doit gagner. Ce qui compte, c’est qui envoie en dernier.",
      ask: [
        "Qui a envoyé ce que le robot fait en ce moment ?",
        "Combien de fois chacune envoie-t-elle ?",
        "Comment choisirais-tu entre deux amis qui te donnent des ordres ?",
      ],
    },
    "remote-control": {
      often: "Le robot doit s’arrêter quand on relâche le bouton. Personne ne le lui a dit.",
      ask: [
        "Quel événement est-ce, de relâcher ?",
        "Comment serait une télécommande qui ne roule que si tu appuies ?",
        "Que fait le robot sans ordre ?",
      ],
    },
    "one-or-the-other": {
      often:
        "`Either` est lu comme « quand les deux se sont produits ». La fonction répond à chacun dès qu’il arrive.",
      ask: [
        "Lequel des deux était-ce ?",
        "À quoi la fonction voit-elle la différence ?",
        "Qu’est-ce qui changerait avec deux fonctions ?",
      ],
    },
    "lift-me": {
      often: "En l’air, seule la lumière change. Les roues ont besoin d’un ordre à elles.",
      ask: [
        "Qu’est-ce qui ne doit jamais arriver ?",
        "Qui a le droit de remettre les roues en marche ?",
        "Quels appareils de la maison s’arrêtent quand on les ouvre ?",
      ],
    },
    "wire-a-reflex": {
      often:
        "On s’attend à ce que le deuxième fil vers le même actionneur gagne. Les deux envoient ; il faut dire lequel passe d’abord.",
      ask: [
        "Quels capteurs arrivent aux roues ?",
        "Qu’est-ce qui est dans le schéma, et qu’est-ce qui n’est que dans la fonction ?",
        "D’où partirait un troisième fil vers `Velocity`, et qui devrait alors passer d’abord ?",
      ],
    },
    "stop-before-the-wall": {
      often:
        "La distance libre devant est confondue avec le chemin parcouru. L’une diminue, l’autre augmente.",
      ask: [
        "Dans quel sens va le nombre ?",
        "Et si le mur bouge ?",
        "Comment s’arrêter à 10 cm d’un mur, de n’importe quel départ ?",
      ],
    },
    "count-the-bumps": {
      often:
        "Les relâchements sont comptés aussi, ou le nouveau nombre est attendu tout de suite. La fonction lit l’ancienne valeur et envoie la nouvelle.",
      ask: [
        "Qu’y a-t-il dans la mémoire avant le premier choc ?",
        "Que lit-elle au troisième choc ?",
        "Pourquoi dit-il 2, 4, 6 ?",
      ],
    },
    "there-and-back": {
      often:
        "`bump` doit faire demi-tour lui-même, croient les élèves. Il écrit seulement ; `drive` doit lire.",
      ask: [
        "Qui écrit, qui lit ?",
        "Se connaissent-ils ?",
        "Que fait `drive` avant que rien ne soit écrit ?",
      ],
    },
    "a-mode-of-my-own": {
      often: "Un cas est ajouté au type, et une des fonctions ne le connaît pas.",
      ask: [
        "À quels endroits trouves-tu chaque mode ?",
        "Dessine les modes comme des cercles : quelles flèches y a-t-il ?",
        "`Mode` est-il une valeur ou une liste de valeurs ?",
      ],
    },
    "for-one-second": {
      often:
        "Les élèves cherchent un ordre qui attend. Rien n’attend ; l’horloge est comparée encore et encore.",
      ask: [
        "Que retient-on : une heure ou une durée ?",
        "Que fait un choc pendant cette seconde ?",
        "Comment en faire une demi-seconde ?",
      ],
    },
    "three-states": {
      often:
        "L’état est cherché dans une fonction. Il est dans la mémoire ; les fonctions la lisent et l’écrivent.",
      ask: [
        "Quelle flèche manque à la machine ?",
        "Dessine les trois états comme des cercles : quel capteur est à quelle flèche ?",
        "Que fait le bouton dans `Go` ?",
      ],
    },
    "my-own-event": {
      often:
        "La réponse est écrite deux fois, une fois par capteur. Un événement avec deux émetteurs a besoin d’une seule réponse.",
      ask: [
        "Qui envoie `Blocked`, et qui le prend ?",
        "Que change un troisième capteur ?",
        "Comment s’appelle ton événement ?",
      ],
    },
    chance: {
      often:
        "Le hasard devrait être différent chaque fois, pense-t-on. La même graine donne la même exécution : on peut donc la regarder de nouveau.",
      ask: [
        "Pourquoi est-il bon de pouvoir répéter une exécution ?",
        "Que fait la fonction du générateur qu’elle reçoit en retour ?",
        "Dans quelle salle une règle fixe est-elle meilleure ?",
      ],
    },
    "a-recipe": {
      often: "On écrit des mètres là où il faut des centimètres : `drive 1` est un centimètre.",
      ask: [
        "Quand commence la deuxième étape ?",
        "Quand le programme est-il fini ?",
        "Quelle différence avec deux fonctions côte à côte ?",
      ],
    },
    "four-times": {
      often:
        "Les étapes sont copiées quatre fois, et une copie est changée. Un morceau qui a un nom se change à un seul endroit.",
      ask: [
        "Qu’est-ce qui se répète ?",
        "De combien tourne-t-il en tout ?",
        "Quel angle donne un triangle ?",
      ],
    },
    "look-inside": {
      often: "`Done` doit arrêter le robot, croit-on. Il termine la tâche ; la dernière vitesse reste.",
      ask: [
        "Qu’est-ce qui commence, qui surveille, qui termine ?",
        "Qui arrête les roues ?",
        "Qu’est-ce qui n’enverrait jamais `Done` ?",
      ],
    },
    "a-task-that-answers": {
      often: "Le robot dit le texte « distance » au lieu du nombre, ou des mètres au lieu de centimètres.",
      ask: [
        "D’où vient le résultat ?",
        "Peut-il changer plus tard ?",
        "Comment obtenir l’aire de la salle ?",
      ],
    },
    "at-the-same-time": {
      often: "`parallel` est mis là où une tâche doit abandonner : il attend les deux.",
      ask: [
        "Laquelle des deux finit la première ?",
        "Qu’arrive-t-il à l’autre ?",
        "Quand veux-tu la première, quand les deux ?",
      ],
    },
    "the-papers-robot": {
      often:
        "La sécurité et la curiosité envoient aux roues en même temps. Ce qui compte le plus doit retenir l’autre.",
      ask: [
        "Qu’est-ce qui doit toujours gagner ?",
        "Pendant combien de temps ?",
        "Essaie une autre salle : qu’est-ce qui était de la chance ?",
      ],
    },
    "a-machine-for-numbers": {
      often:
        "La lettre est prise pour un seul nombre. `x` est chaque position sur le chemin, l’une après l’autre.",
      ask: [
        "Quelle sortie pour l’entrée 2 ?",
        "Quelle entrée donne 0 ?",
        "Deux entrées peuvent-elles avoir la même sortie ? Une entrée peut-elle en avoir deux ?",
      ],
    },
    "where-the-graph-meets-zero": {
      often:
        "Le graphe est pris pour le chemin du robot. À droite la position, en haut la vitesse ; le chemin est dans la salle.",
      ask: [
        "Quelle équation le robot a-t-il résolue ?",
        "Que fait un graphe plus raide ?",
        "Porte le robot au-delà du zéro : où va-t-il ?",
      ],
    },
    "a-graph-in-pieces": {
      often:
        "Les conditions sont lues comme si chacune était seule. `x < 2` vaut aussi à 0,5 ; elle n’y compte pas, car un cas précédent convient.",
      ask: [
        "Pour quels `x` vaut chaque règle ?",
        "Où deux morceaux se rejoignent-ils, et où y a-t-il un saut ?",
        "Y a-t-il une entrée sans sortie ?",
      ],
    },
    "machines-in-a-row": {
      often:
        "`speed . distance` est lu de la gauche. La machine de droite travaille d’abord : `speed (distance here)`, comme f(g(x)).",
      ask: [
        "Qu’est-ce qui passe entre les deux machines ?",
        "Peut-on les échanger ? Que disent leurs types ?",
        "Quelle machine change quand l’anneau se déplace ?",
      ],
    },
    "a-family-of-functions": {
      often:
        "`a` et `x` sont deux lettres et sont confondues. `x` change pendant le trajet ; `a` est choisi une fois et reste.",
      ask: [
        "Qu’ont en commun tous les membres de la famille ?",
        "Que se passe-t-il si `a` est négatif ?",
        "Quelle lettre est l’entrée, lesquelles sont des paramètres ?",
      ],
    },
    "rate-of-change": {
      often:
        "Position et vitesse sont lues sur la même courbe. Une position horizontale, c’est la vitesse 0 ; une vitesse horizontale, une position qui monte régulièrement.",
      ask: [
        "Comment voit-on sur la position quand il était le plus rapide ?",
        "Que signifie une position qui descend ?",
        "Que dit l’aire sous la vitesse ?",
      ],
    },
  },
}
