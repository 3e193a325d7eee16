/// Was die Seiten für Lehrkräfte außer den Texten der Lektionen sagen, auf Deutsch.

import type {TeachingWords} from "../../en/page/teaching.ts"

export const teaching: TeachingWords = {
  labels: {
    about: (minutes, week) => `Etwa ${minutes} Minuten · Woche ${week}`,
    optional: (minutes, week) => `Etwa ${minutes} Minuten · wahlweise, ab Woche ${week}`,
    aims: "Das wissen die Kinder danach",
    steps: "Was gefragt ist",
    step: "Schritt",
    rightAnswer: "richtige Antwort, oder was geprüft wird",
    begins: "Die Lektion beginnt mit diesem Programm",
    ask: "Fragen, die du stellen kannst",
    wrong: "Was schiefgeht",
    nearMisses:
      "Einige Versuche, die nicht bestehen, mit den wichtigen Zeilen und dem, was die Seite dazu sagt:",
    says: (check, seen) => `„${check}“ ist nicht erledigt. ${seen}`,
    solutions: "Lösungen, die bestehen",
    others: "Auch diese bestehen:",
  },
  plan: {
    title: "Zwölf Wochen",
    lead: "Ein Plan für ein Halbjahr mit einem Treffen von 45 Minuten in der Woche. Die Kinder machen die Lektionen der Seite allein oder zu zweit; die übrige Zeit ist für Gespräche, Papier und Projekte da. Bei zwei Treffen in der Woche gehört das zweite einem Projekt.",
    columns: ["Woche", "Lektionen", "worum es geht", "vorbereiten", "gemeinsam und auf Papier"],
    handbook: "45 Minuten gemeinsam",
    weeks: [
      "Klasse starten; drei Wörter für jedes Kind. Arbeitsblatt drucken.",
      "Eine Kiste oder eine Tasche auf dem Boden, um die man herumgeht.",
      "Ein Meter Klebeband auf dem Boden.",
      "Nichts; die Kinder klatschen.",
      "Der Beamer, für **Warum?**.",
      "Ein Spielzeug zum Hochheben, wenn du eins hast. Projekte wählen.",
      "Test 1 auf Papier, 20 Minuten. Ein Zettel und ein Stift als „Erinnerung“.",
      "Drei Karten: Go, Back, Turn.",
      "Ein Würfel für jedes Paar.",
      "Ein Rezept aus der Küche.",
      "Zwei Kinder, die gleichzeitig etwas tun.",
      "Test 2, der Wettbewerb, und die Projekte werden gezeigt.",
    ],
    strand: (page, week) =>
      `**Mit Mathematik:** Ab Woche ${week} kann die Reihe [Algebra](${page}) dazukommen, auch im Mathematikunterricht:`,
    after: projects =>
      `**Wenn die Zeit knapp ist:** Lass in den Wochen 6, 8, 9 und 11 die dritte Lektion weg. **Wenn eine Klasse schnell ist:** Beginne mit den [Projekten](${projects}) in Woche 5. Eine Lektion, die nicht fertig wurde, öffnet sich beim nächsten Mal am selben Schritt.`,
  },
  curricula: {
    title: "Was Schulen unterrichten müssen",
    lead: "Sätze aus Lehrplänen, im Wortlaut und in ihrer Sprache, und die Lektionen der Seite, in denen die Kinder das Verlangte tun. *Teilweise* heißt, dass die Lektionen nicht alles davon lehren. Hier steht nur, was sich belegen ließ, und die Zuordnung ist unsere: Keine Behörde hat sie geprüft. Lehrpläne ändern sich: Vergleiche einen Satz mit der gültigen Fassung, bevor du dich auf ihn berufst.",
    columns: ["wo", "Satz", "Lektionen"],
    part: "teilweise",
    all: "jede Lektion",
    incomplete:
      "Was dieses Dokument für jedes Schuljahr vom Programmieren sagt, ließ sich nicht belegen; es fehlt hier.",
    places: {
      csta: "USA",
      england: "England",
      kmk: "Deutschland",
      "baden-7": "Deutschland: Baden-Württemberg, Klasse 7",
      baden: "Deutschland: Baden-Württemberg, Gymnasium",
      "cycle-4": "Frankreich: Klasse 7 bis 9 (cycle 4)",
      snt: "Frankreich: Klasse 10 (seconde)",
      spain: "Spanien",
      portugal: "Portugal",
    },
  },
  lessons: {
    "hello-robot": {
      often:
        "Die Kinder warten auf das Ende des Programms. Es gibt keins: Eine Geschwindigkeit gilt, bis eine andere kommt.",
      ask: [
        "Wie weit ist er nach 10 Sekunden?",
        "Wann bleibt er stehen?",
        "Welche Zahl änderst du, damit er doppelt so weit kommt?",
      ],
    },
    "turn-on-the-spot": {
      often:
        "Die zweite Zahl wird als Grad gelesen. Es sind Radiant in der Sekunde: 3,14 ist eine halbe Drehung.",
      ask: [
        "Ist links dein Links oder das des Roboters?",
        "Wie lange dauert mit 0,5 eine ganze Drehung?",
        "Was bewirkt ein Minus?",
      ],
    },
    "round-the-box": {
      often: "Die Kinder erwarten eine Ecke: erst geradeaus, dann die Drehung. Beide Zahlen gelten zugleich.",
      ask: [
        "Was macht den Kreis größer?",
        "Zwei Zahlenpaare, derselbe Kreis: welche?",
        "Was ist der Kreis mit 0 als zweiter Zahl?",
      ],
    },
    "light-and-motion": {
      often: "Der zweite Wert wird für einen zweiten Schritt gehalten. Nebeneinander heißt gleichzeitig.",
      ask: [
        "Kommt es auf die Reihenfolge an?",
        "Was tut ein Programm mit zwei Geschwindigkeiten?",
        "Was kannst du gleichzeitig tun?",
      ],
    },
    faster: {
      often:
        "`vl + 0.02` sieht wie eine Geschwindigkeit von 0,02 aus. So viel kommt dazu, 50-mal in der Sekunde.",
      ask: [
        "Was bekommt die Funktion, und was gibt sie?",
        "Wie oft wird sie gefragt?",
        "Was würde `vl - 0.02` tun?",
      ],
    },
    "stop-in-time": {
      often: "Die Kinder denken, dass einmal gewählt wird, am Anfang. Bei jeder Meldung wird neu gewählt.",
      ask: [
        "Was ist `x` jetzt, und jetzt?",
        "Was geschieht, wenn du den Roboter zurückträgst?",
        "Warum nicht `x == 2`?",
      ],
    },
    bump: {
      often: "Ein Stoß ist zwei Ereignisse, gedrückt und losgelassen; darum hört man zwei Töne.",
      ask: [
        "Wie viele Ereignisse waren es?",
        "Was sendet `Nothing`?",
        "Was ist der Unterschied zwischen `Nothing` und einem Licht, das aus ist?",
      ],
    },
    "which-side": {
      often: "Ein Fall, auf den alles passt, steht zuerst, und die anderen werden nie benutzt.",
      ask: [
        "Welcher Fall passt auf dieses Ereignis?",
        "Was, wenn zwei Fälle passen?",
        "Was bedeutet `_` hier?",
      ],
    },
    "two-wills": {
      often:
        "Die Kinder vertauschen die Funktionen: Die spätere soll gewinnen. Es zählt, wer zuletzt sendet.",
      ask: [
        "Wer hat gesendet, was der Roboter gerade tut?",
        "Wie oft sendet jede der beiden?",
        "Wie würdest du entscheiden, wenn zwei Freunde dir Befehle geben?",
      ],
    },
    "remote-control": {
      often: "Der Roboter soll anhalten, wenn man den Knopf loslässt. Das hat ihm niemand gesagt.",
      ask: [
        "Welches Ereignis ist das Loslassen?",
        "Wie wäre eine Fernsteuerung, die nur fährt, solange du drückst?",
        "Was tut der Roboter ohne einen Befehl?",
      ],
    },
    "one-or-the-other": {
      often:
        "`Either` wird als „wenn beides geschehen ist“ gelesen. Es antwortet auf jedes, sobald es kommt.",
      ask: [
        "Welches von beiden war es?",
        "Woran sieht die Funktion den Unterschied?",
        "Was wäre mit zwei Funktionen anders?",
      ],
    },
    "lift-me": {
      often: "In der Luft wird nur das Licht geändert. Die Räder brauchen einen eigenen Befehl.",
      ask: [
        "Was darf nie geschehen?",
        "Wer darf die Räder wieder einschalten?",
        "Welche Geräte bei dir zu Hause halten an, wenn man sie öffnet?",
      ],
    },
    "wire-a-reflex": {
      often:
        "Vom zweiten Draht zum selben Aktor wird erwartet, dass er gewinnt. Beide senden; etwas muss sagen, wer vorgeht.",
      ask: [
        "Welche Sensoren erreichen die Räder?",
        "Was steht im Diagramm, und was nur in der Funktion?",
        "Wo würde ein dritter Draht zu `Velocity` beginnen, und wer soll dann vorgehen?",
      ],
    },
    "stop-before-the-wall": {
      often:
        "Der freie Weg nach vorn wird mit dem gefahrenen Weg verwechselt. Der eine wird kleiner, der andere größer.",
      ask: [
        "In welche Richtung geht die Zahl?",
        "Was, wenn die Wand sich bewegt?",
        "Wie steht er von jedem Start aus 10 cm vor einer Wand?",
      ],
    },
    "count-the-bumps": {
      often:
        "Auch das Loslassen wird gezählt, oder die neue Zahl wird sofort erwartet. Die Funktion liest den alten Wert und sendet den neuen.",
      ask: [
        "Was ist vor dem ersten Stoß in der Erinnerung?",
        "Was liest sie beim dritten Stoß?",
        "Warum sagt er 2, 4, 6?",
      ],
    },
    "there-and-back": {
      often: "`bump` soll den Roboter selbst umdrehen. Es schreibt nur; `drive` muss lesen.",
      ask: [
        "Wer schreibt, wer liest?",
        "Kennen die beiden einander?",
        "Was tut `drive`, bevor etwas geschrieben wurde?",
      ],
    },
    "a-mode-of-my-own": {
      often: "Der Typ bekommt einen neuen Fall, und eine der Funktionen kennt ihn nicht.",
      ask: [
        "An welchen Stellen kommt jeder Modus vor?",
        "Zeichne die Modi als Kreise: Welche Pfeile gibt es?",
        "Ist `Mode` ein Wert oder eine Liste von Werten?",
      ],
    },
    "for-one-second": {
      often:
        "Die Kinder suchen einen Befehl, der wartet. Nichts wartet; die Uhr wird immer wieder verglichen.",
      ask: [
        "Was wird gemerkt: ein Zeitpunkt oder eine Dauer?",
        "Was geschieht bei einem Stoß in dieser Sekunde?",
        "Wie wird eine halbe Sekunde daraus?",
      ],
    },
    "three-states": {
      often:
        "Der Zustand wird in einer Funktion gesucht. Er steht in der Erinnerung; Funktionen lesen und schreiben sie.",
      ask: [
        "Welcher Pfeil fehlt der Maschine?",
        "Zeichne die drei Zustände als Kreise: Welcher Sensor steht an welchem Pfeil?",
        "Was tut der Knopf in `Go`?",
      ],
    },
    "my-own-event": {
      often:
        "Die Antwort wird zweimal geschrieben, für jeden Sensor einmal. Ein Ereignis mit zwei Sendern braucht eine Antwort.",
      ask: [
        "Wer sendet `Blocked`, und wer nimmt es?",
        "Was ändert sich mit einem dritten Sensor?",
        "Wie heißt dein Ereignis?",
      ],
    },
    chance: {
      often:
        "Zufall soll jedes Mal anders sein. Derselbe Startwert gibt denselben Lauf, darum kann man ihn noch einmal ansehen.",
      ask: [
        "Warum ist es gut, dass man einen Lauf wiederholen kann?",
        "Was tut die Funktion mit dem Generator, den sie zurückbekommt?",
        "In welchem Raum ist eine feste Regel besser?",
      ],
    },
    "a-recipe": {
      often: "Meter werden geschrieben, wo Zentimeter gemeint sind: `drive 1` ist ein Zentimeter.",
      ask: [
        "Wann beginnt der zweite Schritt?",
        "Wann ist das Programm zu Ende?",
        "Was ist anders als bei zwei Funktionen nebeneinander?",
      ],
    },
    "four-times": {
      often:
        "Die Schritte werden viermal abgeschrieben, und einer wird geändert. Ein Stück mit Namen ändert man an einer Stelle.",
      ask: ["Was wiederholt sich?", "Wie viel dreht er sich insgesamt?", "Welcher Winkel macht ein Dreieck?"],
    },
    "look-inside": {
      often:
        "`Done` soll den Roboter anhalten. Es beendet die Aufgabe; die letzte Geschwindigkeit gilt weiter.",
      ask: [
        "Was beginnt, was passt auf, was beendet?",
        "Wer hält die Räder an?",
        "Was würde nie `Done` senden?",
      ],
    },
    "a-task-that-answers": {
      often: "Der Text „distance“ wird gesagt statt der Zahl, oder Meter statt Zentimeter.",
      ask: [
        "Woher kommt das Ergebnis?",
        "Kann es sich später ändern?",
        "Wie bekommst du die Fläche des Raums?",
      ],
    },
    "at-the-same-time": {
      often: "`parallel` steht, wo eine Aufgabe aufgeben soll: Es wartet auf beide.",
      ask: [
        "Welche der beiden endet zuerst?",
        "Was geschieht mit der anderen?",
        "Wann willst du die erste, wann beide?",
      ],
    },
    "the-papers-robot": {
      often:
        "Sicherheit und Neugier senden zugleich an die Räder. Was wichtiger ist, muss das andere zurückhalten.",
      ask: ["Was muss immer gewinnen?", "Wie lange?", "Probiere einen anderen Raum: Was war Glück?"],
    },
    "a-machine-for-numbers": {
      often:
        "Der Buchstabe wird für eine einzige Zahl gehalten. `x` steht für jeden Ort auf dem Weg, einen nach dem anderen.",
      ask: [
        "Welche Ausgabe gehört zur Eingabe 2?",
        "Welche Eingabe gibt 0?",
        "Können zwei Eingaben dieselbe Ausgabe haben? Kann eine zwei haben?",
      ],
    },
    "where-the-graph-meets-zero": {
      often:
        "Der Graph wird für den Weg des Roboters gehalten. Nach rechts geht der Ort, nach oben das Tempo; der Weg ist im Raum.",
      ask: [
        "Welche Gleichung hat der Roboter gelöst?",
        "Was tut ein steilerer Graph?",
        "Trag den Roboter über die Nullstelle hinaus: Wohin fährt er?",
      ],
    },
    "a-graph-in-pieces": {
      often:
        "Die Bedingungen werden gelesen, als stünde jede allein. `x < 2` gilt auch bei 0,5; es zählt dort nicht, weil ein früherer Fall passt.",
      ask: [
        "Für welche `x` gilt welche Regel?",
        "Wo treffen sich zwei Stücke, und wo ist ein Sprung?",
        "Gibt es eine Eingabe ohne Ausgabe?",
      ],
    },
    "machines-in-a-row": {
      often:
        "`speed . distance` wird von links gelesen. Die rechte Maschine arbeitet zuerst: `speed (distance here)`, wie in f(g(x)).",
      ask: [
        "Was geht von einer Maschine zur anderen?",
        "Kann man sie vertauschen? Was sagen ihre Typen?",
        "Welche Maschine ändert sich, wenn der Ring woanders liegt?",
      ],
    },
    "a-family-of-functions": {
      often:
        "`a` und `x` sind beide Buchstaben und werden vermischt. `x` ändert sich beim Fahren; `a` wird einmal gewählt und bleibt.",
      ask: [
        "Was haben alle in der Familie gemeinsam?",
        "Was geschieht bei einem negativen `a`?",
        "Welcher Buchstabe ist die Eingabe, welche sind Parameter?",
      ],
    },
    "rate-of-change": {
      often:
        "Ort und Tempo werden von derselben Kurve abgelesen. Ein waagerechter Ort heißt Tempo 0; ein waagerechtes Tempo heißt, dass der Ort gleichmäßig steigt.",
      ask: [
        "Wie sieht man am Ort, wann er am schnellsten war?",
        "Was heißt es, wenn der Ort fällt?",
        "Was sagt die Fläche unter dem Tempo?",
      ],
    },
  },
}
